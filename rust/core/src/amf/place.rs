//! Where the constellations of an AMF file put its objects.

use std::collections::{HashMap, HashSet};

use glam::DAffine3;

use super::{Constellation, Object, PlacedVolume, Purpose};
use crate::mesh::size;
use crate::{CoreError, Result};

/// Most objects that are placed.
const MOST_PLACED: usize = 1 << 16;
/// Most constellations within one another.
const MOST_DEEP: usize = 32;

/// Places each object as often as constellations do; one that is in none, as it is.
///
/// # Errors
/// [`CoreError::Unreadable`] where an instance is of something that is not there, constellations
/// contain themselves, or too much is placed; [`CoreError::Memory`].
pub fn bodies(objects: &[Object], constellations: &[Constellation]) -> Result<Vec<PlacedVolume>> {
    let of_object = by_id(objects.iter().map(|one| &*one.id));
    let of_constellation = by_id(constellations.iter().map(|one| &*one.id));
    let named: HashSet<&str> =
        constellations.iter().flat_map(|c| &c.instances).map(|one| &*one.id).collect();
    let mut placing =
        Placing { of_object, of_constellation, constellations, steps: 0, placed: Vec::new() };
    for (index, object) in objects.iter().enumerate() {
        if !named.contains(&*object.id) {
            placing.placed.push((index, DAffine3::IDENTITY));
        }
    }
    let outermost = |one: &&Constellation| !named.contains(&*one.id);
    for constellation in constellations.iter().filter(outermost) {
        placing.constellation(constellation, DAffine3::IDENTITY, 0)?;
    }
    let faces = |&(index, _): &(usize, DAffine3)| -> u64 {
        objects[index].volumes.iter().map(|volume| volume.faces.len() as u64).sum()
    };
    size::claim_given(placing.placed.iter().map(faces).sum())?;
    Ok(laid_out(objects, &placing.placed))
}

/// Which place has an id: the first, if several do.
fn by_id<'a>(ids: impl Iterator<Item = &'a str>) -> HashMap<&'a str, usize> {
    let mut found = HashMap::new();
    for (index, id) in ids.enumerate() {
        found.entry(id).or_insert(index);
    }
    found
}

struct Placing<'a> {
    of_object: HashMap<&'a str, usize>,
    of_constellation: HashMap<&'a str, usize>,
    constellations: &'a [Constellation],
    /// How many instances were followed, whether to an object or not.
    steps: usize,
    /// Objects, and where they are put.
    placed: Vec<(usize, DAffine3)>,
}

impl Placing<'_> {
    fn constellation(&mut self, one: &Constellation, at: DAffine3, deep: usize) -> Result<()> {
        let refused = |what: String| CoreError::Unreadable(format!("its constellations {what}"));
        if deep > MOST_DEEP {
            return Err(refused(format!("contain themselves, or {MOST_DEEP} others")));
        }
        for instance in &one.instances {
            self.steps += 1;
            if self.steps > MOST_PLACED {
                return Err(refused(format!("place more than {MOST_PLACED} objects")));
            }
            let at = at * instance.placement();
            if let Some(&object) = self.of_object.get(&*instance.id) {
                self.placed.push((object, at));
            } else if let Some(&inner) = self.of_constellation.get(&*instance.id) {
                self.constellation(&self.constellations[inner], at, deep + 1)?;
            } else {
                let id = crate::xml::shown(&instance.id);
                return Err(refused(format!("place the object '{id}', which is not there")));
            }
        }
        Ok(())
    }
}

/// The volumes that are printed or cut out, each with the vertices of its object.
fn laid_out(objects: &[Object], placed: &[(usize, DAffine3)]) -> Vec<PlacedVolume> {
    let mut bodies = Vec::new();
    for (of, &(index, at)) in placed.iter().enumerate() {
        let object = &objects[index];
        let wanted = object.volumes.iter().filter(|one| one.purpose != Purpose::LeftOut);
        for volume in wanted.filter(|volume| !volume.faces.is_empty()) {
            bodies.push(PlacedVolume {
                vertices: object.vertices.iter().map(|&p| at.transform_point3(p)).collect(),
                faces: volume.faces.clone(),
                purpose: volume.purpose,
                of,
            });
        }
    }
    bodies
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;
    use crate::amf::{Instance, Volume};

    fn object(id: &str) -> Object {
        let faces = vec![[0, 1, 2]];
        let volumes = vec![Volume { purpose: Purpose::Part, faces }];
        Object { id: id.into(), vertices: vec![DVec3::X, DVec3::Y, DVec3::Z], volumes }
    }

    fn instance(id: &str, delta: DVec3, rotate: DVec3) -> Instance {
        Instance { id: id.into(), delta, rotate }
    }

    fn constellation(id: &str, instances: Vec<Instance>) -> Constellation {
        Constellation { id: id.into(), instances }
    }

    #[test]
    fn an_instance_is_turned_about_x_then_y_then_z_and_then_moved() {
        let placed = instance("1", dvec3(1.0, 2.0, 3.0), dvec3(90.0, 0.0, 90.0));
        let bodies = bodies(&[object("1")], &[constellation("2", vec![placed])]).unwrap();
        // x stays under the turn about x and becomes y; y becomes z; z becomes −y and then x.
        let expected = [dvec3(1.0, 3.0, 3.0), dvec3(1.0, 2.0, 4.0), dvec3(2.0, 2.0, 3.0)];
        assert_eq!(bodies.len(), 1);
        for (found, expected) in bodies[0].vertices.iter().zip(expected) {
            assert!(found.distance(expected) < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn constellations_place_constellations_and_what_none_places_stays() {
        let inner = constellation("3", vec![instance("1", DVec3::X, DVec3::ZERO)]);
        let outer = constellation("4", vec![instance("3", DVec3::Y, DVec3::ZERO)]);
        let bodies = bodies(&[object("1"), object("2")], &[inner, outer]).unwrap();
        let firsts: Vec<DVec3> = bodies.iter().map(|body| body.vertices[0]).collect();
        assert_eq!(firsts, [DVec3::X, dvec3(2.0, 1.0, 0.0)]);
    }

    #[test]
    fn circles_and_copies_without_end_are_refused() {
        let again = constellation("2", vec![instance("3", DVec3::ZERO, DVec3::ZERO)]);
        let circle = constellation("3", vec![instance("3", DVec3::ZERO, DVec3::ZERO)]);
        let text = bodies(&[object("1")], &[again, circle]).unwrap_err().to_string();
        assert!(text.contains("contain themselves"), "{text}");
        let mut doubled = vec![constellation("c0", vec![instance("1", DVec3::X, DVec3::ZERO)])];
        for level in 0..20 {
            let id = format!("c{level}");
            let two = (0..2).map(|_| instance(&id, DVec3::X, DVec3::ZERO)).collect();
            doubled.push(constellation(&format!("c{}", level + 1), two));
        }
        let text = bodies(&[object("1")], &doubled).unwrap_err().to_string();
        assert!(text.contains("more than 65536"), "{text}");
        let lost = constellation("2", vec![instance("9", DVec3::ZERO, DVec3::ZERO)]);
        let text = bodies(&[object("1")], &[lost]).unwrap_err().to_string();
        assert!(text.contains("'9', which is not there"), "{text}");
    }
}

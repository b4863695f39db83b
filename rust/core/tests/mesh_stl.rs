//! What reading STL promises: the facets of a good file, a precise complaint about a bad one.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod solids;

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use proptest::prelude::*;
use wireprint_core::formats::{Facets, read_stl};
use wireprint_core::mesh::Mesh;

use solids::{sphere, torus};

/// A file of its own for each test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str, content: &[u8]) -> Self {
        let path = std::env::temp_dir().join(format!("wireprint-{}-{name}", std::process::id()));
        fs::write(&path, content).unwrap();
        Self(path)
    }

    fn refusal(&self) -> String {
        read_stl(&self.0).unwrap_err().to_string()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

fn binary(mesh: &Mesh, header: &str) -> Vec<u8> {
    let mut bytes = format!("{header:80}").into_bytes();
    bytes.extend((mesh.faces.len() as u32).to_le_bytes());
    for f in 0..mesh.faces.len() {
        bytes.extend([0; 12]);
        for corner in mesh.corners(f) {
            bytes.extend(corner.as_vec3().to_array().iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn ascii(mesh: &Mesh) -> String {
    let mut text = "solid a name with facet and endsolid in it\n".to_owned();
    for f in 0..mesh.faces.len() {
        text += "  facet normal 0 nan -0\n    OUTER loop\n";
        for corner in mesh.corners(f) {
            let [x, y, z] = corner.as_vec3().to_array();
            writeln!(text, "      vertex {x:e}\t{y:e} {z:e}").unwrap();
        }
        text += "    endloop\n  endfacet\r\n";
    }
    text + "endsolid\n"
}

/// The mesh as the reader must see it: rounded to f32, vertices in the order of first occurrence.
fn expected(mesh: &Mesh) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut ids = std::collections::HashMap::new();
    let faces = (0..mesh.faces.len())
        .map(|f| {
            mesh.corners(f).map(|corner| {
                let rounded = corner.as_vec3().to_array().map(|x| f64::from(x + 0.0));
                *ids.entry(rounded.map(f64::to_bits)).or_insert_with(|| {
                    vertices.push(rounded);
                    vertices.len() as u32 - 1
                })
            })
        })
        .collect();
    (vertices, faces)
}

fn notes(scratch: &Scratch) -> Vec<String> {
    read_stl(&scratch.0).unwrap().notes
}

fn read(scratch: &Scratch) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let Facets { vertices, faces, .. } = read_stl(&scratch.0).unwrap();
    (vertices.into_iter().map(|v| v.to_array()).collect(), faces)
}

#[test]
fn a_binary_file_of_many_chunks_is_welded_in_file_order() {
    let mesh = torus(30.0, 10.0, 256, 128);
    let file = Scratch::new("many.stl", &binary(&mesh, "solid despite its header"));
    assert_eq!(read(&file), expected(&mesh));
}

#[test]
fn an_ascii_file_of_many_chunks_is_read_like_a_binary_one() {
    let mesh = torus(30.0, 10.0, 160, 64);
    let text = ascii(&mesh);
    assert!(text.len() > 3 << 20, "the file must span several chunks");
    let file = Scratch::new("many-ascii.stl", text.as_bytes());
    assert_eq!(read(&file), expected(&mesh));
}

#[test]
fn the_number_of_threads_does_not_change_the_result() {
    let file = Scratch::new("threads.stl", &binary(&torus(30.0, 10.0, 200, 100), ""));
    let single = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(single.install(|| read(&file)), read(&file));
}

#[test]
fn minus_zero_is_zero() {
    let mut mesh = sphere(8);
    for vertex in &mut mesh.vertices {
        vertex.x = if vertex.x.abs() < 1e-9 { -0.0 } else { vertex.x };
    }
    let (vertices, _) = read(&Scratch::new("zero.stl", &binary(&mesh, "")));
    assert!(vertices.as_flattened().iter().all(|x| *x != 0.0 || x.is_sign_positive()));
}

#[test]
fn a_count_that_disagrees_with_the_size_is_refused_without_allocating() {
    let mut bytes = binary(&sphere(8), "");
    bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let text = Scratch::new("count.stl", &bytes).refusal();
    assert!(text.contains("count.stl") && text.contains("byte 80"), "{text}");
    assert!(text.contains("4294967295"), "{text}");
}

#[test]
fn a_truncated_or_overlong_binary_file_is_refused() {
    let bytes = binary(&sphere(8), "");
    let short = Scratch::new("short.stl", &bytes[..bytes.len() - 27]).refusal();
    assert!(short.contains("truncated"), "{short}");
    let long = Scratch::new("long.stl", &[&bytes[..], &[0; 50]].concat()).refusal();
    assert!(long.contains("more than it declares"), "{long}");
}

#[test]
fn what_cannot_be_a_facet_may_follow_the_last_one() {
    let mesh = sphere(8);
    for tail in [1, 49] {
        let bytes = [binary(&mesh, ""), vec![7; tail]].concat();
        let file = Scratch::new(&format!("tail{tail}.stl"), &bytes);
        assert_eq!(read(&file), expected(&mesh));
        assert_eq!(notes(&file), [format!("bytes after the last facet passed over: {tail}")]);
    }
}

#[test]
fn a_count_that_was_never_written_is_taken_from_the_length() {
    let mesh = sphere(8);
    let mut bytes = binary(&mesh, "");
    bytes[80..84].fill(0);
    let file = Scratch::new("count0.stl", &bytes);
    assert_eq!(read(&file), expected(&mesh));
    let note =
        format!("the count at byte 80 is 0, taken from the file's length: {}", mesh.faces.len());
    assert_eq!(notes(&file), [note]);
}

/// What programs write besides: what is replaced in a good file, by what, and the note of it.
#[test]
fn what_other_programs_write_is_read_and_noted() {
    let mesh = torus(30.0, 10.0, 160, 64);
    let facets = mesh.faces.len();
    let good = ascii(&mesh);
    let close = "    endloop\n  endfacet\r\n";
    for (old, new, note) in [
        (
            "normal 0 nan -0",
            "normal -1.#IND 1.#QNAN -nan(ind)",
            format!(
                "normals that are no numbers passed over: {} times, first in line 2",
                3 * facets
            ),
        ),
        (
            "endloop\n",
            "endloop 1\n",
            format!("text after endloop or endfacet passed over: {facets} times, first in line 7"),
        ),
        (
            "endfacet\r\n",
            "endfacet of 12 facets\r\n",
            format!("text after endloop or endfacet passed over: {facets} times, first in line 8"),
        ),
        ("endsolid\n", "", format!("a solid ends without endsolid (line {})", 7 * facets + 2)),
        ("endsolid\n", "endsolid\n\x1a", format!("a ^Z ends the text (line {})", 7 * facets + 3)),
        ("solid a name with", "\u{FEFF}solid a name with", String::new()),
        (close, " endloop endfacet ", String::new()),
    ] {
        let file = Scratch::new("other.stl", good.replace(old, new).as_bytes());
        assert_eq!(read(&file), expected(&mesh), "{new:?}");
        assert_eq!(notes(&file).concat(), note);
    }
    let twice = format!("{}{}", good.replace("endsolid\n", ""), ascii(&sphere(8)));
    let file = Scratch::new("twice.stl", twice.as_bytes());
    assert_eq!(read(&file).1.len(), facets + sphere(8).faces.len());
    assert_eq!(notes(&file), [format!("a solid ends without endsolid (line {})", 7 * facets + 2)]);
}

#[test]
fn a_coordinate_that_is_not_finite_is_named_with_its_facet_and_byte() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        let mut bytes = binary(&sphere(8), "");
        let at = 84 + 50 * 5 + 12 + 12 + 4;
        bytes[at..at + 4].copy_from_slice(&bad.to_le_bytes());
        let text = Scratch::new("nan.stl", &bytes).refusal();
        assert!(text.contains("facet 6"), "{text}");
        assert!(text.contains(&format!("byte {}", at - 4)), "{text}");
    }
}

#[test]
fn one_bad_chunk_does_not_spoil_the_chunks_that_follow_it() {
    let mut bytes = binary(&torus(30.0, 10.0, 256, 128), "");
    bytes[84 + 50 * 16000 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    let file = Scratch::new("spoilt.stl", &bytes);
    let single = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let text = single.install(|| file.refusal());
    assert!(text.contains("facet 16001"), "{text}");
}

#[test]
fn empty_files_are_refused_as_such() {
    assert!(Scratch::new("empty.stl", b"").refusal().contains("empty"));
    assert!(Scratch::new("none.stl", &[0; 84]).refusal().contains("no facets"));
    assert!(Scratch::new("nothing.stl", b"solid x\nendsolid x\n").refusal().contains("no facets"));
    assert!(Scratch::new("brief.stl", &[0; 40]).refusal().contains("too short"));
    assert!(read_stl(&std::env::temp_dir()).is_err());
    assert!(read_stl(&std::env::temp_dir().join("wireprint-missing.stl")).is_err());
}

#[test]
fn an_ascii_file_is_read_strictly_and_complaints_name_the_line() {
    let good = ascii(&sphere(4));
    assert!(read_stl(&Scratch::new("good.stl", good.as_bytes()).0).is_ok());
    let lines: Vec<&str> = good.lines().collect();
    let with_line_4 = |line: &str| {
        let mut changed = lines.clone();
        changed[3] = line;
        changed.join("\n")
    };
    for (line, complaint) in [
        ("vertex 1,5 0 0", "line 4: expected a number"),
        ("vertex 1 0", "line 5: expected a number"),
        ("vertex 1 0 0 0", "line 4: expected vertex"),
        ("vertex 1e999 0 0", "line 4: (inf, 0, 0)"),
        ("vertex nan 0 0", "line 4: (NaN, 0, 0)"),
        ("endloop", "line 4: expected vertex"),
    ] {
        let text = Scratch::new("strict.stl", with_line_4(line).as_bytes()).refusal();
        assert!(text.contains(complaint), "{line:?} gave {text}");
    }
    let cut = &good[..good.len() - 40];
    let refusal = Scratch::new("cut.stl", cut.as_bytes()).refusal();
    assert!(refusal.contains("found the end of the file"), "{refusal}");
    let early = good.replacen("endsolid", "\u{1a} endsolid", 1).replacen(
        "endfacet",
        "endfacet \u{1a}\n\u{1a}",
        1,
    );
    let refusal = Scratch::new("early.stl", early.as_bytes()).refusal();
    assert!(refusal.contains("expected facet or endsolid"), "{refusal}");
    let html = Scratch::new("html.stl", b"<html>solid</html>").refusal();
    assert!(html.contains("line 1: expected solid"), "{html}");
}

#[test]
fn a_complaint_far_into_a_large_ascii_file_names_the_right_line() {
    let text = ascii(&torus(30.0, 10.0, 160, 64));
    let mut lines: Vec<&str> = text.lines().collect();
    let wrong = lines.len() - 40;
    lines[wrong] = "rubbish";
    let refusal = Scratch::new("far.stl", lines.join("\n").as_bytes()).refusal();
    assert!(refusal.contains(&format!("line {}:", wrong + 1)), "{refusal}");
}

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let _ = read_stl(&Scratch::new("any.stl", &bytes).0);
    }

    #[test]
    fn no_text_makes_the_reader_panic(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet",
                "endsolid", "0", "1e3", "-2", "\n",
            ]),
            0..60,
        ),
    ) {
        let _ = read_stl(&Scratch::new("words.stl", format!("solid\n{}", words.join(" ")).as_bytes()).0);
    }
}

"""Things that people print first: a cube, a bottle, a mug."""

import io

import numpy as np
import shapely
import trimesh

from random_solids import at, lathed, standing
from wireprint import Mesh, examples


def _mug():
    """A cup with a wall of 5 mm, a floor and a handle: bodies that overlap."""
    cup = lathed((0, 0), (34, 0), (38, 88), (33, 88), (29, 5), (0, 5))
    # The handle's ends lie within the wall.
    bow = shapely.Point(0, 0).buffer(28).difference(shapely.Point(0, 0).buffer(20))
    handle = at(standing(bow.intersection(shapely.box(-2, -30, 30, 30)), 9), 35, 0, 46)
    return trimesh.util.concatenate([cup, handle])


def meshes():
    """Return the three by name, in mm."""
    found = {"mug": _mug()}
    for name, height_mm in (("cube", 28), ("bottle", 100)):
        found[name] = trimesh.load(io.BytesIO(examples.stl(name)), file_type="stl")
        found[name].apply_scale(height_mm / np.ptp(found[name].bounds[:, 2]))
    return {
        name: Mesh.from_arrays(np.asarray(solid.vertices), np.asarray(solid.faces))
        for name, solid in found.items()
    }

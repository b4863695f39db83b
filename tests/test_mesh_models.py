"""The mesh stage on the shared models, sound and broken."""

import csv

import numpy as np
import pytest

from wireprint._core import Mesh, ModelError
from wireprint.mesh import load_mesh

NO_FACE = 2**32 - 1


def rows(shared, folder):
    with (shared / "models" / folder / "manifest.csv").open() as file:
        return list(csv.DictReader(file))


def test_every_shared_model_loads_at_its_manifests_size(shared):
    failures = []
    for row in rows(shared, "."):
        path = shared / "models" / row["name"]
        options = {"scale": float(row["scale"]), "up": row["up_axis"]}
        mesh = load_mesh(path, **options)
        size = np.ptp(mesh.bounds, axis=0)
        wanted = [float(row[f"bbox_mm_{axis}"]) for axis in "xyz"]
        closed = NO_FACE not in mesh.neighbours
        if not np.allclose(size, wanted, rtol=5e-3):
            failures.append(f"{row['name']}: {size} instead of {wanted}")
        if mesh.report["facets"] != int(row["triangles"]):
            failures.append(f"{row['name']}: {mesh.report['facets']} facets")
        if row["watertight"] == "yes" and not (closed and mesh.volume > 0):
            failures.append(f"{row['name']}: open or inside out")
        if row["watertight"] == "yes" and mesh.report["components"] != int(row["components"]):
            failures.append(f"{row['name']}: {mesh.report['components']} components")
    assert failures == []


def test_open_models_keep_their_rims(shared):
    rims = {"vase_open.stl": 2, "branch_3legs_open.stl": 4}
    for name, count in rims.items():
        report = load_mesh(shared / "models" / name).report
        assert (report["open_rims"], report["closed_holes"]) == (count, 0)


REJECTED = {
    "ascii_unparseable.stl": "line 4: expected a number",
    "crafted_ascii_junk.stl": "line 1: expected solid",
    "crafted_nan_inf_coords.stl": "facet 4 .* byte 246",
    "crafted_truncated_binary.stl": "truncated",
    "crafted_wrong_count_4g.stl": "declares 4294967295 facets",
    "empty_0byte.stl": "empty",
    "header_only_zero_count.stl": "no facets",
    "huge_coordinates.stl": "too large.*--scale",
    "triangle_soup.stl": "no closed contour",
}
ACCEPTED = {
    "binary_with_solid_header.stl": {"facets": 1360, "closed_components": 1},
    "cube_missing_facet.stl": {"closed_holes": 1, "added_facets": 1, "boundary_edges": 0},
    "nonmanifold_cubes.stl": {"nonmanifold_edges": 1, "closed_components": 2},
    "self_intersecting_tube.obj": {"facets": 17160, "closed_components": 1},
    "zero_area_triangle.stl": {"turned_degenerate": 1, "kept_degenerate": 0},
}


def test_the_broken_models_behave_as_their_manifest_says(shared):
    folder = shared / "models" / "broken"
    names = {row["name"] for row in rows(shared, "broken")}
    assert names == {*REJECTED, *ACCEPTED, "crafted_inside_out.stl"}
    for name, complaint in REJECTED.items():
        with pytest.raises(ModelError, match=f"{name}: .*{complaint}"):
            load_mesh(folder / name)
    for name, expected in ACCEPTED.items():
        report = load_mesh(folder / name).report
        assert {key: report[key] for key in expected} == expected


def test_the_inside_out_duck_is_the_duck(shared):
    duck = load_mesh(shared / "models" / "duck.stl", units="m")
    reversed_duck = load_mesh(shared / "models" / "broken" / "crafted_inside_out.stl", units="m")
    assert reversed_duck.report["flipped_facets"] == len(duck.faces)

    def facets(mesh: Mesh):
        corners = mesh.vertices[mesh.faces]
        first = np.lexsort(corners.transpose(2, 0, 1)[::-1], axis=1)[:, 0]
        order = (first[:, None] + np.arange(3)) % 3
        turned = np.take_along_axis(corners, order[:, :, None], 1).reshape(-1, 9)
        return turned[np.lexsort(turned.T)]

    assert np.array_equal(facets(duck), facets(reversed_duck))

"""The models that the package makes itself."""

import io
import math

import pytest
import shapely
import trimesh
from click.testing import CliRunner

from wireprint import cli, examples


def load(name):
    return trimesh.load(io.BytesIO(examples.stl(name)), file_type="stl")


@pytest.mark.parametrize("name", examples.names())
def test_every_example_is_closed_oriented_and_stands_on_the_bed(name):
    mesh = load(name)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    assert mesh.bounds[0][2] == pytest.approx(0, abs=1e-6)


def test_the_cube_is_the_papers():
    assert load("cube").extents == pytest.approx((28, 28, 28))


def test_the_sphere_is_the_papers():
    mesh = load("sphere")
    assert mesh.extents == pytest.approx((78, 78, 78), abs=0.2)
    assert mesh.volume == pytest.approx(4 / 3 * math.pi * 39**3, rel=3e-3)


def test_the_arch_has_two_contours_below_and_one_above():
    mesh = load("arch")

    def contours(z):
        lines = trimesh.intersections.mesh_plane(mesh, [0, 0, 1], [0, 0, z])
        return len(
            shapely.get_parts(shapely.polygonize(shapely.linestrings(lines[:, :, :2].round(6))))
        )

    assert contours(20) == 2
    assert contours(75) == 1


def test_an_example_is_written_to_its_own_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(cli.main, ["example", "bottle"]).exit_code == 0
    assert (tmp_path / "bottle.stl").read_bytes() == examples.stl("bottle")


def test_nothing_is_left_where_writing_fails(tmp_path):
    (tmp_path / "taken").write_text("a file, no folder")
    target = tmp_path / "taken" / "cube.stl"
    result = CliRunner().invoke(cli.main, ["example", "cube", "-o", str(target)])
    assert result.exit_code == 2
    assert str(target) in result.stderr
    assert list(tmp_path.iterdir()) == [tmp_path / "taken"]


def test_the_torus_stands_upright_and_has_its_volume():
    mesh = load("torus")
    assert mesh.extents == pytest.approx((76, 20, 76), abs=0.1)
    assert mesh.volume == pytest.approx(2 * math.pi**2 * 28 * 10**2, rel=3e-3)
    assert mesh.euler_number == 0


def test_the_branch_is_one_body_that_forks_and_merges():
    mesh = load("branch")
    assert (mesh.body_count, mesh.euler_number) == (1, 0)
    count = [len(mesh.section([0, 0, 1], [0, 0, z]).discrete) for z in (10, 50, 72, 110)]
    assert count == [1, 3, 2, 1]

"""A print in the hand, and the frame that it is: against books, another program, direct solves."""

import json
import math
import sys

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from command import run
from wireprint import Settings, _core, examples, grip, load_mesh, make, simulate
from wireprint.forecast_words import sentences
from wireprint.rules import rules_of

POISSON = 0.38


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """G-code of some examples, for the default printer."""
    folder = tmp_path_factory.mktemp("grip")

    def one(name):
        path = folder / f"{name}.stl"
        path.write_bytes(examples.stl(name))
        return make(load_mesh(path), Settings.load(), compare=False).gcode

    return {name: one(name) for name in ("cube", "sphere")}


def ring(radius_mm, corners=72):
    """A ring that lies on the bed."""
    turns = np.linspace(0, 2 * math.pi, corners + 1)
    lines = [
        f"G1 X{radius_mm * math.cos(a):.4f} Y{radius_mm * math.sin(a):.4f} E1 F1800" for a in turns
    ]
    first = lines[0].replace(" E1", "")
    return "\n".join(["M83", "G1 Z0.35 F1800", first, *lines[1:], "G1 Z20"]).encode()


def test_a_ring_between_two_points_gives_way_as_books_say():
    """Roark: 0.149·F·R³/(E·I); pads of 18 mm on 240 mm are nearly points."""
    settings = Settings.load(overrides=["bed.diameter_mm=400"])
    found = grip.grip(ring(120), settings, 0.01)
    inertia = math.pi * settings.strand_mm**4 / 64
    expected = 0.149 * 0.01 * 120**3 / (settings.material.modulus_mpa * inertia)
    assert found.squeeze_mm == pytest.approx(expected, rel=0.06)
    # The moment is greatest under the load: 0.318·F·R.
    stress = 0.318 * 0.01 * 120 * settings.strand_mm / 2 / inertia
    assert found.stress_mpa == pytest.approx(stress, rel=0.1)
    assert abs(found.place_mm[0]) > 110 or abs(found.place_mm[1]) > 110


def test_what_it_bears_does_not_depend_on_what_it_is_asked_with(made):
    settings = Settings.load()
    one, ten = (grip.grip(made["cube"], settings, force) for force in (1, 10))
    assert ten.squeeze_mm == pytest.approx(10 * one.squeeze_mm)
    assert ten.bears_n == pytest.approx(one.bears_n)
    stiff = grip.grip(made["cube"], settings, 10, stiffer=2.0)
    assert stiff.squeeze_mm == pytest.approx(ten.squeeze_mm / 2)
    assert stiff.bears_n == pytest.approx(ten.bears_n, rel=1e-6)


def test_it_is_told_where_it_is_asked_for(made, tmp_path):
    target = tmp_path / "cube.gcode"
    target.write_bytes(made["cube"])
    silent = json.loads(run("simulate", target, "--json").stdout)
    assert silent["grip"] is None
    assert silent["rules"]["grips"]["verdict"] == "not judged"
    told = json.loads(run("simulate", target, "--json", "--grip", 10).stdout)
    rule = told["rules"]["grips"]
    assert (rule["verdict"], rule["limit"], rule["unit"]) == ("ranking", None, "mm")
    assert rule["worst"] == told["grip"]["squeeze_mm"] > 0
    assert rule["bounds"][1] == pytest.approx(2 * rule["worst"])
    words = run("simulate", target, "--grip", 10).stdout
    assert "two fingers that press with 10 N along" in words


@pytest.mark.parametrize("text", [b"M83\nG1 Z9", b"M83\nG1 Z5\nG1 X9"])
def test_nothing_between_the_fingers_is_not_judged(text):
    found = simulate(text, grip_n=10)
    assert found.rules["grips"].verdict == "not judged"
    assert "nothing is between the fingers" in sentences(found)[6]


def test_without_scipy_it_says_what_it_takes(monkeypatch, made):
    for name in ("scipy", "scipy.sparse", "scipy.sparse.csgraph", "scipy.sparse.linalg"):
        monkeypatch.setitem(sys.modules, name, None)
    found = simulate(made["cube"], grip_n=10)
    assert "pip install 'wireprint[grip]'" in sentences(found)[6]


def section(settings):
    """Modulus, shear modulus, area, second moments: about an axis across, and along."""
    strand, modulus = settings.strand_mm, settings.material.modulus_mpa
    inertia = math.pi * strand**4 / 64
    return modulus, modulus / 2 / (1 + POISSON), math.pi * strand**2 / 4, inertia, 2 * inertia


@pytest.mark.parametrize("name", ["cube", "sphere"])
def test_another_programs_frame_gives_way_as_much(made, name):
    """PyNite: a node at the top is pushed; its shift agrees to 1e-9 mm."""
    pynite = pytest.importorskip("Pynite")
    settings = Settings.load()
    places, on_bed, ends, _, _ = _core.frame(made[name], rules_of(settings))
    kept = ends[~(on_bed[ends[:, 0]] & on_bed[ends[:, 1]])]
    modulus, shear, area, inertia, polar = section(settings)
    model = pynite.FEModel3D()
    for node in np.unique(kept):
        model.add_node(str(node), *places[node].tolist())
        model.def_support(str(node), *[bool(on_bed[node])] * 6)
    model.add_material("m", modulus, shear, POISSON, 1.0)
    model.add_section("s", area, inertia, inertia, polar)
    for number, (a, b) in enumerate(kept):
        model.add_member(str(number), str(a), str(b), "m", "s")
    top = int(max(np.unique(kept), key=lambda node: places[node, 2]))
    model.add_node_load(str(top), "FX", 0.01)
    model.analyze_linear(sparse=True)
    node = model.nodes[str(top)]
    other = [node.DX["Combo 1"], node.DY["Combo 1"], node.DZ["Combo 1"]]
    assert direct(places, on_bed, kept, settings, top)[:, 0] * 0.01 == pytest.approx(
        other, abs=1e-9
    )


def direct(places, on_bed, ends, settings, node):
    """Shifts of a node under unit forces there, of shape (3, 3), by a sparse solve of it all."""
    nodes, beams = np.unique(ends, return_inverse=True)
    beams = beams.reshape(-1, 2)
    modulus, shear, area, inertia, polar = section(settings)
    rows, columns, values = [], [], []
    for a, b in beams:
        run = places[nodes[b]] - places[nodes[a]]
        length = np.linalg.norm(run)
        local = stiffness(length, modulus, shear, area, inertia, polar)
        along = run / length
        aside = np.cross(along, np.eye(3)[np.argmin(abs(along))])
        aside /= np.linalg.norm(aside)
        turn = np.kron(np.eye(4), np.array([along, aside, np.cross(along, aside)]))
        degrees = np.r_[6 * a : 6 * a + 6, 6 * b : 6 * b + 6]
        rows.append(np.repeat(degrees, 12))
        columns.append(np.tile(degrees, 12))
        values.append((turn.T @ local @ turn).ravel())
    size = 6 * len(nodes)
    joined = (np.concatenate(rows), np.concatenate(columns))
    whole = coo_matrix((np.concatenate(values), joined), shape=(size, size)).tocsc()
    free = np.flatnonzero(np.repeat(~on_bed[nodes], 6))
    solver = splu(whole[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A")
    first = np.searchsorted(free, 6 * np.searchsorted(nodes, node))
    unit = np.zeros((len(free), 3))
    unit[first : first + 3] = np.eye(3)
    return solver.solve(unit)[first : first + 3]


def stiffness(length, modulus, shear, area, inertia, polar):
    """The textbook's matrix of a beam, as it is found in any book on frames."""
    found = np.zeros((12, 12))
    for i, j, value in (
        (0, 0, modulus * area / length),
        (3, 3, shear * polar / length),
        (1, 1, 12 * modulus * inertia / length**3),
        (2, 2, 12 * modulus * inertia / length**3),
        (4, 4, 4 * modulus * inertia / length),
        (5, 5, 4 * modulus * inertia / length),
    ):
        far = value / 2 if i in (4, 5) else -value
        found[i, j] = found[6 + i, 6 + j] = value
        found[i, 6 + j] = found[6 + i, j] = far
    bend = 6 * modulus * inertia / length**2
    for shift, turn, sign in ((1, 5, 1), (2, 4, -1)):
        for at, side in ((0, 1), (6, -1)):
            for about in (turn, turn + 6):
                found[at + shift, about] = found[about, at + shift] = sign * side * bend
    return found


@pytest.mark.parametrize("name", ["cube", "sphere"])
def test_a_growing_frame_gives_way_as_direct_solves_of_its_parts(made, name):
    """At 30, 60 and 90 % of a print, to 1e-8."""
    settings = Settings.load()
    compliance = simulate(made[name], settings).compliance_mm_n
    places, on_bed, ends, strands, _ = _core.frame(made[name], rules_of(settings))
    bears = ~(on_bed[ends[:, 0]] & on_bed[ends[:, 1]])
    ends, strands = ends[bears], strands[bears]
    for share in (0.3, 0.6, 0.9):
        strand, node = free_end(ends, strands, on_bed, round(share * int(strands.max())))
        laid = ends[strands <= strand]
        block = direct(places, on_bed, laid, settings, node)
        expected = np.linalg.eigvalsh((block + block.T) / 2)[-1]
        assert compliance[strand] == pytest.approx(expected, rel=1e-8)


def free_end(ends, strands, on_bed, first):
    """The first strand from `first` on whose end is free when it is laid, and the node there."""
    for strand in range(first, int(strands.max()) + 1):
        own = ends[strands == strand]
        if len(own):
            node = own[-1][1]
            held = ends[strands <= strand]
            if not on_bed[node] and np.count_nonzero(held == node) == 1:
                return strand, node
    raise AssertionError("no strand ends freely")

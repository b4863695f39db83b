"""A print as the page draws it: strands by texel, with the times at which they are laid."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint.gcode import document
from wireprint.hybrid.motion import motion
from wireprint.view_html import STEPS
from wireprint.view_styles import style_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.pipeline import WirePrint

    Arrays = dict[str, npt.NDArray[Any]]

#: Diameters are sent as multiples of this, mm; a byte holds the thickest.
DIAMETER_STEP_MM: Final = 0.02
#: The bit of a strand's kind that says that it breaks a rule.
BREACH_BIT: Final = 0x80
_MOST_KINDS: Final = 64
_LAYER: Final = b";LAYER_CHANGE\n"


def drawn(made: WirePrint, given: Mesh) -> tuple[dict[str, Any], Arrays]:
    """Return what the page needs to draw a print that was judged.

    Parameters
    ----------
    made
        The print, with its certificate.
    given
        The model before it was put where it fits.

    Returns
    -------
    dict
        ``labels`` (name and colour of each kind), ``low`` and ``span`` (mm; what coordinates are
        steps of), ``diameter_step_mm``, ``slabs_mm`` (height of the highest strand up to each
        slab), ``motion`` (rows of the map that takes the given model to where it is printed),
        ``breaches`` and ``total_s``.
    dict
        ``strands`` (N, 4) uint32: from and to as six uint16, kind and diameter as bytes, slab as
        uint16. ``when`` (N, 2) float32: start and end of each, s. ``speed`` (N,) float32, mm/s:
        as the planner runs it, on average.
    """
    certificate = made.certificate
    assert certificate is not None, "only prints that were judged are drawn"  # noqa: S101
    core = certificate.core
    centre = np.array([*made.settings.printer.bed.centre_mm, 0.0])
    ends = core.strands - centre
    lines = core.strand_lines.astype(np.int64)
    begin, end, total_s = _times(made, lines)
    slabs = _slabs(made.gcode, lines)
    kinds = np.minimum(core.strand_features, _MOST_KINDS - 1).astype(np.uint8)
    kinds[np.isin(lines, _broken_lines(certificate))] |= BREACH_BIT
    low, span = _box(ends)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    laid_s = np.maximum(end - begin, 1e-6)
    head = {
        "labels": _labels(core.features, core.strand_features, length),
        "low": low.tolist(),
        "span": span.tolist(),
        "diameter_step_mm": DIAMETER_STEP_MM,
        "slabs_mm": _heights(ends, slabs),
        "motion": motion(given, made.mesh, _turn(made)).tolist(),
        "breaches": _places(certificate, centre),
        "total_s": total_s,
    }
    arrays = {
        "strands": _packed(ends, low, span, kinds, _diameters(made, len(ends)), slabs),
        "when": np.stack([begin, end], axis=1).astype("<f4"),
        "speed": (length / laid_s).astype("<f4"),
    }
    return head, arrays


def _times(
    made: WirePrint, lines: npt.NDArray[np.int64]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], float]:
    """Return when each strand is begun and done, s, and when all is."""
    planned = document.timing(made.gcode, made.settings, per_move=True)
    rows = planned.per_move
    assert rows is not None, "rows were asked for"  # noqa: S101
    durations = rows[1]
    done = np.cumsum(durations)
    row = np.searchsorted(rows[0].astype(np.int64), lines)
    return done[row] - durations[row], done[row], planned.total_s


def _slabs(gcode: bytes, lines: npt.NDArray[np.int64]) -> npt.NDArray[np.uint16]:
    """Return the slab of each strand, from 0: how many begin before its line, less one."""
    breaks = np.flatnonzero(np.frombuffer(gcode, np.uint8) == ord("\n"))
    begins = []
    at = gcode.find(_LAYER)
    while at >= 0:
        begins.append(at)
        at = gcode.find(_LAYER, at + 1)
    numbers = np.searchsorted(breaks, begins) + 1
    found = np.searchsorted(numbers, lines) - 1
    return np.clip(found, 0, STEPS).astype(np.uint16)


def _heights(ends: npt.NDArray[np.float64], slabs: npt.NDArray[np.uint16]) -> list[float]:
    """Return the height up to which each slab and those below reach, mm."""
    tops = np.zeros(int(slabs.max(initial=0)) + 1)
    np.maximum.at(tops, slabs, ends[:, :, 2].max(axis=1))
    heights: list[float] = np.maximum.accumulate(tops).round(3).tolist()
    return heights


def _broken_lines(certificate: Certificate) -> npt.NDArray[np.int64]:
    found = certificate.breaches()
    lines = [breach.line for breaches in found.values() for breach in breaches]
    lines += [hit.hit_line for hit in certificate.collisions if hit.hit_line is not None]
    return np.array(lines, np.int64)


def _places(certificate: Certificate, centre: npt.NDArray[np.float64]) -> list[dict[str, Any]]:
    """Return each breach with its rule, its words and its place."""
    found = []
    for rule, breaches in certificate.breaches().items():
        for breach in breaches:
            names = ("tip_mm", "from_mm", "at_mm")
            at = next((getattr(breach, name) for name in names if hasattr(breach, name)), None)
            place = None if at is None else (np.array(at) - centre).round(3).tolist()
            found.append({"rule": rule, "words": str(breach), "at_mm": place})
    return found


def _box(ends: npt.NDArray[np.float64]) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    points = ends.reshape(-1, 3)
    low = points.min(axis=0)
    return low, np.maximum(points.max(axis=0) - low, 1e-6)


def _labels(
    names: list[str], features: npt.NDArray[np.uint16], length: npt.NDArray[np.float64]
) -> list[dict[str, Any]]:
    lengths = np.bincount(features, length, minlength=len(names))
    found = []
    for name, length_mm in zip(names, lengths, strict=True):
        style = style_of(name)
        found.append(
            {"label": name, "name": style.name, "colour": style.colour, "length_mm": length_mm}
        )
    return found


def _diameters(made: WirePrint, count: int) -> npt.NDArray[np.uint8]:
    """Return the strands' diameters in steps; the file's own, which has one for each."""
    from wireprint._core import Strands

    found = Strands.from_gcode(made.gcode).diameters
    steps = np.clip(np.rint(found[:count] / DIAMETER_STEP_MM), 1, 255)
    return steps.astype(np.uint8)


def _packed(
    ends: npt.NDArray[np.float64],
    low: npt.NDArray[np.float64],
    span: npt.NDArray[np.float64],
    kinds: npt.NDArray[np.uint8],
    diameters: npt.NDArray[np.uint8],
    slabs: npt.NDArray[np.uint16],
) -> npt.NDArray[np.uint32]:
    packed = np.zeros(
        len(ends), [("ends", "<u2", (2, 3)), ("kind", "u1"), ("diameter", "u1"), ("slab", "<u2")]
    )
    packed["ends"] = np.rint((ends - low) / span * STEPS)
    packed["kind"], packed["diameter"], packed["slab"] = kinds, diameters, slabs
    return packed.view("<u4").reshape(-1, 4)


def _turn(made: WirePrint) -> tuple[float, float, float]:
    return 0.0, 0.0, made.turn_to_fit_deg

"""A print as the page draws it: strands by texel, with the times at which they are laid."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint._core import Strands
from wireprint.gcode import document
from wireprint.hybrid.motion import motion
from wireprint.view_styles import style_of
from wireprint.view_texels import (
    BREACH_BIT,
    DIAMETER_STEP_MM,
    MOST_KINDS,
    box_of,
    heights_of,
    packed,
    slabs_of,
    times_of,
)

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.view_texels import Floats, Integers
    from wireprint.wire_print import WirePrint

    Arrays = dict[str, npt.NDArray[Any]]


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
        ``breaches``, ``total_s`` and that times are known (``timed``).
    dict
        ``strands`` (N, 4) uint32, see `packed`. ``when`` (N, 2) float32: start and end of each, s.
        ``speed`` (N,) float32, mm/s: as the planner runs it, on average.
    """
    certificate = made.certificate
    assert certificate is not None, "only prints that were judged are drawn"  # noqa: S101
    core = certificate.core
    centre = np.array([*made.settings.printer.bed.centre_mm, 0.0])
    ends = core.strands - centre
    lines = core.strand_lines.astype(np.int64)
    begin, end, total_s = _times(made, lines)
    slabs = slabs_of(made.gcode, lines)
    kinds = np.minimum(core.strand_features, MOST_KINDS - 1).astype(np.uint8)
    kinds[np.isin(lines, _broken_lines(certificate))] |= BREACH_BIT
    low, span = box_of(ends)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    diameters = Strands.from_gcode(made.gcode).diameters[: len(ends)]
    laid_s = np.maximum(end - begin, 1e-6)
    head = {
        "labels": _labels(core.features, core.strand_features, length),
        "low": low.tolist(),
        "span": span.tolist(),
        "diameter_step_mm": DIAMETER_STEP_MM,
        "slabs_mm": heights_of(ends, slabs),
        "motion": motion(given, made.mesh, _turn(made)).tolist(),
        "breaches": _places(certificate, centre),
        "total_s": total_s,
        "timed": True,
    }
    arrays = {
        "strands": packed(ends, low, span, kinds, diameters, slabs),
        "when": np.stack([begin, end], axis=1).astype("<f4"),
        "speed": (length / laid_s).astype("<f4"),
    }
    return head, arrays


def hanging(made: WirePrint, head: dict[str, Any], strands: npt.NDArray[np.uint32]) -> Arrays:
    """Return what the strands of a print relax to, to be drawn in their place.

    Parameters
    ----------
    made
        The print, with its certificate.
    head, strands
        How its strands are drawn; see `drawn`.

    Returns
    -------
    dict
        ``relaxed`` (M, 4) uint32: chords where strands hang, else the strands, as texels.
        ``relaxed_of`` (M,) uint32: the strand in which each ends, ascending.
    """
    certificate = made.certificate
    assert certificate is not None, "only prints that were judged are drawn"  # noqa: S101
    order = np.argsort(certificate.core.relaxed_strands, kind="stable")
    of = certificate.core.relaxed_strands[order].astype("<u4")
    ends = certificate.core.relaxed[order] - np.array([*made.settings.printer.bed.centre_mm, 0.0])
    low, span = np.array(head["low"]), np.array(head["span"])
    # Kind, diameter and slab are those of the strand.
    nothing = np.zeros(len(of), np.uint8)
    texels = packed(ends, low, span, nothing, nothing.astype(np.float64), nothing)
    texels[:, 3] = strands[of, 3]
    return {"relaxed": texels, "relaxed_of": of}


def _times(made: WirePrint, lines: Integers) -> tuple[Floats, Floats, float]:
    """Return when each strand is begun and done, s, and when all is."""
    planned = document.timing(made.gcode, made.settings, per_move=True)
    rows = planned.per_move
    assert rows is not None, "rows were asked for"  # noqa: S101
    return (*times_of(rows[0], rows[1], lines), planned.total_s)


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


def _turn(made: WirePrint) -> tuple[float, float, float]:
    return 0.0, 0.0, made.turn_to_fit_deg

"""The figures of a print in words."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint import slimness
from wireprint.duration import duration
from wireprint.weakness import Weak
from wireprint.wholeness import told

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

#: Weak places that are told; of more, their number.
_WEAK = 5


def lines(figures: Mapping[str, Any]) -> list[str]:
    """Return what ``wireprint slice`` prints about one model."""
    machine = f"{figures['printer']} with {figures['material']}"
    return [
        f"{figures['output']}: {duration(figures['print_time_s'])} on {machine}",
        *_rows(figures),
    ]


def _rows(figures: Mapping[str, Any]) -> Iterator[str]:
    x, y, z = figures["size_mm"]
    yield _row("size", f"{x:.1f} × {y:.1f} × {z:.1f} mm")
    if (turned := figures["orientation"]) is not None:
        x, y, z = turned["rotate_deg"]
        yield _row("turned", f"{x:g}, {y:g}, {z:g}° about x, y, z: {turned['why']}")
    if figures["turn_to_fit_deg"]:
        yield _row("turned", f"{figures['turn_to_fit_deg']:g}° about z, to fit the bed")
    yield _row("wire", f"{figures['slices']} slices, {figures['posts']} posts")
    for low, high, most in figures["low_slabs_mm"]:
        yield _row("lower slabs", f"at most {most:g} mm, from z {low:g} to {high:g} mm")
    if figures["brim_rings"]:
        yield _row("brim", f"{figures['brim_rings']} rings about the foot")
    yield _row("strand", f"{figures['strand_mm'] / 1000:.2f} m")
    if slim := slimness.told(figures["strand"]):
        yield _row("slim", slim)
    yield _row("travel", f"{figures['travel_mm'] / 1000:.2f} m")
    yield _row("filament", f"{figures['filament_mm']:.0f} mm, {figures['filament_g']:.1f} g")
    yield _row(
        "time",
        f"{duration(figures['print_time_s'])}, {duration(figures['pause_s'])} of it "
        f"in {figures['pauses']} pauses",
    )
    if "coverage" in figures:
        off = f", {figures['deviation_mm']:.2f} mm off the surface on average"
        yield _row("fidelity", f"{100 * figures['coverage']:.1f} % covered{off}")
    for sentence in figures["repaired"]:
        yield _row("repaired", sentence)
    for part in figures["unprinted"]:
        yield _row(
            "not printed",
            f"{told(part)}: {part['help']}",
        )
    for place in (figures["weak"] or ())[:_WEAK]:
        yield _row("weak", str(Weak(**place)))
    if (rest := len(figures["weak"] or ()) - _WEAK) > 0:
        yield _row("weak", f"and {rest} more places")
    if (regions := figures["regions"]) is not None:
        yield from _of_regions(regions)
    if (forecast := figures.get("forecast")) is not None:
        yield _row("forecast", f"{forecast['trust']}, a model and no part of the certificate")
        for sentence in forecast["sentences"]:
            yield _row("", sentence)
    if (stiffer := figures.get("stiffened")) is not None:
        yield from _of_stiffening(stiffer)
    for sentence in figures["warnings"]:
        yield _row("note", sentence)
    if (sent := figures["sent"]) is not None:
        what = "is printed" if sent["started"] else "waits to be started"
        yield _row("sent", f"to {sent['host']}, where {sent['file']} {what}")


def _of_stiffening(stiffer: Mapping[str, Any]) -> Iterator[str]:
    """Say what was done about a print that would give way."""
    if not stiffer["overrides"]:
        yield _row("stiffer", f"nothing helps: {stiffer['tried']} other prints were tried")
        return
    sets = " ".join(f"--set '{override}'" for override in stiffer["overrides"])
    before, after = (stiffer[f"meets_{when}_mm"] or 0.0 for when in ("before", "after"))
    grips = ""
    if stiffer["bears_after_n"] is not None:
        grips = f"; bears {stiffer['bears_before_n']:.2g} → {stiffer['bears_after_n']:.2g} N"
    took = " → ".join(duration(stiffer[f"print_time_{when}_s"]) for when in ("before", "after"))
    enough = "" if stiffer["enough"] else "; that does not suffice yet"
    yield _row("stiffer", f"with {sets}, found among {stiffer['tried']} prints that were tried")
    yield _row(
        "",
        f"strands are pulled aside by {before:.2g} → {after:.2g} mm{grips}, in {took}{enough}",
    )


def _of_regions(regions: Mapping[str, Any]) -> Iterator[str]:
    count = len(regions["runs"])
    yield _row(
        "layers",
        f"{regions['layer_wise_mm'] / 1000:.2f} m in {count} runs on {regions['area_mm2']:.0f} mm²"
        if count
        else "none: no marked stretch is half of a slab high and long enough",
    )
    by_reason: dict[str, list[Mapping[str, Any]]] = {}
    for run in regions["dropped"]:
        by_reason.setdefault(run["reason"], []).append(run)
    for reason, runs in by_reason.items():
        x, y, z = runs[0]["place_mm"]
        yield _row(
            "stays wire",
            f"{sum(run['area_mm2'] for run in runs):.0f} mm² in {len(runs)} runs "
            f"({reason.replace('_', ' ')}), first at ({x:.1f}, {y:.1f}, {z:.1f}): "
            f"{runs[0]['help']}",
        )
    for part in regions["hollow"]:
        yield _row(
            "hollow",
            f"{part['volume_mm3']:.0f} mm³ at z {part['low_mm']:.1f}–{part['high_mm']:.1f} mm "
            f"({part['reason'].replace('_', ' ')}): {part['help']}",
        )


def _row(name: str, text: str) -> str:
    return f"  {name:12}{text}"

"""What a mesh's repair and a print's omissions mean, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, TypedDict

from wireprint.mesh import UNITS_MM

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.fidelity import Fidelity, Patch
    from wireprint.settings import Settings

#: Models up to this size are mostly not meant in mm …
_SMALL_MM: Final = 10.0
#: … (less than this, a nozzle's width, makes no print) …
_TINY_MM: Final = 0.5
#: … but in a unit in which they have a size like this.
_USUAL_MM: Final = (20.0, 500.0)
#: Options of placing that leave a model as large as its file says, in mm.
_AS_IN_THE_FILE: Final = {"units": "mm", "scale": 1.0, "height_mm": None}

#: Counts of a mesh's report that are repairs, and how they read.
_REPAIRS: Final = {
    "welded_vertices": "vertices welded across cracks",
    "dropped_degenerate": "facets without area dropped",
    "turned_degenerate": "facets without area turned",
    "dropped_duplicate": "duplicate facets dropped",
    "flipped_facets": "facets turned outwards",
    "closed_holes": "holes closed",
}
#: Counts that a user should know of, though nothing was done about them.
_WARNINGS: Final = {
    "kept_degenerate": "facets without area kept",
    "open_rims": "open rims kept",
    "nonmanifold_edges": "edges with more than two facets",
    "one_sided": "bodies with one side only",
}


#: Reason, lowest and highest z in mm, area in mm², a point of it in mm.
LeftOut = tuple[str, float, float, float, tuple[float, float, float]]


class Unprinted(TypedDict):
    """A part of the surface that is not printed."""

    reason: str
    #: Lowest and highest z, mm.
    low_mm: float
    high_mm: float
    area_mm2: float
    #: Its middle; of a part that is listed though strands pass near to it, a point of it.
    place_mm: tuple[float, float, float]
    #: Extent along x, y, z; None of a part that is listed though strands pass near to it.
    size_mm: tuple[float, float, float] | None
    help: str


#: Why something is not printed → what would help.
_HELP: Final = {
    "not_covered": "turn the model (--orient auto), or set lower slabs (--slab-min)",
    "mid_air": "turn the model (--orient auto)",
    "no_foothold": "print it larger, with a smaller nozzle, or with lower slabs",
    "wide_span": "turn the model, or raise wire.span_limit_mm if your material holds it",
    "wide_roof": "turn the model so that the face stands upright",
    "breaks_rules": "turn the model (--orient auto), or set lower slabs (--slab-min)",
}
#: What columns would carry.
_SUPPORTED: Final = frozenset({"mid_air", "wide_span", "wide_roof"})

#: Bare patches are named from this area on, mm², or from this share of the surface on.
_PATCH_MM2: Final = 100.0
_PATCH_SHARE: Final = 0.01


def repairs(mesh: Mesh) -> list[str]:
    """Sentences about what was repaired in a mesh; empty for a clean one."""
    return _sentences(mesh.report, _REPAIRS)


def warnings(mesh: Mesh) -> list[str]:
    """Sentences about how a mesh was read, and about its faults that stay."""
    return [*mesh.notes, *_sentences(mesh.report, _WARNINGS)]


def units_meant(size_mm: tuple[float, float, float], placement: Mapping[str, Any]) -> list[str]:
    """Ask for the unit of a model that is too small to be meant in mm; empty for any other.

    Parameters
    ----------
    size_mm
        Its extent along x, y, z.
    placement
        How it was placed: what `wireprint.mesh.load_mesh` takes. Whoever says how large the model
        is has thought of its unit.
    """
    longest_mm = max(size_mm)
    said = any(placement.get(name, usual) != usual for name, usual in _AS_IN_THE_FILE.items())
    if said or longest_mm >= _SMALL_MM:
        return []
    low_mm, high_mm = _USUAL_MM
    units = [
        name
        for name, unit_mm in UNITS_MM.items()
        if unit_mm > 1 and low_mm <= longest_mm * unit_mm <= high_mm
    ]
    if not units:
        if longest_mm >= _TINY_MM:
            return []
        return [f"it measures {longest_mm:.3g} mm at most; say how large it is by --height"]
    ways_out = " or ".join(f"--units {name}" for name in units)
    return [f"it measures {longest_mm:.3g} mm at most; is that its unit? Try {ways_out}"]


def slowed(settings: Settings) -> list[str]:
    """Sentences about speeds that the hot end does not reach, for want of molten filament."""
    extruder, speeds = settings.printer.extruder, settings.printer.speeds
    asked = {"print_mm_s": speeds.print_mm_s, "first_layer_mm_s": speeds.first_layer_mm_s}
    return [
        f"speeds.{name} {value:g} is more than the hot end melts "
        f"(extruder.max_flow_mm3_s {extruder.max_flow_mm3_s:g}): printed at "
        f"{getattr(settings, name):.1f} mm/s"
        for name, value in asked.items()
        if getattr(settings, name) < value
    ]


def led_out(certificate: Certificate, settings: Settings) -> str | None:
    """Say which sequence of the printer's profile leads the head off the bed; None if neither does.

    No size of the model would help. What is printed bears labels, and the sequences stand before
    and behind all of that.
    """
    core = certificate.core
    features = core.features
    labelled = [
        line
        for line, feature in zip(core.strand_lines, core.strand_features, strict=True)
        if features[feature]
    ]
    if not labelled:
        return None
    outside = [breach for breach in certificate.out_of_bounds if breach.bound == "volume"]
    if any(labelled[0] <= breach.line <= labelled[-1] for breach in outside):
        # The print itself leaves it; the sequences may only begin or end out there.
        return None
    if not outside:
        return None
    key = "gcode.start" if outside[0].line < labelled[0] else "gcode.end"
    return (
        f"{key} of the printer {settings.printer.name} leads the head out of its build volume "
        f"({settings.printer.bed}): {outside[0]}; change {key} in the printer's profile"
    )


def breaches(certificate: Certificate, settings: Settings) -> str:
    """Say which rules a file breaks, how often, and where first."""
    outside = [b.value for b in certificate.out_of_bounds if b.bound == "volume"]
    if outside:
        return (
            f"the print leaves the build volume of {settings.printer.name} "
            f"({settings.printer.bed}) by {max(outside):.1f} mm; scale it or change the printer"
        )
    found = {name: breaches for name, breaches in certificate.breaches().items() if breaches}
    counts = ", ".join(f"{name.replace('_', ' ')}: {len(list_)}" for name, list_ in found.items())
    first = min((breach for list_ in found.values() for breach in list_), key=lambda b: b.line)
    return f"the print would break the rules ({counts}); first in line {first.line}, {first}"


def unprinted(
    planned: Sequence[LeftOut], fidelity: Fidelity | None, settings: Settings
) -> list[Unprinted]:
    """List the parts of the surface that are not printed, bottom up, with what would help.

    Parameters
    ----------
    planned
        What planning left out, as `Wireframe.unprinted` has it.
    fidelity
        What the certificate measured; None: planning is believed.
    settings
        What the print was made with.

    Notes
    -----
    Listed is every patch that the certificate finds bare and that has 1 cm² or 1 % of the surface.
    Planning knows why, where what it left out lies in a patch; what else it left out is listed
    besides, though strands pass so near that the certificate does not miss it.
    """
    rest = list(planned)
    listed = [] if fidelity is None else _patches(fidelity, rest, settings)
    listed += [
        Unprinted(
            reason=reason,
            low_mm=low,
            high_mm=high,
            area_mm2=area,
            place_mm=place,
            size_mm=None,
            help=_help(reason, settings),
        )
        for reason, low, high, area, place in rest
    ]
    return sorted(listed, key=lambda part: (part["low_mm"], part["high_mm"]))


def listed_from_mm2(fidelity: Fidelity) -> float:
    """Return from which area on a bare patch is listed, mm²."""
    return min(_PATCH_MM2, _PATCH_SHARE * fidelity.area_mm2)


def _patches(fidelity: Fidelity, planned: list[LeftOut], settings: Settings) -> list[Unprinted]:
    """List the bare patches that are large enough; take out of `planned` what lies in them."""
    least_mm2 = listed_from_mm2(fidelity)
    listed = []
    for patch in fidelity.uncovered:
        if patch.area_mm2 < least_mm2:
            break
        known = [part for part in planned if _lies_in(part, patch, fidelity.within_mm)]
        planned[:] = [part for part in planned if part not in known]
        reason = max(known, key=lambda part: part[3])[0] if known else "not_covered"
        (low_x, low_y, low_z), (high_x, high_y, high_z) = patch.low_mm, patch.high_mm
        listed.append(
            Unprinted(
                reason=reason,
                low_mm=low_z,
                high_mm=high_z,
                area_mm2=patch.area_mm2,
                place_mm=patch.centroid_mm,
                size_mm=(high_x - low_x, high_y - low_y, high_z - low_z),
                help=_help(reason, settings),
            )
        )
    return listed


def _lies_in(part: LeftOut, patch: Patch, within_mm: float) -> bool:
    """Whether something that planning left out is what a bare patch shows.

    Planning tells a point of the rim, and around the rim surface may be covered.
    """
    _, low, high, _, (x, y, _) = part
    box = list(zip((x, y), patch.low_mm, patch.high_mm, strict=False))
    rim = within_mm + max(most - least for _, least, most in box) / 2
    beside = all(least - rim <= at <= most + rim for at, least, most in box)
    return beside and low - within_mm <= patch.high_mm[2] and patch.low_mm[2] <= high + within_mm


def _help(reason: str, settings: Settings) -> str:
    if reason in _SUPPORTED and settings.wire.supports != "wire":
        return "print it with --supports wire"
    return _HELP.get(reason, "")


def _sentences(counts: Mapping[str, int], wordings: Mapping[str, str]) -> list[str]:
    return [f"{text}: {counts[name]}" for name, text in wordings.items() if counts[name]]

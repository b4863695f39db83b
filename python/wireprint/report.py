"""What a mesh's repair and a print's omissions mean, in words."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Final, TypedDict

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Fidelity
    from wireprint.hybrid.prove import Proved
    from wireprint.hybrid.runs import Section
    from wireprint.regions import Region
    from wireprint.settings import Settings

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


class Unprinted(TypedDict):
    """A part of the surface that is not printed."""

    reason: str
    low_mm: float
    high_mm: float
    area_mm2: float
    place_mm: tuple[float, float, float]
    help: str


class Marked(TypedDict):
    """What is marked on a model."""

    #: How many marks there are of each kind of shape, and how many of them erase.
    kinds: dict[str, int]
    erase: int
    #: Surface that is marked in the end, and its share (0–1).
    area_mm2: float
    share: float


class Run(TypedDict):
    """A run of zigzag sections that is marked."""

    slab: int
    contour: int
    from_mm: float
    to_mm: float
    area_mm2: float
    place_mm: tuple[float, float, float]


class DroppedRun(Run):
    """A run that is marked, but printed as wire."""

    reason: str
    help: str


class HollowPart(TypedDict):
    """What of a region's inside is not filled."""

    reason: str
    volume_mm3: float
    low_mm: float
    high_mm: float
    help: str


class Regions(TypedDict):
    """What of the marked surface is printed as layers."""

    layer_wise_mm: float
    area_mm2: float
    runs: list[Run]
    dropped: list[DroppedRun]
    filled_mm3: float
    hollow: list[HollowPart]
    rounds: int


#: Why something is not printed → what would help.
_HELP: Final = {
    "not_covered": "turn the model (--orient auto), or set lower slabs (--slab-min)",
    "mid_air": "turn the model, or print it with --supports wire",
    "no_foothold": "print it larger, with a smaller nozzle, or with lower slabs",
    "wide_span": "turn the model, or raise wire.span_limit_mm if your material holds it",
    "wide_roof": "turn the model so that the face stands upright",
}

#: Why a marked run stays wire → what would help.
_REGION_HELP: Final = {
    "short_run": "mark more around it, or lower regions.shortest_run",
    "mid_air": "turn the model so that the part stands on something, or mark what is below it too",
    "in_the_way": "mark the wire near to it too, or print with lower slabs",
    "overhang": "turn the model, or mark less of what hangs over",
    "wide_bridge": "raise regions.infill_density, or mark what is below it too",
    "no_room": "turn or move the model away from the edge of the bed",
    "unproved": "mark less, or something simpler",
    "beside_wire": "mark the walls near to it too, or print with lower slabs",
    "over_hollow": "mark what is below it too, or let it reach from wall to wall",
}


#: A print that leaves more than this share of the surface bare has its bare patches named …
_BARE_SHARE: Final = 0.05
#: … if they are larger than this share of it.
_PATCH_SHARE: Final = 0.01


def repairs(mesh: Mesh) -> list[str]:
    """Sentences about what was repaired in a mesh; empty for a clean one."""
    return _sentences(mesh.report, _REPAIRS)


def warnings(mesh: Mesh) -> list[str]:
    """Sentences about how a mesh was read, and about its faults that stay."""
    return [*mesh.notes, *_sentences(mesh.report, _WARNINGS)]


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


def unprinted(wireframe: Wireframe) -> list[Unprinted]:
    """List the parts of the surface that are not printed, bottom up, with what would help."""
    return [
        {
            "reason": reason,
            "low_mm": low,
            "high_mm": high,
            "area_mm2": area,
            "place_mm": place,
            "help": _HELP.get(reason, ""),
        }
        for reason, low, high, area, place in wireframe.unprinted
    ]


def regions(proved: Proved) -> Regions:
    """Tell what of the marked surface is printed as layers, and what is not and why."""
    return {
        "layer_wise_mm": proved.layer_wise_mm,
        "area_mm2": sum(run.area_mm2 for run in proved.plan.sections),
        "runs": [_run(run) for run in proved.plan.sections],
        "dropped": [
            {**_run(run), "reason": reason, "help": _REGION_HELP[reason]}
            for run, reason in proved.plan.runs.dropped
        ],
        "filled_mm3": proved.plan.filled_mm3,
        "hollow": [
            {
                "reason": part.reason,
                "volume_mm3": part.volume_mm3,
                "low_mm": part.low_mm,
                "high_mm": part.high_mm,
                "help": _REGION_HELP[part.reason],
            }
            for part in proved.plan.left_hollow()
        ],
        "rounds": proved.rounds,
    }


def _run(run: Section) -> Run:
    return {
        "slab": run.slab,
        "contour": run.contour,
        "from_mm": run.from_mm,
        "to_mm": run.to_mm,
        "area_mm2": run.area_mm2,
        "place_mm": run.place_mm,
    }


def uncovered(fidelity: Fidelity, area_mm2: float) -> list[Unprinted]:
    """List the patches that the certificate finds bare, where they come to more than a little.

    Parameters
    ----------
    fidelity
        What the certificate measured.
    area_mm2
        The model's surface.
    """
    if 1.0 - fidelity.coverage <= _BARE_SHARE:
        return []
    return [
        {
            "reason": "not_covered",
            "low_mm": patch.low_mm[2],
            "high_mm": patch.high_mm[2],
            "area_mm2": patch.area_mm2,
            "place_mm": patch.centroid_mm,
            "help": _HELP["not_covered"],
        }
        for patch in fidelity.uncovered
        if patch.area_mm2 > _PATCH_SHARE * area_mm2
    ]


def _sentences(counts: Mapping[str, int], wordings: Mapping[str, str]) -> list[str]:
    return [f"{text}: {counts[name]}" for name, text in wordings.items() if counts[name]]


def marks(mesh: Mesh, region: Region) -> Marked | None:
    """Tell what is marked on a model; None where nothing is."""
    if not region:
        return None
    from wireprint.regions.surface import marked_surface

    surface = marked_surface(mesh, region)
    return Marked(
        kinds=dict(Counter(getattr(mark.shape, "kind", "predicate") for mark in region.marks)),
        erase=sum(mark.erase for mark in region.marks),
        area_mm2=surface.marked_mm2,
        share=surface.marked_mm2 / surface.area_mm2,
    )

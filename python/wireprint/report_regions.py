"""What is marked on a model, and what of it is printed as layers, in words."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Final, TypedDict

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.hybrid.prove import Proved
    from wireprint.hybrid.runs import Section
    from wireprint.regions import Region


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


def marks(mesh: Mesh, region: Region) -> Marked | None:
    """Tell what is marked on a model; None where nothing is."""
    if not region:
        return None
    from wireprint.regions.surface import marked_area

    marked_mm2, area_mm2 = marked_area(mesh, region)
    return Marked(
        kinds=dict(Counter(getattr(mark.shape, "kind", "predicate") for mark in region.marks)),
        erase=sum(mark.erase for mark in region.marks),
        area_mm2=marked_mm2,
        share=marked_mm2 / area_mm2,
    )

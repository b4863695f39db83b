"""What a mesh's repair and a print's omissions mean, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypedDict

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint._core import Mesh, Wireframe

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


#: Why something is not printed → what would help.
_HELP: Final = {
    "mid_air": "turn the model, or print it with --supports wire",
    "no_foothold": "print it larger, with a smaller nozzle, or with lower slabs",
    "wide_span": "turn the model, or raise wire.span_limit_mm if your material holds it",
    "wide_roof": "turn the model so that the face stands upright",
}


def repairs(mesh: Mesh) -> list[str]:
    """Sentences about what was repaired in a mesh; empty for a clean one."""
    return _sentences(mesh.report, _REPAIRS)


def warnings(mesh: Mesh) -> list[str]:
    """Sentences about faults of a mesh that stay."""
    return _sentences(mesh.report, _WARNINGS)


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


def _sentences(counts: Mapping[str, int], wordings: Mapping[str, str]) -> list[str]:
    return [f"{text}: {counts[name]}" for name, text in wordings.items() if counts[name]]

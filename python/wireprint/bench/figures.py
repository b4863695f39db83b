"""The figures of one model that make up a row."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint.pipeline import make

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.bench.task import Row
    from wireprint.pipeline import WirePrint
    from wireprint.settings import Settings


def certificate(mesh: Mesh, settings: Settings, row: Row) -> None:
    """Fill in what the wire print is like, and whether it keeps the rules."""
    row |= sizes(mesh)
    row |= wire_print(make(mesh, settings))


def comparison(mesh: Mesh, settings: Settings, row: Row) -> None:
    """Fill in the certificate, and time and filament under every condition."""
    from wireprint.comparison import compare

    certificate(mesh, settings, row)
    for one in compare(mesh, settings).conditions:
        prefix = one.condition.replace("-", "_")
        row[f"{prefix}_time_s"] = one.print_time_s
        row[f"{prefix}_filament_mm"] = one.filament_mm
        row[f"{prefix}_filament_g"] = one.filament_g
        row[f"{prefix}_speedup"] = one.speedup
        row[f"{prefix}_compute_s"] = one.compute_s


def sizes(mesh: Mesh) -> dict[str, Any]:
    """Return what is known of a model before anything is made of it."""
    size_x, size_y, size_z = mesh.size_mm
    return {
        "size_x_mm": size_x,
        "size_y_mm": size_y,
        "size_z_mm": size_z,
        "triangles": len(mesh.faces),
    }


def wire_print(made: WirePrint) -> dict[str, Any]:
    """Return the figures and the verdict of a wire print that was judged."""
    told = made.figures()
    return {
        "certified": told["certified"],
        **told["breaches"],
        "coverage": told["coverage"],
        "deviation_mm": told["deviation_mm"],
        "chord_deviation_mm": told["chord_deviation_mm"],
        "unprinted_parts": len(told["unprinted"]),
        "unprinted_mm2": sum((part["area_mm2"] for part in told["unprinted"]), 0.0),
        "print_time_s": told["print_time_s"],
        "strand_mm": told["strand_mm"],
        "support_mm": support_mm(made),
        "filament_g": told["filament_g"],
        "plan_s": sum(told["timings_s"].values()),
    }


def support_mm(made: WirePrint) -> float:
    """Length of the strands that only support others, mm."""
    import numpy as np

    from wireprint.gcode.flavors import KINDS

    ends = made.wireframe.strands[made.wireframe.strand_kinds == KINDS.index("support")]
    return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())

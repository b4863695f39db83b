"""The figures of one model that make up a row."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint._core import UnprintableError, WireprintError
from wireprint.comparison import CONDITIONS, HYBRID, WIREPRINT
from wireprint.pipeline import make

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.bench.task import Row
    from wireprint.model import Model
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint


def certificate(model: Model, settings: Settings, row: Row) -> None:
    """Fill in what the plain wire print is like, and whether it keeps the rules."""
    _certified(model, settings, row)


def comparison(model: Model, settings: Settings, row: Row) -> None:
    """Fill in the certificate, and time and filament under every condition.

    Raises
    ------
    UnprintableError
        Some conditions failed; the cells of the others are filled in.
    """
    made = _certified(model, settings, row)
    conditions = (*CONDITIONS, HYBRID) if model.region else CONDITIONS
    # One at a time: what a layer slicer cannot print may still be worth a wire print.
    failures = [
        f"{name}: {reason}"
        for name in conditions
        if (reason := _condition(name, model, settings, made, row)) is not None
    ]
    if failures:
        raise UnprintableError("; ".join(failures))


def column(condition: str, figure: str) -> str:
    """Name of the column of a condition's figure."""
    return f"{condition.replace('-', '_')}_{figure}"


def _certified(model: Model, settings: Settings, row: Row) -> WirePrint:
    row |= sizes(model.mesh)
    made = make(model.mesh, settings, partial=True)
    row |= wire_print(made)
    return made


def _condition(
    name: str, model: Model, settings: Settings, made: WirePrint, row: Row
) -> str | None:
    """Fill in one condition; return why it fails, if it does."""
    from wireprint import comparison

    try:
        if name == WIREPRINT:
            found = comparison.condition_of(made)
        else:
            [found] = comparison.compare(model.mesh, settings, [name], model.region).conditions
    except Exception as error:
        return str(error) if isinstance(error, WireprintError) else repr(error)
    row[column(name, "time_s")] = found.print_time_s
    row[column(name, "filament_mm")] = found.filament_mm
    row[column(name, "filament_g")] = found.filament_g
    row[column(name, "compute_s")] = found.compute_s
    base_s = row.get(column(CONDITIONS[0], "time_s"))
    if base_s is not None:
        row[column(name, "speedup")] = base_s / found.print_time_s
    return None


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
        "support_mm": made.wireframe.support_mm,
        "filament_g": told["filament_g"],
        "plan_s": sum(told["timings_s"].values()),
    }

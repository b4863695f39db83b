"""How long a model takes as a wire print, and how long in layers: the paper's figure 16."""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import MemoryLimitError, ModelError, SettingError, UnprintableError
from wireprint.duration import duration
from wireprint.filament import Filament
from wireprint.gcode import document

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from wireprint._core import Mesh, Toolpath, WireprintError
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint


@dataclass(frozen=True, slots=True)
class Condition:
    """One way to print a model."""

    #: One of `CONDITIONS`, or `HYBRID`.
    condition: str
    #: As the printer's firmware would take; heating and homing aside, s.
    print_time_s: float
    #: Filament used, mm.
    filament_mm: float
    #: Its weight, g.
    filament_g: float
    #: How many times faster than the first condition.
    speedup: float
    #: Time to compute the print and its estimate, s.
    compute_s: float


@dataclass(frozen=True, slots=True, repr=False)
class Comparison:
    """A model printed in several ways."""

    #: In the order of `CONDITIONS`, `HYBRID` last.
    conditions: tuple[Condition, ...]
    #: Why the other ones failed, by name.
    failures: dict[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        """Say how long each takes."""
        told = ", ".join(f"{one.condition} {duration(one.print_time_s)}" for one in self.conditions)
        failed = f"; failed: {', '.join(self.failures)}" if self.failures else ""
        return f"<Comparison {told}{failed}>"

    def to_dict(self) -> dict[str, Any]:
        """Return everything as values that JSON knows.

        Returns
        -------
        dict
            ``conditions`` and ``failed``.
        """
        return {
            "conditions": [asdict(condition) for condition in self.conditions],
            "failed": [
                {"condition": name, "error": reason} for name, reason in self.failures.items()
            ],
        }


def compare(
    mesh: Mesh,
    settings: Settings,
    conditions: Iterable[str] | None = None,
    region: Region | None = None,
) -> Comparison:
    """Print a model in every way and tell the times.

    Parameters
    ----------
    mesh
        The model, placed: its lowest point at z = 0.
    settings
        Printer, material, way of wiring; ``settings.layerwise`` for the other conditions.
    conditions
        Which of `CONDITIONS` and `HYBRID`; all by default. The first of them that can be printed is
        the measure of speed-up.
    region
        What is marked, in the mesh's coordinates. Only then there is `HYBRID`: the wire print with
        layers there.

    Returns
    -------
    Comparison

    Raises
    ------
    SettingError
        A condition is unknown, or is `HYBRID` where nothing is marked.
    ModelError, UnprintableError
        The model cannot be printed in any of the ways.
    """
    makers = _MAKERS
    if region:
        makers = _MAKERS | {HYBRID: partial(_hybrid, region)}
    wanted = set(makers if conditions is None else conditions)
    if unknown := sorted(wanted - set(makers)):
        why = "nothing is marked" if unknown[0] == HYBRID else "it is no condition"
        msg = f"condition {unknown[0]!r}: {why}; there are {', '.join(makers)}"
        raise SettingError(msg)
    found: list[Condition] = []
    failures: dict[str, WireprintError] = {}
    for name in (name for name in makers if name in wanted):
        begin = time.perf_counter()
        try:
            machine, path = makers[name](mesh, settings)
        except (ModelError, UnprintableError, MemoryLimitError) as error:
            failures[name] = error
            continue
        text = document.body(path, machine, document.dated(None), wire=name in _WIRED)
        estimate = document.timing(text, machine)
        base_s = found[0].print_time_s if found else estimate.total_s
        found.append(
            Condition(
                condition=name,
                print_time_s=estimate.total_s,
                filament_mm=estimate.filament_mm,
                filament_g=Filament.of(machine).grams(estimate.filament_mm),
                speedup=base_s / estimate.total_s,
                compute_s=time.perf_counter() - begin,
            )
        )
    if failures and not found:
        raise next(iter(failures.values()))
    return Comparison(tuple(found), {name: str(error) for name, error in failures.items()})


def condition_of(made: WirePrint) -> Condition:
    """Return the condition `WIREPRINT` of a model that was made already."""
    filament_mm, checked_s = made.estimate.filament_mm, made.timings_s.get("check", 0.0)
    return Condition(
        condition=WIREPRINT,
        print_time_s=made.estimate.total_s,
        filament_mm=filament_mm,
        filament_g=Filament.of(made.settings).grams(filament_mm),
        speedup=1.0,
        compute_s=sum(made.timings_s.values()) - checked_s,
    )


def _solid(mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.layerwise.areas import areas
    from wireprint.layerwise.printing import layered
    from wireprint.layerwise.recipe import Recipe

    recipe = Recipe.of(settings.layerwise, settings.printer)
    return settings, layered(areas(mesh, recipe.layer_mm, recipe.resolution_mm), recipe)


def _frame(mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.layerwise.frame import areas
    from wireprint.layerwise.printing import layered
    from wireprint.layerwise.recipe import Recipe

    recipe = Recipe.of(settings.layerwise, settings.printer)
    return settings, layered(areas(mesh, settings.layerwise.frame, recipe.layer_mm), recipe)


def _vase(mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.layerwise.areas import areas
    from wireprint.layerwise.recipe import Recipe
    from wireprint.layerwise.vase import spiral

    recipe = Recipe.of(settings.layerwise, settings.printer)
    return settings, spiral(areas(mesh, recipe.layer_mm, recipe.resolution_mm), recipe)


def _fast(mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.layerwise.areas import areas
    from wireprint.layerwise.printing import layered
    from wireprint.layerwise.recipe import Recipe, on_fast_printer

    machine = on_fast_printer(settings)
    recipe = Recipe.of(settings.layerwise.fast, machine.printer)
    return machine, layered(areas(mesh, recipe.layer_mm, recipe.resolution_mm), recipe)


def _wire(mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.fitting import fitted
    from wireprint.stages import toolpath, wireframe

    return settings, toolpath(wireframe(fitted(mesh, settings).mesh, settings), settings)


def _hybrid(region: Region, mesh: Mesh, settings: Settings) -> tuple[Settings, Toolpath]:
    from wireprint.fitting import fitted
    from wireprint.hybrid.motion import motion
    from wireprint.hybrid.prove import proved
    from wireprint.hybrid.sketch import Sketch

    place = fitted(mesh, settings)
    moved = region.transformed(motion(mesh, place.mesh, (0.0, 0.0, place.turn_deg)))
    return settings, proved(Sketch.of(place.mesh, settings), moved).toolpath


#: What `wireprint.make` makes.
WIREPRINT: Final = "wireprint"

_MAKERS: Final[dict[str, Callable[[Mesh, Settings], tuple[Settings, Toolpath]]]] = {
    "layerwise-solid": _solid,
    "layerwise-wireframe": _frame,
    WIREPRINT: _wire,
    "vase": _vase,
    "layerwise-fast": _fast,
}

#: A wire print with layers where something is marked.
HYBRID: Final = "hybrid"
#: Conditions of which at least a part is wire.
_WIRED: Final = frozenset({"wireprint", HYBRID})
#: Names of the conditions of any model, in order.
CONDITIONS: Final[tuple[str, ...]] = tuple(_MAKERS)

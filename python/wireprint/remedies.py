"""Other ways to print a model that one way leaves bare, the least trouble first."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint.settings import Settings

#: A common nozzle finer than the paper's, mm.
_FINE_NOZZLE_MM: Final = 0.4
#: By how much limits of what hangs are raised.
_FARTHER: Final = 2.0


@dataclass(frozen=True)
class Remedy:
    """A change that may help."""

    #: The command's options for it.
    options: str
    #: What is to be minded; empty: nothing.
    proviso: str
    settings: Settings
    #: Whether the model is turned into its best pose.
    orient: bool = False

    def __str__(self) -> str:
        """Tell the options, and what is to be minded."""
        return f"{self.options}{f', {self.proviso}' if self.proviso else ''}"


def remedies(settings: Settings) -> Iterator[Remedy]:
    """Give what differs from the settings and may leave less bare."""
    for options, override, proviso in _changes(settings):
        try:
            changed = settings.but(overrides=[override])
        except SettingError:
            continue
        yield Remedy(options, proviso, changed)
    yield Remedy("--orient auto", "", settings, orient=True)


def _changes(settings: Settings) -> Iterator[tuple[str, str, str]]:
    wire, nozzle_mm = settings.wire, settings.printer.head.nozzle_mm
    if wire.supports != "wire":
        yield "--supports wire", "wire.supports=wire", ""
    if not wire.caps:
        yield "--caps", "wire.caps=true", ""
    if wire.pattern != "zigzag":
        yield "--pattern zigzag", "wire.pattern=zigzag", ""
    if settings.slab_min_mm > nozzle_mm:
        yield f"--slab-min {nozzle_mm:g}", f"wire.slab_min_mm={nozzle_mm:g}", ""
    if nozzle_mm > _FINE_NOZZLE_MM:
        change = f"head.nozzle_mm={_FINE_NOZZLE_MM:g}"
        yield f"--set {change}", change, "with such a nozzle"
    for limit in ("span_limit_mm", "free_end_limit_mm"):
        change = f"wire.{limit}={_FARTHER * getattr(wire, limit):g}"
        yield f"--set {change}", change, "if your material holds it"

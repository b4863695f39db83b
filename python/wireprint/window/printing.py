"""A sketch's print, told in the order in which people wait for it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint import report, report_regions
from wireprint.clock import Clock
from wireprint.pipeline import make
from wireprint.wholeness import is_whole, shortfall
from wireprint.window.answer import encoded
from wireprint.window.drawing import drawn, hanging

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from datetime import datetime

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.hybrid.sketch import Sketch
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint

#: Figures of a print that the page does not show.
_UNSHOWN = ("orientation", "size_mm", "repaired", "regions", "timings_s")


class Printing:
    """A print that was made and judged.

    Parameters
    ----------
    mesh
        The model.
    settings, region
        What it is printed with, and what of it as layers.
    date
        Written into the file.
    on_stage
        Called before each stage; it may raise to give up.
    kept
        `sketch` of an earlier print of the same mesh with the same settings.

    Raises
    ------
    UnprintableError, ModelError
        As `wireprint.make`, but for prints that leave much bare.
    """

    def __init__(
        self,
        mesh: Mesh,
        settings: Settings,
        region: Region,
        date: datetime,
        on_stage: Callable[[str], None],
        kept: Sketch | None = None,
    ) -> None:
        begin = time.perf_counter()
        self._mesh, self._region, self._on_stage = mesh, region, on_stage
        self._made = make(
            mesh,
            settings,
            region or None,
            date=date,
            clock=Clock(on_stage, on_stage),
            compare=False,
            partial=True,
            kept=kept,
        )
        self._made_s = time.perf_counter() - begin
        self.gcode = self._made.gcode
        self.sketch = self._made.sketch

    @property
    def refused(self) -> str:
        """Why `slice` would not write it; empty: it would."""
        certificate, settings = self._certificate, self._made.settings
        if not certificate.ok:
            return report.breaches(certificate, settings)
        return "" if is_whole(certificate, settings) else shortfall(certificate, settings)

    def events(self) -> Iterator[tuple[str, bytes]]:
        """Yield the print, then what is marked, then how faithful the print is."""
        head, arrays = drawn(self._made, self._mesh)
        yield (
            "print",
            encoded(
                {
                    "event": "print",
                    "figures": _shown(self._made),
                    "regions": _regions(self._made),
                    "refused": self.refused,
                    "made_s": self._made_s,
                    **head,
                },
                arrays,
            ),
        )
        self._on_stage("paint")
        yield "paint", encoded({"event": "paint"}, {"corners": self._painted()})
        self._on_stage("rest")
        yield "rest", encoded(self._rest(), hanging(self._made, head, arrays["strands"]))

    def prepare(self) -> None:
        """Make what the next stroke will ask for, while nobody waits for it."""
        for part in ("samples", "strips", "level", "areas", "touchable"):
            self._on_stage(part)
            getattr(self.sketch, part)

    @property
    def _certificate(self) -> Certificate:
        assert self._made.certificate is not None, "it was judged"  # noqa: S101
        return self._made.certificate

    def _painted(self) -> np.ndarray[Any, np.dtype[np.float32]]:
        """Return the triangles that are marked, in the given model's frame."""
        if not self._region:
            return np.zeros((0, 3, 3), "<f4")
        from wireprint.regions.surface import marked_surface

        surface = marked_surface(self._mesh, self._region)
        return surface.corners[surface.marked].astype("<f4")

    def _rest(self) -> dict[str, Any]:
        made = self._made
        fidelity = self._certificate.compared(made.mesh).fidelity
        assert fidelity is not None, "it was compared with its model"  # noqa: S101
        return {
            "event": "rest",
            "deviation_mm": fidelity.deviation_mm,
            "chord_deviation_mm": fidelity.chord_deviation_mm,
        }


def _shown(made: WirePrint) -> dict[str, Any]:
    return {name: value for name, value in made.figures().items() if name not in _UNSHOWN}


def _regions(made: WirePrint) -> dict[str, Any] | None:
    """Tell what of the marks is not printed as layers, and how much is."""
    if made.regions is None:
        return None
    found = report_regions.regions(made.regions)
    return {
        "area_mm2": found["area_mm2"],
        "filled_mm3": found["filled_mm3"],
        "dropped": [
            {name: run[name] for name in ("reason", "help", "area_mm2", "place_mm")}
            for run in found["dropped"]
        ],
        "hollow": found["hollow"],
    }

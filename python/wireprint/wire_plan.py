"""A plan of a print; what is known of that is found out when it is first asked for."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from wireprint._core import WireprintError
from wireprint.gcode import document
from wireprint.mending import judged
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    from collections.abc import Iterable

    from wireprint._core import Mesh, Wireframe
    from wireprint.fidelity import Fidelity
    from wireprint.settings import Settings

#: Bands that `wire.low_slabs_mm` takes.
_MOST_BANDS: Final = 50


@dataclass(frozen=True)
class Plan:
    """A plan; what is known of its print is found out when it is first asked for."""

    mesh: Mesh
    settings: Settings
    wireframe: Wireframe

    @cached_property
    def fidelity(self) -> Fidelity | None:
        """What its print covers; None if it breaks the rules."""
        if not self.wireframe.strand_count:
            return None
        try:
            verdict = judged(self.wireframe, self.settings, mesh=self.mesh)
        except WireprintError:
            return None
        return verdict.fidelity if verdict.ok else None

    @cached_property
    def time_s(self) -> float:
        """What its print takes, s, but for heating and homing."""
        path = toolpath(self.wireframe, self.settings)
        return document.timing(document.commands(path, self.settings), self.settings).total_s

    @property
    def braced(self) -> float:
        """Diagonals per post."""
        return self.wireframe.diagonal_count / max(1, self.wireframe.post_count)

    def lower(self, bands: Iterable[tuple[float, float, float]]) -> Plan | None:
        """Plan anew with lower slabs besides those that it has; None where there is no plan.

        Parameters
        ----------
        bands
            From which height to which slabs are lower, and their greatest height, mm.
        """
        added = [[round(value, 3) for value in band] for band in bands]
        bands_mm = [*map(list, self.settings.wire.low_slabs_mm), *added][:_MOST_BANDS]
        try:
            settings = self.settings.but(overrides=[f"wire.low_slabs_mm={json.dumps(bands_mm)}"])
            return Plan(self.mesh, settings, wireframe(self.mesh, settings))
        except WireprintError:
            return None

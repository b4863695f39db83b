"""Time that stages take, and a place to give up between them."""

from __future__ import annotations

import time
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


@dataclass
class Clock:
    """Time that each stage takes to compute."""

    on_stage: Callable[[str], None] | None = None
    #: Called with the steps of long stages, too; like `on_stage` it may raise to give up.
    on_step: Callable[[str], None] | None = None
    timings_s: dict[str, float] = field(default_factory=dict)

    def step(self, name: str) -> None:
        """Announce a step of a stage."""
        if self.on_step is not None:
            self.on_step(name)

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Announce a stage and measure it, s."""
        if self.on_stage is not None:
            self.on_stage(name)
        begin = time.perf_counter()
        yield
        self.timings_s[name] = time.perf_counter() - begin

"""What stands on the bed before a print begins: earlier prints, and objects.

An earlier print is its own G-code, judged together with the new one, as one file that a printer
would be given. An object is nobody's print: it becomes strands so close that the head meets one
wherever it would meet the object's surface, and their own breaches are left aside.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from wireprint import _core
from wireprint._core import SettingError
from wireprint.alongside import lying_along
from wireprint.gcode.source import read
from wireprint.rules import rules_of
from wireprint.stopped import stopped_text, whole_lines

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint._core import Wireframe
    from wireprint.settings import Settings
    from wireprint.stopped import Stopped
    from wireprint.verdict import Point


@dataclass(frozen=True, repr=False)
class Standing:
    """What stands, in the machine's coordinates, mm."""

    #: Earlier prints, in their order: name and G-code, each as far as it was carried out.
    prints: tuple[tuple[str, bytes], ...] = ()
    #: Objects as strands in G-code; empty: none.
    objects: bytes = b""
    #: What both are read by.
    settings: Settings | None = None

    def __repr__(self) -> str:
        """Say what stands, not its text."""
        prints = ", ".join(name for name, _ in self.prints) or "no prints"
        return f"<Standing {prints}{', objects' if self.objects else ''}>"

    @cached_property
    def text(self) -> bytes:
        """All of it as one text."""
        return self.objects + b"".join(whole_lines(text) for _, text in self.prints)

    @cached_property
    def strands(self) -> npt.NDArray[np.float64]:
        """Every strand that stands, (N, 2, 3), mm."""
        if self.settings is None or not self.text:
            import numpy as np

            return np.empty((0, 2, 3))
        return _core.certify(self.text, rules_of(self.settings)).strands

    def about(self, origin_mm: Point) -> npt.NDArray[np.float64]:
        """Return the strands from another origin.

        Parameters
        ----------
        origin_mm
            Where its x = y = z = 0 lies in the machine's coordinates, (3,).

        Returns
        -------
        ndarray
            Both ends of each, (N, 2, 3), mm.
        """
        import numpy as np

        moved: npt.NDArray[np.float64] = self.strands - np.array(origin_mm)
        return moved

    @property
    def top_mm(self) -> float:
        """Height of it, mm; 0 where nothing stands."""
        return float(self.strands[..., 2].max(initial=0.0))

    @property
    def given(self) -> int:
        """Number of lines that nobody judges: those of objects."""
        return self.objects.count(b"\n")

    def place(self, line: int) -> tuple[str | None, int]:
        """Tell which print a line is of.

        Parameters
        ----------
        line
            Number of a line of all that stands and the new print behind it, from 1.

        Returns
        -------
        name : str or None
            Of the print; None: the new one.
        line : int
            The number there.
        """
        line -= self.given
        for name, text in self.prints:
            count = whole_lines(text).count(b"\n")
            if line <= count:
                return name, line
            line -= count
        return None, line

    def is_within(self, size_mm: Sequence[float], origin_mm: Point) -> bool:
        """Tell whether something stands where a model will.

        Parameters
        ----------
        size_mm
            The model's size along x, y and z.
        origin_mm
            Where the middle of its foot lies in the machine's coordinates, (3,).

        Returns
        -------
        bool
            Whether a strand ends within its box.
        """
        import numpy as np

        half = np.array([size_mm[0] / 2, size_mm[1] / 2])
        own = self.about(origin_mm).reshape(-1, 3)
        inside = (np.abs(own[:, :2]) <= half).all(axis=1) & (own[:, 2] <= size_mm[2])
        return bool((inside & (own[:, 2] >= 0)).any())

    def printed_of(self, frame: Wireframe, origin_mm: Point) -> list[int]:
        """Return the numbers of a print's strands that stand already, ascending.

        Parameters
        ----------
        frame
            The print.
        origin_mm
            Where its x = y = z = 0 lies in the machine's coordinates, (3,).

        Returns
        -------
        list of int
            Those that lie along what stands, end to end.
        """
        return lying_along(frame, origin_mm, self.strands)


def read_prints(
    sources: Sequence[str | os.PathLike[str]], settings: Settings, stopped: Stopped | None = None
) -> tuple[tuple[str, bytes], ...]:
    """Read earlier prints; the last one was stopped, where that is told.

    Parameters
    ----------
    sources
        Files, in the order in which they were printed.
    settings
        What they are read by.
    stopped
        Where the last one was stopped; None: it ran to its end.

    Returns
    -------
    tuple of (str, bytes)
        Name and G-code of each, as far as it was carried out.

    Raises
    ------
    GcodeError, OSError
        A file cannot be read.
    SettingError
        It was not stopped there.
    """
    found = []
    for number, source in enumerate(sources):
        text, _ = read(source)
        if stopped is not None and number == len(sources) - 1:
            try:
                text = stopped_text(text, stopped, settings)
            except SettingError as error:
                raise SettingError(f"{os.fspath(source)}: {error}") from None
        found.append((os.fspath(source), text))
    return tuple(found)

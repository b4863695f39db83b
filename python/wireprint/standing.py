"""What stands on the bed before a print begins: earlier prints, and objects.

An earlier print is its own G-code, judged together with the new one, as one file that a printer
would be given. An object is nobody's print: it becomes strands so close that the head meets one
wherever it would meet the object's surface, and their own breaches are left aside.
"""

from __future__ import annotations

import math
import os
import re
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import SettingError
from wireprint.gcode.flavors import FLAVORS
from wireprint.gcode.source import read
from wireprint.rules import rules_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint._core import Wireframe
    from wireprint.settings import Settings
    from wireprint.verdict import Point

#: A strand of the new print that lies along standing ones to this stands already, mm: G-code has
#: thousandths along each axis.
SAME_MM: Final = 0.002
_STOPPED: Final = re.compile(r"(line:)?(\d+(?:\.\d+)?)", re.ASCII)


@dataclass(frozen=True, slots=True)
class Stopped:
    """Where an earlier print was stopped."""

    #: Height that it had come to, mm, or the last line that was carried out; one is None.
    z_mm: float | None = None
    #: Number of the last line that was carried out, from 1.
    line: int | None = None

    @classmethod
    def read(cls, text: str) -> Stopped:
        """Read ``40.5`` (a height, mm) or ``line:1234``.

        Parameters
        ----------
        text
            As the command takes it.

        Returns
        -------
        Stopped
            The height or the line.

        Raises
        ------
        SettingError
            It is neither.
        """
        found = _STOPPED.fullmatch(text.strip())
        if found is None or (found[1] and "." in found[2]):
            raise SettingError(f"{text!r} is no height in mm, and no line, such as line:1234")
        return cls(line=int(found[2])) if found[1] else cls(z_mm=float(found[2]))


@dataclass(frozen=True)
class Standing:
    """What stands, in the machine's coordinates, mm."""

    #: Earlier prints, in their order: name and G-code, each as far as it was carried out.
    prints: tuple[tuple[str, bytes], ...] = ()
    #: Objects as strands in G-code; empty: none.
    objects: bytes = b""
    #: What both are read by.
    settings: Settings | None = None

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


def lying_along(frame: Wireframe, origin_mm: Point, strands: npt.NDArray[np.float64]) -> list[int]:
    """Return the numbers of a print's strands that lie along others from end to end, ascending.

    Parameters
    ----------
    frame, origin_mm
        See `Standing.printed_of`.
    strands
        The others, in the machine's coordinates, mm, shape (N, 2, 3).
    """
    import numpy as np

    own = frame.strands + np.array(origin_mm)
    if not len(own) or not len(strands):
        return []
    # A strand may have been written in two pieces, one with the air on: its ends are looked for,
    # and whatever leads from one to the other.
    cells = {_cell(end): True for ends in strands for end in ends}
    near = [all(_known(cells, end) for end in ends) for ends in own]
    return _along(own, np.flatnonzero(near), strands)


def stopped_text(text: bytes, at: Stopped, settings: Settings) -> bytes:
    """Return a text as far as it was carried out.

    Raises
    ------
    SettingError
        It was not stopped there: the text has no such line, or nothing lies below that height.
    """
    lines = text.splitlines(keepends=True)
    if at.line is not None:
        if not 0 < at.line <= len(lines):
            raise SettingError(f"it has no line {at.line}; the last one is {len(lines)}")
        # A head that was stopped stood there: what it had drawn out has set.
        stood = FLAVORS[settings.printer.gcode.flavor].dwell
        wait = stood.format(ms=math.ceil(1000 * settings.solidify_s)).encode()
        return whole_lines(b"".join(lines[: at.line])) + wait
    core = _core.certify(text, rules_of(settings))
    above = core.strands[..., 2].max(axis=1) > (at.z_mm or 0.0) + SAME_MM
    if not above.any():
        return text
    first = int(above.argmax())
    if first == 0:
        raise SettingError(f"nothing of it lies below {at.z_mm:g} mm")
    return b"".join(lines[: int(core.strand_lines[first - 1])]) + _dwells(
        lines, int(core.strand_lines[first - 1]), int(core.strand_lines[first])
    )


def _dwells(lines: Sequence[bytes], after: int, before: int) -> bytes:
    """Return the dwell that follows a line, where the head was left to stand there."""
    for line in lines[after : before - 1]:
        if line.startswith(b"G4"):
            return line
        if line.startswith((b"G0", b"G1")):
            break
    return b""


def whole_lines(text: bytes) -> bytes:
    """Return a text that ends with its last line."""
    return text if not text or text.endswith(b"\n") else text + b"\n"


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


def _cell(end: npt.NDArray[np.float64]) -> tuple[int, int, int]:
    x, y, z = (round(float(value) / SAME_MM) for value in end)
    return x, y, z


def _known(cells: dict[tuple[int, int, int], bool], end: npt.NDArray[np.float64]) -> bool:
    x, y, z = _cell(end)
    steps = (-1, 0, 1)
    return any((x + i, y + j, z + k) in cells for i in steps for j in steps for k in steps)


def _along(
    own: npt.NDArray[np.float64],
    numbers: npt.NDArray[np.int64],
    standing: npt.NDArray[np.float64],
) -> list[int]:
    """Return which of these strands lie along standing ones from end to end."""
    import numpy as np
    from shapely import STRtree, box

    low, high = standing.min(axis=1), standing.max(axis=1)
    tree = STRtree(box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
    found = []
    for number in numbers:
        start, end = own[number]
        run = end - start
        length = float(np.linalg.norm(run))
        if length == 0.0:
            continue
        a, b = np.minimum(start, end) - SAME_MM, np.maximum(start, end) + SAME_MM
        near = standing[tree.query(box(a[0], a[1], b[0], b[1]))]
        place = (near - start) @ run / length
        off = np.linalg.norm(near - start - place[..., None] * run / length, axis=-1)
        along = np.sort(place[(off <= SAME_MM).all(axis=1)], axis=1)
        at = 0.0
        for begin, finish in along[np.argsort(along[:, 0])]:
            if begin > at + SAME_MM:
                break
            at = max(at, float(finish))
        if at >= length - SAME_MM:
            found.append(int(number))
    return found

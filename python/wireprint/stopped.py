"""An earlier print that was stopped: where, and its G-code up to there."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import SettingError
from wireprint.alongside import SAME_MM
from wireprint.gcode.flavors import FLAVORS
from wireprint.rules import rules_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.settings import Settings

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

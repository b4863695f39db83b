"""Runs of wire as text: out of the other program's hands, and back into them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint._core import SettingError, UnprintableError
from wireprint.gcode import document, own_settings
from wireprint.gcode.flavors import FLAVORS
from wireprint.rules import rules_of
from wireprint.splicing.runs import led, runs_of

if TYPE_CHECKING:
    from wireprint._core import Toolpath
    from wireprint.settings import Settings
    from wireprint.splicing.runs import Run

#: A fan's command, and which fan it is for.
_FAN: Final = re.compile(rb"^(?:M106|M107)\b[^;\n]*", re.MULTILINE)
_OTHER_FAN: Final = re.compile(rb"\bP[1-9]")
_TYPE: Final = re.compile(rb"^;\s*TYPE:[^\n]*", re.MULTILINE)
_SHIFTED: Final = (
    "coordinates are relative, in inches, shifted or scaled there (G91, G20, G92, M200, M220, M221)"
)


@dataclass
class Layers:
    """G-code of another program, into which wire is put."""

    text: bytes
    name: str
    settings: Settings
    #: What it leaves to chance, in sentences, as it is found out.
    remarks: dict[str, None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Read it.

        Raises
        ------
        UnprintableError
            It prints nothing.
        """
        self._rules: dict[str, Any] = rules_of(self.settings)
        self._core = _core.certify(self.text, self._rules)
        if not len(self._core.strands):
            msg = f"{self.name}: it prints nothing that wire could be put between"
            raise UnprintableError(msg)
        self._lines = self.text.splitlines(keepends=True)

    def with_wire(self, path: Toolpath) -> tuple[bytes, tuple[float, ...]]:
        """Return the file with a wire's moves in it, and the heights at which they are, mm.

        Raises
        ------
        SettingError
            The file leaves the printer as no move of ours can be put there.
        """
        runs = list(runs_of(path, self._core, self._lines))
        parts, done, last = [], 0, int(self._core.strand_lines[-1])
        for run in runs:
            before = b"".join(self._lines[: run.line])
            parts += [*self._lines[done : run.line], _joined(before)]
            parts.append(self._written(path, run, before, more=run.line < last))
            done = run.line
        rest = self._lines[done:]
        if done >= last:
            parts.append(document.ending(path.top_mm, self.settings))
            rest = [line for line in rest if line.startswith(b";")]
        block = own_settings.block(self.settings).encode() + b"\n"
        heights = sorted({float(path.to[run.moves[0], 2]) for run in runs})
        return b"".join([*parts, block, *rest]), tuple(heights)

    def _written(self, path: Toolpath, run: Run, before: bytes, *, more: bool) -> bytes:
        """Return a run as text: out of the other program's hands, and back into them."""
        settings = self.settings
        at, extruder, relative, feed_mm_s, plain = _core.modes_after(before, self._rules)
        if not plain:
            raise SettingError(f"{self.name}, line {run.line}: {_SHIFTED}; wire cannot be put in")
        own = document.moves(led(path, run, at, more, settings), settings)
        modes = document.modes(settings)
        gentle, usual = document.bed_limits(settings)
        fan = _last(_FAN, before, lambda found: not _OTHER_FAN.search(found))
        air_off = FLAVORS[settings.printer.gcode.flavor].air(settings.printer.cooling)[1]
        blows = fan is not None and fan.startswith(b"M106") and bool(air_off)
        back = [f"G92 E{extruder:.5f}\n{'M83' if relative else 'M82'}\n".encode(), usual.encode()]
        if b"M106" in own or b"M107" in own or blows:
            back.append((fan or b"M107") + b"\n")
        for line in (*modes.splitlines(), *gentle.splitlines()):
            word = line.split()[0]
            if word.startswith(("G", "M82", "M83")):
                continue
            earlier = _last(re.compile(rb"^%s\b[^;\n]*" % word.encode(), re.MULTILINE), before)
            if earlier is not None:
                back.append(earlier + b"\n")
            elif line in modes:
                self.remarks[
                    f"{self.name} never says {word}: it stays as the wire has it, {line}"
                ] = None
        label = _last(_TYPE, before)
        parts = [
            b";WIPE_END\n" if before.rfind(b";WIPE_START") > before.rfind(b";WIPE_END") else b"",
            f"; wire of wireprint begins\n{modes}{gentle}{air_off if blows else ''}".encode(),
            own,
            *back,
            f"G1 F{max(1, round(feed_mm_s * 60))}\n".encode(),
            b"" if label is None else label + b"\n",
            b"; wire of wireprint ends\n",
        ]
        return b"".join(parts)


def _joined(before: bytes) -> bytes:
    return b"" if before.endswith(b"\n") or not before else b"\n"


def _last(pattern: re.Pattern[bytes], text: bytes, counts: Any = lambda _: True) -> bytes | None:
    """Return the last match that counts, without the blanks at its end."""
    found = None
    for match in pattern.finditer(text):
        if counts(match[0]):
            found = match[0].strip()
    return found

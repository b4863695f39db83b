"""Wire put into another program's G-code, slab by slab between its layers, and judged as one file.

Each slab of the wire is begun once all layers that end below it are printed, and before those that
lie above: so the wire stands on what is below it, and carries what comes after it. The other
program's own lines are kept as they are; between them stand runs of ours, which find and leave the
printer as those lines expect it. Where wire comes last, the printer's own end sequence ends the
print, for the other program's does not know how high it has become.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core, standing
from wireprint._core import SettingError, Toolpath, UnprintableError
from wireprint.certificate import check
from wireprint.fitting import fitted
from wireprint.gcode import document, own_settings
from wireprint.gcode.flavors import FLAVORS
from wireprint.rules import rules_of
from wireprint.splicing.runs import led, runs_of, without_priming
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings
    from wireprint.splicing.runs import Run
    from wireprint.verdict import Point

    Floats = npt.NDArray[np.float64]

#: A fan's command, and which fan it is for.
_FAN: Final = re.compile(rb"^(?:M106|M107)\b[^;\n]*", re.MULTILINE)
_OTHER_FAN: Final = re.compile(rb"\bP[1-9]")
_TYPE: Final = re.compile(rb"^;\s*TYPE:[^\n]*", re.MULTILINE)
_SHIFTED: Final = (
    "coordinates are relative, in inches, shifted or scaled there (G91, G20, G92, M200, M220, M221)"
)


@dataclass(frozen=True, repr=False)
class Spliced:
    """A file that two programs made, with the verdict on the whole of it."""

    settings: Settings
    mesh: Mesh
    wireframe: Wireframe
    gcode: bytes
    certificate: Certificate
    print_time_s: float
    #: Heights at which wire was put in, mm, ascending.
    heights_mm: tuple[float, ...]
    #: What the other program left to chance, in sentences.
    remarks: tuple[str, ...]

    def __repr__(self) -> str:
        """Say what it comes to."""
        verdict = "certified" if self.certificate.ok else "not certified"
        return f"<Spliced at {len(self.heights_mm)} heights, {self.print_time_s:.0f} s, {verdict}>"


def splice(
    mesh: Mesh,
    layers: bytes,
    settings: Settings,
    *,
    at_mm: Point = (0.0, 0.0, 0.0),
    name: str = "the other file",
) -> Spliced:
    """Print a model as wire within the G-code of another program.

    Parameters
    ----------
    mesh
        What is wired: supports, a core, or a part of its own.
    layers
        The G-code of the other program, for the same printer and nozzle.
    settings
        Printer and material; start and end are the other file's own.
    at_mm
        Where the middle of the model's foot stands, from the middle of the bed, mm; its z is the
        height of the layers that it stands on.
    name
        What the other file is called in errors.

    Returns
    -------
    Spliced
        The file and its certificate, which may well find breaches.

    Raises
    ------
    SettingError
        The other file leaves the printer as no move of ours can be put there.
    UnprintableError
        The model does not fit, nothing of it can be printed, or the other file prints nothing.
    """
    rules = rules_of(settings)
    core = _core.certify(layers, rules)
    if not len(core.strands):
        raise UnprintableError(f"{name}: it prints nothing that wire could be put between")
    lines = layers.splitlines(keepends=True)
    below = None
    if at_mm[2] > 0:
        text = standing.stopped_text(layers, standing.Stopped(z_mm=at_mm[2]), settings)
        below = standing.Standing(((name, text),), settings=settings)
    body = fitted(mesh, settings).mesh
    frame = wireframe(body, settings, None, below, at_mm)
    path = without_priming(toolpath(frame, settings, below, at_mm))
    if not len(path):
        raise UnprintableError("nothing of the model can be printed as wire")
    runs = list(runs_of(path, core, lines))
    parts, remarks, done = [], dict[str, None](), 0
    for run in runs:
        before = b"".join(lines[: run.line])
        more = run.line < int(core.strand_lines[-1])
        parts += [b"".join(lines[done : run.line]), _joined(before)]
        parts.append(_text(path, run, before, more, settings, rules, name, remarks))
        done = run.line
    rest = lines[done:]
    if done >= int(core.strand_lines[-1]):
        parts.append(document.ending(path.top_mm, settings))
        rest = [line for line in rest if line.startswith(b";")]
    block = own_settings.block(settings).encode() + b"\n"
    text = b"".join([*parts, block, *rest])
    certificate = check(text, settings, body, deviation=False, at_mm=at_mm)
    heights = sorted({float(path.to[run.moves[0], 2]) for run in runs})
    time_s = document.timing(text, settings).total_s
    return Spliced(settings, body, frame, text, certificate, time_s, tuple(heights), tuple(remarks))


def _joined(before: bytes) -> bytes:
    return b"" if before.endswith(b"\n") or not before else b"\n"


def _text(
    path: Toolpath,
    run: Run,
    before: bytes,
    more: bool,
    settings: Settings,
    rules: dict[str, Any],
    name: str,
    remarks: dict[str, None],
) -> bytes:
    """Return a run as text: out of the other program's hands, and back into them."""
    at, extruder, relative, feed_mm_s, plain = _core.modes_after(before, rules)
    if not plain:
        raise SettingError(f"{name}, line {run.line}: {_SHIFTED}; wire cannot be put in")
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
            remarks[f"{name} never says {word}: it stays as the wire has it, {line}"] = None
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


def _last(pattern: re.Pattern[bytes], text: bytes, counts: Any = lambda _: True) -> bytes | None:
    """Return the last match that counts, without the blanks at its end."""
    found = None
    for match in pattern.finditer(text):
        if counts(match[0]):
            found = match[0].strip()
    return found

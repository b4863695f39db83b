"""Whether a profile prints: a cube that is made with it, and judged."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint._core import SettingError
from wireprint.importing.sequences import PLAIN_END, plain_start
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.importing import Imported
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint

#: Lines of its sequences that are left out at most, one after the other; of longer ones, and of
#: those that cannot be judged so either, what heats, homes and levels is kept.
_MOST_LEFT_OUT = 12
_LONGEST = 60
#: Plastic that goes with any printer.
_MATERIAL = "pla"


def tried(found: Imported) -> tuple[Imported, Settings]:
    """Print a cube with a profile, and leave out of its sequences what cannot be judged.

    Parameters
    ----------
    found
        What was imported.

    Returns
    -------
    Imported
        The profile with which the print is certified.
    Settings
        What it was printed with.

    Raises
    ------
    SettingError
        The profile is no whole one, or what it prints breaks the rules.
    """
    from wireprint.certificate import check
    from wireprint.report import breaches, led_out

    if found.values["gcode"]["start"].count("\n") > _LONGEST:
        found = _plain(found)
    for trial in range(2 * _MOST_LEFT_OUT):
        if trial == _MOST_LEFT_OUT:
            found = _plain(found)
        made = _printed(found)
        certificate = check(made.gcode, made.settings)
        if certificate.ok:
            return found, made.settings
        first = min(
            (breach for list_ in certificate.breaches().values() for breach in list_),
            key=lambda breach: breach.line,
        )
        line = made.gcode.decode().split("\n")[first.line - 1]
        lesser = _without(found, line, str(first))
        if lesser is None:
            break
        found = lesser
    reason = led_out(certificate, made.settings) or breaches(certificate, made.settings)
    msg = (
        f"{', '.join(found.files)}: a 28 mm cube that is printed with it is not certified: "
        f"{reason}; "
        "name a printer that is like it by --like, or another --hotend"
    )
    raise SettingError(msg)


def _printed(found: Imported) -> WirePrint:
    from wireprint import examples
    from wireprint.mesh import load_mesh
    from wireprint.pipeline import make
    from wireprint.settings import Settings

    with tempfile.TemporaryDirectory() as folder:
        profile, model = Path(folder) / "imported.toml", Path(folder) / "cube.stl"
        profile.write_text(found.text(), encoding="utf-8")
        settings = Settings.load(str(profile), _MATERIAL)
        model.write_bytes(examples.stl("cube"))
        return make(load_mesh(model), settings, certify=False)


def _plain(found: Imported) -> Imported:
    """Return a profile with sequences of our own, for the firmware's own are beyond us."""
    gcode = dict(found.values["gcode"])
    gcode["start"], gcode["end"] = plain_start(gcode["start"]), PLAIN_END
    remark = "gcode.start and end are plain ones: those of the source do more than can be judged"
    values = found.values | {"gcode": gcode}
    kept = tuple(one for one in found.remarks if "gcode." not in one)
    return replace(found, values=values, remarks=(*kept, remark))


def _without(found: Imported, line: str, why: str) -> Imported | None:
    """Return a profile without a line of its start or end sequence; None if neither holds it."""
    gcode: dict[str, Any] = dict(found.values["gcode"])
    for key in ("start", "end"):
        lines = gcode[key].splitlines()
        if line in lines:
            gcode[key] = "\n".join(one for one in lines if one != line) + "\n"
            remark = f"gcode.{key} is without {one_line(line)}: {why}"
            values = found.values | {"gcode": gcode}
            return replace(found, values=values, remarks=(*found.remarks, remark))
    return None

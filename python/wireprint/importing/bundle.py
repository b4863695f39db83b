"""PrusaSlicer's and SuperSlicer's ``.ini`` files: one configuration, or a bundle of presets."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.importing.reading import MOST_IN_VALUE, Config, Given
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Iterator

#: Kinds of presets, a later one over an earlier one, and how a printer names its usual one.
_KINDS: Final = {
    "print": "default_print_profile",
    "filament": "default_filament_profile",
    "printer": "",
}
#: Those without which a file is no bundle.
_BUNDLED: Final = ("printer", "filament")
_MOST_ELDERS: Final = 40
_MOST_SHOWN: Final = 8
_SECTION: Final = re.compile(r"\[([^\]]*)\]\s*$")
_ENTRY: Final = re.compile(r"\s*([^\s=][^=]*?)\s*=\s?(.*)")


@dataclass
class Presets:
    """A file's presets by kind and name; the kind ``""`` holds what stands under no header."""

    sections: dict[tuple[str, str], Config] = field(default_factory=dict)

    def names(self, kind: str) -> list[str]:
        """Return the names of the presets that can be chosen."""
        return [name for known, name in self.sections if known == kind and not name.startswith("*")]

    def resolved(self, kind: str, name: str, below: tuple[str, ...] = ()) -> Config:
        """Return a preset with what it inherits.

        Raises
        ------
        SettingError
            It inherits from nothing, or from itself.
        """
        own = self.sections[kind, name]
        found: Config = {}
        inherits = own.get("inherits")
        for elder in re.split(r"\s*;\s*", inherits.text if inherits else ""):
            if not elder or inherits is None:
                continue
            elder = elder.strip('"')
            if elder == name or elder in below or len(below) > _MOST_ELDERS:
                chain = " → ".join(map(one_line, (*below, name, elder)))
                raise SettingError(f"{inherits.place}: presets inherit in a circle: {chain}")
            if (kind, elder) not in self.sections:
                msg = f"{inherits.place}: no {kind} is called {one_line(elder)!r} in this file"
                raise SettingError(msg)
            found |= self.resolved(kind, elder, (*below, name))
        return found | own


def presets(text: str, name: str) -> Presets:
    """Take a file apart.

    Raises
    ------
    SettingError
        A line is no entry; the error names file and line.
    """
    found = Presets()
    section: Config = found.sections.setdefault(("", ""), {})
    for number, line in enumerate(text.splitlines(), start=1):
        place = f"{name}:{number}"
        if not line.strip() or line.lstrip().startswith(("#", ";")):
            continue
        if head := _SECTION.match(line):
            kind, _, called = head[1].partition(":")
            section = found.sections.setdefault((kind.strip(), called.strip()), {})
        elif entry := _ENTRY.match(line):
            if len(entry[2]) > MOST_IN_VALUE:
                raise SettingError(f"{place}, {entry[1]}: a value of more than 128 kB")
            section[entry[1]] = Given(entry[2].strip(), f"{place}, {entry[1]}")
        else:
            shown = one_line(line.strip())[:40]
            raise SettingError(f"{place}: {shown!r} is no entry, as in key = value")
    return found


def configuration(text: str, name: str, preset: str | None) -> Config:
    """Return the settings of one printer, and of a filament where one is chosen.

    Parameters
    ----------
    text, name
        The file.
    preset
        Name of the printer's preset in a bundle; None: the one that the bundle itself names, or the
        only one.

    Raises
    ------
    SettingError
        The file is damaged, or has several printers and none is chosen.
    """
    found = presets(text, name)
    single = found.sections["", ""]
    if not any(kind in _BUNDLED for kind, _ in found.sections):
        return single
    chosen = found.sections.get(("presets", ""), {})
    names = found.names("printer")
    wanted = preset
    if wanted is None and "printer" in chosen:
        wanted = chosen["printer"].text.strip('"')
    if wanted is None and len(names) == 1:
        wanted = names[0]
    if wanted not in names:
        raise SettingError(f"{name}: {_which(preset, names)}")
    printer = found.resolved("printer", str(wanted))
    place = f"{name}, [printer:{one_line(str(wanted))}]"
    printer.setdefault("printer_settings_id", Given(str(wanted), place))
    merged: Config = {}
    for kind, usual in _KINDS.items():
        given = chosen.get(kind) or printer.get(usual)
        called = re.split(r"\s*;\s*", given.text)[0].strip('"') if given else ""
        if kind != "printer" and called in found.names(kind):
            # What only completes a printer may be damaged.
            with suppress(SettingError):
                merged |= found.resolved(kind, called)
    return merged | printer


def _which(preset: str | None, names: list[str]) -> str:
    shown = list(_shown(names))
    if preset is None:
        return f"a bundle of {len(names)} printers; name one by --preset: {', '.join(shown)}"
    return f"no printer is called {one_line(preset)!r}; {catalogue.hint(preset, shown)}"


def _shown(names: list[str]) -> Iterator[str]:
    yield from map(one_line, names[:_MOST_SHOWN])
    if len(names) > _MOST_SHOWN:
        yield "…"

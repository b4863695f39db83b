"""Klipper's configuration: sections, the files that it includes, and what SAVE_CONFIG keeps.

klipper3d.org/Config_Reference.html and klippy/configfile.py tell the form.
"""

from __future__ import annotations

import glob
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from wireprint._core import SettingError
from wireprint.importing.reading import MOST_IN_VALUE, Config, Given, text_of
from wireprint.text import one_line

#: More files make no printer.
_MOST_FILES: Final = 200
#: Of all files together.
_MOST_BYTES: Final = 32 << 20
_SECTION: Final = re.compile(r"\[([^\]\n]*)\]\s*$")
_OPTION: Final = re.compile(r"([^\s:=\[#;][^:=]*?)\s*[:=]\s?(.*)")
_COMMENT: Final = re.compile(r"(?:^|\s)[#;].*$")
#: What stands before the lines that the firmware keeps by itself.
_SAVED: Final = "#*#"


@dataclass
class KlipperConfig:
    """All sections, the last value of an option winning."""

    sections: dict[str, Config] = field(default_factory=dict)
    files: list[Path] = field(default_factory=list)
    #: Sentences about includes that lead nowhere.
    remarks: list[str] = field(default_factory=list)
    _bytes: int = 0

    def section(self, name: str) -> Config:
        """Return a section; an empty one where there is none."""
        return self.sections.get(name, {})

    def read(self, path: Path, within: tuple[Path, ...] = ()) -> None:
        """Read a file and those that it includes.

        Raises
        ------
        SettingError
            A file cannot be read, has a line that is none of Klipper's, or includes itself; the
            error names file and line.
        """
        text = text_of(path)
        self._bytes += len(text)
        self.files.append(path)
        if len(self.files) > _MOST_FILES or self._bytes > _MOST_BYTES:
            msg = f"{path}: more than {_MOST_FILES} files, or {_MOST_BYTES >> 20} MB, are included"
            raise SettingError(msg)
        section: Config | None = None
        option, indent = "", 0
        for number, line in enumerate(text.splitlines(), start=1):
            place = f"{path.name}:{number}"
            if saved := line.startswith(_SAVED):
                line = line.removeprefix(_SAVED).removeprefix(" ")
            elif line.lstrip().startswith(("#", ";")):
                continue
            line = _COMMENT.sub("", line).rstrip()
            if not line:
                continue
            # As Python's reader has it: what stands further in than its option goes on with that.
            stands = len(line) - len(line.lstrip())
            if stands > indent and section is not None and option:
                self._go_on(section, option, line.strip())
                continue
            line, indent = line.strip(), stands
            if head := _SECTION.match(line):
                name = " ".join(head[1].split())
                option = ""
                if name.startswith("include "):
                    self._include(path, name.removeprefix("include ").strip(), place, within)
                    section = None
                else:
                    section = self.sections.setdefault(name, {})
            elif (entry := _OPTION.match(line)) and section is not None:
                option = entry[1].strip().lower()
                section[option] = Given(entry[2].strip(), f"{place}, {one_line(option)}")
            elif not saved:
                shown = one_line(line.strip())[:40]
                raise SettingError(f"{place}: {shown!r} is no section, nor an option of one")

    @staticmethod
    def _go_on(section: Config, option: str, more: str) -> None:
        before = section[option]
        if len(before.text) + len(more) > MOST_IN_VALUE:
            msg = f"{before.place}: a value of more than {MOST_IN_VALUE >> 10} kB"
            raise SettingError(msg)
        section[option] = Given(f"{before.text}\n{more}".lstrip("\n"), before.place)

    def _include(self, path: Path, pattern: str, place: str, within: tuple[Path, ...]) -> None:
        chain = (*within, path)
        found = sorted(glob.glob(os.path.join(glob.escape(str(path.parent)), pattern)))
        if not found:
            self.remarks.append(f"{place}: nothing is called {one_line(pattern)}; read without it")
        for name in found:
            other = Path(name)
            if any(other.resolve() == one.resolve() for one in chain):
                names = " → ".join(one.name for one in (*chain, other))
                raise SettingError(f"{place}: files include each other in a circle: {names}")
            if other.is_file():
                self.read(other, chain)

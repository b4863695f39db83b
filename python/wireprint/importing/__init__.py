"""Printers of other programs as profiles: firmware's configurations, and slicers' settings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import toml
from wireprint._core import SettingError
from wireprint.importing import bundle, cura, cura_files, embedded, klipper, orca, slic3r
from wireprint.importing.completion import complete
from wireprint.importing.klipper_config import KlipperConfig
from wireprint.importing.reading import text_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from wireprint.importing.completion import Namesake
    from wireprint.importing.draft import Draft
    from wireprint.toml import Key

#: Order of a profile's tables.
_ORDER: Final[tuple[str, ...]] = (
    "name",
    "known_as",
    "kinematics",
    "bed",
    "head",
    "motion",
    "homing",
    "extruder",
    "speeds",
    "cooling",
    "gcode",
)


@dataclass(frozen=True)
class Imported:
    """A printer that was read from files of other programs."""

    #: Tables of a profile.
    values: dict[str, Any]
    #: Where each figure comes from.
    comments: dict[Key, str]
    #: What a user should know, in sentences.
    remarks: tuple[str, ...]
    #: The files' names.
    files: tuple[str, ...]

    def text(self) -> str:
        """Return it as the text of a profile."""
        from wireprint.toml_text import written

        head = [f"{self.values['name']}, imported from {', '.join(self.files)}."]
        head += [f"Note: {sentence}" for sentence in self.remarks]
        return written(self.values, self.comments, head)


def imported(
    paths: Sequence[str | Path],
    *,
    hotend: str | None = None,
    like: tuple[str, Mapping[str, Any]] | None = None,
    preset: str | None = None,
    namesake: Namesake | None = None,
) -> Imported:
    """Read a printer from files of other programs.

    Parameters
    ----------
    paths
        Klipper's ``printer.cfg``, PrusaSlicer's ``.ini``, OrcaSlicer's ``.json``, Cura's
        ``.def.json`` or ``.inst.cfg``, or G-code or a 3MF project that one of them wrote. What a
        later one says is laid over the earlier ones.
    hotend
        What the head is, of `hotends.HOTENDS`.
    like
        Printer whose figures hold where the files have none: its name and its tables.
    preset
        Which printer of a bundle is meant.
    namesake
        Finds the printer that holds where nothing else is named, by what the files call theirs;
        `wireprint.lineage.namesake` does.

    Raises
    ------
    SettingError
        A file cannot be understood, or something is missing; it names file, line and key.
    """
    files = [Path(path) for path in paths]
    draft: Draft | None = None
    for path in files:
        other = _draft_of(path, preset)
        draft = other if draft is None else _laid_over(draft, other)
    if draft is None:
        raise SettingError("no file to import is named")
    complete(draft, str(files[0]), hotend, like, namesake)
    values = {key: draft.values[key] for key in _ORDER if key in draft.values}
    names = tuple(path.name for path in files)
    return Imported(values, draft.comments, tuple(draft.remarks), names)


def _laid_over(below: Draft, above: Draft) -> Draft:
    # A bed of another shape has other measures.
    if above.get("bed.shape") is not None:
        below.values.pop("bed", None)
    toml.merge(below.values, above.values)
    below.comments |= above.comments
    below.called += above.called
    for remark in above.remarks:
        below.remark(remark)
    return below


def _draft_of(path: Path, preset: str | None) -> Draft:
    """Read one file, by its name and what is in it."""
    name = path.name.lower()
    if path.is_dir():
        raise SettingError(f"{path}: a folder; name the printer's own file in it")
    if name.endswith(".json"):
        text = text_of(path)
        if name.endswith(".def.json"):
            return cura.draft_of(cura_files.definition(path, text), str(path))
        return slic3r.draft_of(orca.configuration(path, text), str(path))
    if name.endswith(".inst.cfg"):
        return cura.draft_of(cura_files.instance(path, text_of(path)), str(path))
    if name.endswith(".cfg"):
        config = KlipperConfig()
        config.read(path)
        return klipper.draft_of(config, str(path))
    if name.endswith(".ini"):
        text = text_of(path)
        return slic3r.draft_of(bundle.configuration(text, path.name, preset), str(path))
    if not path.is_file():
        raise SettingError(f"{path}: no such file")
    found = embedded.in_3mf(path) if name.endswith(".3mf") else None
    config_of_file = found if found is not None else embedded.in_gcode(path)
    draft_of = cura.draft_of if "definition" in config_of_file else slic3r.draft_of
    return draft_of(config_of_file, str(path))


def motion_of(path: str | Path) -> dict[str, Any]:
    """Return the limits that a file of another program has, and its kinematics.

    Raises
    ------
    SettingError
        As `imported`.
    """
    # A head has no part in it, so any will do.
    found = imported([path], hotend="v6")
    motion: dict[str, Any] = found.values["motion"]
    return motion | {"kinematics": found.values["kinematics"]}

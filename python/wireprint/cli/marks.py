"""The options that mark parts of a model to be printed as layers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from wireprint.cli.paths import InputFile
from wireprint.mesh import format_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from wireprint.model import Model
    from wireprint.regions import Mark, Region

Command = TypeVar("Command", bound="Callable[..., object]")


class MarkType(click.ParamType["Mark"]):
    """``sphere:0,0,30,8``."""

    name = "MARK"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Mark:
        """Read one mark."""
        from wireprint._core import SettingError
        from wireprint.regions import grammar

        try:
            return grammar.parse(value)
        except SettingError as error:
            self.fail(str(error), param, ctx)


def marks_options(command: Command) -> Command:
    """Add the options that `marks_from` understands."""
    options = (
        click.option(
            "--fill",
            type=MarkType(),
            multiple=True,
            metavar="MARK",
            help="Print what lies in it as layers: box:X0,Y0,Z0,X1,Y1,Z1, sphere:X,Y,Z,RADIUS, "
            "z:LOW..HIGH or half:NX,NY,NZ,DISTANCE, in mm where the model stands; after erase: "
            "as wire again. May be repeated; the last one that covers a place wins.",
        ),
        click.option(
            "--fill-file",
            type=InputFile(must_be_there=False),
            multiple=True,
            metavar="FILE",
            help="Marks from strokes (.json), or from a painted model (.3mf) that is placed as "
            "MODEL is; may be repeated.",
        ),
        click.option(
            "--fill-state",
            type=click.IntRange(1, 255),
            multiple=True,
            metavar="N",
            help="Extruder whose paint counts; default: that of all; may be repeated.",
        ),
        click.option(
            "--fill-set",
            multiple=True,
            metavar="NAME",
            help="3MF triangle set that counts as painted; may be repeated.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


def marks_from(options: dict[str, Any], models: Iterable[Path]) -> Marks:
    """Take the options of `marks_options` out of a command's own, which `placement_options` has.

    Raises
    ------
    click.UsageError
        They choose among paint or sets where no 3MF file could have any.
    """
    marks = Marks(
        options.pop("fill"),
        options.pop("fill_file"),
        options.pop("fill_state"),
        options.pop("fill_set"),
    )
    formats = [format_of(model, options["file_format"]) for model in models]
    formats += map(format_of, marks.files)
    if (marks.states or marks.sets) and "3mf" not in formats:
        name = "--fill-state" if marks.states else "--fill-set"
        raise click.UsageError(f"{name} needs a 3MF file, as MODEL or --fill-file")
    return marks


@dataclass(frozen=True)
class Marks:
    """What the options of `marks_options` say."""

    fill: tuple[Mark, ...]
    files: tuple[Path, ...]
    states: tuple[int, ...]
    sets: tuple[str, ...]

    def concern(self, path: Path, placement: dict[str, Any]) -> bool:
        """Whether a model may be marked: here, or by its own file."""
        own = format_of(path, placement["file_format"]) == "3mf"
        return bool(self.fill or self.files or own)

    def load(self, path: Path, placement: dict[str, Any]) -> Model:
        """Read a model with its own marks, those of the files and the single ones, in this order.

        Raises
        ------
        ModelError, SettingError
            A file cannot be read, or has no mark.
        """
        from dataclasses import replace

        from wireprint.model import load_model

        model = load_model(path, states=self.states, sets=self.sets, **placement)
        from wireprint.regions import Region

        region = model.region
        for file in self.files:
            region = region.add(self._read(file, placement))
        return replace(model, region=region.add(Region(self.fill)))

    def _read(self, file: Path, placement: dict[str, Any]) -> Region:
        from wireprint.model import load_marks
        from wireprint.regions import document

        if format_of(file) == "3mf":
            placed = {name: value for name, value in placement.items() if name != "file_format"}
            return load_marks(file, states=self.states, sets=self.sets, **placed)
        return document.read(file)

"""``wireprint view``."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint._core import GcodeError
from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say
from wireprint.forecast_scales import RULES as FIGURES
from wireprint.naming import named
from wireprint.streams import STREAM, is_stream

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.view_source import Shown
    from wireprint.view_stages import Stage
    from wireprint.weakness import Weak


class PixelSize(click.ParamType[tuple[int, int]]):
    """``1600x1200``."""

    name = "WxH"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """Read width and height."""
        if isinstance(value, tuple):
            return value
        found = re.fullmatch(r"(\d{1,5})[x×](\d{1,5})", value.lower())
        if found is None:
            self.fail(f"{value!r} is not WIDTHxHEIGHT, such as 1600x1200", param, ctx)
        return int(found[1]), int(found[2])


class Words(click.ParamType[tuple[str, ...]]):
    """``contour,post``."""

    name = "NAME,…"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[str, ...]:
        """Split at commas."""
        if isinstance(value, tuple):
            return value
        return tuple(word.strip() for word in value.split(",") if word.strip())


class SlabRange(click.ParamType[range]):
    """``12`` or ``12..15``."""

    name = "N|FROM..TO"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> range:
        """Read one number or two."""
        if isinstance(value, range):
            return value
        found = re.fullmatch(r"(\d{1,6})(?:\.\.(\d{1,6}))?", value.strip())
        if found is None or int(found[2] or found[1]) < int(found[1]):
            self.fail(f"{value!r} is not N or FROM..TO, such as 12 or 12..15", param, ctx)
        return range(int(found[1]), int(found[2] or found[1]) + 1)


#: Stages of a print that can be drawn; see `view_stages`, which takes its time to be imported.
_STAGES = ("slices", "contours", "strips", "posts", "strands", "toolpath")


@click.command()
@click.argument("file", type=InputFile())
@click.option(
    "-o",
    "--output",
    type=OutputName(),
    help="Picture (.png), or page that turns in a browser (.html); default: FILE.png.",
)
@click.option(
    "--camera",
    default="iso",
    show_default=True,
    metavar="NAME|AZ,EL",
    help="iso, front, side, top, or azimuth and elevation in degrees.",
)
@click.option("--size", type=PixelSize(), default=(1600, 1200), help="Pixels of a picture.")
@click.option("--travels", is_flag=True, help="Draw moves without extrusion, too.")
@click.option("--kinds", type=Words(), help="Show only these: contour, post, diagonal, …")
@click.option("--weak", is_flag=True, help="Mark and tell where G-code's posts give way easily.")
@click.option(
    "--colour",
    type=click.Choice(tuple(FIGURES)),
    help="Colour G-code's strands by a figure of its forecast (wireprint simulate).",
)
@click.option("--edges", is_flag=True, help="Draw the edges of a model's triangles.")
@click.option("--stage", type=click.Choice(_STAGES), help="Draw what this stage makes of a model.")
@click.option("--slabs", type=SlabRange(), help="Slabs of that stage, from 0; default: all.")
@marks_options
@settings_options
@placement_options
def view(
    file: Path,
    output: str | None,
    camera: str,
    size: tuple[int, int],
    travels: bool,
    kinds: tuple[str, ...] | None,
    weak: bool,
    colour: str | None,
    edges: bool,
    stage: Stage | None,
    slabs: range | None,
    **options: Any,
) -> None:
    """Draw G-code or a model.

    FILE is G-code of any program, or a model; - is stdin, G-code unless --format tells. How a model
    is placed and what is marked on it matters to models alone; size and edges to pictures alone;
    printer, material and other settings to --stage alone.
    """
    from wireprint import view as pictures
    from wireprint import view_source

    chosen, marks = chosen_from(options), marks_from(options, [file])
    if output is None and is_stream(file):
        raise click.UsageError("what comes by a pipe has no name: name the picture with -o")
    target = files.output(
        output or file.with_suffix(".png"),
        f"{file.stem}.png",
        files.PICTURE_SUFFIXES + files.PAGE_SUFFIXES,
        [file, *marks.files, *chosen.files],
    )
    if colour is not None:
        _forecast(file, target, colour, size, camera)
        say(f"{target}: {file.name}", err=output == STREAM)
        return
    places: tuple[Weak, ...] = ()
    gcode: bytes | None = None
    by_stdin = is_stream(file) and options["file_format"] is None
    if by_stdin or view_source.is_gcode(file):
        if marks.fill or marks.files:
            raise click.UsageError(f"{file}: G-code cannot be marked; mark its model")
        if stage is not None:
            raise click.UsageError(f"{file}: --stage draws what becomes of a model; name its model")
        gcode = view_source.text_in(file)
        shown: Shown = view_source.strands_from(gcode, file)
        places = _weak(file) if weak else ()
    elif stage is not None:
        from wireprint import view_stages

        model = marks.load(file, options)
        shown = view_stages.stage(stage, model.mesh, chosen.of(model), slabs)
    elif marks.concern(file, options):
        shown = view_source.load(marks.load(file, options))
    else:
        from wireprint.mesh import load_mesh

        shown = load_mesh(file, **options)
    common: dict[str, Any] = {
        "camera": camera,
        "kinds": kinds,
        "travels": travels or stage == "toolpath",
        "title": file.name if stage is None else f"{file.name}: {stage}",
        "weak": [place.place_mm for place in places],
    }
    if str(target).lower().endswith(files.PAGE_SUFFIXES):
        target.write(_page(shown, gcode, file, common).encode())
    else:
        target.write(pictures.render_png(shown, size=size, edges=edges, **common))
    say(f"{target}: {file.name}", err=output == STREAM)
    for place in places:
        say(f"  weak        {place}", err=output == STREAM)


def _page(shown: Shown, gcode: bytes | None, file: Path, common: dict[str, Any]) -> str:
    """Draw a page; where G-code cannot be timed, its strands take turns, and that is said."""
    from wireprint import view as pictures

    try:
        return pictures.render_html(shown, gcode=gcode, **common)
    except GcodeError as error:
        why = str(error).rpartition("; ")[0] or error
        say(f"{file}: {why}; strands are shown in their order, without times", err=True)
        return pictures.render_html(shown, **common)


def _forecast(
    file: Path, target: files.Output, colour: str, size: tuple[int, int], camera: str
) -> None:
    """Draw G-code in the colours of a figure, for the printer that its file names."""
    from wireprint import forecast_page, view_source
    from wireprint.forecast import simulate

    if not (is_stream(file) or view_source.is_gcode(file)):
        raise click.UsageError(
            f"{file}: --colour draws a forecast of G-code; slice the model first"
        )
    found = simulate(file)
    if str(target).lower().endswith(files.PAGE_SUFFIXES):
        target.write(forecast_page.page(found, colour, file.name))
    else:
        target.write(forecast_page.picture(found, colour, file.name, size, camera))


def _weak(file: Path) -> tuple[Weak, ...]:
    """Find where a print gives way easily, by the printer that its file names."""
    from wireprint.gcode.source import read
    from wireprint.rules import settings_for
    from wireprint.weakness import find_weak

    text, _ = read(file)
    with named(file):
        places = find_weak(text, settings_for(text, None))
    if places is None:
        say(f"{file}: how far it gives way was not judged: too much work", err=True)
    return places or ()

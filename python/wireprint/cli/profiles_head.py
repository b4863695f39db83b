"""``wireprint profiles head``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from wireprint import files
from wireprint._core import SettingError
from wireprint.cli import completion
from wireprint.cli.defaults import default
from wireprint.cli.paths import OutputName
from wireprint.cli.say import say_all
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from wireprint.heads.measures import Measure
    from wireprint.settings import Settings
    from wireprint.settings.head import Head


@click.command("head")
@click.option(
    "--printer",
    shell_complete=completion.printers,
    metavar="NAME|FILE",
    help="Printer whose head it is; its other figures are kept.",
)
@click.option("--tip-mm", type=float, metavar="MM", help="A: width of the nozzle's flat tip.")
@click.option("--flank-deg", type=float, metavar="DEG", help="B: angle of the nozzle's flank.")
@click.option(
    "--cone-height-mm", type=float, metavar="MM", help="C: height of the lowest thing around."
)
@click.option("--block-radius-mm", type=float, metavar="MM", help="D: reach of the heater block.")
@click.option(
    "--gauge",
    metavar="TOOTH,ROOF",
    help="B and C as the printed gauge has them: the first tooth and the first roof that were "
    "touched, 0 for none; --printer must be the one that it was made for.",
)
@click.option("-o", "--output", type=OutputName(), metavar="OUT", help="Profile to write.")
@click.option("--update", is_flag=True, help="Change [head] in the profile OUT, which is there.")
def measure(
    printer: str | None,
    tip_mm: float | None,
    flank_deg: float | None,
    cone_height_mm: float | None,
    block_radius_mm: float | None,
    gauge: str | None,
    output: str | None,
    update: bool,
) -> None:
    """Measure the head of your printer, and write it into a profile.

    A drawing shows four measures. What no option gives is asked for in a terminal, and kept as it
    is elsewhere. What the head means for prints is told; OUT is written only where nothing is, or
    with --update, which changes those figures and no other line.
    """
    from wireprint.heads import drawing
    from wireprint.heads.measures import MEASURES, measured
    from wireprint.settings import Settings

    name = printer or default("printer")[0]
    before = Settings.load(name)
    given = {"A": tip_mm, "B": flank_deg, "C": cone_height_mm, "D": block_radius_mm}
    source = "measured"
    if gauge is not None:
        if flank_deg is not None or cone_height_mm is not None:
            raise SettingError("--gauge tells B and C: leave out --flank-deg and --cone-height-mm")
        from wireprint.heads.gauge import answered

        given |= answered(before, gauge)
        source = f"measured; B and C by the gauge: {gauge}"
    err = output == STREAM
    say_all(drawing.text(before.printer.head), err=err)
    asks = gauge is None and sys.stdin.isatty() and sys.stdout.isatty()
    figures = {}
    for one in MEASURES:
        value = given[one.letter]
        if value is None and asks:
            value = _asked(one, before.printer.head)
        if value is not None:
            figures[one.key] = round(one.within(value, before.printer.head) * one.factor, 4)
    after, figures = measured(before, figures)
    _tell(figures, after, before, err=err)
    if output is not None:
        _write(output, name, figures, source, update=update)
        say_all([f"{output}: written; --printer {output} prints with it"], err=err)


def _asked(one: Measure, head: Head) -> float:
    """Ask for a measure until it is one that a head can have."""

    def read(text: str) -> float:
        try:
            # With a point, or a comma as most of Europe writes it.
            value = float(text.replace(",", "."))
        except ValueError:
            raise click.UsageError(f"{text!r} is no number") from None
        try:
            return one.within(value, head)
        except SettingError as error:
            raise click.UsageError(str(error)) from None

    now = f"{one.of(head):g}"
    return float(click.prompt(f" {one.letter}, {one.unit}", default=now, value_proc=read))


def _tell(figures: dict[str, float], after: Settings, before: Settings, *, err: bool) -> None:
    from wireprint.heads.measures import meaning

    shown = [f"{key:18} = {value:g}" for key, value in figures.items()]
    say_all(["", "[head]", *shown, "", *meaning(after, before)], err=err)


def _write(
    output: str, printer: str, figures: dict[str, float], source: str, *, update: bool
) -> None:
    from wireprint.heads import profile

    if not figures:
        raise SettingError(f"nothing was measured: nothing to write into {output}")
    path = Path(output)
    own = output != STREAM and path.is_file()
    if own and not update:
        msg = f"{output} is there already; --update changes [head] in it, and nothing else"
        raise SettingError(msg)
    if update and not own:
        raise SettingError(f"{output} is no profile that is there; leave out --update")
    stem = path.stem if output != STREAM and not output.endswith("/") else f"{printer}-measured"
    text = (
        profile.updated(path, figures, source)
        if update
        else profile.new(printer, Path(stem).name, figures, source)
    )
    # An update replaces its input, and is meant to.
    others = [printer] if Path(printer).is_file() and not update else []
    files.output(output, f"{stem}.toml", (".toml",), others).write(text.encode())

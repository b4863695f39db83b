"""``wireprint simulate``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from wireprint import files
from wireprint._core import MemoryLimitError
from wireprint.cli import completion
from wireprint.cli.amounts import Amount
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.say import say_all, say_json
from wireprint.forecast_scales import RULES as FIGURES
from wireprint.naming import named
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from wireprint.forecast import Forecast
    from wireprint.settings import Settings


@click.command()
@click.argument("file", type=InputFile())
@click.option(
    "--printer",
    shell_complete=completion.printers,
    metavar="NAME|FILE",
    help="Profile to forecast for; default: the file's own, else kossel-mini.",
)
@click.option(
    "--material",
    shell_complete=completion.materials,
    metavar="NAME|FILE",
    help="Material's profile; default: the file's own, else abs.",
)
@click.option(
    "--calibration",
    type=InputFile(),
    metavar="FILE.toml",
    help="What wireprint calibrate fit wrote.",
)
@click.option(
    "--set",
    "overrides",
    shell_complete=completion.settings,
    multiple=True,
    metavar="KEY=VALUE",
    help="A single setting, such as air_mm_s.fan=4000; may be repeated.",
)
@click.option(
    "--grip",
    type=Amount(0.1, 1000),
    metavar="N",
    help="Press it between two fingers at half its height, newtons: how far it gives way and what "
    "it bears.",
)
@click.option("--html", type=OutputName(), help="Page to draw the strands to, in colours.")
@click.option(
    "--colour",
    type=click.Choice(tuple(FIGURES)),
    default="sag",
    help="What the page colours strands by.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one object in place of words.")
def simulate(
    file: Path,
    printer: str | None,
    material: str | None,
    calibration: Path | None,
    overrides: tuple[str, ...],
    grip: float | None,
    html: str | None,
    colour: str,
    as_json: bool,
) -> None:
    """Forecast whether posts hold, stretches sag, and strands meet and weld.

    FILE may come from any program; - is stdin. A model, not a measurement: figures may be half or
    twice as large unless the printer was calibrated (wireprint calibrate), and no part of the
    certificate. The exit code is 0 whatever the forecast.
    """
    from wireprint.forecast import simulate as forecast

    target = None
    if html is not None:
        inputs = [path for path in (file, calibration) if path is not None]
        target = files.output(html, f"{file.stem}.html", files.PAGE_SUFFIXES, inputs)
    settings = _settings(file, printer, material, calibration, overrides)
    with named(file, MemoryLimitError):
        found = forecast(file, settings, grip)
    if target is not None:
        from wireprint.forecast_page import page

        target.write(page(found, colour, file.name))
    to_stderr = html == STREAM
    if as_json:
        from wireprint.forecast_words import told

        say_json({"file": str(file), **told(found)}, indent=2, err=to_stderr)
    else:
        say_all(_lines(file, found), err=to_stderr)


def _settings(
    file: Path,
    printer: str | None,
    material: str | None,
    calibration: Path | None,
    overrides: tuple[str, ...],
) -> Settings | str | None:
    """Lay what was named over what the file says of itself."""
    if material is None and calibration is None and not overrides:
        return printer
    from wireprint.gcode.source import read
    from wireprint.rules import judge_of

    text, name = read(file)
    own = judge_of(text, printer, name).settings
    load = [] if calibration is None else [calibration]
    return own.but(material=material, load=load, overrides=overrides)


def _lines(file: Path, found: Forecast) -> Iterator[str]:
    from wireprint.forecast_words import sentences, unknown

    settings = found.judge.settings
    yield (
        f"{file}: forecast for {settings.printer.name} with {settings.material.name}, "
        f"{found.judge.why}; {found.trust}, a model and no part of the certificate"
    )
    for sentence in sentences(found):
        yield f"  {sentence}"
    yield "  What this forecast does not know:"
    for sentence in unknown(settings):
        yield f"    {sentence}"

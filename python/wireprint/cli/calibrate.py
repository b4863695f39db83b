"""``wireprint calibrate``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.say import say_all
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.calibration.prints import Print

_SUMMARIES: dict[Print, str] = {
    "ladder": "Write twelve tents whose pauses grow: the first that stands tells the pause.",
    "harp": "Write strands of three lengths at two speeds: their sags tell draw and viscosity.",
    "mast": "Write one long strand: a coin that hangs from it tells how stiff strands are.",
    "sphere": "Write nine spheres, three speeds by three pauses, as the paper's figure 15.",
}
#: A fit that is off by more deviations than this is told as doubtful.
_DOUBTFUL = 2.5


@click.group()
def calibrate() -> None:
    """Make forecasts true for your printer: print, measure, fit.

    Print a ladder and a harp with the nozzle, filament and air that you will use (a mast and
    spheres tell more), write down what they ask for, and let fit make a file of it. With --load
    it gives slice its pause, and with --calibration or --load forecasts say "calibrated".
    """


def _command(name: Print) -> click.Command:
    @click.command(name, help=_SUMMARIES[name], short_help=_SUMMARIES[name])
    @settings_options
    @click.option(
        "-o", "--output", required=True, type=OutputName(), metavar="OUT", help="G-code to write."
    )
    def write(output: str, **options: Any) -> None:
        from wireprint.calibration.prints import printed
        from wireprint.duration import duration

        chosen = chosen_from(options)
        settings = chosen.settings()
        target = files.output(output, f"{name}.gcode", files.GCODE_SUFFIXES, chosen.files)
        made = printed(name, settings)
        target.write(made.gcode)
        takes = duration(made.takes_s)
        machine = f"{settings.printer.name} with {settings.material.name}"
        say_all(
            [f"{target}: {name}, {takes} on {machine}", *(f"  {word}" for word in made.words)],
            err=output == STREAM,
        )

    return write


for _name in _SUMMARIES:
    calibrate.add_command(_command(_name))


@calibrate.command()
@click.argument("answers", type=InputFile())
@settings_options
@click.option(
    "-o", "--output", required=True, type=OutputName(), metavar="OUT", help="TOML file to write."
)
def fit(answers: Path, output: str, **options: Any) -> None:
    """Fit what was measured, and write pause and sags with their spread.

    ANSWERS is a TOML file with date, [ladder] first_standing, for each strand of a harp
    [[harp]] length_mm, speed_mm_s, sag_mm, [mast] weight_g, length_mm, drop_mm, and for each
    row of spheres [[sphere]] speed_mm_s, pause_s; those that were printed. The options are
    those that the prints were made with.
    """
    from wireprint._core import SettingError
    from wireprint.calibration import bending
    from wireprint.calibration.answers import read
    from wireprint.calibration.fit import fitted, written

    chosen = chosen_from(options)
    settings = chosen.settings()
    target = files.output(output, "calibration.toml", (".toml",), [answers, *chosen.files])
    told = read(answers, settings)
    try:
        found = fitted(settings, told)
        text = written(settings, told, found)
    except SettingError as error:
        raise SettingError(f"{answers}: {error}") from error
    target.write(text.encode())
    lines = [
        f"{target}: {settings.printer.name} with {settings.material.name}",
        f"  pause  {found.pause_s:.2f} ± {found.pause_spread_s:.2f} s "
        f"(computed without: {settings.solidify_s:.2f} s)",
    ]
    if told.sags:
        lines += [
            f"  sag    {sag:.2f} ± {spread:.2f} mm of a strand of {length:g} mm"
            for length, sag, spread in found.sags_mm
        ]
    if told.stiff is not None:
        modelled = bending.of_strand(settings.strand_mm, settings.material.modulus_mpa)
        lines.append(
            f"  bends  {told.stiff.bending_n_mm2:.3g} ± {told.stiff.spread_n_mm2:.2g} N·mm² "
            f"(computed without: {modelled:.3g} N·mm²)"
        )
    if found.misfit > _DOUBTFUL:
        lines.append(
            "  doubtful: answers and model disagree; were nozzle, filament and air those of the "
            "options? Measure again, or print a new ladder"
        )
    lines.append(f"  use it: wireprint slice … --load {target}")
    say_all(lines, err=output == STREAM)

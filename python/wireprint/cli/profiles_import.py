"""``wireprint profiles import``."""

from __future__ import annotations

from pathlib import Path

import click

from wireprint import files
from wireprint.cli import completion
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.say import say
from wireprint.streams import STREAM


@click.command("import")
@click.argument("sources", nargs=-1, required=True, type=InputFile(), metavar="FILE...")
@click.option(
    "-o", "--output", required=True, type=OutputName(), metavar="OUT", help="Profile to write."
)
@click.option("--hotend", metavar="NAME", help="Hot end whose shape the head has, such as v6.")
@click.option(
    "--like",
    metavar="NAME|FILE",
    shell_complete=completion.printers,
    help="Printer whose figures hold where the files have none.",
)
@click.option("--preset", metavar="NAME", help="Printer that is meant in a bundle of several.")
@click.option("--name", metavar="NAME", help="What the printer shall be called.")
def import_profile(
    sources: tuple[Path, ...],
    output: str,
    hotend: str | None,
    like: str | None,
    preset: str | None,
    name: str | None,
) -> None:
    """Write a profile of your own printer from files of other programs.

    FILE is Klipper's printer.cfg, PrusaSlicer's or SuperSlicer's .ini, OrcaSlicer's or Bambu
    Studio's .json, Cura's .def.json or .inst.cfg, or G-code or a 3MF project that one of them
    wrote; several complete each other. No such file tells the shape of the head: --hotend takes it
    from a table, --like from another printer.

    A 28 mm cube is printed with the profile, and judged, before it is written.
    """
    from wireprint.importing import imported
    from wireprint.importing.trial import tried
    from wireprint.lineage import namesake, tables

    target = files.output(output, "printer.toml", (".toml",), sources)
    elder = None if like is None else (like, tables(like))
    found = imported(sources, hotend=hotend, like=elder, preset=preset, namesake=namesake)
    if name is not None:
        found.values["name"] = name
    found, settings = tried(found)
    target.write(found.text().encode())
    to_stderr = output == STREAM
    printer = settings.printer
    say(
        f"{target}: {printer.name}, {printer.kinematics}, {printer.bed}, "
        f"{printer.head.nozzle_mm:g} mm nozzle, {printer.gcode.flavor}",
        *(f"  note        {sentence}" for sentence in found.remarks),
        "  judged      a 28 mm cube is certified with it; "
        f"wireprint slice MODEL -o OUT --printer {target}",
        err=to_stderr,
    )

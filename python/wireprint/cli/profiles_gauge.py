"""``wireprint profiles gauge``."""

from __future__ import annotations

from typing import Any

import click

from wireprint import files
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import OutputName
from wireprint.cli.say import say_all
from wireprint.streams import STREAM


@click.command("gauge")
@settings_options
@click.option(
    "-o", "--output", required=True, type=OutputName(), metavar="OUT", help="G-code to write."
)
def gauge(output: str, **options: Any) -> None:
    """Write a small print that the head touches where its profile is wrong.

    Beside each tooth the tip comes down as near as the flank allows if it is as steep as the tooth;
    past each roof it slides as if all of the head were higher than that. Whatever is touched is a
    lone strand. Count what is bent or molten, from the first on, and answer with
    wireprint profiles head --gauge TOOTH,ROOF --printer PRINTER -o OUT.
    """
    from wireprint.heads.gauge_print import printed

    chosen = chosen_from(options)
    settings = chosen.settings()
    target = files.output(output, "gauge.gcode", files.GCODE_SUFFIXES, chosen.files)
    made = printed(settings)
    target.write(made.gcode)
    one, printer = made.gauge, chosen.printer or settings.printer.name
    fences = ("no roofs", "one fence of roofs", "two fences of roofs")[made.fences]
    say_all(
        [
            f"{target}: {len(one.teeth_deg)} teeth, {fences}",
            *(f"  {word}" for word in one.words()),
            f"  certified   for a head of {one.supposed.slant_deg:g}° and "
            f"{one.supposed.cone_height_mm:g} mm; for that of the profile {made.beyond} descents "
            "of the tip are collisions, each with a lone strand, where the list says beyond",
            "  answer      wireprint profiles head --gauge TOOTH,ROOF "
            f"--printer {printer} -o my-printer.toml, 0 where none is touched",
        ],
        err=output == STREAM,
    )

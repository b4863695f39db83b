"""``wireprint splice``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint.cli.amounts import Amount
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say, say_json
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path


@click.command()
@click.argument("layers", type=InputFile(), metavar="LAYERS.gcode")
@click.argument("model", type=InputFile())
@click.option(
    "-o", "--output", required=True, type=OutputName(), help="G-code file to write, - for stdout."
)
@settings_options
@placement_options
@click.option(
    "--at",
    "at_mm",
    type=float,
    nargs=2,
    default=(0.0, 0.0),
    metavar="X Y",
    help="Where the model stands, from the middle of the bed, mm.",
)
@click.option(
    "--lift",
    "lift_mm",
    type=Amount(min=0),
    default=0.0,
    metavar="MM",
    help="Height of the layers that the model stands on; 0: the bed.",
)
@click.option(
    "--only-supports",
    is_flag=True,
    help="Only what would carry the model, for layers of that very model.",
)
@click.option("--force", is_flag=True, help="Write the file even if it breaks the rules.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
def splice(
    layers: Path,
    model: Path,
    output: str,
    at_mm: tuple[float, float],
    lift_mm: float,
    only_supports: bool,
    force: bool,
    as_json: bool,
    **options: Any,
) -> None:
    """Put a wire print of MODEL between the layers of another slicer's file.

    LAYERS.gcode is made for the same printer and nozzle, by PrusaSlicer, OrcaSlicer, Cura or
    whatever else; its lines stay as they are. Each slab of the wire is printed once the layers
    below it are: so it may be a support, a core, or stand on top. The whole file is judged; one
    that breaks a rule is not written.
    """
    chosen = chosen_from(options)
    target = files.output(
        output, f"{model.stem}.gcode", files.GCODE_SUFFIXES, [layers, model, *chosen.files]
    )
    from wireprint._core import UnprintableError
    from wireprint.duration import duration
    from wireprint.gcode.source import read
    from wireprint.mesh import load_mesh
    from wireprint.report import breaches
    from wireprint.splicing import splice as spliced

    settings = chosen.settings()
    text, name = read(layers)
    found = spliced(
        load_mesh(model, **options),
        text,
        settings,
        supports=only_supports,
        at_mm=(*at_mm, lift_mm),
        name=name,
    )
    warnings = list(found.remarks)
    if not found.certificate.ok:
        reason = breaches(found.certificate, settings)
        if not force:
            raise UnprintableError(f"{model} within {layers}: {reason}")
        warnings.append(f"written although {reason}")
    target.write(found.gcode)
    fidelity = found.certificate.fidelity
    figures = {
        "model": str(model),
        "layers": str(layers),
        "output": str(target),
        "printer": settings.printer.name,
        "material": settings.material.name,
        "heights_mm": list(found.heights_mm),
        "print_time_s": found.print_time_s,
        "certified": found.certificate.ok,
        "breaches": {name: len(rows) for name, rows in found.certificate.breaches().items()},
        "coverage": None if fidelity is None else fidelity.coverage,
        "warnings": warnings,
    }
    to_stderr = output == STREAM
    if as_json:
        say_json(figures, err=to_stderr)
        return
    verdict = "certified" if found.certificate.ok else "not certified"
    heights = ", ".join(f"{height:.1f}" for height in found.heights_mm)
    say(
        f"{target}: {duration(found.print_time_s)} on {settings.printer.name}: {verdict}",
        err=to_stderr,
    )
    say(f"  wire at     {heights} mm", err=to_stderr)
    for warning in warnings:
        say(f"  warning     {warning}", err=to_stderr)

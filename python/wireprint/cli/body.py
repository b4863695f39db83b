"""``wireprint body``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import click

from wireprint import files
from wireprint.cli.amounts import Amount
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say, say_json
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path

_SUFFIXES: Final = (".3mf", ".stl")


@click.command()
@click.argument("print_", type=InputFile(), metavar="WIRE.gcode")
@click.option(
    "-o",
    "--output",
    required=True,
    type=OutputName(),
    metavar="BODY",
    help="Model to write, .3mf or .stl; - for stdout, as 3MF.",
)
@click.option("--printer", help="Profile of the nozzle; default: the file's own, else kossel-mini.")
@click.option(
    "--only",
    multiple=True,
    metavar="TYPE",
    help="Only what is labelled so (;TYPE:), such as support; may be repeated.",
)
@click.option(
    "--model",
    "model_path",
    type=InputFile(),
    help="Model to put beside it as a body of its own, placed by the options below as slice "
    "places it; 3MF alone.",
)
@click.option(
    "--diameter",
    "diameter_mm",
    type=Amount(min=0.01),
    metavar="MM",
    help="Thickness of the tubes; default: the strand's.",
)
@click.option("--sides", type=click.IntRange(3, 64), default=8, help="Corners of a tube.")
@placement_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
def body(
    print_: Path,
    output: str,
    printer: str | None,
    only: tuple[str, ...],
    model_path: Path | None,
    diameter_mm: float | None,
    sides: int,
    as_json: bool,
    **placement: Any,
) -> None:
    """Write the strands of a print as tubes that other slicers print.

    Skirts, brims and purge lines are left out. The body lies about the middle of the bed, z from
    the bed: where slice puts the model. With --model both are in one file, so that the slicer keeps
    them together: wire as supports or as a core of what it prints in layers.
    """
    inputs = [path for path in (print_, model_path) if path is not None]
    target = files.output(output, f"{print_.stem}{_SUFFIXES[0]}", _SUFFIXES, inputs)
    as_3mf = not str(target).lower().endswith(".stl")
    if model_path is not None and not as_3mf:
        raise click.UsageError("an STL file holds one body; with --model write a .3mf file")
    from wireprint.certificate import check
    from wireprint.mesh import load_mesh
    from wireprint.threemf.write import Body, assembly
    from wireprint.tubes import as_stl, strands_of, tubes

    certificate = check(print_, printer)
    settings = certificate.judge.settings
    strands, kinds = strands_of(certificate, only)
    diameter_mm = settings.strand_mm if diameter_mm is None else diameter_mm
    vertices, faces = tubes(strands, diameter_mm, sides)
    if as_3mf:
        bodies = [Body("wire", vertices, faces)]
        if model_path is not None:
            from wireprint.fitting import fitted

            mesh = fitted(load_mesh(model_path, **placement), settings).mesh
            bodies.insert(0, Body(model_path.stem, mesh.vertices, mesh.faces))
        target.write(assembly(bodies))
    else:
        target.write(as_stl(vertices, faces))
    figures = {
        "print": str(print_),
        "output": str(target),
        "strands": len(strands),
        "types": kinds,
        "diameter_mm": diameter_mm,
        "triangles": len(faces),
        "certified": certificate.ok,
    }
    if as_json:
        say_json(figures, err=output == STREAM)
        return
    say(
        f"{target}: {len(strands)} strands as tubes of {diameter_mm:g} mm, {len(faces)} triangles",
        err=output == STREAM,
    )

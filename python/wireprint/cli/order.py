"""``wireprint order``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import click

from wireprint import files
from wireprint.cli.amounts import Amount
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import orient_option
from wireprint.cli.progress import Progress
from wireprint.cli.say import say, say_json
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path

#: Suffixes of strut graphs that are written beside G-code.
_GRAPHS: Final = (".obj", ".ply", ".glb", ".json", ".3mf")
_FRAMES: Final = (".csv", ".json")


@click.command()
@click.argument("graph", type=InputFile())
@click.option(
    "-o", "--output", required=True, type=OutputName(), help="G-code file to write, - for stdout."
)
@click.option(
    "--graph",
    "graph_out",
    type=OutputName(),
    help="Strut graph in the order of printing, too: .json (COMPAS), .ply, .obj, .glb or .3mf.",
)
@click.option(
    "--frames",
    "frames_out",
    type=OutputName(),
    help="Frames for robots, too: position, tool axis, speed, extruder; .csv or .json.",
)
@click.option("--scale", type=Amount(min=0, min_open=True), default=1.0, help="Factor.")
@click.option(
    "--rotate",
    "rotate_deg",
    type=float,
    nargs=3,
    default=(0.0, 0.0, 0.0),
    metavar="X Y Z",
    help="Degrees about x, then y, then z.",
)
@orient_option
@click.option(
    "--partial",
    is_flag=True,
    help="Leave out what cannot be printed, as little as is found, and name it.",
)
@click.option(
    "--effort",
    type=Amount(min=0, min_open=True),
    default=1.0,
    help="How long it may search, times the usual half a minute of a processor.",
)
@settings_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
def order(
    graph: Path,
    output: str,
    graph_out: str | None,
    frames_out: str | None,
    scale: float,
    rotate_deg: tuple[float, float, float],
    orient: bool,
    partial: bool,
    effort: float,
    as_json: bool,
    **options: Any,
) -> None:
    """Print a strut graph: find an order and directions that the head can follow.

    GRAPH is made of struts: lines of OBJ, PLY or glTF, a graph of COMPAS (JSON), or the beam
    lattice of a 3MF file. Parts that nothing leads to from the bed get an upright support, unless
    --supports none is given; what cannot be printed is named, and nothing is written, unless
    --partial is given. With --orient auto, it is put on the side on which it prints best. A search
    that spends its effort ends with the best it found, and says so: the same file everywhere.
    """
    chosen = chosen_from(options)
    inputs = [graph, *chosen.files]
    target = files.output(output, f"{graph.stem}.gcode", files.GCODE_SUFFIXES, inputs)
    others = []
    for name, suffixes in ((graph_out, _GRAPHS), (frames_out, _FRAMES)):
        default = f"{graph.stem}.ordered{suffixes[0]}"
        others.append(None if name is None else files.output(name, default, suffixes, inputs))
    files.distinct([target, *others])
    from wireprint.duration import duration
    from wireprint.gcode.document import dated
    from wireprint.struts import order as ordered
    from wireprint.struts import read_struts, struts_as
    from wireprint.struts.frames import as_csv
    from wireprint.struts.frames import as_json as frames_json
    from wireprint.struts.words import SPENT, refusal

    settings = chosen.settings()
    with_supports = settings.wire.supports == "wire"
    struts = read_struts(graph).moved((0.0, 0.0, 0.0), scale).turned(rotate_deg)
    with Progress(len(struts), lines=True, what="struts") as progress:
        progress.show("searching")
        found = ordered(
            struts,
            settings,
            supports=with_supports,
            partial=partial,
            orient=orient,
            effort=effort,
            told=progress.reach,
            date=dated(graph),
        )
    target.write(found.gcode)
    if others[0] is not None:
        suffix = str(others[0]).rpartition(".")[2].lower()
        others[0].write(struts_as(found.graph, suffix, settings.strand_mm / 2))
    if others[1] is not None:
        as_bytes = as_csv if str(others[1]).lower().endswith(".csv") else frames_json
        others[1].write(as_bytes(found.toolpath, settings))
    to_stderr = output == STREAM
    figures = {
        "graph": str(graph),
        "output": str(target),
        "printer": settings.printer.name,
        "struts": len(found.graph),
        "supports": list(found.supports),
        "unprinted": [
            {"strut": number, "nodes": struts.edges[number].tolist(), "reason": why}
            for number, why in found.unprinted
        ],
        "rotate_deg": list(found.rotate_deg) if orient else None,
        "effort_spent": found.effort_spent,
        "floating": int(found.floating.sum()),
        "print_time_s": found.print_time_s,
        "certified": found.certificate.ok,
    }
    if as_json:
        say_json(figures, err=to_stderr)
        return
    say(
        f"{target}: {duration(found.print_time_s)} on {settings.printer.name}, "
        f"{figures['struts']} struts, {figures['floating']} of them to a free end: certified",
        err=to_stderr,
    )
    if orient:
        x, y, z = found.rotate_deg
        say(f"  turned      {x:g}, {y:g}, {z:g} degrees about x, y, z", err=to_stderr)
    if found.unprinted:
        for line in refusal(struts, found.unprinted).splitlines():
            say(f"  unprinted   {line}", err=to_stderr)
    if found.effort_spent:
        say(f"  effort      {SPENT}", err=to_stderr)
    for number in found.supports:
        x, y, z = found.graph.ends[number, 1]
        say(f"  support     strut {number}, to ({x:.1f}, {y:.1f}, {z:.1f})", err=to_stderr)

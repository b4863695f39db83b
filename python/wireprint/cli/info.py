"""``wireprint info``."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

import click

from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile
from wireprint.cli.placement import orient_option, placement_options
from wireprint.cli.say import say, say_json

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from wireprint.orientation import Orientation
    from wireprint.report_regions import Marked
    from wireprint.threemf.contents import Contents


@click.command()
@click.argument("model", type=InputFile())
@marks_options
@settings_options
@placement_options
@orient_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def info(model: Path, as_json: bool, orient: bool, **options: Any) -> None:
    """Tell size, surface, marks and faults of a model.

    With --orient auto also: how it would print in several poses, the best of which is described.
    Settings count for that alone.
    """
    from wireprint import report, report_regions

    chosen, marks = chosen_from(options), marks_from(options, [model])
    loaded = marks.load(model, options)
    settings, mesh = chosen.of(loaded), loaded.mesh
    marked = report_regions.marks(mesh, loaded.region)
    turned = None
    if orient:
        from wireprint.orientation import orient as best

        turned = best(mesh, settings)
        mesh = turned.mesh
    x, y, z = loaded.mesh.size_mm
    warnings = [*report.warnings(mesh), *report.units_meant((x, y, z), options)]
    found = {
        "model": str(model),
        "size_mm": mesh.size_mm,
        "area_mm2": mesh.area,
        "volume_mm3": mesh.volume,
        "closed": mesh.report["boundary_edges"] == 0,
        "repaired": report.repairs(mesh),
        "warnings": warnings,
        "counts": mesh.report,
        "marks": marked,
        "contents": None if loaded.contents is None else loaded.contents.to_dict(),
        "orientation": None if turned is None else turned.to_dict(),
    }
    if as_json:
        say_json(found)
        return
    x, y, z = mesh.size_mm
    say(str(model))
    say(f"  size       {_figure(x)} × {_figure(y)} × {_figure(z)} mm")
    say(f"  facets     {mesh.report['facets']} in {mesh.report['components']} parts")
    say(f"  surface    {_figure(mesh.area / 100)} cm²")
    say(f"  volume     {_figure(mesh.volume / 1000)} cm³{'' if found['closed'] else ' (open)'}")
    if loaded.contents is not None:
        for line in _contents(loaded.contents):
            say(line)
    if marked is not None:
        say(f"  marked     {_marked(marked)}")
    for sentence in report.repairs(mesh):
        say(f"  repaired   {sentence}")
    for sentence in warnings:
        say(f"  note       {sentence}")
    if turned is not None:
        for line in _poses(turned):
            say(line)


def _figure(value: float) -> str:
    """Return a figure with two decimals, or as many as a small one needs."""
    return f"{value:.2f}" if value >= 0.1 or value <= 0 else f"{value:.2g}"


def _contents(contents: Contents) -> Iterator[str]:
    """Tell plates and bodies of a 3MF file; a plain one has none to tell of."""
    from wireprint.threemf.contents import shown

    for plate in contents.plates:
        mark = "→" if plate.taken else " "
        name = f" {shown(plate.name)}" if plate.name else ""
        objects = ", ".join(shown(one) for one in plate.objects) or "nothing to print"
        yield f"  plate    {mark} {plate.number}{name}: {objects}"
    for body in contents.bodies:
        count = f"{body.count} × " if body.count > 1 else ""
        size = f", {body.triangles} facets" if body.triangles else ""
        name = shown(body.name) if body.name else "unnamed"
        yield f"  body       {count}{name}: {body.role}{size}"


def _marked(marks: Marked) -> str:
    """Say how much of the surface is marked, and by what."""
    shapes = ", ".join(f"{count} × {kind}" for kind, count in marks["kinds"].items())
    erased = f"; {marks['erase']} of these erase" if marks["erase"] else ""
    return (
        f"{marks['area_mm2'] / 100:.2f} cm², {marks['share']:.1%} of the surface ({shapes}{erased})"
    )


def _poses(found: Orientation) -> Iterator[str]:
    """Tell what each pose comes to, the chosen one marked."""
    yield f"  pose       {found}"
    for pose in found.poses:
        if pose.passed_over is None:
            mark = "→" if pose is found.chosen else " "
            angles = ", ".join(f"{angle:.4g}" for angle in pose.rotate_deg)
            yield f"           {mark} {angles:24} {', '.join(pose.told())}"
    passed_over = Counter(pose.passed_over for pose in found.poses if pose.passed_over)
    for reason, count in passed_over.items():
        yield f"             {count} more: {reason}"

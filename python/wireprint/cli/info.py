"""``wireprint info``."""

from __future__ import annotations

import json
from typing import Any

import click

from wireprint.cli.placement import placement_options


@click.command()
@click.argument("model", type=click.Path())
@placement_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def info(model: str, as_json: bool, **placement: Any) -> None:
    """Tell size, surface and faults of a model."""
    from wireprint import report
    from wireprint.mesh import load_mesh

    mesh = load_mesh(model, **placement)
    found = {
        "model": model,
        "size_mm": mesh.size_mm,
        "area_mm2": mesh.area,
        "volume_mm3": mesh.volume,
        "closed": mesh.report["boundary_edges"] == 0,
        "repaired": report.repairs(mesh),
        "warnings": report.warnings(mesh),
        "counts": mesh.report,
    }
    if as_json:
        click.echo(json.dumps(found))
        return
    x, y, z = mesh.size_mm
    click.echo(model)
    click.echo(f"  size       {x:.2f} × {y:.2f} × {z:.2f} mm")
    click.echo(f"  facets     {mesh.report['facets']} in {mesh.report['components']} parts")
    click.echo(f"  surface    {mesh.area / 100:.2f} cm²")
    click.echo(f"  volume     {mesh.volume / 1000:.2f} cm³{'' if found['closed'] else ' (open)'}")
    for sentence in report.repairs(mesh):
        click.echo(f"  repaired   {sentence}")
    for sentence in report.warnings(mesh):
        click.echo(f"  note       {sentence}")

"""``wireprint check``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint._core import MemoryLimitError
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say_all, say_json
from wireprint.naming import named
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings
    from wireprint.standing import Standing

#: Breaches of one rule that are printed; the rest is counted.
SHOWN = 10


@click.command()
@click.argument("prints", nargs=-1, required=True, type=InputFile(), metavar="FILE…")
@click.option("--printer", help="Profile to judge by; default: the file's own, else kossel-mini.")
@click.option(
    "--set",
    "overrides",
    multiple=True,
    metavar="KEY=VALUE",
    help="Single setting to judge by, such as head.slant_deg=45; may be repeated.",
)
@click.option(
    "--model",
    "model_path",
    type=InputFile(),
    help="Model to compare with, placed by the options below as slice places it.",
)
@click.option(
    "--stopped",
    metavar="MM|line:N",
    help="Height or line at which the last but one of several files was stopped.",
)
@placement_options
@click.option(
    "--picture",
    type=OutputName(),
    help="PNG file to draw the print to, breaches in red.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one object with every breach.")
@click.pass_context
def check(
    ctx: click.Context,
    /,
    prints: tuple[Path, ...],
    printer: str | None,
    overrides: tuple[str, ...],
    model_path: Path | None,
    stopped: str | None,
    picture: str | None,
    as_json: bool,
    **placement: Any,
) -> None:
    """Judge whether a G-code file can be printed.

    FILE may come from any program; - is stdin. Several are judged as one: each stands on the bed
    when the next one is printed. The whole head follows every move; the exit code is
    1 if it runs into something, or if a strand starts or ends in the air, hangs too far, or leaves
    the machine's bounds.
    """
    from wireprint.certificate import check as judge

    file, target = prints[-1], None
    if picture is not None:
        inputs = [path for path in (*prints, model_path, printer) if path is not None]
        target = files.output(picture, f"{file.stem}.png", files.PICTURE_SUFFIXES, inputs)
    judge_by = _settings(printer, overrides) if overrides else printer
    standing = _standing(prints[:-1], file, judge_by, stopped)
    with named(file, MemoryLimitError):
        certificate = judge(file, judge_by, _model(model_path, placement), standing=standing)
    to_stderr = picture == STREAM
    if target is not None:
        from wireprint.view import render_png

        target.write(render_png(certificate, title=" + ".join(one.name for one in prints)))
    if as_json:
        told = {"file": str(file), "onto": [str(one) for one in prints[:-1]]}
        say_json(told | certificate.to_dict(), indent=2, err=to_stderr)
    else:
        say_all(_lines(prints, certificate, standing), err=to_stderr)
    ctx.exit(0 if certificate.ok else 1)


def _standing(
    earlier: tuple[Path, ...],
    last: Path,
    judge_by: str | Settings | None,
    stopped: str | None,
) -> Standing | None:
    """Read the prints before the last one, which tells by what all are judged."""
    if not earlier:
        if stopped is not None:
            raise click.UsageError("--stopped is for the print that another one was printed onto")
        return None
    from wireprint.gcode.source import read
    from wireprint.rules import settings_for
    from wireprint.standing import Standing, read_prints
    from wireprint.stopped import Stopped

    settings = settings_for(read(last)[0], judge_by)
    where = None if stopped is None else Stopped.read(stopped)
    return Standing(read_prints(earlier, settings, where), settings=settings)


def _settings(printer: str | None, overrides: tuple[str, ...]) -> Settings:
    from wireprint.settings import Settings

    chosen: dict[str, Any] = {} if printer is None else {"printer": printer}
    return Settings.load(overrides=overrides, **chosen)


def _model(path: Path | None, placement: dict[str, Any]) -> Mesh | None:
    if path is None:
        return None
    from wireprint.mesh import load_mesh

    return load_mesh(path, **placement)


def _lines(
    prints: tuple[Path, ...], certificate: Certificate, standing: Standing | None
) -> Iterator[str]:
    """Say what the verdict is, and what it rests on."""

    def place(line: int) -> str:
        if standing is None:
            return f"line {line}"
        name, own = standing.place(line)
        return f"{name or prints[-1]}, line {own}"

    verdict = "printable" if certificate.ok else "not printable"
    together = " as one" if standing is not None else ""
    yield (
        f"{' + '.join(map(str, prints))}: {verdict}{together} on "
        f"{certificate.printer}, {certificate.judge.why} "
        f"({certificate.moves} moves, {certificate.strands} strands)"
    )
    if certificate.unjudged:
        yield f"  not judged from {place(certificate.unjudged[0].line)}"
    for sentence in (*certificate.profile, *certificate.remarks):
        yield f"  {sentence}"
    for name, found in certificate.breaches().items():
        yield f"  {name.replace('_', ' ')}: {len(found)}"
        for breach in found[:SHOWN]:
            yield f"    {place(breach.line)}: {breach}"
        if len(found) > SHOWN:
            yield f"    and {len(found) - SHOWN} more"
    yield (
        f"  longest span: {certificate.max_span_mm:.1f} mm; "
        f"longest free end: {certificate.max_free_end_mm:.1f} mm"
    )
    for title, counts in (
        ("move nothing", certificate.harmless),
        ("before the print, not carried out", certificate.preparing),
    ):
        if counts:
            told = ", ".join(f"{name} ×{count}" for name, count in counts.items())
            yield f"  {title}: {told}"
    if (fidelity := certificate.fidelity) is not None:
        yield f"  coverage: {fidelity.coverage:.1%} within {fidelity.within_mm:g} mm"
        yield (
            f"  deviation: {fidelity.deviation_mm:.2f} mm (at most "
            f"{fidelity.max_deviation_mm:.2f}); as chords {fidelity.chord_deviation_mm:.2f} mm "
            f"(at most {fidelity.max_chord_deviation_mm:.2f})"
        )

"""``wireprint studio``."""

from __future__ import annotations

import importlib.util
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import click

from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from wireprint.cli.marks import Marks
    from wireprint.cli.options import Chosen
    from wireprint.settings import Settings
    from wireprint.window.source import Source

#: What the extra brings.
_NEEDS: Final = ("starlette", "uvicorn", "websockets")
#: What is shown if nothing is named.
_EXAMPLE: Final = "bottle"


@click.command()
@click.argument("model", type=InputFile(), required=False)
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    help="Port on this machine; default: a free one.",
)
@click.option("--browser/--no-browser", default=True, help="Open the window, or only say where.")
@marks_options
@settings_options
@placement_options
def studio(model: Path | None, port: int, browser: bool, **options: Any) -> None:
    """Open a window that paints, shows and prints a model.

    The browser shows MODEL and its wire print; what a brush or a shape marks is printed as layers,
    and each change is answered by the proven print, its time and its filament. MODEL is watched:
    saved anew, it is printed anew, and marks stay. Without MODEL a bottle is shown. The window is
    served on this machine alone, to whoever has the address that is printed; Ctrl-C ends it.
    """
    missing = [name for name in _NEEDS if importlib.util.find_spec(name) is None]
    if missing:
        msg = f"the window needs {' and '.join(missing)}: pip install 'wireprint[studio]'"
        raise click.UsageError(msg)
    if model is None:
        with _example() as path:
            _open(path, port, browser, options)
    else:
        _open(model, port, browser, options)


@contextmanager
def _example() -> Iterator[Path]:
    """Yield a file with the example, which goes when the window does."""
    import tempfile
    from pathlib import Path

    from wireprint import examples

    with tempfile.TemporaryDirectory(prefix="wireprint-") as folder:
        path = Path(folder) / f"{_EXAMPLE}.stl"
        path.write_bytes(examples.stl(_EXAMPLE))
        yield path


def _open(model: Path, port: int, browser: bool, options: dict[str, Any]) -> None:
    from wireprint.window.address import Address

    chosen, marks = chosen_from(options), marks_from(options, [model])
    # What is wrong with the settings is said here, not in the window.
    chosen.recalled()
    try:
        address = Address.bound(port)
    except OSError as error:
        raise click.UsageError(f"port {port}: {(error.strerror or str(error)).lower()}") from None
    # Who calls now waits in the queue of the port, while the server's modules are imported.
    say(address.url)
    if browser:
        import webbrowser

        webbrowser.open(address.url)
    from wireprint.window.server import serve

    try:
        serve(_source(model, chosen, marks, options), address)
    except KeyboardInterrupt:
        say("closed", err=True)


def _source(model: Path, chosen: Chosen, marks: Marks, placement: dict[str, Any]) -> Source:
    from wireprint.gcode.document import dated
    from wireprint.streams import is_stream
    from wireprint.text import one_line
    from wireprint.window.source import Source

    def settings(printer: str | None, material: str | None, saved: Settings | None) -> Settings:
        others = replace(
            chosen, printer=printer or chosen.printer, material=material or chosen.material
        )
        return others.settings() if saved is None else others.over(saved)

    return Source(
        name=one_line(model.name),
        path=None if is_stream(model) else model,
        load=lambda: marks.load(model, placement),
        settings=settings,
        dated=lambda: dated(None if is_stream(model) else model),
    )

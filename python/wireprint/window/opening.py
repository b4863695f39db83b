"""A window on a model that is in memory: in a notebook's cell, or in the browser."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint._core import Mesh, SettingError
from wireprint.model import Model, load_model
from wireprint.regions import Region
from wireprint.settings import Settings
from wireprint.window.source import Source

if TYPE_CHECKING:
    from wireprint.window.widget import Widget

#: What each way needs, and the extra that brings it.
_NEEDS: Final = {
    "notebook": ("anywidget", "traitlets"),
    "studio": ("starlette", "uvicorn", "websockets"),
}


def studio(
    model: str | os.PathLike[str] | Mesh | Model,
    settings: Settings | None = None,
    region: Region | None = None,
    *,
    height_px: int = 560,
) -> Widget | None:
    """Open the window that paints, shows and prints a model.

    Parameters
    ----------
    model
        A file, a mesh, or a model with what is marked on it.
    settings
        Printer, material and way of wiring to begin with; default: the model's own, or the usual.
    region
        What is printed as layers at first, besides what the model has.
    height_px
        Height of the view in a notebook, pixels.

    Returns
    -------
    Widget or None
        In a notebook: the view, which the cell shows; its ``region``, ``settings`` and ``gcode()``
        are what was made of the model. Elsewhere the window opens in the browser, and this returns
        when it is interrupted.

    Raises
    ------
    ModelError
        The file cannot be read.
    SettingError
        What the window needs is not installed.
    """
    name = Path(model).name if isinstance(model, str | os.PathLike) else "model"
    source = Source.of(*_taken(model, settings, region), name)
    if in_notebook():
        _has("notebook")
        from wireprint.window.widget import Widget

        return Widget(source, height_px)
    _has("studio")
    _serve(source)
    return None


def in_notebook() -> bool:
    """Whether cells show what an expression gives: under a kernel of Jupyter, or in marimo."""
    if "marimo" in sys.modules:
        return bool(sys.modules["marimo"].running_in_notebook())
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return getattr(shell, "kernel", None) is not None


def _taken(
    given: str | os.PathLike[str] | Mesh | Model, settings: Settings | None, region: Region | None
) -> tuple[Model, Settings]:
    """Return the model with all marks, and the settings."""
    if isinstance(given, Mesh):
        model = Model(given, Region(), None)
    elif isinstance(given, Model):
        model = given
    else:
        model = load_model(given)
    if region is not None:
        marked = Region((*model.region.marks, *region.marks))
        model = Model(model.mesh, marked, model.settings, model.contents)
    return model, settings or model.settings or Settings.load()


def _has(extra: str) -> None:
    missing = [name for name in _NEEDS[extra] if importlib.util.find_spec(name) is None]
    if missing:
        msg = f"the window needs {' and '.join(missing)}: pip install 'wireprint[{extra}]'"
        raise SettingError(msg)


def _serve(source: Source) -> None:
    import webbrowser

    from wireprint.window.address import Address
    from wireprint.window.server import serve

    address = Address.bound(0)
    print(address.url)
    webbrowser.open(address.url)
    try:
        serve(source, address)
    except KeyboardInterrupt:
        return

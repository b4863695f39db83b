"""What can be drawn: the strands of G-code, or a model, from files and from memory."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, cast

from wireprint import _core
from wireprint._core import Mesh, Strands
from wireprint.files import GCODE_SUFFIXES
from wireprint.naming import named
from wireprint.view_styles import style_of

if TYPE_CHECKING:
    from wireprint._core import Toolpath
    from wireprint.inputs import ModelLike
    from wireprint.model import Model
    from wireprint.settings import Settings
    from wireprint.verdict import Point


class Written(Protocol):
    """What has G-code, as a `wireprint.WirePrint` has."""

    @property
    def gcode(self) -> bytes:
        """The file."""


class Judged(Protocol):
    """What was judged, as a `wireprint.Certificate` is."""

    @property
    def core(self) -> _core.Certificate:
        """The verdict, with all strands."""

    @property
    def rules(self) -> dict[str, Any]:
        """What it was judged by."""

    @property
    def breach_points_mm(self) -> list[Point]:
        """One place for each breach, mm."""


#: What can be shown: a file, G-code as bytes, or what is in memory already.
Source: TypeAlias = "ModelLike | bytes | Written | Judged | Strands"
#: What is in memory: a model is a mesh with marks.
Shown: TypeAlias = "Strands | Mesh | Model"


def is_gcode(path: str | os.PathLike[str]) -> bool:
    """Whether a file's name is that of G-code."""
    return Path(path).suffix.lower() in GCODE_SUFFIXES


def load(source: Source, **placement: Any) -> Shown:
    """Read what a file shows: the strands of G-code, or a model with the marks of its file.

    Parameters
    ----------
    source
        A G-code or model file; G-code as bytes; a print or a certificate; whatever
        `wireprint.as_mesh` takes. Strands, meshes and models are returned as they are.
    **placement
        How a model is placed: what `wireprint.mesh.load_mesh` takes.

    Returns
    -------
    Strands, Mesh or Model
        What can be drawn; a mesh where nothing is marked.

    Raises
    ------
    GcodeError, ModelError, OSError
        The file cannot be read.
    """
    if isinstance(source, Strands | Mesh):
        return source
    if isinstance(source, bytes):
        return Strands.from_gcode(source)
    if isinstance(gcode := getattr(source, "gcode", None), bytes):
        return Strands.from_gcode(gcode)
    if isinstance(source, str | os.PathLike) and is_gcode(source):
        return strands_in(source)
    if (judged := judged_in(source)) is not None:
        core, width_mm = judged.core, judged.rules["strand_mm"]
        return Strands.from_arrays(core.strands, core.strand_features, core.features, width_mm)
    from wireprint.inputs import as_model

    model = as_model(cast("ModelLike", source), **placement)
    return model if model.region else model.mesh


def judged_in(source: Source) -> Judged | None:
    """Return what is shown if it is a certificate, which brings its breaches along."""
    judged = isinstance(getattr(source, "core", None), _core.Certificate)
    return cast("Judged", source) if judged else None


def strands_in(path: str | os.PathLike[str]) -> Strands:
    """Read the strands of a G-code file, whatever its name.

    Parameters
    ----------
    path
        The file.

    Returns
    -------
    Strands
        What it lays.

    Raises
    ------
    GcodeError, OSError
        The file cannot be read.
    """
    return strands_from(text_in(path), path)


def text_in(path: str | os.PathLike[str]) -> bytes:
    """Return the text of a G-code file, whatever its name; see `wireprint.gcode.source.read`."""
    from wireprint.gcode.source import read

    return read(path)[0]


def strands_from(gcode: bytes, path: str | os.PathLike[str]) -> Strands:
    """Return the strands of a text, which is called by its file's name in errors.

    Raises
    ------
    GcodeError
        It lays none.
    """
    with named(path):
        return Strands.from_gcode(gcode)


def strands_of(toolpath: Toolpath, settings: Settings) -> Strands:
    """Return what a toolpath lays, to be drawn before any G-code is written.

    Parameters
    ----------
    toolpath, settings
        See `wireprint.whole_file.to_gcode`.

    Returns
    -------
    Strands
        What it lays.
    """
    from wireprint._core import KINDS

    diameter_mm = settings.printer.extruder.filament_diameter_mm
    return Strands.from_toolpath(toolpath, KINDS, diameter_mm)


def size_text(shown: Shown) -> str:
    """Size of the object itself, such as ``84.2 x 65.0 x 83.4 mm``."""
    return " x ".join(f"{length:.1f}" for length in size_mm(shown)) + " mm"


def size_mm(shown: Shown) -> list[float]:
    """Size of the object itself, mm."""
    if not isinstance(shown, Strands):
        low, high = mesh_of(shown).bounds.tolist()
    else:
        objects = [label for label in shown.labels if style_of(label).is_object]
        low, high = shown.bounds(objects) or shown.bounds(shown.labels) or ((0.0,) * 3,) * 2
    return [b - a for a, b in zip(low, high, strict=True)]


def mesh_of(shown: Mesh | Model) -> Mesh:
    """Return the mesh of a model, marked or not."""
    return shown if isinstance(shown, Mesh) else shown.mesh

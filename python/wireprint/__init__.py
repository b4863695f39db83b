"""Turns a 3D model into a wire print that an ordinary printer makes in minutes.

The names here read like the pipeline:

>>> import wireprint
>>> mesh = wireprint.load_mesh("bottle.stl")  # doctest: +SKIP
>>> settings = wireprint.Settings.load(printer="kossel-mini", material="abs")
>>> strands = wireprint.wireframe(mesh, settings)  # doctest: +SKIP
>>> path = wireprint.toolpath(strands, settings)  # doctest: +SKIP
>>> wireprint.write_gcode("bottle.gcode", path, settings)  # doctest: +SKIP

`make` does all of it at once and tells the figures. What a name needs is imported when it is
first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from wireprint import regions as regions
    from wireprint import settings as settings
    from wireprint import view as view
    from wireprint._core import (
        KINDS,
        FaultError,
        GcodeError,
        MemoryLimitError,
        Mesh,
        ModelError,
        SettingError,
        Toolpath,
        UnprintableError,
        Wireframe,
        WireprintError,
        __version__,
    )
    from wireprint.certificate import Certificate, check
    from wireprint.comparison import Comparison, Condition, compare
    from wireprint.forecast import Forecast, simulate
    from wireprint.inputs import as_mesh
    from wireprint.mesh import load_mesh
    from wireprint.model import Model, load_model
    from wireprint.orientation import Orientation, orient
    from wireprint.pipeline import make, write_gcode
    from wireprint.project import write_project
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.stages import toolpath, wireframe
    from wireprint.timing import estimate
    from wireprint.whole_file import to_gcode
    from wireprint.wholeness import IncompleteError
    from wireprint.window.opening import studio
    from wireprint.wire_print import WirePrint

__all__ = [
    "KINDS",
    "Certificate",
    "Comparison",
    "Condition",
    "FaultError",
    "Forecast",
    "GcodeError",
    "IncompleteError",
    "MemoryLimitError",
    "Mesh",
    "Model",
    "ModelError",
    "Orientation",
    "Region",
    "SettingError",
    "Settings",
    "Toolpath",
    "UnprintableError",
    "WirePrint",
    "Wireframe",
    "WireprintError",
    "__version__",
    "as_mesh",
    "check",
    "compare",
    "estimate",
    "load_mesh",
    "load_model",
    "make",
    "orient",
    "simulate",
    "studio",
    "to_gcode",
    "toolpath",
    "wireframe",
    "write_gcode",
    "write_project",
]

_HOMES = {
    "KINDS": "wireprint._core",
    "Certificate": "wireprint.certificate",
    "Comparison": "wireprint.comparison",
    "Condition": "wireprint.comparison",
    "Forecast": "wireprint.forecast",
    "Orientation": "wireprint.orientation",
    "IncompleteError": "wireprint.wholeness",
    "Model": "wireprint.model",
    "Region": "wireprint.regions",
    "Settings": "wireprint.settings",
    "WirePrint": "wireprint.wire_print",
    "as_mesh": "wireprint.inputs",
    "check": "wireprint.certificate",
    "compare": "wireprint.comparison",
    "estimate": "wireprint.timing",
    "load_mesh": "wireprint.mesh",
    "load_model": "wireprint.model",
    "make": "wireprint.pipeline",
    "simulate": "wireprint.forecast",
    "orient": "wireprint.orientation",
    "studio": "wireprint.window.opening",
    "to_gcode": "wireprint.whole_file",
    "toolpath": "wireprint.stages",
    "wireframe": "wireprint.stages",
    "write_gcode": "wireprint.pipeline",
    "write_project": "wireprint.project",
}


#: Modules that are reached by way of the package, too.
_MODULES = ("regions", "settings", "view")


def __getattr__(name: str) -> Any:
    """Import what a name stands for."""
    if name in _MODULES:
        return importlib.import_module(f"wireprint.{name}")
    if name not in __all__:
        msg = f"module 'wireprint' has no attribute {name!r}"
        raise AttributeError(msg)
    home = importlib.import_module(_HOMES.get(name, "wireprint._core"))
    value = globals()[name] = getattr(home, name)
    return value


def __dir__() -> list[str]:
    """List the names that may be used."""
    return sorted({*globals(), *__all__, *_MODULES})

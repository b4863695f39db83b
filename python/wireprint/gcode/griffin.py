"""The header without which printers of Ultimaker's Griffin firmware (UM3, S3, S5) refuse a file.

It tells them what to heat before they begin, and for which machine the file is. What must stand in
it: Ultimaker/libCharon, ``Charon/filetypes/GCodeFile.py``, which those printers read files by.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from wireprint._core import __version__
from wireprint.filament import Filament

if TYPE_CHECKING:
    from datetime import datetime

    import numpy as np
    import numpy.typing as npt

    from wireprint._core import Estimate, Toolpath
    from wireprint.settings import Settings


def header(path: Toolpath, settings: Settings, estimate: Estimate, date: datetime) -> bytes:
    """Return the header of a file, which stands ahead of all else.

    Parameters
    ----------
    path, settings
        The moves, and what they were made with.
    estimate
        What the planner says of them.
    date
        Of the file.
    """
    printer, material = settings.printer, settings.material
    low, high = _size_mm(path)
    nozzle = f"{printer.head.nozzle_mm:g}"
    entries = {
        "HEADER_VERSION": "0.1",
        "FLAVOR": "Griffin",
        "GENERATOR.NAME": "wireprint",
        "GENERATOR.VERSION": __version__,
        "GENERATOR.BUILD_DATE": f"{date:%Y-%m-%d}",
        "TARGET_MACHINE.NAME": (printer.known_as or (printer.name,))[0],
        "EXTRUDER_TRAIN.0.INITIAL_TEMPERATURE": f"{material.nozzle_c}",
        "EXTRUDER_TRAIN.0.MATERIAL.VOLUME_USED": _volume_mm3(settings, estimate),
        "EXTRUDER_TRAIN.0.NOZZLE.DIAMETER": nozzle,
        "EXTRUDER_TRAIN.0.NOZZLE.NAME": f"AA {nozzle}",
        "BUILD_PLATE.INITIAL_TEMPERATURE": f"{material.bed_c}",
        "PRINT.TIME": f"{estimate.total_s:.0f}",
        "PRINT.GROUPS": "1",
    }
    for end, corner in (("MIN", low), ("MAX", high)):
        for axis, value in zip("XYZ", corner, strict=True):
            entries[f"PRINT.SIZE.{end}.{axis}"] = f"{value:.3f}"
    lines = [f";{key}:{value}" for key, value in entries.items()]
    return "\n".join([";START_OF_HEADER", *lines, ";END_OF_HEADER", ""]).encode()


def _volume_mm3(settings: Settings, estimate: Estimate) -> str:
    filament = Filament.of(settings)
    grams = filament.grams(estimate.filament_mm)
    return f"{1000 * grams / settings.material.density_g_cm3:.0f}"


def _size_mm(path: Toolpath) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return the lowest and highest coordinates of what is laid, mm, (3,) each."""
    import numpy as np

    laid = path.to[path.filament > 0]
    if not len(laid):
        return np.zeros(3), np.zeros(3)
    return laid.min(axis=0), laid.max(axis=0)

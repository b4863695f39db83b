"""Frames for robots: where the tool is, where it points, how fast it goes, and what it extrudes."""

from __future__ import annotations

import csv
import io
import json
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import KINDS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint._core import Toolpath
    from wireprint.settings import Settings

#: Columns of the CSV file, and keys of each frame in JSON.
COLUMNS: Final = (
    "kind",
    "x_mm",
    "y_mm",
    "z_mm",
    "axis_x",
    "axis_y",
    "axis_z",
    "speed_mm_s",
    "extrude_mm3",
    "extrude_mm3_s",
    "pause_s",
    "air",
)


def frames(path: Toolpath, settings: Settings) -> Iterator[tuple[object, ...]]:
    """Yield a frame for each move: what is reached at its end, by `COLUMNS`.

    The tool axis is the direction from the tip into the head: a printer's head is upright. Melt is
    told as volume, so any extruder can be driven by it; it is negative where it is pulled back.
    """
    section_mm2 = np.pi / 4 * settings.printer.extruder.filament_diameter_mm**2
    at = np.array(path.start)
    rows = zip(
        path.kind,
        path.to,
        path.speed,
        path.filament * section_mm2,
        path.pause,
        path.air,
        strict=True,
    )
    for kind, to, speed, volume, pause, air in rows:
        length = float(np.linalg.norm(to - at))
        time_s = length / speed if length > 0 else abs(volume / section_mm2) / speed
        yield (
            KINDS[kind],
            *(round(float(value), 4) for value in to),
            *(0.0, 0.0, 1.0),
            round(float(speed), 4),
            round(float(volume), 6),
            round(float(volume) / time_s, 6) if time_s > 0 else 0.0,
            round(float(pause), 4),
            bool(air),
        )
        at = to


def as_csv(path: Toolpath, settings: Settings) -> bytes:
    """Return the frames as CSV: a line of names, then one line a frame."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows(frames(path, settings))
    return text.getvalue().encode()


def as_json(path: Toolpath, settings: Settings) -> bytes:
    """Return the frames as JSON: ``frames``, and what they are in."""
    document = {
        "units": {"length": "mm", "time": "s", "volume": "mm3"},
        "origin": "the machine's, z from the bed",
        "tool_axis": "from the tip into the head",
        "frames": [dict(zip(COLUMNS, frame, strict=True)) for frame in frames(path, settings)],
    }
    return json.dumps(document).encode() + b"\n"

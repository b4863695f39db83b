"""Readers of a print's file that are no part of the package: its moves, and its pictures."""

import base64
import io
import math
import re

from PIL import Image

_AXES = "XYZ"
#: By as much, mm, coordinates of three decimals make a move shorter at most.
_ROUNDED_MM = 0.001 * math.sqrt(3)
_PICTURE = re.compile(
    r"^; thumbnail(|_QOI) begin (\d+)x(\d+) (\d+)\n((?:; \S+\n)+); thumbnail\1 end$", re.MULTILINE
)


def pictures(text):
    """Return the pictures as Prusa's firmware and Moonraker look for them, decoded.

    Returns
    -------
    list of tuple
        Width and height, form, and the picture; as the lines before it say, which it keeps.
    """
    found = []
    for form, width, height, length, rows in _PICTURE.findall(text):
        code = rows.replace("; ", "").replace("\n", "")
        assert len(code) == int(length)
        image = Image.open(io.BytesIO(base64.b64decode(code, validate=True)))
        told = (int(width), int(height), form.strip("_") or "PNG")
        assert (*image.size, image.format) == told
        found.append((*told, image))
    return found


def wanted(printer):
    """Return width, height and form of the pictures that a printer's profile asks for."""
    sizes = printer.gcode.thumbnails
    return [(size[0], size[1], size[2] if len(size) > 2 else "PNG") for size in sizes]


def moves(text):
    """Walk a file of absolute coordinates; yield line, from, to (mm), filament (mm), mm/s."""
    at, speed, extruded, relative = [0.0, 0.0, 0.0], 0.0, 0.0, False
    for number, line in enumerate(text.splitlines(), 1):
        name, *words = line.partition(";")[0].split() or [""]
        relative = {"M82": False, "M83": True}.get(name, relative)
        if name not in ("G0", "G1", "G92"):
            continue
        told = {word[0]: float(word[1:]) for word in words}
        to = [told.get(axis, old) for axis, old in zip(_AXES, at, strict=True)]
        filament = told.get("E", 0.0 if relative else extruded) - (0.0 if relative else extruded)
        extruded = told.get("E", extruded)
        if name != "G92":
            speed = told.get("F", 60 * speed) / 60
            yield number, at, to, filament, speed
        at = to


def beyond(text, printer):
    """Return what a file asks for that is beyond a printer's limits: line and what, each once.

    A move whose share along z is too fast is slowed down as a whole by every firmware, with its
    flow: so it is with slicers' files, and so the planner times it.
    """
    found = {}
    for number, start, end, filament, speed in moves(text):
        for what in _beyond(start, end, filament, speed, printer):
            found.setdefault(what, number)
    return [f"line {number}: {what}" for what, number in found.items()]


def _beyond(start, end, filament, speed, printer):
    motion, bed, extruder = printer.motion, printer.bed, printer.extruder
    span = [b - a for a, b in zip(start, end, strict=True)]
    length = math.hypot(*span)
    slack = 1 + 1e-3
    if length == 0:
        if abs(filament) > 0 and speed > motion.max_extrude_only_velocity * slack:
            yield "filament alone is faster than the extruder"
        return
    if speed * math.hypot(*span[:2]) / length > motion.max_velocity * slack:
        yield "faster than the machine"
    area = math.pi / 4 * extruder.filament_diameter_mm**2
    if filament * area * speed / (length + _ROUNDED_MM) > extruder.max_flow_mm3_s * slack:
        yield "more flow than the hot end melts"
    if filament > 0 and not _within(end, bed):
        yield "beside the bed"


def _within(point, bed):
    x, y, z = point
    if bed.origin == "centre":
        width, depth = (
            (bed.diameter_mm, bed.diameter_mm)
            if bed.shape == "round"
            else (bed.width_mm, bed.depth_mm)
        )
        x, y = x + width / 2, y + depth / 2
    if bed.shape == "round":
        inside = math.hypot(x - bed.diameter_mm / 2, y - bed.diameter_mm / 2) <= bed.diameter_mm / 2
    else:
        inside = 0 <= x <= bed.width_mm and 0 <= y <= bed.depth_mm
    return inside and 0 <= z <= bed.height_mm

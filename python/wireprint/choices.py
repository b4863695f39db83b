"""What settings choose between: the one list of each, which the command's options offer, too."""

from typing import Literal

#: Firmware that reads the G-code; `wireprint.gcode.flavors` says how each is spoken to.
Flavor = Literal["marlin", "reprapfirmware", "repetier", "klipper", "griffin"]
#: Words after ``;TYPE:``.
TypeWords = Literal["own", "prusa"]
#: What solidifies floating strokes.
CoolingMethod = Literal["valve", "fan", "none"]
#: How slabs are filled; each is a variant of the core's `Pattern`.
Pattern = Literal["zigzag", "peaks"]
#: Rule by which posts are placed.
Placement = Literal["optimal", "paper"]
#: What keeps floating strokes from sagging.
Strategy = Literal["pause", "slow", "overshoot"]
#: What carries parts that would hang in the air.
Supports = Literal["wire", "none"]

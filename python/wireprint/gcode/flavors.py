"""What sets the firmwares' dialects apart; the only place that knows.

A new flavour is one more entry of `FLAVORS`, and its name in ``choices.Flavor``.

Sources: marlinfw.org/docs/gcode; docs.duet3d.com, "GCode dictionary"; Repetier-Firmware,
Repetier.ino; klipper3d.org/G-Codes.html; RepRapFirmware, GCodeQueue.cpp; Klipper,
kinematics/extruder.py; Ultimaker/libCharon.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

if TYPE_CHECKING:
    from wireprint.settings.printer import Cooling, Gcode

#: What viewers read at a change of layer, in PrusaSlicer's form.
LAYER: Final = (
    ";LAYER_CHANGE\n;Z:{z}\n;HEIGHT:{height}\n;BEFORE_LAYER_CHANGE\n;{z}\n;AFTER_LAYER_CHANGE\n"
)

#: Starts a command at once, ahead of moves that still wait in the queue; so it must follow this.
_FINISH_MOVES = "M400\n"


@dataclass(frozen=True)
class Flavor:
    """The commands of a firmware. Each line ends with a newline."""

    #: Opens and closes the valve; take ``{pin}`` and ``{output}``.
    valve_on: str
    valve_off: str
    #: Limits the acceleration of an axis, mm/s², in printing and travelling; takes ``{axis}`` and
    #: ``{accel}``.
    limit: str = "M201 {axis}{accel:g}\n"
    #: Whether the head must stand still when the valve is switched.
    valve_halts: bool = False
    #: Tells the lag of the flow behind the feed; takes ``{lag}`` in s. Empty: it knows of none.
    advance: str = ""
    #: The strokes that it advances: all, or only those that move along x or y.
    advances: Literal["all", "sideways"] = "all"
    #: Waits ``{ms}``. G4 with P in milliseconds is the one form that all four read alike.
    dwell: str = "G4 P{ms}\n"
    fan_on: str = "M106 S255\n"
    fan_off: str = "M107\n"
    retract: str = "G10\n"
    unretract: str = "G11\n"
    #: Empty: it shows none, or counts by itself.
    progress: str = "M73 P{percent} R{minutes}\n"
    #: Whether files begin with a header of the firmware's own, `wireprint.gcode.griffin`.
    griffin: bool = False

    def air(self, cooling: Cooling) -> tuple[str, str]:
        """Return the commands that switch the air on and off."""
        if cooling.method == "valve":
            names = {"pin": cooling.valve_pin, "output": cooling.valve_output}
            return self.valve_on.format(**names), self.valve_off.format(**names)
        if cooling.method == "fan":
            return self.fan_on, self.fan_off
        return "", ""

    def pressure_advance(self, gcode: Gcode) -> Literal["all", "sideways", "none"]:
        """Return for which strokes the firmware makes up for the lag of the flow."""
        return self.advances if self.advance and gcode.pressure_advance else "none"


FLAVORS: Final[dict[str, Flavor]] = {
    "marlin": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S255\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
        valve_halts=True,
        advance="M900 K{lag:g}\n",
    ),
    # M42 there counts from 0 to 1 and waits in a queue of its own for the moves before it.
    "reprapfirmware": Flavor(
        valve_on="M42 P{pin} S1\n",
        valve_off="M42 P{pin} S0\n",
        advance="M572 D0 S{lag:g}\n",
    ),
    # Its own advance, M233, is a quadratic one with constants of another kind.
    "repetier": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S255\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
        valve_halts=True,
        limit="M201 {axis}{accel:g}\nM202 {axis}{accel:g}\n",
    ),
    # No M42; SET_PIN takes its turn in the queue of moves, so it needs no waiting. A limit for a
    # single axis is not known; pressure is advanced only where x or y moves.
    "klipper": Flavor(
        valve_on="SET_PIN PIN={output} VALUE=1\n",
        valve_off="SET_PIN PIN={output} VALUE=0\n",
        limit="SET_VELOCITY_LIMIT ACCEL={accel:g}\n",
        advance="SET_PRESSURE_ADVANCE ADVANCE={lag:g}\n",
        advances="sideways",
    ),
    # Ultimaker's since the UM3: Marlin behind a program that reads the header, heats and homes.
    "griffin": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S255\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
        valve_halts=True,
        progress="",
        griffin=True,
    ),
}

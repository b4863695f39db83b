"""What sets the firmwares' dialects apart; the only place that knows.

A new flavour is one more entry of `FLAVORS` (and of ``settings.Flavor``).

Sources: marlinfw.org/docs/gcode; docs.duet3d.com, "GCode dictionary"; Repetier-Firmware,
Repetier.ino; klipper3d.org/G-Codes.html.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from wireprint.settings import Cooling

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
    #: Waits ``{ms}``. G4 with P in milliseconds is the one form that all four read alike.
    dwell: str = "G4 P{ms}\n"
    fan_on: str = "M106 S255\n"
    fan_off: str = "M107\n"
    retract: str = "G10\n"
    unretract: str = "G11\n"
    progress: str = "M73 P{percent} R{minutes}\n"

    def air(self, cooling: Cooling) -> tuple[str, str]:
        """Return the commands that switch the air on and off."""
        if cooling.method == "valve":
            names = {"pin": cooling.valve_pin, "output": cooling.valve_output}
            return self.valve_on.format(**names), self.valve_off.format(**names)
        if cooling.method == "fan":
            return self.fan_on, self.fan_off
        return "", ""


FLAVORS: Final[dict[str, Flavor]] = {
    "marlin": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S255\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
    ),
    # M42 there counts from 0 to 1 and runs in step with the moves.
    "reprapfirmware": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S1\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
    ),
    "repetier": Flavor(
        valve_on=f"{_FINISH_MOVES}M42 P{{pin}} S255\n",
        valve_off=f"{_FINISH_MOVES}M42 P{{pin}} S0\n",
    ),
    # No M42; SET_PIN takes its turn in the queue of moves, so it needs no waiting.
    "klipper": Flavor(
        valve_on="SET_PIN PIN={output} VALUE=1\n",
        valve_off="SET_PIN PIN={output} VALUE=0\n",
    ),
}

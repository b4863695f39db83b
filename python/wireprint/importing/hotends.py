"""The shape of common hot ends and nozzles, which no firmware and hardly a slicer knows.

Figures are of the nozzle as it stands below its heater block, from its maker's length, thread and
hexagon where these are known; the flank is the line from the rim of the flat tip to the corner of
the hexagon. Silicone socks and fan ducts differ from printer to printer: measure yours (README,
"Your own printer").
"""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint._core import SettingError
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.importing.draft import Draft


@dataclass(frozen=True)
class Hotend:
    """A hot end with its usual nozzle."""

    #: Radius of the tip around the opening, mm: half of a nozzle's opening is added to it.
    land_mm: float
    #: The flank's angle from the horizontal, degrees.
    slant_deg: float
    #: From the tip to the underside of the heater block, mm.
    cone_height_mm: float
    #: Reach of block, sock and fan ducts around the axis, mm.
    block_radius_mm: float
    #: What its filament melts at, mm³/s.
    max_flow_mm3_s: float
    source: str


_V6_NOZZLE: Final = "E3D's V6 nozzle: 12.5 mm long, 7.5 of it thread, hexagon 7 mm, cone 2 mm high"

HOTENDS: Final[dict[str, Hotend]] = {
    "v6": Hotend(0.3, 29, 5, 22, 15, _V6_NOZZLE),
    "volcano": Hotend(0.3, 29, 5, 25, 25, "E3D's Volcano nozzle: below its thread as the V6's"),
    "revo": Hotend(
        0.3, 29, 4, 20, 15, "estimate: E3D's Revo nozzle as the V6's, nearer to its heater's sock"
    ),
    "mk8": Hotend(
        0.3, 40, 7, 22, 12, "usual MK8 nozzle: 13 mm long, 5 of it thread, hexagon 6 mm; less sock"
    ),
    "bambu": Hotend(
        0.3, 30, 4, 20, 25, "estimate: the X1's and A1's hot end with its silicone sock"
    ),
    "nextruder": Hotend(0.3, 30, 5, 22, 15, "estimate: as the V6's nozzle, which it takes as well"),
    "rapido": Hotend(0.3, 29, 5, 22, 30, f"takes {_V6_NOZZLE}"),
    "dragon": Hotend(0.3, 29, 5, 22, 20, f"takes {_V6_NOZZLE}"),
    "k1": Hotend(0.3, 32, 4.5, 22, 25, "estimate: Creality's ceramic heater with its sock"),
    "ultimaker": Hotend(
        0.3, 45, 3, 20, 12, "Cura, ultimaker3: machine_nozzle_head_distance 3, expansion angle 45"
    ),
    "jhead": Hotend(0.15, 32, 6, 20, 15, "WirePrint (UIST 2014): 32°, 6 mm high"),
}


def find(name: str) -> Hotend:
    """Return a hot end of the table.

    Raises
    ------
    SettingError
        There is none of that name; all are listed.
    """
    plain = name.lower().replace(" ", "").replace("-", "").removeprefix("e3d")
    found = HOTENDS.get(plain)
    if found is None:
        close = difflib.get_close_matches(plain, HOTENDS, n=1)
        meant = f"did you mean {close[0]}? " if close else ""
        known = ", ".join(HOTENDS)
        raise SettingError(f"--hotend {one_line(name)}: {meant}there are {known}")
    return found


def add_to(draft: Draft, name: str) -> None:
    """Fill in what a source does not say of the head."""
    hotend = find(name)
    nozzle_mm = draft.get("head.nozzle_mm") or 0.4
    said = f"--hotend {name}: {hotend.source}"
    draft.fill("head.tip_radius_mm", round(nozzle_mm / 2 + hotend.land_mm, 3), said)
    draft.fill("head.slant_deg", hotend.slant_deg, said)
    draft.fill("head.cone_height_mm", hotend.cone_height_mm, said)
    draft.fill("head.block_radius_mm", hotend.block_radius_mm, said)
    draft.fill("extruder.max_flow_mm3_s", hotend.max_flow_mm3_s, said)

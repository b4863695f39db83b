"""What the firmwares document of commands, as far as a print needs it: each with its letters.

marlinfw.org/docs/gcode, and of its relatives help.prusa3d.com (G80, W of G28) and Bambu's own
sequences (figures with M17); docs.duet3d.com, "GCode dictionary"; Repetier.ino;
klipper3d.org/G-Codes.html; Ultimaker's sequences (G280).
"""

import re

_AXES = "XYZE"
#: What all of them know.
_COMMON = {
    "G0": "XYZEF",
    "G1": "XYZEF",
    "G4": "SP",
    "G21": "",
    "G28": "XYZ",
    "G90": "",
    "G91": "",
    "G92": _AXES,
    "M73": "PR",
    "M82": "",
    "M83": "",
    "M84": "S" + _AXES,
    "M104": "ST",
    "M106": "SP",
    "M107": "P",
    "M109": "SRT",
    "M140": "S",
    "M190": "SR",
    "M400": "",
}
_MARLIN = {"G28": "XYZW", "G29": "", "G80": "", "M17": "XYZ", "M18": "XYZES", "M42": "PSIT"}
_MARLIN |= {"M201": _AXES, "M204": "PRTS", "M900": "KLST"}
_DUET = {"G29": "SP", "M42": "PS", "M201": _AXES, "M572": "DS"}
_REPETIER = {"M42": "PS", "M201": _AXES, "M202": _AXES}
_GRIFFIN = {"G280": "S", "M42": "PS", "T0": ""}
#: Klipper's own take words for letters.
_KLIPPER = {"SET_PRESSURE_ADVANCE": ["ADVANCE"], "SET_VELOCITY_LIMIT": ["ACCEL"]}
_KLIPPER |= {"SET_PIN": ["PIN", "VALUE"]}
#: Macros that the makers' own configurations bring.
_MACROS = {"PRINT_START": "", "PRINT_END": "", "START_PRINT": ["EXTRUDER_TEMP", "BED_TEMP"]}
DOCUMENTED = {
    "marlin": _COMMON | _MARLIN,
    "reprapfirmware": _COMMON | _DUET,
    "repetier": _COMMON | _REPETIER,
    "griffin": _COMMON | _GRIFFIN,
    "klipper": _COMMON | _KLIPPER | _MACROS,
}


def undocumented(text, flavor):
    """Return the commands, with their letters, of which a firmware's documents say nothing."""
    found = set()
    for line in text.splitlines():
        name, *words = line.partition(";")[0].split() or [""]
        letters = [re.match(r"[A-Z_]+", word)[0] for word in words]
        known = DOCUMENTED[flavor].get(name)
        if name and (known is None or not set(letters) <= set(known)):
            found.add(" ".join([name, *letters]))
    return found

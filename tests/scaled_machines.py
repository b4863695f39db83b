"""Machines that are so many times as large as another, and as fast."""

from wireprint.settings import Settings

#: Lengths and speeds of a profile that grow with the machine.
GROWING = [
    *(f"head.{name}_mm" for name in ("nozzle", "tip_radius", "cone_height", "block_radius")),
    *(f"head.{name}_mm" for name in ("carriage_height", "carriage_radius")),
    *(f"motion.max_z_{name}" for name in ("velocity", "accel")),
    *(f"speeds.{name}_mm_s" for name in ("print", "travel", "first_layer")),
    *(f"wire.{name}_mm" for name in ("span_limit", "free_end_limit", "cap_spacing")),
    *(f"wire.{name}_mm" for name in ("deviation_target", "travel_lift")),
]


def scaled(machine, factor):
    """Settings of a machine that is so many times as large, and as fast."""
    plain = Settings.load(*machine)
    overrides = [f"wire.pause_s={plain.pause_s}"]
    for name in GROWING:
        section, key = name.split(".")
        of = plain.wire if section == "wire" else getattr(plain.printer, section)
        overrides.append(f"{name}={getattr(of, key) * factor}")
    if plain.printer.motion.marlin is not None:
        # A firmware's own limits of the slow axis.
        for name in ("max_velocity", "max_accel"):
            grown = [limit * factor for limit in getattr(plain.printer.motion.marlin, name)]
            overrides.append(f"motion.marlin.{name}={grown}")
    overrides.append(f"extruder.max_flow_mm3_s={plain.printer.extruder.max_flow_mm3_s * factor**3}")
    return Settings.load(*machine, overrides=overrides)

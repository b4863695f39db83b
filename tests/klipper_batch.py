"""A printer's configuration for Klipper itself, on its simulated board, and a file run by it.

WIREPRINT_KLIPPER names a checkout of Klipper with ``out/klipper.dict``, for the Linux process
(``cp test/configs/linuxprocess.config .config && make olddefconfig && make``), and
WIREPRINT_KLIPPER_PYTHON, or this Python, has its modules
(``pip install cffi greenlet jinja2 pyserial msgspec``).
"""

import os
import subprocess
import sys
from pathlib import Path

CHECKOUT = Path(os.environ.get("WIREPRINT_KLIPPER") or "/nowhere")
_BOARD = CHECKOUT / "out" / "klipper.dict"
_PYTHON = os.environ.get("WIREPRINT_KLIPPER_PYTHON", sys.executable)

#: What the makers' own configurations bring.
MACROS = """
[gcode_macro PRINT_START]
gcode:
    G28
[gcode_macro START_PRINT]
gcode:
    G28
[gcode_macro PRINT_END]
gcode:
    M104 S0
    M140 S0
"""


def stepper(section, first, options):
    """A motor's section, whose pins are numbered from the first on."""
    pins = {"step_pin": first, "dir_pin": first + 1, "enable_pin": first + 2}
    lines = [f"{key}: gpiochip0/gpio{number}" for key, number in pins.items()]
    lines += ["microsteps: 16", "rotation_distance: 40"]
    return "\n".join([f"[{section}]", *lines, *(f"{k}: {v}" for k, v in options.items()), ""])


def axes(printer):
    """The three axes' sections."""
    bed, homing, motion = printer.bed, printer.homing, printer.motion
    if printer.kinematics == "delta":
        geometry = {"arm_length": motion.arm_length, "position_endstop": motion.endstop_height}
        return [
            stepper(
                f"stepper_{tower}",
                10 * number,
                {"endstop_pin": f"gpiochip1/gpio{number}", **geometry},
            )
            for number, tower in enumerate("abc")
        ]
    # Homing may lead beside the bed.
    reach = {"x": bed.width_mm, "y": bed.depth_mm, "z": bed.height_mm}
    ends = {"x": homing.x_mm or 0.0, "y": homing.y_mm or 0.0, "z": 0.0}
    if homing.z_end == "top":
        ends["z"] = bed.height_mm
    return [
        stepper(
            f"stepper_{axis}",
            10 * number,
            {
                "endstop_pin": f"gpiochip1/gpio{number}",
                "position_endstop": ends[axis],
                "position_min": min(0.0, ends[axis]),
                "position_max": max(reach[axis], ends[axis]),
                "homing_positive_dir": ends[axis] > reach[axis] / 2,
            },
        )
        for number, axis in enumerate("xyz")
    ]


def configuration(printer, folder):
    """The whole of a ``printer.cfg``."""
    motion, head, extruder = printer.motion, printer.head, printer.extruder
    limits = {"max_velocity": motion.max_velocity, "max_accel": motion.max_accel}
    limits |= {"max_z_velocity": min(motion.max_z_velocity, motion.max_velocity)}
    limits |= {"square_corner_velocity": motion.square_corner_velocity}
    if printer.kinematics == "delta":
        limits |= {"delta_radius": motion.delta_radius, "minimum_z_position": -5}
    else:
        limits |= {"max_z_accel": min(motion.max_z_accel, motion.max_accel)}
    heats = "heater_pin: gpiochip2/gpio{}\nsensor_type: Generic 3950\nsensor_pin: analog{}\n"
    heats += "control: watermark\nmin_temp: 0\nmax_temp: 400\n"
    feeds = {
        "nozzle_diameter": head.nozzle_mm,
        "filament_diameter": extruder.filament_diameter_mm,
        "max_extrude_only_velocity": motion.max_extrude_only_velocity,
        "max_extrude_only_accel": motion.max_extrude_only_accel,
    }
    return "\n".join(
        [
            f"[mcu]\nserial: {folder}/none\n",
            "[printer]",
            f"kinematics: {printer.kinematics}",
            *(f"{key}: {value}" for key, value in limits.items()),
            "",
            *axes(printer),
            stepper("extruder", 40, feeds) + heats.format(0, 0),
            "[heater_bed]\n" + heats.format(1, 1),
            "[fan]\npin: gpiochip2/gpio2\n",
            # It knows M73.
            "[display_status]\n",
            MACROS,
        ]
    )


def ready():
    """Whether there is a Klipper to carry files out."""
    return _BOARD.is_file()


def complaints(printer, gcode, folder):
    """Have Klipper carry a file out in an empty folder; return what it says against it."""
    (folder / "printer.cfg").write_text(configuration(printer, folder))
    (folder / "print.gcode").write_bytes(gcode)
    log = folder / "klippy.log"
    call = [_PYTHON, str(CHECKOUT / "klippy" / "klippy.py"), str(folder / "printer.cfg")]
    call += ["-i", str(folder / "print.gcode"), "-o", str(folder / "out"), "-l", str(log)]
    done = subprocess.run([*call, "-d", str(_BOARD)], capture_output=True, timeout=300, check=False)
    said = log.read_text(errors="replace") if log.exists() else str(done.stderr)
    if done.returncode:
        return [f"Klipper stops with {done.returncode}: {said[-2000:]}"]
    return [line for line in said.splitlines() if "Unknown command" in line]

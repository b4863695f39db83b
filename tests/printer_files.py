"""Files that say what a printer is, as firmware and slicers write them, of made-up printers."""

import io
import json
import zipfile

KLIPPER = """
# A bed slinger.
[include mcu/*.cfg]
[include macros.cfg]

[stepper_x]
step_pin: PB9
microsteps: 16
rotation_distance: 40
position_endstop: -4
position_min: -4
position_max: 231   # as far as the switch

[stepper_y]
position_endstop = 0
position_max = 222

[stepper_z]
position_min: -3
position_max: 243

[extruder]
nozzle_diameter: 0.600
filament_diameter: 1.750
max_extrude_only_velocity: 61
pressure_advance: 0.05
pid_Kp: 20

[safe_z_home]
home_xy_position: 110,112.5
z_hop: 8

[firmware_retraction]
retract_length: 0.9
retract_speed: 41

[printer]
kinematics: cartesian
max_velocity: 280
max_accel: 2700
max_z_velocity: 9
max_z_accel: 90
square_corner_velocity: 6.5

#*# <---------------------- SAVE_CONFIG ---------------------->
#*# DO NOT EDIT THIS BLOCK OR BELOW. The contents are auto-generated.
#*#
#*# [extruder]
#*# pressure_advance = 0.031
"""

KLIPPER_MACROS = """
[gcode_macro START_PRINT]
gcode:
    {% set BED_TEMP = params.BED_TEMP|default(60)|float %}
    {% set EXTRUDER_TEMP = params.EXTRUDER_TEMP|default(190)|float %}
    M140 S{BED_TEMP}
    G90
    G28
    M190 S{BED_TEMP}
    M109 S{EXTRUDER_TEMP}

[gcode_macro END_PRINT]
gcode:
    M140 S0
    M104 S0
    M106 S0
    G91
    G1 X-2 Y-2 E-3 F300
    G1 Z10 F3000
    G90
    M84
"""

DELTA = """
[printer]
kinematics: delta
max_velocity: 310
max_accel: 3100
max_z_velocity: 155
delta_radius: 151.5
print_radius: 112

[stepper_a]
rotation_distance: 40
microsteps: 16
position_endstop: 371.5
arm_length: 281
[stepper_b]
rotation_distance: 40
[stepper_c]
rotation_distance: 40

[extruder]
nozzle_diameter: 0.4
filament_diameter: 1.75
"""

SLIC3R = {
    "printer_settings_id": "Maker One",
    "printer_model": "MAKER1",
    "gcode_flavor": "marlin2",
    "bed_shape": "0x0,231x0,231x212,0x212",
    "max_print_height": "243",
    "nozzle_diameter": "0.6",
    "filament_diameter": "1.75",
    "machine_max_feedrate_x": "210,180",
    "machine_max_feedrate_y": "205,180",
    "machine_max_feedrate_z": "13,12",
    "machine_max_feedrate_e": "90,80",
    "machine_max_acceleration_x": "1300,960",
    "machine_max_acceleration_y": "1250,960",
    "machine_max_acceleration_z": "210,200",
    "machine_max_acceleration_e": "5100,5000",
    "machine_max_acceleration_extruding": "1260,960",
    "machine_max_acceleration_retracting": "1230,960",
    "machine_max_acceleration_travel": "1510,1250",
    "machine_max_jerk_x": "8,8",
    "machine_max_jerk_y": "7,8",
    "machine_max_jerk_z": "0.3,0.4",
    "machine_max_jerk_e": "4.5,1.5",
    "retract_length": "0.75",
    "retract_speed": "36",
    "deretract_speed": "24 # a remark, as some bundles have it",
    "filament_max_volumetric_speed": "14",
    "extruder_clearance_radius": "46",
    "extruder_clearance_height": "17",
    "first_layer_temperature": "218",
    "temperature": "212",
    "first_layer_bed_temperature": "61",
    "bed_temperature": "58",
    "thumbnails": "16x16/QOI, 313x173/QOI, 640x480/PNG",
    "start_gcode": (
        "G90\\nM83\\nM104 S{first_layer_temperature[0]} ; heat\\n"
        "M140 S[first_layer_bed_temperature]\\nM190 S[first_layer_bed_temperature]\\n"
        'M109 S[first_layer_temperature]\\nG28 W\\n{if filament_type[0]=="FLEX"}G1 X999'
        "{else}G80 X{first_layer_print_min[0]} Y{first_layer_print_min[1]}{endif}\\n"
        "M117 {somebody_knows}\\nM907 E{unheard_of*2}\\nG1 Y-3 F1000\\nG1 X60 E9 F1000"
    ),
    "end_gcode": (
        "{if max_layer_z < max_print_height}G1 Z{z_offset+min(max_layer_z+1, max_print_height)}"
        " F720 ; up{endif}\\nM104 S0\\nM140 S0\\nM107\\nG1 X200 Y170 F3600\\nM84 X Y E"
    ),
}

ORCA_BASE = {
    "type": "machine",
    "name": "fdm_maker_common",
    "from": "system",
    "gcode_flavor": "marlin",
    "printable_height": "243",
    "nozzle_diameter": ["0.4"],
    "machine_max_speed_x": ["410", "200"],
    "machine_max_speed_y": ["400", "200"],
    "machine_max_speed_z": ["21", "20"],
    "machine_max_speed_e": ["31", "30"],
    "machine_max_acceleration_x": ["11000", "20000"],
    "machine_max_acceleration_y": ["10500", "20000"],
    "machine_max_acceleration_z": ["510", "200"],
    "machine_max_acceleration_e": ["5050", "5000"],
    "machine_max_acceleration_extruding": ["10100", "20000"],
    "machine_max_acceleration_retracting": ["4900", "5000"],
    "machine_max_jerk_x": ["9", "9"],
    "machine_max_jerk_y": ["9", "9"],
    "machine_max_jerk_z": ["3", "3"],
    "machine_max_jerk_e": ["2.5", "2.5"],
    "retraction_length": ["0.8"],
    "retraction_speed": ["33"],
    "deretraction_speed": ["29"],
    "machine_start_gcode": (
        "M140 S[bed_temperature_initial_layer_single]\n"
        "M104 S{nozzle_temperature_initial_layer[0]}\n"
        "G28\nG29 A\nM190 S[bed_temperature_initial_layer_single]\n"
        "M109 S[nozzle_temperature_initial_layer]\nG1 X20 Y5 Z0.3 E12"
    ),
    "machine_end_gcode": "G1 Z{max_layer_z + 2} F600\nM104 S0\nM140 S0\nM106 S0\nM84",
}
ORCA = {
    "type": "machine",
    "name": "Maker Cube 0.6 nozzle",
    "inherits": "fdm_maker_common",
    "printer_model": "Maker Cube",
    "printer_structure": "corexy",
    "printable_area": ["0x0", "221x0", "221x212", "0x212"],
    "nozzle_diameter": ["0.6"],
    "extruder_clearance_height_to_rod": "36",
    "extruder_clearance_radius": "57",
    "thumbnails": ["48x48/PNG", "300x300/PNG"],
}

CURA_BASE = {
    "name": "Maker Base",
    "version": 2,
    "inherits": "fdmprinter",
    "overrides": {
        "machine_max_feedrate_x": {"value": 320},
        "machine_max_feedrate_z": {"value": 11},
        "machine_max_feedrate_e": {"value": 52},
        "machine_acceleration": {"value": 510},
        "machine_start_gcode": {
            "default_value": (
                "G28 ;Home\nM190 S{material_bed_temperature_layer_0}\n"
                "M109 S{material_print_temperature_layer_0}\nG1 X10.1 Y20 Z0.28 F5000.0\n"
                "G1 X10.1 Y200.0 Z0.28 F1500.0 E15 ;Draw the first line\nG92 E0"
            )
        },
        "machine_end_gcode": {
            "default_value": "G91\nG1 E-2 Z0.2 F2400\nG90\nG1 X0 Y{machine_depth}\nM104 S0\nM140 S0"
        },
        "retraction_speed": {"value": 47},
    },
}
CURA_EXTRUDER = {
    "name": "Extruder 1",
    "version": 2,
    "inherits": "fdmextruder",
    "overrides": {
        "machine_nozzle_size": {"default_value": 0.5},
        "material_diameter": {"default_value": 2.85},
    },
}
CURA = {
    "name": "Maker Two",
    "version": 2,
    "inherits": "maker_base",
    "metadata": {"machine_extruder_trains": {"0": "maker_two_extruder_0"}},
    "overrides": {
        "machine_name": {"default_value": "Maker Two"},
        "machine_width": {"default_value": 236},
        "machine_depth": {"default_value": 227},
        "machine_height": {"default_value": 252},
        "gantry_height": {"value": 26},
        "machine_head_with_fans_polygon": {
            "default_value": [[-26, 34], [-26, -32], [32, -32], [32, 34]]
        },
        "retraction_amount": {"default_value": 5.5},
        "line_width": {"value": "machine_nozzle_size * 1.1"},
        "machine_gcode_flavor": {"default_value": "RepRap (Marlin/Sprinter)"},
    },
}


def ini(config, **changes):
    """A PrusaSlicer file of its settings."""
    values = {key: value for key, value in (config | changes).items() if value is not None}
    return "# generated by PrusaSlicer 2.8.0\n" + "".join(f"{k} = {v}\n" for k, v in values.items())


def bundle():
    """A bundle of three printers, two of which inherit."""
    common = "".join(f"{k} = {v}\n" for k, v in SLIC3R.items() if k != "printer_settings_id")
    return (
        "[vendor]\nname = Maker\n\n[printer:*common*]\n" + common + "\n[printer:*wide*]\n"
        "nozzle_diameter = 0.8\n\n[printer:Maker One]\ninherits = *common*\n\n"
        "[printer:Maker One 0.8]\ninherits = *common*; *wide*\nmax_print_height = 200\n\n"
        "[filament:*PLA*]\ntemperature = 215\n[filament:Maker PLA]\ninherits = *PLA*\n"
        "filament_max_volumetric_speed = 9.5\n"
    )


def block(config, begin="; prusaslicer_config = begin", end="; prusaslicer_config = end"):
    """What a slicer leaves at the end of its G-code."""
    lines = [f"; {key} = {value}" for key, value in config.items()]
    return "\n".join(["G1 X1 Y1", "M84", "", begin, *lines, end, ""])


def orca_config():
    """OrcaSlicer's settings, as it writes them at the end of G-code and into projects."""
    return ORCA_BASE | {key: value for key, value in ORCA.items() if key != "inherits"}


def orca_block():
    """The same as lines of comments."""
    lines = {
        key: (",".join(value) if isinstance(value, list) else value).replace("\n", "\\n")
        for key, value in orca_config().items()
    }
    return block(lines, "; CONFIG_BLOCK_START", "; CONFIG_BLOCK_END")


def project(part, content):
    """A 3MF file with a part."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("3D/3dmodel.model", "<model/>")
        archive.writestr(part, content)
    return file.getvalue()


def cura_changes(definition=None):
    """Cura's changed settings in its G-code: JSON in pieces, its texts escaped once more."""
    machine = "" if definition is None else f"definition = {definition}\\n"
    values = "[values]\\nmachine_height = 199\\nretraction_amount = 3\\n"
    quality = f"[general]\\nversion = 4\\n{machine}\\n{values}"
    text = json.dumps({"global_quality": quality}).replace("\\\\", "\\\\\\\\")
    pieces = [text[at : at + 70] for at in range(0, len(text), 70)]
    head = ";FLAVOR:Marlin\n;TARGET_MACHINE.NAME:Maker Two\nG28\n"
    return head + "".join(f";SETTING_3 {piece}\n" for piece in pieces)


def cura_project(**changed):
    """A project of Cura's: the machine with what it inherits, in groups, and what was changed."""
    told = CURA_BASE["overrides"] | CURA["overrides"]
    as_text = {
        key: {one: f"={value}" if one == "value" else str(value) for one, value in entry.items()}
        for key, entry in told.items()
    }
    machine = {"label": "Machine", "children": {key: as_text.pop(key) for key in list(as_text)[:9]}}
    definition = {"name": "Maker Two", "settings": {"machine": machine, **as_text}}
    own = {"machine": {"children": CURA_EXTRUDER["overrides"]}}
    extruder = {"name": "Extruder", "settings": own}
    stack = "[general]\nname = {}\n\n[metadata]\nposition = {}\n\n[containers]\n{}"
    chains = {
        "attic #2.global.cfg": ("attic", "", ["attic_user", "empty_quality", "attic", "maker_two"]),
        "left #2.extruder.cfg": ("Left", "0", ["left_user", "nozzle", "maker_left"]),
        "right #2.extruder.cfg": ("Right", "1", ["right_user", "maker_left"]),
    }
    files = {
        "maker_two.def.json": json.dumps(definition, indent=4),
        "maker_left.def.json": json.dumps(extruder, indent=4),
        "attic_user.inst.cfg": "[values]\nmachine_height = 240\n",
        "attic.inst.cfg": "[values]\nmachine_height = 230\nretraction_speed = 41\n",
        "nozzle.inst.cfg": "[values]\nmachine_nozzle_size = 0.6\n",
        "left_user.inst.cfg": "[values]\nretraction_amount = =machine_nozzle_size * 10\n",
        "right_user.inst.cfg": "[values]\nmachine_nozzle_size = 0.25\n",
        "version.ini": "[versions]\ncura_version = 5.6.0\n",
    }
    for name, (called, position, chain) in chains.items():
        listed = "\n".join(f"{number} = {one}" for number, one in enumerate(chain))
        files[name] = stack.format(called, position, listed)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("3D/3dmodel.model", "<model/>")
        for name, content in (files | changed).items():
            archive.writestr(f"Cura/{name}", content)
    return file.getvalue()

"""Printers of other programs as profiles, figure by figure as their files say."""

import json
import tomllib

import pytest

import bgcode_files
import printer_files as files
from wireprint import examples, limits
from wireprint._core import SettingError
from wireprint.bounds import bounds_of
from wireprint.importing import imported
from wireprint.importing.completion import BOUNDED
from wireprint.importing.hotends import HOTENDS
from wireprint.importing.trial import tried
from wireprint.keys import described
from wireprint.lineage import namesake, tables
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.settings import Settings


@pytest.fixture
def folder(tmp_path):
    """All the kinds of files, side by side."""
    (tmp_path / "mcu").mkdir()
    (tmp_path / "mcu" / "board.cfg").write_text("[mcu]\nserial: /dev/ttyUSB0\n")
    (tmp_path / "macros.cfg").write_text(files.KLIPPER_MACROS)
    (tmp_path / "printer.cfg").write_text(files.KLIPPER)
    (tmp_path / "delta.cfg").write_text(files.DELTA)
    (tmp_path / "maker.ini").write_text(files.ini(files.SLIC3R))
    (tmp_path / "bundle.ini").write_text(files.bundle())
    (tmp_path / "fdm_maker_common.json").write_text(json.dumps(files.ORCA_BASE, indent=4))
    (tmp_path / "cube.json").write_text(json.dumps(files.ORCA, indent=4))
    (tmp_path / "maker_base.def.json").write_text(json.dumps(files.CURA_BASE, indent=4))
    (tmp_path / "maker_two.def.json").write_text(json.dumps(files.CURA, indent=4))
    extruder = json.dumps(files.CURA_EXTRUDER, indent=4)
    (tmp_path / "maker_two_extruder_0.def.json").write_text(extruder)
    (tmp_path / "cura.3mf").write_bytes(files.cura_project())
    (tmp_path / "prusa.gcode").write_text(files.block(files.SLIC3R))
    (tmp_path / "orca.gcode").write_text(files.orca_block())
    project = files.project("Metadata/project_settings.config", json.dumps(files.orca_config()))
    (tmp_path / "orca.3mf").write_bytes(project)
    lines = files.block(files.SLIC3R).replace("prusaslicer_config", "nothing")
    (tmp_path / "prusa.3mf").write_bytes(files.project("Metadata/Slic3r_PE.config", lines))
    return tmp_path


def flat(values, prefix=""):
    """A profile's figures by dotted key."""
    found = {}
    for key, value in values.items():
        within = isinstance(value, dict)
        found |= flat(value, f"{prefix}{key}.") if within else {f"{prefix}{key}": value}
    return found


def told(text):
    """The commands of a sequence."""
    return [line for line in text.splitlines() if line.strip()]


FIGURES = {
    "printer.cfg": {
        "kinematics": "cartesian",
        "bed.width_mm": 231,
        "bed.depth_mm": 222,
        "bed.height_mm": 243,
        "bed.origin": "corner",
        "head.nozzle_mm": 0.6,
        "motion.max_velocity": 280,
        "motion.max_accel": 2700,
        "motion.max_z_velocity": 9,
        "motion.max_z_accel": 90,
        "motion.square_corner_velocity": 6.5,
        "motion.max_extrude_only_velocity": 61,
        "homing.x_mm": -4,
        "homing.y_mm": 0,
        "homing.z_end": "bed",
        "homing.lift_mm": 8,
        "homing.z_place_mm": [110, 112.5],
        "extruder.retract_mm": 0.9,
        "extruder.retract_speed_mm_s": 41,
        "extruder.filament_diameter_mm": 1.75,
        # What SAVE_CONFIG keeps wins.
        "extruder.pressure_lag_s": 0.031,
        "gcode.flavor": "klipper",
    },
    "delta.cfg": {
        "kinematics": "delta",
        "bed.shape": "round",
        "bed.diameter_mm": 224,
        "bed.origin": "centre",
        "motion.delta_radius": 151.5,
        "motion.arm_length": 281,
        "motion.endstop_height": 371.5,
        "motion.print_radius": 112,
        "motion.step_distance": 0.0125,
        "motion.max_z_velocity": 155,
        "motion.max_z_accel": 3100,
    },
    "maker.ini": {
        "name": "Maker One",
        "known_as": ["Maker One"],
        "kinematics": "cartesian",
        "bed.shape": "rectangular",
        "bed.width_mm": 231,
        "bed.depth_mm": 212,
        "bed.height_mm": 243,
        "head.nozzle_mm": 0.6,
        "head.carriage_height_mm": 17,
        "head.carriage_radius_mm": 46,
        "motion.max_velocity": 210,
        "motion.max_accel": 1260,
        "motion.max_z_velocity": 13,
        "motion.max_extrude_only_velocity": 90,
        "motion.marlin.max_velocity": [210, 205, 13, 90],
        "motion.marlin.max_accel": [1300, 1250, 210, 5100],
        "motion.marlin.jerk": [8, 7, 0.3, 4.5],
        "motion.marlin.print_accel": 1260,
        "motion.marlin.travel_accel": 1510,
        "motion.marlin.retract_accel": 1230,
        "extruder.retract_mm": 0.75,
        "extruder.retract_speed_mm_s": 36,
        "extruder.unretract_speed_mm_s": 24,
        "extruder.max_flow_mm3_s": 14,
        "gcode.flavor": "marlin",
        "gcode.thumbnails": [[16, 16, "QOI"], [313, 173, "QOI"], [640, 480]],
    },
    "cube.json": {
        "name": "Maker Cube",
        "kinematics": "corexy",
        "bed.width_mm": 221,
        "bed.depth_mm": 212,
        "bed.height_mm": 243,
        "head.nozzle_mm": 0.6,
        "head.carriage_height_mm": 36,
        "head.carriage_radius_mm": 57,
        "motion.max_velocity": 410,
        "motion.max_accel": 10100,
        "motion.max_z_velocity": 21,
        "motion.marlin.max_velocity": [410, 400, 21, 31],
        "motion.marlin.max_accel": [11000, 10500, 510, 5050],
        "motion.marlin.jerk": [9, 9, 3, 2.5],
        "motion.marlin.travel_accel": 10100,
        "extruder.retract_mm": 0.8,
        "extruder.retract_speed_mm_s": 33,
        "extruder.unretract_speed_mm_s": 29,
        "gcode.thumbnails": [[48, 48], [300, 300]],
    },
    "maker_two.def.json": {
        "name": "Maker Two",
        "bed.width_mm": 236,
        "bed.depth_mm": 227,
        "bed.height_mm": 252,
        # Its extruder has a file of its own.
        "head.nozzle_mm": 0.5,
        "extruder.filament_diameter_mm": 2.85,
        "head.carriage_height_mm": 26,
        "head.carriage_radius_mm": 46.7,
        "motion.max_velocity": 320,
        "motion.max_accel": 510,
        "motion.max_z_velocity": 11,
        "motion.max_extrude_only_velocity": 52,
        "extruder.retract_mm": 5.5,
        "extruder.retract_speed_mm_s": 47,
        "gcode.flavor": "marlin",
    },
}
FIGURES["cura.3mf"] = FIGURES["maker_two.def.json"] | {
    # The nozzle's own file, what was changed of the machine, and by its user.
    "head.nozzle_mm": 0.6,
    "bed.height_mm": 240,
    "extruder.retract_mm": 6,
    "extruder.retract_speed_mm_s": 41,
}
FIGURES["prusa.gcode"] = FIGURES["prusa.3mf"] = FIGURES["maker.ini"]
FIGURES["orca.gcode"] = FIGURES["orca.3mf"] = FIGURES["cube.json"]


@pytest.mark.parametrize("name", FIGURES)
def test_each_figure_is_what_the_file_says(folder, name):
    found = flat(imported([folder / name], hotend="v6").values)
    assert {key: found.get(key) for key in FIGURES[name]} == FIGURES[name]


@pytest.mark.parametrize("name", FIGURES)
def test_what_is_imported_is_a_profile_that_prints(folder, name):
    found, settings = tried(imported([folder / name], hotend="v6"))
    mine = folder / "mine.toml"
    mine.write_text(found.text(), encoding="utf-8")
    assert Settings.load(str(mine)).printer == settings.printer
    assert tomllib.loads(found.text()) == found.values


@pytest.mark.parametrize("name", FIGURES)
def test_each_figure_names_file_line_and_key_or_is_called_an_estimate(folder, name):
    found = imported([folder / name], hotend="v6")
    for key, comment in found.comments.items():
        assert comment, key
    lines = (folder / "printer.cfg").read_text().splitlines()
    if name == "printer.cfg":
        place = found.comments["bed", "width_mm"]
        number = lines.index("position_max: 231   # as far as the switch") + 1
        assert place == f"printer.cfg:{number}, position_max"


def test_a_start_macro_is_called_with_the_temperatures_that_it_asks_for(folder):
    gcode = imported([folder / "printer.cfg"], hotend="v6").values["gcode"]
    assert told(gcode["start"]) == [
        "START_PRINT BED_TEMP={bed_c} EXTRUDER_TEMP={nozzle_c}",
        "M190 S{bed_c}",
        "M109 S{nozzle_c}",
    ]
    # An end macro is written out, so that it can be judged, behind a rise above the print.
    assert told(gcode["end"]) == [
        "G90",
        "G1 Z{park_z_mm} F600",
        "M140 S0",
        "M104 S0",
        "M106 S0",
        "G91",
        "G1 X-2 Y-2 E-3 F300",
        "G90",
        "M84",
    ]


def test_options_may_stand_further_in_than_their_section(folder):
    lines = files.KLIPPER.replace("[include mcu/*.cfg]\n[include macros.cfg]\n", "").splitlines()
    within = [line if line.startswith(("[", "#")) else f"    {line}" for line in lines]
    macro = [
        "[gcode_macro END_PRINT]",
        "  description: ends",
        "  gcode:",
        "    M104 S0",
        "    M140 S0",
    ]
    (folder / "indented.cfg").write_text("\n".join([*within, *macro]))
    (folder / "flat.cfg").write_text("\n".join(lines))
    found = imported([folder / "indented.cfg"], hotend="v6").values
    flat_one = imported([folder / "flat.cfg"], hotend="v6").values
    assert found["motion"] == flat_one["motion"]
    assert found["homing"] == flat_one["homing"]
    assert "M104 S0" in found["gcode"]["end"]


def test_a_macro_with_logic_is_not_believed(folder):
    macros = "[gcode_macro PRINT_END]\ngcode:\n  {% if printer.x %}\n  G1 X0\n  {% endif %}\n"
    (folder / "macros.cfg").write_text(macros)
    found = imported([folder / "printer.cfg"], hotend="v6")
    assert "PRINT_END" not in found.values["gcode"]["end"]
    assert any("PRINT_END decides by itself" in remark for remark in found.remarks)


def test_placeholders_are_resolved_or_named(folder):
    found = imported([folder / "maker.ini"], hotend="v6")
    assert told(found.values["gcode"]["start"]) == [
        "G90",
        "M83",
        "M104 S{nozzle_c}",
        "M140 S{bed_c}",
        "M190 S{bed_c}",
        "M109 S{nozzle_c}",
        "G28 W",
        "G80",
    ]
    assert told(found.values["gcode"]["end"]) == [
        "G1 Z{park_z_mm} F720",
        "M104 S0",
        "M140 S0",
        "M107",
        "G1 X200 Y170 F3600",
        "M84 X Y E",
    ]
    assert any("M907 E{unheard_of*2}" in remark for remark in found.remarks)
    assert any("G1 Y-3 F1000; G1 X60 E9 F1000" in remark for remark in found.remarks)


def test_a_bundle_asks_which_printer_is_meant(folder):
    with pytest.raises(SettingError, match=r"a bundle of 2 printers; .*Maker One, Maker One 0\.8"):
        imported([folder / "bundle.ini"], hotend="v6")
    with pytest.raises(
        SettingError, match="no printer is called 'Maker Oen'; did you mean Maker One"
    ):
        imported([folder / "bundle.ini"], hotend="v6", preset="Maker Oen")
    found = flat(imported([folder / "bundle.ini"], hotend="v6", preset="Maker One 0.8").values)
    assert (found["head.nozzle_mm"], found["bed.height_mm"]) == (0.8, 200)


def test_several_files_complete_each_other(folder):
    (folder / "filament.ini").write_text(
        "filament_max_volumetric_speed = 8\nnozzle_diameter = 0.6\n"
    )
    found = imported([folder / "printer.cfg", folder / "filament.ini"], hotend="v6")
    assert found.values["extruder"]["max_flow_mm3_s"] == 8
    assert found.values["bed"]["width_mm"] == 231


def test_what_cura_changed_completes_a_printer_that_is_like_it(folder):
    (folder / "cura.gcode").write_text(files.cura_changes())
    with pytest.raises(SettingError, match=r"it does not say bed\.shape; .* --like"):
        imported([folder / "cura.gcode"], hotend="v6")
    from wireprint.lineage import tables

    like = ("prusa-mk4s", tables("prusa-mk4s"))
    found = flat(imported([folder / "cura.gcode"], like=like).values)
    assert found["name"] == "Maker Two"
    assert found["bed.height_mm"] == 199
    assert found["extruder.retract_mm"] == 3
    assert found["bed.width_mm"] == 250


def test_cura_says_which_of_its_files_has_the_rest(folder):
    (folder / "cura.gcode").write_text(files.cura_changes(definition="maker_two"))
    with pytest.raises(SettingError, match=r"maker_two\.def\.json has what it does not say"):
        imported([folder / "cura.gcode"], hotend="v6")
    both = [folder / "maker_two.def.json", folder / "cura.gcode"]
    found = flat(imported(both, hotend="v6").values)
    assert (found["bed.width_mm"], found["bed.height_mm"]) == (236, 199)


def test_binary_gcode_says_what_its_printer_is(folder):
    table = "".join(f"{key}={value}\n" for key, value in files.SLIC3R.items())
    (folder / "b.bgcode").write_bytes(
        bgcode_files.bgcode(
            bgcode_files.block(0, b"Producer=PrusaSlicer 2.8.0\n"),
            bgcode_files.block(3, b"printer_model=MAKER1\n"),
            bgcode_files.block(2, table.encode(), bgcode_files.DEFLATE),
            bgcode_files.block(1, b"G28\nG1 X1 ; moved\n" * 40),
        )
    )
    found = flat(imported([folder / "b.bgcode"], hotend="v6").values)
    wanted = FIGURES["maker.ini"]
    assert {key: found.get(key) for key in wanted} == wanted


def test_a_block_of_settings_ends_where_it_says(folder):
    lines = files.block(files.SLIC3R)
    after = "".join(f"; max_print_height = {height}\n" for height in range(30))
    (folder / "more.gcode").write_text(lines + after)
    assert imported([folder / "more.gcode"], hotend="v6").values["bed"]["height_mm"] == 243


@pytest.mark.parametrize(
    ("name", "content", "fault"),
    [
        ("maker_two.def.json", "{ no", "maker_two.def.json"),
        ("attic_user.inst.cfg", "machine_height = 1", "attic_user.inst.cfg: no settings of Cura"),
        (
            "attic_user.inst.cfg",
            "[values]\nmachine_height = tall",
            "attic_user.inst.cfg, machine_hei",
        ),
        ("attic #2.global.cfg", "[containers", "attic #2.global.cfg: no settings of Cura"),
        ("attic_user.inst.cfg", "\0", "attic_user.inst.cfg:1: it holds zeros"),
    ],
)
def test_what_is_damaged_of_a_project_of_curas_is_named(tmp_path, name, content, fault):
    (tmp_path / "p.3mf").write_bytes(files.cura_project(**{name: content}))
    with pytest.raises(SettingError) as error:
        imported([tmp_path / "p.3mf"], hotend="v6")
    assert fault in str(error.value)
    assert "p.3mf" in str(error.value)


def test_a_printer_of_ours_by_its_name_completes_what_is_not_said(tmp_path):
    config = files.SLIC3R | {"printer_settings_id": "my own", "printer_model": "MK4S"}
    (tmp_path / "mine.gcode").write_text(files.block(config))
    found = imported([tmp_path / "mine.gcode"], namesake=namesake)
    own = Settings.load("prusa-mk4s").printer
    assert found.values["name"] == "my own"
    assert found.values["head"]["slant_deg"] == own.head.slant_deg
    assert found.comments["head", "slant_deg"] == "as prusa-mk4s has it"
    assert any("'MK4S' is as our prusa-mk4s has it" in remark for remark in found.remarks)
    # What the file says is its own, and what is asked for goes before what is called alike.
    assert found.values["bed"]["width_mm"] == 231
    other = imported([tmp_path / "mine.gcode"], hotend="ultimaker", namesake=namesake)
    assert other.values["head"]["slant_deg"] == 45


def test_speeds_of_a_quicker_printer_are_kept_within_the_machines(folder):
    slow = files.SLIC3R | {"machine_max_feedrate_x": "120", "machine_max_feedrate_y": "120"}
    (folder / "slow.ini").write_text(files.ini(slow))
    found = imported([folder / "slow.ini"], like=("bambu-x1c", tables("bambu-x1c")))
    assert found.values["speeds"]["travel_mm_s"] == found.values["motion"]["max_velocity"] == 120
    tried(found)


def test_the_heads_shape_is_asked_for(folder):
    with pytest.raises(
        SettingError, match=r"does not say the head's shape .*--hotend NAME \(v6, volcano"
    ):
        imported([folder / "printer.cfg"])
    with pytest.raises(SettingError, match="--hotend rapdio: did you mean rapido"):
        imported([folder / "printer.cfg"], hotend="rapdio")


@pytest.mark.parametrize("hotend", HOTENDS)
def test_every_hot_end_makes_a_head_that_prints(folder, hotend):
    found = imported([folder / "delta.cfg"], hotend=hotend)
    tried(found)
    assert found.values["head"]["slant_deg"] == HOTENDS[hotend].slant_deg


def test_a_delta_of_a_slicer_takes_its_geometry_from_one_that_is_like_it(folder):
    from math import cos, sin, tau

    corners = ",".join(
        f"{90 * cos(tau * i / 24):.9g}x{90 * sin(tau * i / 24):.9g}" for i in range(24)
    )
    (folder / "round.ini").write_text(files.ini(files.SLIC3R, bed_shape=corners))
    with pytest.raises(SettingError, match=r"motion\.delta_radius of a delta; .*printer\.cfg"):
        imported([folder / "round.ini"], hotend="v6")
    from wireprint.lineage import tables

    found = imported([folder / "round.ini"], like=("kossel-mini", tables("kossel-mini")))
    assert found.values["bed"]["diameter_mm"] == 180
    assert found.values["motion"]["delta_radius"] == 101


def test_a_file_of_another_program_is_a_printer_wherever_one_is_named(folder):
    cfg = folder / "printer.cfg"
    settings = Settings.load(f"{cfg}#rapido")
    assert settings.printer.bed.width_mm == 231
    assert Settings.load(f"{cfg}#prusa-mk4s").printer.head.slant_deg == 30
    with pytest.raises(SettingError, match="--hotend"):
        Settings.load(str(cfg))


def test_it_tells_the_limits_that_time_is_computed_from(folder):
    found = limits.of_file(str(folder / "printer.cfg"))
    assert (found["kinematics"], found["max_velocity"], found["max_accel"]) == (
        "cartesian",
        280,
        2700,
    )
    assert limits.of_file(str(folder / "maker.ini"))["marlin"]["jerk"] == (8, 7, 0.3, 4.5)


def test_a_bed_that_begins_beside_zero_keeps_its_middle(folder):
    (folder / "a.ini").write_text(files.ini(files.SLIC3R, bed_shape="5x0,215x0,215x220,5x220"))
    found = imported([folder / "a.ini"], hotend="mk8")
    assert found.values["bed"]["width_mm"] == 220
    assert any("keep to models of 210 × 220 mm" in remark for remark in found.remarks)


def test_a_users_preset_inherits_from_the_makers_in_the_slicers_own_folders(tmp_path):
    maker, own = tmp_path / "system" / "Maker" / "machine", tmp_path / "user" / "me" / "machine"
    maker.mkdir(parents=True)
    own.mkdir(parents=True)
    (maker / "fdm_maker_common.json").write_text(json.dumps(files.ORCA_BASE))
    (maker / "Maker Cube 0.6 nozzle.json").write_text(json.dumps(files.ORCA))
    mine = {"name": "Mine", "inherits": "Maker Cube 0.6 nozzle", "printable_height": "199"}
    (own / "Mine.json").write_text(json.dumps(mine))
    found = flat(imported([own / "Mine.json"], hotend="v6").values)
    assert (found["bed.height_mm"], found["bed.width_mm"]) == (199, 221)


def test_a_printers_usual_filament_and_print_complete_it(tmp_path):
    printer = {key: value for key, value in files.SLIC3R.items() if not key.startswith("filament_")}
    printer |= {
        "default_filament_profile": '"Good PLA";Other',
        "default_print_profile": "0.2 mm",
        "end_gcode": "G1 X5 F{travel_speed*60}\\nM106 S{min(255, (max_fan_speed[0] + 10) * 2.55)}",
    }
    lines = "".join(f"{key} = {value}\n" for key, value in printer.items())
    (tmp_path / "b.ini").write_text(
        "[vendor]\nname = Maker\ndefault speed =100\nsome[0] = 1\n[print:0.2 mm]\n"
        "travel_speed = 130\n"
        "[filament:Other]\nfilament_max_volumetric_speed = 3\n"
        "[filament:Good PLA]\nfilament_max_volumetric_speed = 13\nfilament_diameter = 1.75\n"
        f"max_fan_speed = 70\n[printer:Maker One]\n{lines}"
    )
    found = flat(imported([tmp_path / "b.ini"], hotend="v6").values)
    assert found["extruder.max_flow_mm3_s"] == 13
    assert told(found["gcode.end"])[2:4] == ["G1 X5 F7800", "M106 S204"]


def test_the_macro_that_starts_a_print_gets_what_is_known(tmp_path):
    start = (
        "PRINT_START EXTRUDER=[nozzle_temperature_initial_layer] LAYERS={nobody_knows},{a} "
        "PRINT_MIN={first_layer_print_min[0]},{first_layer_print_min[1]} SIZE={b} "
        "BED={bed_temperature}"
        "\n{e_retracted[0] = 2 * retract_length[0]}\nG29.1 Z{+0.0}"
        "\nM862 {if num_extruders > 1}T1{endif}\nSET_PIN PIN=a VALUE={nobody_knows}"
    )
    own = files.ORCA_BASE | files.ORCA | {"machine_start_gcode": start, "gcode_flavor": "klipper"}
    del own["inherits"]
    (tmp_path / "k.json").write_text(json.dumps(own))
    found = imported([tmp_path / "k.json"], hotend="v6")
    assert told(found.values["gcode"]["start"])[:4] == [
        "G28",
        "PRINT_START EXTRUDER={nozzle_c} PRINT_MIN={min_x_mm},{min_y_mm} BED={bed_c}",
        "G29.1 Z0",
        "M862",
    ]
    assert any("SET_PIN PIN=a VALUE={nobody_knows}" in remark for remark in found.remarks)


def test_a_start_sequence_is_told_what_the_print_covers(folder):
    _, settings = tried(imported([folder / "maker.ini"], hotend="v6"))
    cube = folder / "cube.stl"
    cube.write_bytes(examples.stl("cube"))
    start = (
        settings.printer.gcode.start + "M555 X{min_x_mm} Y{min_y_mm:d} W{max_x_mm} H{max_y_mm:.1f}"
    )
    gcode = settings.printer.gcode.model_copy(update={"start": start})
    printer = settings.printer.model_copy(update={"gcode": gcode})
    made = make(load_mesh(cube), settings.model_copy(update={"printer": printer}))
    line = next(one for one in made.gcode.decode().splitlines() if one.startswith("M555"))
    low_x, low_y, high_x, high_y = (float(word[1:]) for word in line.split()[1:])
    laid = made.toolpath.to[made.toolpath.filament > 0]
    assert (low_x, high_x) == pytest.approx((laid[:, 0].min(), laid[:, 0].max()), abs=1e-3)
    assert (low_y, high_y) == pytest.approx((laid[:, 1].min(), laid[:, 1].max()), abs=0.5)


def test_a_figure_that_stands_for_no_limit_is_the_most_that_there_is(folder):
    fast = {f"machine_max_feedrate_{axis}": "30000" for axis in "xyze"}
    (folder / "fast.ini").write_text(files.ini(files.SLIC3R, max_print_height="0.5", **fast))
    with pytest.raises(SettingError, match=r"fast\.ini:\d+, max_print_height: 0\.5 is less"):
        imported([folder / "fast.ini"], hotend="v6")
    (folder / "fast.ini").write_text(files.ini(files.SLIC3R, **fast))
    found = imported([folder / "fast.ini"], hotend="v6")
    assert found.values["motion"]["marlin"]["max_velocity"] == [5000] * 4
    assert any("machine_max_feedrate_x: 30000 is taken as 5000" in one for one in found.remarks)
    tried(found)


def test_an_extruders_own_file_stands_above_the_machines(folder):
    child = {"version": 2, "inherits": "maker_two", "name": "Three"}
    child["overrides"] = {"machine_nozzle_size": {"default_value": 0.8}}
    child["metadata"] = {"machine_extruder_trains": {"0": "3-d ex"}}
    own = {"overrides": {"machine_nozzle_size": {"default_value": 0.6}}}
    (folder / "3-d ex.def.json").write_text(json.dumps(own))
    (folder / "three.def.json").write_text(json.dumps(child))
    found = flat(imported([folder / "three.def.json"], hotend="v6").values)
    assert (found["head.nozzle_mm"], found["extruder.filament_diameter_mm"]) == (0.6, 2.85)


def test_what_bounds_an_imported_figure_bounds_a_profiles():
    known = {key.short: (key.low, key.high) for key in described(Settings)}
    for key, kind in BOUNDED.items():
        # Lists have no bounds of their own, but their parts'.
        assert known[key] in (bounds_of(kind), (None, None)), key


def test_an_ultimaker_of_cura_heats_and_homes_by_itself(folder):
    own = {key: dict(value) for key, value in files.CURA["overrides"].items()}
    own |= {"machine_gcode_flavor": {"default_value": "Griffin"}}
    own |= {key: {"default_value": ""} for key in ("machine_start_gcode", "machine_end_gcode")}
    (folder / "um.def.json").write_text(json.dumps(files.CURA | {"overrides": own}))
    found, settings = tried(imported([folder / "um.def.json"], hotend="v6"))
    assert settings.printer.gcode.flavor == "griffin"
    assert told(found.values["gcode"]["start"]) == ["T0", "M109 S{nozzle_c}", "G280 S1"]

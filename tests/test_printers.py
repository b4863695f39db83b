"""Each printer of the package: what it prints, what its firmware is told, what it shows."""

import io
import re
from functools import cache

import pytest

import everyday
import wireprint
from firmware_words import undocumented
from print_files import beyond, pictures, wanted
from wireprint import Settings, catalogue, limits
from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.standing import Standing

PRINTERS = catalogue.names("printers")


@pytest.fixture(scope="module")
def models():
    return everyday.meshes()


@cache
def settings_of(printer, nozzle_mm=None):
    return Settings.load(printer, "pla", nozzle_mm=nozzle_mm)


@pytest.fixture(scope="module")
def cubes(models):
    """The cube's G-code on each printer."""

    @cache
    def made(printer):
        return wireprint.make(models["cube"], settings_of(printer), compare=False).gcode.decode()

    return made


def test_two_dozen_printers_are_there():
    assert len(PRINTERS) >= 24
    family = {name.partition("-")[0] for name in PRINTERS}
    makers = "prusa bambu voron ender creality anycubic neptune sidewinder flsun kossel ultimaker"
    assert family >= set(makers.split())


@pytest.mark.parametrize("printer", PRINTERS)
@pytest.mark.parametrize("name", ["cube", "bottle", "mug"])
def test_each_printer_prints_the_usual_things_certified_and_whole(models, printer, name):
    settings = settings_of(printer).but(overrides=["gcode.thumbnails=[]"])
    made = wireprint.make(models[name], settings, compare=False)
    assert made.certificate.ok
    # Judged once more by its name alone, as a stranger's file would be.
    assert check(made.gcode, printer).ok


@pytest.mark.parametrize("printer", PRINTERS)
@pytest.mark.parametrize("nozzle_mm", [0.4, 0.6, 0.8])
def test_each_printer_prints_with_each_usual_nozzle(models, printer, nozzle_mm):
    settings = settings_of(printer, nozzle_mm).but(overrides=["gcode.thumbnails=[]"])
    made = wireprint.make(models["cube"], settings, compare=False)
    assert made.certificate.ok


@pytest.mark.parametrize("printer", PRINTERS)
def test_its_firmware_documents_every_command_and_letter(cubes, printer):
    assert undocumented(cubes(printer), settings_of(printer).printer.gcode.flavor) == set()


@pytest.mark.parametrize("flavor", ["marlin", "reprapfirmware", "repetier", "klipper"])
@pytest.mark.parametrize("cooling", ["fan", "valve"])
def test_each_firmware_documents_what_any_printer_is_told(models, flavor, cooling):
    overrides = [f"gcode.flavor={flavor}", f"cooling.method={cooling}", "gcode.start=G28"]
    overrides += ["gcode.end=M84", "gcode.thumbnails=[]"]
    overrides += ["cooling.valve_pin=4", "cooling.valve_output=air"]
    settings = settings_of("prusa-mk4s").but(overrides=overrides)
    made = wireprint.make(models["cube"], settings, compare=False)
    assert undocumented(made.gcode.decode(), flavor) == set()


@pytest.mark.parametrize("printer", PRINTERS)
def test_no_move_asks_for_more_than_the_machine_has(models, printer):
    settings = settings_of(printer).but(overrides=["gcode.thumbnails=[]"])
    made = wireprint.make(models["mug"], settings, compare=False)
    assert beyond(made.gcode.decode(), settings.printer) == []


@pytest.mark.parametrize("printer", PRINTERS)
def test_it_heats_homes_and_cools(cubes, printer):
    text = cubes(printer)
    start, _, rest = text.partition(";LAYER_CHANGE")
    assert re.search(r"^G28|^G280|^(PRINT_START|START_PRINT)", start, re.MULTILINE)
    assert re.search(rf"^M109 (T0 )?S{settings_of(printer).material.nozzle_c}", start, re.MULTILINE)
    end = rest[rest.rindex(";TYPE:") :]
    assert re.search(r"^M104 S0", end, re.MULTILINE) or "PRINT_END" in end


@pytest.mark.parametrize("printer", PRINTERS)
def test_its_pictures_are_found_as_its_firmware_looks_for_them(cubes, printer):
    found = pictures(cubes(printer))
    assert [tuple(told) for *told, _ in found] == wanted(settings_of(printer).printer)
    assert all(image.convert("RGBA").getextrema()[3][1] > 0 for *_, image in found)


@pytest.mark.parametrize("printer", PRINTERS)
def test_its_pictures_end_where_prusas_own_reader_still_looks_for_them(models, printer, tmp_path):
    made = wireprint.make(models["mug"], settings_of(printer), compare=False)
    pictures_end = made.gcode.rindex(b"; thumbnail") if b"; thumbnail" in made.gcode else 0
    # PrusaLink's py-gcode-metadata reads so many bytes from the start.
    assert pictures_end < 400_000
    reader = pytest.importorskip("gcode_metadata")
    (tmp_path / "mug.gcode").write_bytes(made.gcode)
    read = reader.FDMMetaData(str(tmp_path / "mug.gcode"))
    read.load(save_cache=False)
    shown = {f"{w}x{h}_{form}" for w, h, form in wanted(settings_of(printer).printer)}
    assert set(read.thumbnails) == shown
    assert read.data["filament_type"] == "PLA"


def test_the_makers_names_lead_to_their_printers():
    from wireprint.gcode.origin import known_printer

    said = {
        "Original Prusa MINI & MINI+ Input Shaper": "prusa-mini",
        "MK4": "prusa-mk4",
        "Bambu Lab A1 mini": "bambu-a1-mini",
        "ENDER3V2": "ender-3-v2",
        "Voron 0.1": "voron-0",
        "Creality K1": "creality-k1",
        "FLSun QQS Pro": "flsun-qqs",
    }
    for written, profile in said.items():
        assert known_printer(f"; printer_model = {written}\n".encode())[0] == profile


def test_no_two_printers_claim_the_same_name():
    claimed = [
        name
        for printer in PRINTERS
        for name in {
            re.sub(r"[^a-z0-9]", "", name.lower())
            for name in (printer, *settings_of(printer).printer.known_as)
        }
    ]
    assert {name for name in claimed if claimed.count(name) > 1} == set()


@pytest.mark.parametrize("printer", PRINTERS)
def test_klippers_limits_and_marlins_agree(printer):
    settings = settings_of(printer)
    motion = settings.printer.motion
    if limits.firmware_of(settings.printer) != "klipper" and motion.marlin is not None:
        assert motion.marlin.max_velocity[0] == motion.max_velocity
        assert motion.marlin.max_velocity[2] == motion.max_z_velocity
        assert motion.marlin.max_velocity[3] == motion.max_extrude_only_velocity


#: Printers that probe z in the middle of the bed, and whose makers switch the motors off.
FORGET_Z = {"bambu-a1", "bambu-a1-mini", "creality-k1", "neptune-4"}


@pytest.mark.parametrize("printer", PRINTERS)
def test_each_printer_prints_on_top_of_its_own_print_or_says_why_not(models, cubes, printer):
    settings = settings_of(printer).but(overrides=["gcode.thumbnails=[]"])
    text = cubes(printer).encode()
    before = Standing((("below.gcode", text),), settings=settings)
    options = {"standing": before, "at_mm": (0.0, 0.0, before.top_mm), "compare": False}
    if printer in FORGET_Z:
        with pytest.raises(UnprintableError, match=r"homes z at \(.*\), where something stands"):
            wireprint.make(models["cube"], settings, **options)
        return
    made = wireprint.make(models["cube"], settings, **options)
    assert made.certificate.ok
    assert check(text + made.gcode, printer).ok


@pytest.mark.parametrize("nozzle_mm", [0.4, 0.6, 0.8])
def test_a_usual_nozzle_is_no_smaller_head_than_the_printers(models, nozzle_mm):
    made = wireprint.make(models["mug"], settings_of("kossel-mini", nozzle_mm), compare=False)
    assert check(made.gcode).ok
    assert not check(made.gcode).remarks


def test_ultimakers_find_the_header_that_they_ask_for(cubes):
    text = cubes("ultimaker-s3")
    head = text[: text.index(";END_OF_HEADER\n")].splitlines()
    assert head[0] == ";START_OF_HEADER"
    told = dict(line[1:].split(":") for line in head[1:])
    asked = ["TARGET_MACHINE.NAME", "GENERATOR.NAME", "GENERATOR.VERSION", "GENERATOR.BUILD_DATE"]
    numbers = ["BUILD_PLATE.INITIAL_TEMPERATURE", "PRINT.TIME"]
    numbers += [f"PRINT.SIZE.{end}.{axis}" for end in ("MIN", "MAX") for axis in "XYZ"]
    numbers += [
        f"EXTRUDER_TRAIN.0.{key}"
        for key in ("NOZZLE.DIAMETER", "MATERIAL.VOLUME_USED", "INITIAL_TEMPERATURE")
    ]
    assert (told["HEADER_VERSION"], told["FLAVOR"]) == ("0.1", "Griffin")
    assert all(told[key] for key in asked)
    assert all(float(told[key]) >= 0 for key in numbers)
    assert float(told["PRINT.SIZE.MAX.Z"]) == pytest.approx(28, abs=0.5)
    # Their own reader, where it is installed.
    charon = pytest.importorskip("Charon.filetypes.GCodeFile")
    found = charon.GCodeFile.parseHeader(io.BytesIO(text.encode()))
    assert found["machine_type"] == "Ultimaker S3"

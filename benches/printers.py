"""Writes docs/printers.md: a cube, a bottle and a mug on every printer with every nozzle.

python benches/printers.py [-o PAGE] [--only TEXT] [--nozzles MM…] [--jobs N]

Each file is judged as it is made, and once more by its name alone; its moves, commands and pictures
are read by the readers of `tests/print_files.py`. Where WIREPRINT_KLIPPER names a checkout of
Klipper (see `tests/test_klipper_own.py`), Klipper carries out what is written for it. Exit code 1:
something is wrong with one; it is told.
"""

import argparse
import itertools
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

import shared_models

sys.path.append(str(shared_models.REPOSITORY / "tests"))

import everyday
import firmware_words
import klipper_batch
import print_files
from wireprint import Settings, catalogue, make, profile_text
from wireprint._core import WireprintError
from wireprint.certificate import check
from wireprint.duration import duration

NOZZLES_MM = (0.4, 0.6, 0.8)
MODELS = ("cube", "bottle", "mug")
PAGE = """# The printers

Written by `python benches/printers.py`: a cube of 28 mm, a bottle of 100 mm and a mug of 88 mm, in
PLA, on each printer with each usual nozzle. A time (of cube, bottle and mug) stands for a file that
is certified and whole, is judged clean once more by itself alone, asks for no more speed, flow or
room than the printer has, and has no command or letter that its firmware does not document; by
readers that are no part of the package.

{table}

{klipper}
Pictures were found as the firmware looks for them, and decoded. **Estimates** are figures of the
profile for which there was no source: where they are the head's, the [gauge](head.md) tells them.
"""


def judged(task):
    """Print one thing; return the task, its time, what is wrong, and whether Klipper ran it."""
    printer, nozzle_mm, model = task
    settings = Settings.load(printer, "pla", nozzle_mm=nozzle_mm)
    try:
        made = make(_models()[model], settings, compare=False)
    except WireprintError as error:
        return task, None, [str(error)], False
    text, machine = made.gcode.decode(), settings.printer
    wrong = [] if made.certificate.ok else ["is not certified"]
    again = check(made.gcode)
    wrong += [] if again.ok and not again.remarks else ["is not clean when judged by its name"]
    wrong += print_files.beyond(text, machine)
    wrong += sorted(firmware_words.undocumented(text, machine.gcode.flavor))
    seen = [tuple(picture[:3]) for picture in print_files.pictures(text)]
    wrong += [] if seen == print_files.wanted(machine) else [f"shows {seen}"]
    ran = machine.gcode.flavor == "klipper" and klipper_batch.ready()
    if ran:
        with tempfile.TemporaryDirectory() as folder:
            wrong += klipper_batch.complaints(machine, made.gcode, Path(folder))
    return task, made.estimate.total_s, wrong, ran


@cache
def _models():
    return everyday.meshes()


def row(printer, nozzles_mm, found):
    """One line of the table."""
    gcode = Settings.load(printer, "pla").printer.gcode
    pictures = " ".join(f"{w}×{h}" for w, h, *_ in gcode.thumbnails)
    form = " QOI" if any("QOI" in size for size in gcode.thumbnails) else ""
    lines = profile_text.whole("printers", printer)
    estimates = sum("# estimate" in line for line in lines)
    times = (
        "<br>".join(
            "–" if (time_s := found[printer, nozzle_mm, model]) is None else duration(time_s)
            for model in MODELS
        )
        for nozzle_mm in nozzles_mm
    )
    cells = [printer, gcode.flavor, *times, f"{pictures}{form}" or "none", str(estimates)]
    return f"| {' | '.join(cells)} |"


def main():
    """Print all of it and write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    page = shared_models.REPOSITORY / "docs" / "printers.md"
    parser.add_argument("-o", "--output", type=Path, default=page)
    parser.add_argument("--only", default="", help="printers whose name has this text")
    parser.add_argument("--nozzles", type=float, nargs="+", default=NOZZLES_MM)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    names = [name for name in catalogue.names("printers") if options.only in name]
    tasks = list(itertools.product(names, options.nozzles, MODELS))
    found, faults, ran = {}, 0, 0
    with ProcessPoolExecutor(options.jobs) as pool:
        for task, time_s, wrong, by_klipper in pool.map(judged, tasks):
            found[task] = None if wrong else time_s
            faults, ran = faults + bool(wrong), ran + by_klipper
            print(
                *task,
                duration(time_s) if time_s else "-",
                *(f"WRONG: {w}" for w in wrong),
                flush=True,
            )
    heads = [f"{nozzle_mm:g} mm" for nozzle_mm in options.nozzles]
    columns = ["printer", "firmware", *heads, "pictures", "estimates"]
    table = [f"| {' | '.join(columns)} |", "|---" * len(columns) + "|"]
    table += [row(name, options.nozzles, found) for name in names]
    klipper = (
        f"Klipper itself carried out {ran} of these files, in its batch mode.\n" if ran else ""
    )
    options.output.write_text(PAGE.format(table="\n".join(table), klipper=klipper))
    print(f"{len(tasks) - faults} of {len(tasks)} files are right: {options.output}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

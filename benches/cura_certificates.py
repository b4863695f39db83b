"""Writes docs/cura_certificates.md: CuraEngine's wire prints of the shared models, judged.

    CURA_DEFS_HOME=/tmp/peers python benches/cura_certificates.py [MANIFEST] [-o PAGE] [--jobs N]

Needs CuraEngine and its definitions, as `../shared/peers/setup.sh` installs them.
"""

import os
import subprocess
import tempfile
import time
from functools import partial
from pathlib import Path

import numpy as np

import certificates
import shared_models
from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.duration import duration
from wireprint.timing import estimate

#: The nozzle's angle from the horizontal: what CuraEngine assumes unless told (the default of
#: machine_nozzle_expansion_angle), and the Kossel Mini's, which we print with.
ANGLES_DEG = (45, 32)
#: What one run may take, as `cura_wire.sh` reads it: kB of memory, and s.
LIMITS = {"MEMKB": "4000000", "TLIM": "60"}
COLUMNS = {
    "model": lambda row: row["model"],
    "breaches": lambda row: str(certificates.breaches(row)),
    "of them collisions": lambda row: str(row["collisions"]),
    "deepest, mm": lambda row: f"{row['deepest_mm']:.1f}",
    "coverage": lambda row: f"{row['coverage']:.1%}",
    "deviation, mm": lambda row: f"{row['deviation_mm']:.2f}",
    "as chords, mm": lambda row: f"{row['chord_deviation_mm']:.2f}",
    "time": lambda row: duration(row["print_time_s"]),
    "computed in, s": lambda row: f"{row['run_s']:.2f}",
}
PAGE = """# CuraEngine's wire prints of the shared models

Written by `CURA_DEFS_HOME=/tmp/peers python benches/cura_certificates.py`. The same models, sizes,
judge and bed as in [certificates.md](certificates.md); CuraEngine 4.13's wire mode as
`../shared/peers/cura_wire.sh` runs it (0.7 mm nozzle, 3 mm high, 30 mm/s, strategy `compensate`),
within 4 GB and 60 s a model. Each model is printed twice: for the nozzle's angle that CuraEngine
assumes by default (45°), and for that of the Kossel Mini (32°); each print is judged at the angle
that it was made for. Times are those of our estimate, the computing is CuraEngine's whole run.
"""
SECTION = """
## {angle}°

{table}

{summary}
"""


def evaluate(angle, model, settings, row):
    """Let CuraEngine print a model for a nozzle's angle, and judge what it writes."""
    mesh = model.mesh
    with tempfile.TemporaryDirectory(prefix="cura-") as folder:
        file = Path(folder) / "model.stl"
        file.write_bytes(stl(mesh))
        begin = time.perf_counter()
        gcode = printed(file, angle)
        row["run_s"] = time.perf_counter() - begin
    head = settings.printer.head.model_copy(update={"slant_deg": float(angle)})
    printer = settings.printer.model_copy(update={"head": head})
    certificate = check(gcode, settings.model_copy(update={"printer": printer}), mesh)
    row |= {name: len(found) for name, found in certificate.breaches().items()}
    row["deepest_mm"] = max((hit.depth_mm for hit in certificate.collisions), default=0.0)
    row["coverage"] = certificate.fidelity.coverage
    row["deviation_mm"] = certificate.fidelity.deviation_mm
    row["chord_deviation_mm"] = certificate.fidelity.chord_deviation_mm
    row["print_time_s"] = estimate(gcode, printer=settings.printer.name).total_s


def printed(model, angle):
    """Run CuraEngine within its limits; return its G-code."""
    script = shared_models.SHARED / "peers" / "cura_wire.sh"
    target = model.with_suffix(".gcode")
    command = [script, model, target, "-s", f"machine_nozzle_expansion_angle={angle}"]
    done = subprocess.run(["bash", *command], env=os.environ | LIMITS, capture_output=True)
    if done.returncode == 124:
        raise UnprintableError(f"CuraEngine takes longer than {LIMITS['TLIM']} s")
    if done.returncode != 0 or not target.exists():
        last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
        raise UnprintableError(f"CuraEngine fails ({done.returncode}): {''.join(last)}")
    return target.read_bytes()


def stl(mesh):
    """Return a mesh, as it stands on the bed, as binary STL."""
    facets = np.zeros(len(mesh.faces), [("normal", "<3f4"), ("corners", "<9f4"), ("flags", "<u2")])
    facets["corners"] = mesh.vertices[mesh.faces].reshape(-1, 9)
    return bytes(80) + np.uint32(len(facets)).tobytes() + facets.tobytes()


def summary(rows):
    """Tell how many prints there are, and how many of them keep the rules."""
    done = [row for row in rows if not row["error"]]
    return (
        f"{len(done)} of {len(rows)} models printed; "
        f"{sum(not certificates.breaches(row) for row in done)} without a breach; "
        f"{np.median([certificates.breaches(row) for row in done]):.0f} breaches in the median; "
        f"coverage {np.median([row['coverage'] for row in done]):.1%} in the median."
    )


def section(options, angle):
    """Evaluate the models for one angle."""
    rows = shared_models.evaluated(options, partial(evaluate, angle))
    table = shared_models.markdown(COLUMNS, rows)
    return SECTION.format(angle=angle, table=table, summary=summary(rows))


def main():
    """Evaluate the models and write the page."""
    options = shared_models.arguments(__doc__.splitlines()[0], "cura_certificates.md")
    sections = [section(options, angle) for angle in ANGLES_DEG]
    options.output.write_text(PAGE + "".join(sections), encoding="utf-8")


if __name__ == "__main__":
    main()

"""Writes docs/cura_certificates.md: CuraEngine's wire prints of the shared models, judged.

    CURA_DEFS_HOME=/tmp/peers python benches/cura_certificates.py [MANIFEST] [-o PAGE] [--jobs N]

Needs CuraEngine and its definitions, as `../shared/peers/setup.sh` installs them.
"""

import os
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import certificates
import shared_models
from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.timing import clock, estimate

#: The nozzle's angle from the horizontal: what CuraEngine assumes unless told (the default of
#: machine_nozzle_expansion_angle), and the Kossel Mini's, which we print with.
ANGLES_DEG = {"its": 45, "ours": 32}
#: What one run may take, as `cura_wire.sh` reads it: kB of memory, and s.
LIMITS = {"MEMKB": "4000000", "TLIM": "60"}
COLUMNS = {"model": lambda row: row["model"]} | {
    f"{heading}, {angle}°": lambda row, name=name, show=show: show(row[name])
    for name, angle in ANGLES_DEG.items()
    for heading, show in {
        "collisions": lambda found: str(found["collisions"]),
        "all breaches": lambda found: str(sum(found[key] for key in certificates.BREACHES)),
        "coverage": lambda found: f"{found['coverage']:.1%}",
        "deviation, mm": lambda found: f"{found['deviation_mm']:.2f}",
        "as chords, mm": lambda found: f"{found['chord_deviation_mm']:.2f}",
        "time": lambda found: clock(found["print_time_s"]),
        "computed in, s": lambda found: f"{found['compute_s']:.2f}",
    }.items()
}
PAGE = """# CuraEngine's wire prints of the shared models

Written by `CURA_DEFS_HOME=/tmp/peers python benches/cura_certificates.py`. The same models, sizes,
judge and bed as in [certificates.md](certificates.md); CuraEngine 4.13's wire mode as
`../shared/peers/cura_wire.sh` runs it (0.7 mm nozzle, 3 mm high, 30 mm/s, strategy `compensate`).
Each model is printed twice: with the nozzle's angle that CuraEngine assumes by default (45°), and
with that of the Kossel Mini (32°); each print is judged at the angle that it was made with.

{table}

{summary}

Times are those of our estimate, the computing is CuraEngine's whole run.
"""


def evaluate(mesh, settings, row):
    """Let CuraEngine print a model for either angle, and judge what it writes."""
    with tempfile.TemporaryDirectory(prefix="cura-") as folder:
        model = Path(folder) / "model.stl"
        model.write_bytes(stl(mesh))
        for name, angle in ANGLES_DEG.items():
            row[name] = judged(model, mesh, settings, angle)


def judged(model, mesh, settings, angle):
    """Return the figures of one print."""
    begin = time.perf_counter()
    gcode = printed(model, angle)
    compute_s = time.perf_counter() - begin
    head = settings.printer.head.model_copy(update={"slant_deg": float(angle)})
    printer = settings.printer.model_copy(update={"head": head})
    certificate = check(gcode, settings.model_copy(update={"printer": printer}), mesh)
    return {
        **{name: len(found) for name, found in certificate.breaches().items()},
        "coverage": certificate.fidelity.coverage,
        "deviation_mm": certificate.fidelity.deviation_mm,
        "chord_deviation_mm": certificate.fidelity.chord_deviation_mm,
        "print_time_s": estimate(gcode, printer="kossel-mini").total_s,
        "compute_s": compute_s,
    }


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
        raise UnprintableError(f"CuraEngine fails at {angle}° ({done.returncode}): {''.join(last)}")
    return target.read_bytes()


def stl(mesh):
    """Return a mesh, as it stands on the bed, as binary STL."""
    facets = np.zeros(len(mesh.faces), [("normal", "<3f4"), ("corners", "<9f4"), ("flags", "<u2")])
    facets["corners"] = mesh.vertices[mesh.faces].reshape(-1, 9)
    return bytes(80) + np.uint32(len(facets)).tobytes() + facets.tobytes()


def summary(rows):
    """Tell how many prints there are, and how many of them keep the rules."""
    lines = []
    for name, angle in ANGLES_DEG.items():
        done = [row[name] for row in rows if name in row]
        clean = sum(not any(found[key] for key in certificates.BREACHES) for found in done)
        free = sum(not found["collisions"] for found in done)
        lines.append(
            f"- {angle}°: {len(done)} of {len(rows)} models printed; {clean} without a breach, "
            f"{free} without a collision; coverage "
            f"{np.median([found['coverage'] for found in done]):.1%} in the median."
        )
    return "\n".join(lines)


def main():
    """Evaluate the models and write the page."""
    options = shared_models.arguments(__doc__.splitlines()[0], "cura_certificates.md")
    rows = shared_models.evaluated(options, evaluate)
    table = shared_models.markdown(COLUMNS, rows)
    options.output.write_text(PAGE.format(table=table, summary=summary(rows)), encoding="utf-8")


if __name__ == "__main__":
    main()

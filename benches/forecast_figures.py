"""Writes docs/forecast_figures.md: the paper's pause, and what the remedies changed.

python benches/forecast_figures.py [-o PAGE]

The paper's figures come from the model alone. The others are of prints of the design's four models
(cube, sphere, bottle, bunny; the last where shared models are at hand), as they are written now;
"before" is what the design found before there were any remedies, and where a remedy can be taken
out of the written text, that.
"""

import argparse
import re
import tempfile
from pathlib import Path

import shared_models
from wireprint import Settings, _core, examples, load_mesh
from wireprint.cooling import heat_transfer_w_m2k
from wireprint.forecast import simulate
from wireprint.forecast_terms import air_mm_s
from wireprint.pipeline import make

PAGE = """# Figures of the forecast

Written by `python benches/forecast_figures.py`. A model throughout: no figure was measured on a
printer.

## The paper's pause

ABS of 0.7 mm, air jets of 6 m/s, a post that may lean by half a strand under 0.01 N. The paper
found 30 mm/s with a pause of 1 s the best, and 5 mm/s without a pause slower. **Best pause** at
30 mm/s: {best}. Strokes are a post of 5 mm and a diagonal of 8.5 mm.

{paper}

## What the remedies changed

**Before** is what the design's prototype found in prints without them.

{remedies}

## Pauses

{pauses}
"""
#: What the design found: diagonals of posts with 0.4 mm, and sags of contours without air, mm.
DIAGONALS = {"cube": "22/60", "sphere": "89/487", "bottle": "0/660", "bunny": "218/1131"}
SAGS_MM = {"cube": 0.84, "sphere": 0.24, "bottle": 0.28, "bunny": 0.18}
#: A post and its diagonal, mm, the pull, N, and the longest pause, s.
POST_MM, DIAGONAL_MM, PULL_N, LONGEST_S = 5.0, 8.5, 0.01, 60.0
#: A lag of the flow behind the feed, s: that of a Bowden tube.
LAG_S = 0.3
#: Height of the design's bunny, mm.
BUNNY_MM = 100.0
AIR = re.compile(rb"^M(106|107|42)\b.*\n", re.MULTILINE)
ADVANCE = re.compile(rb"^(M900|M572|SET_PRESSURE_ADVANCE)\b.*\n", re.MULTILINE)


def table(heads, rows):
    """Lay out a Markdown table."""
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)], *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def paper():
    """The pause of posts of some lengths, and what a post and its diagonal take at some speeds."""
    matter = Settings.load("kossel-mini", "abs").material.matter(0.7)

    def pause(length_mm, speed):
        return _core.holding_pause(matter, 6000.0, length_mm, speed, PULL_N, LONGEST_S)

    best = ", ".join(f"{pause(one, 30.0):.2f} s for a post of {one:g} mm" for one in (2, 5, 11))
    rows = []
    for speed in (5.0, 10.0, 30.0, 60.0):
        way, held = (POST_MM + DIAGONAL_MM) / speed, pause(POST_MM, speed)
        rows.append([f"{speed:g}", f"{way:.2f}", f"{held:.2f}", f"{way + held:.2f}"])
    heads = ["mm/s", "strokes, s", "pause that holds, s", "with it, s"]
    return best, table(heads, rows)


def models():
    """The meshes of the design's four models: the last is no example."""
    for name in ("cube", "sphere", "bottle"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{name}.stl"
            path.write_bytes(examples.stl(name))
            yield name, load_mesh(path)
    bunny = shared_models.SHARED / "models" / "bunny.stl"
    if bunny.exists():
        yield "bunny", load_mesh(bunny, height_mm=BUNNY_MM)


def remedies():
    """Rows of what was and what is."""
    for name, mesh in models():
        thin, wide = (shared_models.roomy(one) for one in ("prusa-mk4s/pla", "kossel-mini/abs"))
        frame = make(mesh, thin, compare=False).wireframe
        now = f"{frame.diagonal_count}/{frame.post_count}"
        yield f"{name}: diagonals of posts, 0.4 mm", DIAGONALS[name], now
        made = make(mesh, wide, compare=False).gcode
        still = simulate(AIR.sub(b"", made), wide).rules["sags"].worst
        sag = simulate(made, wide).rules["sags"].worst
        before = f"{SAGS_MM[name]} ({still:.2f} with its air taken out)"
        yield f"{name}: worst sag, ABS 0.7 mm, mm", before, f"{sag:.2f}"
        bare = make(mesh, wide.but(overrides=["extruder.pressure_lag_s=0"]), compare=False).gcode
        lagging = wide.but(overrides=[f"extruder.pressure_lag_s={LAG_S}"])
        oozes = simulate(ADVANCE.sub(b"", bare), lagging)
        stops = simulate(make(mesh, lagging, compare=False).gcode, lagging)
        yield (
            f"{name}: strokes off by a fifth of their material, lag {LAG_S:g} s",
            f"{oozes.rules['flows'].over} of {oozes.rules['flows'].of}",
            f"{stops.rules['flows'].over} of {stops.rules['flows'].of}",
        )
        knots = [(one.rules["knots"].worst or 0.0) for one in (oozes, stops)]
        yield f"{name}: knots stand out by, mm", *(f"{one:.2f}" for one in knots)


def constants():
    """Rows of what was one constant for all."""
    for strand_mm in (0.4, 0.7):
        told = [heat_transfer_w_m2k(strand_mm, 150.0, 25.0, air, 0.18) for air in (0.0, 3000.0)]
        yield (
            f"heat transfer of {strand_mm} mm at 150 °C, W/m²K (still, 3 m/s)",
            "one constant",
            f"{told[0]:.0f}, {told[1]:.0f}",
        )


def pauses():
    """The pause of each printer and material."""
    rows = []
    for printer, nozzle_mm in (("kossel-mini", 0.7), ("prusa-mk4s", 0.7), ("prusa-mk4s", 0.4)):
        for material in ("abs", "pla", "petg"):
            settings = Settings.load(printer, material, nozzle_mm=nozzle_mm)
            air = air_mm_s(settings)
            cools = settings.material.solidify_s(nozzle_mm, air)
            still = settings.material.solidify_s(nozzle_mm, 0.0)
            row = [f"{printer}/{material}, {nozzle_mm} mm", f"{air / 1000:g}"]
            rows.append([*row, f"{cools:.2f}", f"{settings.solidify_s:.2f}", f"{still:.1f}"])
    heads = ["", "air, m/s", "to hold_c, s", "auto, s", "still air, s"]
    return table(heads, rows)


def main():
    """Work all of it out, and write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    target = shared_models.REPOSITORY / "docs" / "forecast_figures.md"
    parser.add_argument("-o", "--output", type=Path, default=target)
    options = parser.parse_args()
    best, times = paper()
    told = table(["", "before", "now"], [*remedies(), *constants()])
    text = PAGE.format(best=best, paper=times, remedies=told, pauses=pauses())
    options.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

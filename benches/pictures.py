"""Draw the pictures of docs/ anew: what each stage makes of an example, by our own renderer; the
head with its measures, and its gauge.

Usage: python benches/pictures.py [FOLDER]
"""

import sys
import tempfile
from pathlib import Path

from wireprint import check, examples, load_mesh, make, view, view_stages
from wireprint.heads import drawing
from wireprint.heads.gauge_print import printed
from wireprint.settings import Settings

FOLDER = Path(__file__).parents[1] / "docs" / "pictures"
SIZE = (720, 540)
#: Name of the picture: stage, example and maybe "lying", slabs (None: all), camera; maybe settings.
PICTURES = {
    "slices": ("slices", "branch", None, "iso"),
    "levels": ("slices", "sphere", None, "front"),
    "posts-paper": ("posts", "bottle", range(12, 14), "iso", "wire.placement=paper"),
    "order": ("toolpath", "branch", range(13, 15), "30,40"),
    "flat": ("strands", "cube", range(4, 5), "20,50"),
    "contours": ("contours", "torus lying", None, "30,40"),
    "strips": ("strips", "arch", range(2, 3), "iso"),
    "posts": ("posts", "bottle", range(12, 14), "iso"),
    "strands": ("strands", "bottle", range(12, 14), "iso"),
    "toolpath": ("toolpath", "branch", None, "iso"),
}


def main() -> None:
    """Draw them all."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    settings = Settings.load()
    (folder / "head.svg").write_text(drawing.svg(settings.printer.head), encoding="utf-8")
    with tempfile.TemporaryDirectory() as work:
        gauge = Path(work) / "gauge.gcode"
        gauge.write_bytes(printed(settings).gcode)
        view.render_png(gauge, folder / "gauge.png", size=SIZE, title="gauge")
        for name, (stage, example, slabs, camera, *changed) in PICTURES.items():
            kind, _, lying = example.partition(" ")
            model = Path(work) / f"{kind}.stl"
            model.write_bytes(examples.stl(kind))
            mesh = load_mesh(model, rotate=(90.0 if lying else 0.0, 0.0, 0.0))
            shown = view_stages.stage(stage, mesh, Settings.load(overrides=changed), slabs)
            picture = folder / f"{name}.png"
            view.render_png(
                shown,
                picture,
                size=SIZE,
                camera=camera,
                travels=stage == "toolpath",
                title=f"{example}: {name}",
            )
            print(f"{picture}: {picture.stat().st_size / 1000:.0f} kB")
        breaches(Path(work), folder / "certificate.png")


def breaches(work: Path, picture: Path) -> None:
    """Draw a bottle that is printed for a slim head, and where a blunt one would meet it."""
    model = work / "bottle.stl"
    model.write_bytes(examples.stl("bottle"))
    slim, blunt = (Settings.load(overrides=[f"head.slant_deg={slant}"]) for slant in (60, 30))
    made = make(load_mesh(model, height_mm=60.0), slim, certify=False)
    gcode = work / "bottle.gcode"
    gcode.write_bytes(made.gcode)
    marked = check(made.gcode, blunt).breach_points_mm
    view.render_png(gcode, picture, size=SIZE, breaches=marked, title="bottle, under a blunt head")
    print(f"{picture}: {picture.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()

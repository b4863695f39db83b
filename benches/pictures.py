"""Draw the pictures of docs/ anew: what each stage makes of an example, by our own renderer; the
head with its measures, and its gauge.

Usage: python benches/pictures.py [FOLDER]
"""

import sys
import tempfile
from pathlib import Path

from wireprint import examples, load_mesh, view, view_stages
from wireprint.heads import drawing
from wireprint.heads.gauge_print import printed
from wireprint.settings import Settings

FOLDER = Path(__file__).parents[1] / "docs" / "pictures"
SIZE = (720, 540)
#: Name of the picture: stage, example and maybe "lying", slabs (None: all), camera.
PICTURES = {
    "slices": ("slices", "branch", None, "iso"),
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
        for name, (stage, example, slabs, camera) in PICTURES.items():
            kind, _, lying = example.partition(" ")
            model = Path(work) / f"{kind}.stl"
            model.write_bytes(examples.stl(kind))
            mesh = load_mesh(model, rotate=(90.0 if lying else 0.0, 0.0, 0.0))
            shown = view_stages.stage(stage, mesh, settings, slabs)
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


if __name__ == "__main__":
    main()

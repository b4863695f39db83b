"""The goldens: what models come to on several printers, so that no print changes unseen.

python benches/goldens.py [--update] [--only TEXT] [--jobs N]

Compares the examples and, where they are at hand, the shared models with `benches/goldens/*.tsv`
(one file a printer) and tells which figures got better or worse; --update writes them anew.
Exit code 1: something differs and was not written.
"""

import argparse
import csv
import hashlib
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import shared_models
from wireprint import examples
from wireprint.pipeline import make

FOLDER = Path(__file__).parent / "goldens"
MACHINES = ("kossel-mini/abs", "prusa-mk4s/pla", "voron-2.4/abs")
#: What a figure is rounded to, and whether more of it is better (1), worse (-1) or neither (0).
FIGURES = {
    "posts": (0, 0),
    "diagonals": (0, 1),
    "strand_mm": (1, 0),
    "travel_mm": (1, -1),
    "print_time_s": (1, -1),
    "coverage": (4, 1),
    "deviation_mm": (3, -1),
    "breaches": (0, -1),
    "unprinted_mm2": (0, -1),
}
#: Besides: the toolpath as a hash, and why there is none.
COLUMNS = ("model", *FIGURES, "toolpath", "error")
#: Toolpaths are hashed to this many decimals: a thousandth of a mm, mm/s, s.
DECIMALS = 3


def evaluate(model, settings, row):
    """Fill in the figures of a model's print."""
    row |= figures(model.mesh, settings)


def figures(mesh, settings):
    """Figures of a print, rounded, and the hash of its toolpath; all as text."""
    made = make(mesh, settings, partial=True)
    told = made.figures() | {"diagonals": made.wireframe.diagonal_count}
    told["breaches"] = sum(told["breaches"].values())
    told["unprinted_mm2"] = sum(part["area_mm2"] for part in told["unprinted"])
    cells = {name: f"{told[name]:.{places}f}" for name, (places, _) in FIGURES.items()}
    return cells | {"toolpath": fingerprint(made.toolpath)}


def fingerprint(path):
    """Hash of a toolpath's moves, rounded so that the last bit of a sine does not matter."""
    whole = hashlib.sha256()
    for name in ("to", "kind", "speed", "filament", "pause", "air", "slab"):
        values = np.round(np.asarray(getattr(path, name), dtype=np.float64), DECIMALS)
        whole.update((values + 0.0).tobytes())  # no -0
    return whole.hexdigest()[:16]


def written(folder):
    """Write the examples into a folder; return their paths."""
    paths = [folder / f"{name}.stl" for name in examples.names()]
    for path in paths:
        path.write_bytes(examples.stl(path.stem))
    return paths


def rows(only="", jobs=1):
    """Evaluate all models; return the rows by printer and model's name."""
    found = {}
    manifest = shared_models.SHARED / "models" / "manifest.csv"
    with tempfile.TemporaryDirectory() as folder:
        sources = {"example": [str(path) for path in written(Path(folder))]}
        if manifest.exists():
            sources["shared"] = [str(manifest)]
        for source, models in sources.items():
            each = shared_models.on_each(MACHINES, models, evaluate, jobs, only)
            for machine, model, row in each:
                found[machine, f"{source}/{model}"] = golden(row)
    return found


def golden(row):
    """The cells of a row that are kept; those of a model without a print are empty."""
    return {name: row.get(name) or "" for name in COLUMNS[1:]}


def file_of(machine):
    """Where a printer's goldens are kept."""
    return FOLDER / f"{machine.replace('/', '-')}.tsv"


def kept():
    """The goldens by printer and model's name."""
    found = {}
    for machine in MACHINES:
        if file_of(machine).exists():
            with file_of(machine).open(encoding="utf-8", newline="") as file:
                for row in csv.DictReader(file, delimiter="\t"):
                    found[machine, row.pop("model")] = row
    return found


def keep(goldens):
    """Write the goldens, each printer's into its file."""
    for machine in MACHINES:
        with file_of(machine).open("w", encoding="utf-8", newline="") as file:
            table = csv.DictWriter(file, COLUMNS, delimiter="\t", lineterminator="\n")
            table.writeheader()
            for (of, model), row in sorted(goldens.items()):
                if of == machine:
                    table.writerow({"model": model, **row})


@dataclass(frozen=True)
class Change:
    """A cell that is no longer what it was."""

    machine: str
    model: str
    name: str
    before: str
    after: str

    @property
    def is_one(self):
        """Whether anything changed; the words of an error do not matter."""
        if self.name == "error":
            return bool(self.before) != bool(self.after)
        return self.before != self.after

    @property
    def step(self):
        """How far the figure went, positive where it grew; 0 for what is no figure."""
        if self.name not in FIGURES or not (self.before and self.after):
            return 0.0
        return float(self.after) - float(self.before)

    @property
    def verdict(self):
        """Whether this is better or worse; None where it is neither."""
        if self.name == "error":
            return "worse" if self.after else "better"
        grade = self.step * FIGURES.get(self.name, (0, 0))[1]
        return "better" if grade > 0 else "worse" if grade < 0 else None

    def __str__(self):
        """Tell the figure before and after."""
        verdict = f" ({self.verdict})" if self.verdict else ""
        return f"{self.name} {self.before or '–'} → {self.after or '–'}{verdict}"


def changes(before, after):
    """What differs between goldens and rows, for the rows alone; a new row has no figures yet."""
    return [
        change
        for (machine, model), row in sorted(after.items())
        for name in COLUMNS[1:]
        if (
            change := Change(
                machine, model, name, before.get((machine, model), {}).get(name, ""), row[name]
            )
        ).is_one
    ]


def told(found, before, after):
    """Changes as text: a line a print, then one a printer and figure."""
    lines = []
    for machine, model in sorted({(change.machine, change.model) for change in found}):
        own = [c for c in found if (c.machine, c.model) == (machine, model)]
        figures_ = "; ".join(str(change) for change in own if change.name != "toolpath")
        lines.append(f"{model} on {machine}: {figures_ or 'other moves, the same figures'}")
    for machine in sorted({change.machine for change in found}):
        lines += [f"in all on {machine}:"]
        lines += [_summed(machine, name, found, before, after) for name in FIGURES]
    return "\n".join(lines)


def _summed(machine, name, found, before, after):
    """A figure summed over the models that were printed before and after, and who went where."""
    both = [
        (float(before[key][name]), float(row[name]))
        for key, row in after.items()
        if key[0] == machine and row[name] and before.get(key, {}).get(name)
    ]
    old, new = (sum(column) for column in zip(*both, strict=True)) if both else (0.0, 0.0)
    own = [c for c in found if (c.machine, c.name) == (machine, name)]
    better, worse = (sum(c.verdict == word for c in own) for word in ("better", "worse"))
    verdict = f"; {better} better, {worse} worse" if FIGURES[name][1] else f"; {len(own)} changed"
    return f"  {name:14} {old:.6g} → {new:.6g}{verdict}"


def main():
    """Compare, tell, and write if asked to."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", action="store_true", help="write the goldens anew")
    parser.add_argument("--only", default="", help="models whose file's name has this text")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    before, after = kept(), rows(options.only, options.jobs)
    found = changes(before, after)
    print(told(found, before, after) or f"{len(after)} prints are what they were")
    if options.update:
        gone = {} if options.only else {key: row for key, row in before.items() if is_gone(key)}
        keep({key: row for key, row in before.items() if key not in gone} | after)
    sys.exit(bool(found) and not options.update)


def is_gone(key):
    """Whether a golden's model is no more: shared models that are not at hand may be elsewhere."""
    source, name = key[1].split("/")
    return source == "example" and Path(name).stem not in examples.names()


if __name__ == "__main__":
    main()

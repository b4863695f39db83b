"""Prints random marks on the shared models as layers, and tells how much of each is, and why not.

python benches/marks.py [COUNT] [--seed FIRST] [--printer NAME --material NAME] [--model TEXT]
    [--only SEED…]

Marks are those of `tests/random_marks.py`: bands, boxes and strokes; a seed is always the same mark
on the same model. Marks of less than 30 mm² are passed over.
"""

import argparse
import dataclasses
import sys
import time
from collections import Counter

import numpy as np

import shared_models
from wireprint.bench.plan import Placement, plan
from wireprint.hybrid.prove import proved
from wireprint.hybrid.sketch import Sketch
from wireprint.mesh import load_mesh

sys.path.append(str(shared_models.REPOSITORY / "tests"))

import random_marks

#: Marks of less are passed over, mm².
LEAST_MM2 = 30.0
#: What is hoped for: in the median, and of each.
MEDIAN, EACH = 0.98, 0.9


@dataclasses.dataclass(frozen=True)
class Found:
    """What became of a mark."""

    seed: int
    model: str
    mark: random_marks.Mark
    marked_mm2: float
    #: Area that stays wire, mm², by reason.
    dropped: Counter
    #: Length of the layers' lines, and of the pieces of them that are done without, mm.
    lines_mm: float
    trimmed_mm: float
    rounds: int
    certified: bool
    #: Processor time, s.
    seconds: float

    @property
    def share(self):
        """Share of the marked area that is layers, as much less as their lines are shorter."""
        laid = self.lines_mm / max(self.lines_mm + self.trimmed_mm, 1e-9)
        return laid * (1 - sum(self.dropped.values()) / self.marked_mm2)

    def __str__(self):
        """One line."""
        lost = ", ".join(f"{why} {area:.0f}" for why, area in self.dropped.most_common())
        verdict = "" if self.certified else " BREACHES"
        return (
            f"{self.share:.3f}{verdict} seed {self.seed} {self.model}: {self.mark.kind} "
            f"{self.mark.told}, {self.marked_mm2:.0f} mm² ({lost or 'all'}; "
            f"{self.trimmed_mm:.1f} of {self.lines_mm:.0f} mm trimmed), rounds {self.rounds}, "
            f"{self.seconds:.1f} s"
        )


def found(sketch, seed, model):
    """Print a mark; None where too little is marked."""
    mark, begin = random_marks.mark(sketch.mesh, seed), time.process_time()
    made = proved(sketch, mark.region)
    seconds = time.process_time() - begin
    dropped = Counter()
    for run, why in made.plan.runs.dropped:
        dropped[why] += run.area_mm2
    marked_mm2 = sum(run.area_mm2 for run in made.plan.sections) + sum(dropped.values())
    if marked_mm2 < LEAST_MM2:
        return None
    lines, verdict = (made.layer_wise_mm, made.trimmed_mm), made.verdict.ok
    return Found(seed, model, mark, marked_mm2, dropped, *lines, made.rounds, verdict, seconds)


def sketches(seeds, settings, only):
    """Give each seed with its model's sketch and name, model by model."""
    tasks = plan([str(shared_models.SHARED / "models" / "manifest.csv")], Placement(), {})
    models = [(str(task.model).rpartition("/")[2], task) for task in tasks]
    models = [(name, task) for name, task in models if only in name]
    chosen = [int(np.random.default_rng([seed, 1]).integers(len(models))) for seed in seeds]
    for number, (name, task) in enumerate(models):
        own = [seed for seed, which in zip(seeds, chosen, strict=True) if which == number]
        if own:
            mesh = load_mesh(task.model, **dataclasses.asdict(task.placement))
            sketch = Sketch.of(mesh, settings)
            for seed in own:
                yield seed, sketch, name


def main():
    """Print the marks and tell what came of them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", nargs="?", type=int, default=50)
    parser.add_argument("--seed", type=int, default=0, help="of the first mark")
    parser.add_argument("--printer", default="kossel-mini")
    parser.add_argument("--material", default="abs")
    parser.add_argument("--model", default="", help="only models whose name has this text")
    parser.add_argument("--only", type=int, nargs="*", help="seeds, in place of a count of them")
    options = parser.parse_args()
    settings = shared_models.roomy(f"{options.printer}/{options.material}")
    seeds = options.only or range(options.seed, options.seed + options.count)
    results = []
    for seed, sketch, name in sketches(seeds, settings, options.model):
        result = found(sketch, seed, name)
        if result is not None:
            print(result, flush=True)
            results.append(result)
    shares = np.array([result.share for result in results])
    low, breaches = int((shares < EACH).sum()), sum(not result.certified for result in results)
    slow = sum(result.rounds > 2 for result in results)
    print(
        f"{len(results)} marks: median {np.median(shares):.3f}, least {shares.min():.3f}, "
        f"{low} below {EACH}, {slow} in more than two rounds, {breaches} with breaches"
    )
    sys.exit(breaches > 0 or low > 0 or np.median(shares) < MEDIAN)


if __name__ == "__main__":
    main()

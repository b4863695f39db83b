"""Writes docs/certificates.md: the certificate of every shared model.

python benches/certificates.py [MANIFEST] [-o PAGE] [--jobs N]
"""

from statistics import median

import shared_models
from wireprint.bench import figures
from wireprint.duration import duration
from wireprint.pipeline import make

BREACHES = (
    "collisions",
    "floating_starts",
    "dangling_ends",
    "spans_over",
    "out_of_bounds",
    "underfed",
    "hurried",
    "cold",
    "unhomed",
    "unjudged",
)
COLUMNS = {
    "model": lambda row: row["model"],
    "breaches": lambda row: str(breaches(row)),
    "coverage": lambda row: f"{row['coverage']:.1%}",
    "deviation, mm": lambda row: f"{row['deviation_mm']:.2f}",
    "as chords, mm": lambda row: f"{row['chord_deviation_mm']:.2f}",
    "time": lambda row: duration(row["print_time_s"]),
    "× plain": lambda row: f"{row['plain_ratio']:.2f}",
    "strand, m": lambda row: f"{row['strand_mm'] / 1000:.1f}",
    "supports, m": lambda row: f"{row['support_mm'] / 1000:.2f}",
    "unprinted, mm²": lambda row: f"{row['unprinted_mm2']:.0f}",
    "computed in, s": lambda row: f"{row['plan_s']:.2f}",
}
PAGE = """# Certificates of the shared models

Written by `python benches/certificates.py`. Each model of `../shared/models` at the size of its
manifest, with all defaults (`kossel-mini`, `abs`), on a bed that is large enough for all of them.

{table}

{summary}

- **breaches**: of the rules of `wireprint check`, all kinds together.
- **coverage**: share of the surface within 4 mm of a strand. **deviation**: mean distance of the
  strands from the surface, as commanded; **as chords**: what hangs in the air relaxed.
- **× plain**: print time against the plain zigzag, which has neither caps nor supports.
- **unprinted**: surface that `slice` says it leaves out.
- **computed in**: from the mesh in memory to the judged file, one process a core, one thread each.
"""


def evaluate(model, settings, row):
    """Fill in the certificate, and what it costs in print time."""
    figures.certificate(model, settings, row)
    row["plain_ratio"] = row["print_time_s"] / plain_time_s(model.mesh, settings)


def plain_time_s(mesh, settings):
    """Print time of the same slices without caps and supports, s."""
    wire = settings.wire.model_copy(update={"caps": False, "supports": "none"})
    plain = settings.model_copy(update={"wire": wire})
    return make(mesh, plain, certify=False).estimate.total_s


def breaches(row):
    """Count the breaches of all rules."""
    return sum(row[name] for name in BREACHES)


def summary(rows):
    """Tell the medians and the worst of what was printed."""
    done = [row for row in rows if not row["error"]]

    def middle(name):
        return median(row[name] for row in done)

    return (
        f"{len(done)} of {len(rows)} models; {sum(row['certified'] for row in done)} without a "
        f"breach; coverage {middle('coverage'):.1%} in the median, "
        f"{min(row['coverage'] for row in done):.1%} at least; deviation "
        f"{middle('deviation_mm'):.2f} mm, {max(row['deviation_mm'] for row in done):.2f} at most; "
        f"as chords {middle('chord_deviation_mm'):.2f} mm, "
        f"{max(row['chord_deviation_mm'] for row in done):.2f} at most; "
        f"{middle('plain_ratio'):.2f} × the plain zigzag's time in the median; "
        f"{sum(row['plan_s'] for row in done):.1f} s of computing in all."
    )


def main():
    """Evaluate the models and write the page."""
    options = shared_models.arguments(__doc__.splitlines()[0], "certificates.md")
    rows = shared_models.evaluated(options, evaluate)
    table = shared_models.markdown(COLUMNS, rows)
    options.output.write_text(PAGE.format(table=table, summary=summary(rows)), encoding="utf-8")


if __name__ == "__main__":
    main()

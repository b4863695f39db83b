"""A page about a table of results: distributions by kind of shape, what fails, what changed."""

from __future__ import annotations

from html import escape
from statistics import median
from typing import TYPE_CHECKING, Final

from wireprint._core import __version__
from wireprint.bench.kinds import FIGURES, by_kind, changes, spread

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from wireprint.bench.kinds import Change, Changes, Figure
    from wireprint.bench.task import Row

#: Models that are named in a list; the rest is counted.
SHOWN: Final = 20
#: Width and height of the strip on which a distribution is drawn, pixels.
_WIDE, _HIGH = 420, 16
_STYLE: Final = """
:root { color-scheme: light dark; --ink: #222; --faint: #8883; --box: #2a6fb0;
  --bad: #c0392b; --good: #2e7d46 }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e4; --box: #6aa9e0; --bad: #ef8a7d; --good: #7ccf97 } }
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); max-width: 70rem;
  margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.5rem }
h2 { font-size: 1.15rem; margin-top: 2.5rem }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
th, td { padding: .15rem .6rem; text-align: right; border-bottom: 1px solid var(--faint);
  white-space: nowrap }
th:first-child, td:first-child { text-align: left }
td.words { white-space: normal; text-align: left }
svg { display: block }
.box { fill: var(--box); fill-opacity: .35 }
.line { stroke: var(--box); stroke-width: 1.5 }
.median { stroke: var(--ink); stroke-width: 2 }
.good { color: var(--good) }
.bad { color: var(--bad) }
dl { display: flex; flex-wrap: wrap; gap: .5rem 2.5rem }
dt { font-size: .85rem; opacity: .75 }
dd { margin: 0; font-size: 1.5rem }
code { font-size: .85em }
.scroll { overflow-x: auto }
"""


def html(rows: Sequence[Row], title: str, before: Sequence[Row] | None, against: str = "") -> bytes:
    """Return the page: one file that needs no other.

    Parameters
    ----------
    rows
        The table.
    title
        What it is called.
    before, against
        An older table to compare with, and what that is called; None: none.
    """
    parts = [_summary(rows)]
    if before is not None:
        parts.append(_changes(changes(before, rows), against))
    parts += [_distribution(rows, figure) for figure in FIGURES]
    parts += [_failures(rows), _bare(rows)]
    body = "\n".join(part for part in parts if part)
    heading = escape(title)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; '
        "style-src 'unsafe-inline'\">\n"
        f"<title>{heading}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"<h1>{heading}</h1>\n{body}\n<footer><p>wireprint {__version__}</p></footer>\n"
        "</body>\n</html>\n"
    ).encode()


def _summary(rows: Sequence[Row]) -> str:
    machines = sorted({f"{row.get('printer')}, {row.get('material')}" for row in rows})
    tiles = {
        "models": f"{len(rows)}",
        "kinds": f"{len(by_kind(rows))}",
        "certified": f"{sum(row.get('certified') is True for row in rows)}",
        "failed": f"{sum(bool(row.get('error')) for row in rows)}",
        "rows a second and process": f"{_rate(rows):.2g}",
    }
    listed = "".join(f"<div><dt>{name}</dt><dd>{value}</dd></div>" for name, value in tiles.items())
    return f"<p>{escape('; '.join(machines))}</p>\n<dl>{listed}</dl>"


def _rate(rows: Sequence[Row]) -> float:
    spent = sum(row.get("compute_s") or 0.0 for row in rows)
    return len(rows) / spent if spent else 0.0


def _distribution(rows: Sequence[Row], figure: Figure) -> str:
    whole = spread(rows, figure)
    if whole is None:
        return ""
    unit = f", {figure.unit}" if figure.unit else ""
    lines = [
        f"<h2>{escape(figure.title)}{unit}</h2>\n<div class=scroll><table>\n<tr><th>kind</th>"
        "<th>models</th><th></th><th>least</th><th>quarter</th><th>median</th>"
        "<th>three quarters</th><th>most</th></tr>"
    ]
    groups = {"all": list(rows)} | by_kind(rows)
    for kind, members in groups.items():
        found = spread(members, figure)
        if found is not None:
            cells = "".join(f"<td>{value:.{figure.decimals}f}</td>" for value in found.values())
            strip = _strip(list(found.values()), whole["min"], whole["max"])
            count = sum(row.get(figure.column) is not None for row in members)
            lines.append(f"<tr><td>{escape(kind)}</td><td>{count}</td><td>{strip}</td>{cells}</tr>")
    return "\n".join([*lines, "</table></div>"])


def _strip(values: Sequence[float], low: float, high: float) -> str:
    """Draw least, quartiles and most on the axis that all kinds share."""

    def at(value: float) -> float:
        return 1 + (_WIDE - 2) * ((value - low) / (high - low) if high > low else 0.5)

    least, first, middle, third, most = map(at, values)
    half = _HIGH / 2
    return (
        f'<svg width="{_WIDE}" height="{_HIGH}" role="img" aria-hidden="true">'
        f'<line class="line" x1="{least:.1f}" x2="{most:.1f}" y1="{half}" y2="{half}"/>'
        f'<rect class="box" x="{first:.1f}" width="{max(third - first, 1):.1f}" y="2" '
        f'height="{_HIGH - 4}"/>'
        f'<line class="median" x1="{middle:.1f}" x2="{middle:.1f}" y1="1" y2="{_HIGH - 1}"/></svg>'
    )


def _failures(rows: Sequence[Row]) -> str:
    failed = [(row["model"], row["error"]) for row in rows if row.get("error")]
    return _listed("Failed", ("model", "why"), failed) if failed else ""


def _bare(rows: Sequence[Row]) -> str:
    known = [row for row in rows if row.get("coverage") is not None]
    least = sorted(known, key=lambda row: (row["coverage"], row["model"]))[:SHOWN]
    cells = [(row["model"], f"{row['coverage']:.1%}") for row in least if row["coverage"] < 1]
    return _listed("Least covered", ("model", "covered"), cells) if cells else ""


def _changes(found: Changes, against: str) -> str:
    lines = [f"<h2>What changed since {escape(against)}</h2>"]
    counts = {
        "in both": (found.shared, ""),
        "certified no more": (len(found.lost), "bad"),
        "certified now": (len(found.won), "good"),
        "failing now": (len(found.failing), "bad"),
        "failing no more": (len(found.mended), "good"),
        "only there": (len(found.gone), ""),
        "only here": (len(found.new), ""),
    }
    tiles = "".join(
        f'<div><dt>{name}</dt><dd class="{tone if count else ""}">{count}</dd></div>'
        for name, (count, tone) in counts.items()
    )
    lines.append(f"<dl>{tiles}</dl>\n<div class=scroll><table><tr><th>figure</th><th>changed</th>")
    lines.append("<th>better</th><th>worse</th><th>change, median</th></tr>")
    for figure in FIGURES:
        lines += _changed(figure, found.figures[figure.column])
    lines.append("</table></div>")
    for title, models in (
        ("Certified no more", found.lost),
        ("Failing now", found.failing),
    ):
        if models:
            lines.append(_listed(title, ("model",), [(model,) for model in models]))
    for figure in FIGURES:
        worst = found.figures[figure.column][:SHOWN]
        rows = [
            (
                one.model,
                *(f"{v:.{figure.decimals}f}" for v in (one.before, one.after)),
                one.signed,
            )
            for one in worst
        ]
        if rows:
            title = f"Greatest changes: {figure.title.lower()}"
            lines.append(_listed(title, ("model", "before", "now", "change"), rows))
    return "\n".join(lines)


def _changed(figure: Figure, found: Sequence[Change]) -> Iterator[str]:
    if not found:
        return
    better, worse = ("–", "–")
    if figure.more_is_better is not None:
        good = sum((one.after > one.before) == figure.more_is_better for one in found)
        better, worse = str(good), str(len(found) - good)
    middle = median(one.share for one in found)
    yield (
        f"<tr><td>{escape(figure.title)}</td><td>{len(found)}</td><td>{better}</td>"
        f"<td>{worse}</td><td>{middle:+.2%}</td></tr>"
    )


def _listed(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [f"<h2>{escape(title)}</h2>\n<div class=scroll><table><tr>"]
    lines += [f"<th>{escape(head)}</th>" for head in heads]
    lines.append("</tr>")
    for first, *rest in rows[:SHOWN]:
        style = ' class="words"' if heads[-1] == "why" else ""
        cells = "".join(f"<td{style}>{escape(cell)}</td>" for cell in rest)
        lines.append(f"<tr><td><code>{escape(first)}</code></td>{cells}</tr>")
    more = f"<p>and {len(rows) - SHOWN} more</p>" if len(rows) > SHOWN else ""
    return "\n".join([*lines, f"</table></div>{more}"])

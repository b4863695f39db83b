"""What sturdy prints must come to, and whether they do: the verdicts below docs/sturdiness.md."""

from statistics import median

#: Diagonals per post: in the median of a printer's models; of each; of thin double walls.
BRACED_MEDIAN, BRACED_EACH, BRACED_THIN = 0.85, 0.6, 0.8
#: Thin double walls, which shall not be travelled more than this share of their strand.
THIN, THIN_TRAVEL = ("mug.stl", "bowl.obj", "goblet.stl", "wineglass.stl"), 0.2
#: Small rings in a row, whose worst post shall give way half as much as before instead.
ROWS_OF_RINGS = ("chain_loop.3mf", "branches_16.stl", "thin_wall.stl")
WORST_SHARE = 0.5
#: How much stiffer to pinch than before, in the median.
PINCHED, PINCH_GAIN = "prusa-mk4s/pla", 4.0
#: How far 95 % of the posts may give way while they are printed, mm/N.
TIP, TIP_MM_N = "kossel-mini/abs", 40.0


def told(old, new):
    """All goals with their verdicts, as a list in Markdown.

    Parameters
    ----------
    old, new
        Figures (see `sturdiness.FIGURES`) by printer and model; None where there is none.
    """
    lines = []
    for machine in dict.fromkeys(of for of, _ in new):
        before, after = (
            {m: row for (of, m), row in all_.items() if of == machine} for all_ in (old, new)
        )
        lines += _of_printer(machine, before, after)
    return "\n".join(lines)


def _of_printer(machine, old, new):
    printed = {model: row for model, row in new.items() if row["braced"] is not None}
    yield _each(machine, "printed", {model: model in printed for model in new})
    braced = median(row["braced"] for row in printed.values()) if printed else 0.0
    text = f"braced {braced:.2f} in the median, wanted {BRACED_MEDIAN}"
    yield _line(machine, text, braced >= BRACED_MEDIAN)
    yield _each(
        machine,
        f"braced {BRACED_EACH} or more",
        {
            model: row["braced"] >= BRACED_EACH
            for model, row in printed.items()
            if model not in ROWS_OF_RINGS
        },
        lambda model: f"{new[model]['braced']:.2f}",
    )
    yield _each(
        machine,
        f"thin double walls braced {BRACED_THIN} or more",
        {model: row["braced"] >= BRACED_THIN for model, row in printed.items() if model in THIN},
        lambda model: f"{new[model]['braced']:.2f}",
    )
    yield _each(
        machine,
        f"thin double walls with a travel share of {THIN_TRAVEL} or less",
        {
            model: row["travel_share"] <= THIN_TRAVEL
            for model, row in printed.items()
            if model in THIN
        },
        lambda model: f"{new[model]['travel_share']:.2f}",
    )
    yield _each(
        machine,
        "rows of rings whose worst tip gives way half as much as before",
        {
            model: row["tip_worst_mm_n"] <= WORST_SHARE * old[model]["tip_worst_mm_n"]
            for model, row in printed.items()
            if model in ROWS_OF_RINGS and _both(old, new, model, "tip_worst_mm_n")
        },
        lambda model: f"{old[model]['tip_worst_mm_n']:.0f} → {new[model]['tip_worst_mm_n']:.0f}",
    )
    if machine == PINCHED:
        yield _pinched(machine, old, new)
    if machine == TIP:
        yield _each(
            machine,
            f"95 % of the posts at {TIP_MM_N:g} mm/N or less",
            {
                model: row["tip_95_mm_n"] <= TIP_MM_N
                for model, row in printed.items()
                if row["tip_95_mm_n"] is not None
            },
            lambda model: f"{new[model]['tip_95_mm_n']:.0f}",
        )
    yield _time(machine, old, new)
    yield _each(
        machine,
        "no breach",
        {model: row["breaches"] == 0 for model, row in printed.items()},
        lambda model: f"{new[model]['breaches']:.0f}",
    )


def _pinched(machine, old, new):
    """Models and directions count alike; those that could not be measured do not."""
    gains = [
        new[model][name] / old[model][name]
        for name in ("pinch_x_n_mm", "pinch_y_n_mm")
        for model in new
        if _both(old, new, model, name)
    ]
    gain = median(gains) if gains else 0.0
    text = f"pinch {gain:.1f} times as stiff as before in the median, wanted {PINCH_GAIN:g}"
    return _line(machine, text, gain >= PINCH_GAIN)


def _time(machine, old, new):
    """Time in the sum, of the models that are printed both before and now."""
    both = [model for model in new if _both(old, new, model, "print_time_s")]
    before_h, after_h = (sum(row[m]["print_time_s"] for m in both) / 3600 for row in (old, new))
    text = f"{after_h:.2f} h of printing in all, before {before_h:.2f} h"
    return _line(machine, text, after_h <= before_h)


def _both(old, new, model, name):
    return all(rows.get(model, {}).get(name) is not None for rows in (old, new))


def _each(machine, goal, holds, figure=lambda _: ""):
    """A goal for each model, with those that miss it."""
    missed = [f"{model} {figure(model)}".strip() for model, ok in holds.items() if not ok]
    rest = f"; not {', '.join(missed)}" if missed else ""
    return _line(machine, f"{goal}: {len(holds) - len(missed)} of {len(holds)}{rest}", not missed)


def _line(machine, text, holds):
    return f"- {'**met**' if holds else 'missed'}, {machine}: {text}."

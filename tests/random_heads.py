"""Parts of heads at random, as single keys of the settings."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from random import Random


def parts(draw: Random, most: int = 3, lowest_mm: float = 0.5) -> list[str]:
    """Return `head.parts` with up to so many boxes and cylinders; none half the time.

    They hang as low as `lowest_mm` over the bed where the tip touches it.
    """
    if draw.random() < 0.5:
        return []
    made = [_part(draw, lowest_mm) for _ in range(draw.randint(1, most))]
    return [f"head.parts=[{', '.join(made)}]"]


def _part(draw: Random, lowest_mm: float) -> str:
    bottom = f"bottom_mm = {draw.uniform(lowest_mm, 8):.2f}"
    x, y = (draw.choice((-1, 1)) * draw.uniform(3, 35) for _ in range(2))
    if draw.random() < 0.4:
        radius = draw.uniform(0.5, 8)
        centre = f"centre_mm = [{x:.2f}, {y:.2f}], radius_mm = {radius:.2f}"
        return f'{{ shape = "cylinder", {centre}, {bottom} }}'
    wide, deep, turn = draw.uniform(1, 25), draw.uniform(1, 25), draw.choice((0, 0, 45, 90, -31.5))
    extent = f"x_mm = [{x:.2f}, {x + wide:.2f}], y_mm = [{y:.2f}, {y + deep:.2f}]"
    return f'{{ shape = "box", {extent}, turn_deg = {turn}, {bottom} }}'

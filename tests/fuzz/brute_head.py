"""Whether a straight move drives the head into a straight strand, by halving the square of places.

Every place of the tip along the move and every place of the material along the strand: a square.
A part of it is thrown away once no point in it can be deep enough, by bounds on the distances in
it; it counts once its middle is. What is left undecided at a millionth is a graze.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Halvings of either side of the square.
HALVINGS = 20


@dataclass(frozen=True)
class Head:
    """The figures of a profile: mm and degrees."""

    tip_radius_mm: float
    slant_deg: float
    cone_height_mm: float
    block_radius_mm: float
    carriage_height_mm: float
    carriage_radius_mm: float

    #: Boxes and cylinders, as the profile has them.
    parts: list[dict[str, Any]] = field(default_factory=list)

    @classmethod
    def of(cls, figures: dict[str, Any]) -> Head:
        """Take what is needed from the rules of a file."""
        return cls(**{name: figures[name] for name in cls.__dataclass_fields__})

    def underside(self, offset: NDArray[Any], spread: NDArray[Any] | float = 0.0) -> NDArray[Any]:
        """Lowest height of the head over its tip at places beside it, mm; infinite beyond it.

        Places are x and y seen from the tip; all as far from them as `spread` along x and y count.
        """
        spread = np.broadcast_to(spread, offset.shape)
        wide = np.hypot(spread[..., 0], spread[..., 1])
        distance = np.maximum(np.hypot(offset[..., 0], offset[..., 1]) - wide, 0)
        slope = np.tan(np.radians(self.slant_deg))
        flank = slope * np.maximum(distance - self.tip_radius_mm, 0)
        under = np.minimum(flank, self.cone_height_mm)
        under = np.where(distance > self.block_radius_mm, self.carriage_height_mm, under)
        under = np.where(distance > self.carriage_radius_mm, np.inf, under)
        for part in self.parts:
            over = _box_is_over if part["shape"] == "box" else _cylinder_is_over
            under = np.where(
                over(part, offset, spread), np.minimum(under, part["bottom_mm"]), under
            )
        return under

    @property
    def reach_mm(self) -> float:
        """Distance from the axis beyond which there is nothing of the head."""
        return max([self.carriage_radius_mm, self.block_radius_mm, *map(_farthest, self.parts)])


def _box_is_over(part: dict[str, Any], offset: NDArray[Any], spread: NDArray[Any]) -> NDArray[Any]:
    turn = np.radians(part["turn_deg"])
    cos, sin = np.cos(turn), np.sin(turn)
    x = cos * offset[..., 0] + sin * offset[..., 1]
    y = cos * offset[..., 1] - sin * offset[..., 0]
    more_x = abs(cos) * spread[..., 0] + abs(sin) * spread[..., 1]
    more_y = abs(sin) * spread[..., 0] + abs(cos) * spread[..., 1]
    (left, right), (front, back) = part["x_mm"], part["y_mm"]
    in_x = (x >= left - more_x) & (x <= right + more_x)
    return in_x & (y >= front - more_y) & (y <= back + more_y)


def _cylinder_is_over(
    part: dict[str, Any], offset: NDArray[Any], spread: NDArray[Any]
) -> NDArray[Any]:
    x, y = part["centre_mm"]
    distance = np.hypot(offset[..., 0] - x, offset[..., 1] - y)
    return distance <= part["radius_mm"] + np.hypot(spread[..., 0], spread[..., 1])


def _farthest(part: dict[str, Any]) -> float:
    if part["shape"] == "cylinder":
        return float(np.hypot(*part["centre_mm"]) + part["radius_mm"])
    return float(np.hypot(max(map(abs, part["x_mm"])), max(map(abs, part["y_mm"]))))


def depth_at(head: Head, tip: NDArray[Any], material: NDArray[Any]) -> NDArray[Any]:
    """How far material is in the head whose tip is at a place, mm."""
    offset = material - tip
    return offset[..., 2] - head.underside(offset[..., :2])


def hits(
    head: Head, moves: NDArray[Any], strands: NDArray[Any], deeper_than: float
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Judge pairs of moves and strands, each ``(N, 2, 3)``.

    Returns
    -------
    certain, possible
        Whether a pair certainly has a place that deep, and whether it may have one.
    """
    count = len(moves)
    certain = np.zeros(count, bool)
    pair = np.arange(count)
    low = np.zeros((count, 2))
    base = strands[:, 0] - moves[:, 0]
    along = moves[:, 0] - moves[:, 1]
    across = strands[:, 1] - strands[:, 0]
    side = 1.0
    for _ in range(HALVINGS):
        middle = low + side / 2
        offset = base[pair] + middle[:, :1] * along[pair] + middle[:, 1:] * across[pair]
        deep = offset[:, 2] - head.underside(offset[:, :2]) > deeper_than
        certain[pair[deep]] = True
        # Within the part nothing is farther from its middle than this.
        lies = np.abs(along[pair]) + np.abs(across[pair])
        spread = lies * side / 2
        best = offset[:, 2] + spread[:, 2] - head.underside(offset[:, :2], spread[:, :2])
        open_ = (best > deeper_than) & ~certain[pair]
        pair, low = pair[open_], low[open_]
        side /= 2
        corners = np.array([[0, 0], [0, side], [side, 0], [side, side]])
        low = (low[:, None] + corners).reshape(-1, 2)
        pair = np.repeat(pair, 4)
        if len(pair) > 4_000_000:
            break
    possible = certain.copy()
    possible[pair] = True
    return certain, possible


def far_apart(head: Head, move: NDArray[Any], strands: NDArray[Any]) -> NDArray[Any]:
    """Whether strands are too low, or too far to the side, to be hit by a move at all."""
    low, high = move.min(axis=0), move.max(axis=0)
    first, last = strands.min(axis=1), strands.max(axis=1)
    reach = head.reach_mm
    beside = (first[:, :2] > high[:2] + reach) | (last[:, :2] < low[:2] - reach)
    return beside.any(axis=1) | (last[:, 2] < low[2])

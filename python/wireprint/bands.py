"""Bands of heights."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

#: From height to height, mm.
Band = tuple[float, float]


def joined(bands: Iterable[Band]) -> list[Band]:
    """Return bands, those that overlap as one, from the lowest up."""
    found: list[Band] = []
    for low, high in sorted(bands):
        if found and low <= found[-1][1]:
            found[-1] = found[-1][0], max(found[-1][1], high)
        else:
            found.append((low, high))
    return found

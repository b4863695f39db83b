"""Marks in a few words: ``box:0,0,0,10,10,5``, ``z:20..35``, ``erase:sphere:0,0,30,8``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from wireprint._core import SettingError
from wireprint.regions.region import Mark
from wireprint.regions.shapes import Box, HalfSpace, Shape, Sphere, ZRange

if TYPE_CHECKING:
    from collections.abc import Callable

#: Name of each shape → how it is written, its count of numbers, and what makes it of them.
_SHAPES: dict[str, tuple[str, int, Callable[[list[float]], Shape]]] = {
    "box": (
        "box:X0,Y0,Z0,X1,Y1,Z1",
        6,
        lambda n: Box(low_mm=_point(map(min, n, n[3:])), high_mm=_point(map(max, n, n[3:]))),
    ),
    "sphere": (
        "sphere:X,Y,Z,RADIUS",
        4,
        lambda n: Sphere(centre_mm=_point(n[:3]), radius_mm=n[3]),
    ),
    "half": (
        "half:NX,NY,NZ,DISTANCE",
        4,
        lambda n: HalfSpace(normal=_point(n[:3]), offset_mm=n[3]),
    ),
}
_RANGE = "z:LOW..HIGH"
_ERASE = "erase:"


def parse(text: str) -> Mark:
    """Return the mark that a text describes.

    Parameters
    ----------
    text
        ``box:X0,Y0,Z0,X1,Y1,Z1`` (any two opposite corners), ``sphere:X,Y,Z,RADIUS``,
        ``half:NX,NY,NZ,DISTANCE`` (what lies at least so far from the origin along the normal), or
        ``z:LOW..HIGH``, where either end may be missing; all in mm. With ``erase:`` before it the
        mark erases.

    Raises
    ------
    SettingError
        It describes none.
    """
    erase, body = text.startswith(_ERASE), text.removeprefix(_ERASE)
    name, _, numbers = body.partition(":")
    try:
        return Mark(_range(numbers) if name == "z" else _solid(name, numbers), erase)
    except ValidationError as error:
        what = error.errors(include_url=False)[0]["msg"].removeprefix("Value error, ")
        raise SettingError(f"{text}: {what[:1].lower()}{what[1:]}") from None
    except ValueError as error:
        raise SettingError(f"{text}: {error}") from None


def _solid(name: str, text: str) -> Shape:
    if name not in _SHAPES:
        forms = [form for form, _, _ in _SHAPES.values()]
        raise ValueError(f"a mark is one of {', '.join([*forms, _RANGE])}, or erase: and one")
    form, count, make = _SHAPES[name]
    numbers = [float(number) for number in text.split(",")]
    if len(numbers) != count:
        raise ValueError(f"has {len(numbers)} numbers, not {count}; write {form}")
    if not all(map(math.isfinite, numbers)):
        raise ValueError("numbers must be finite")
    return make(numbers)


def _range(text: str) -> Shape:
    low, dots, high = text.partition("..")
    if not dots:
        raise ValueError(f"write {_RANGE}")
    ends = [float(end) if end.strip() else None for end in (low, high)]
    return ZRange(low_mm=ends[0], high_mm=ends[1])


def _point(numbers: Any) -> tuple[float, float, float]:
    x, y, z = numbers
    return x, y, z

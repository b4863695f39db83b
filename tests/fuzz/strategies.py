"""Settings for hypothesis, made from the schema that `wireprint profiles --keys` shows.

Every key is drawn by what it holds and between which bounds: plain values, the bounds themselves,
what lies just beyond them, and what is no value at all; several keys at a time, on any printer and
material.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from hypothesis import strategies as st
from inputs import flat

from wireprint import Settings, catalogue
from wireprint.settings import describe

if TYPE_CHECKING:
    from wireprint.keys import Key

PRINTERS = catalogue.names("printers")
MATERIALS = catalogue.names("materials")
#: What is no value of most keys, as it is written behind `=`.
ODD = [
    "",
    "nan",
    "-inf",
    "1e308",
    "-0.0",
    "9" * 400,
    "null",
    "[]",
    "{}",
    "true",
    '"\\u0000"',
    "é",
    "=",
]
#: Numbers by which a value may differ from a good one.
FACTORS = [0.01, 0.5, 0.8, 1.0, 1.25, 2.0, 100.0]


@dataclass(frozen=True)
class Drawn:
    """Profiles, and single keys laid over them as `--set` takes them."""

    printer: str
    material: str
    overrides: tuple[str, ...]

    @property
    def keys(self) -> list[str]:
        """The keys that differ from the profiles."""
        return [override.partition("=")[0] for override in self.overrides]


def drawn(most: int = 6) -> st.SearchStrategy[Drawn]:
    """Profiles with up to `most` keys of other values: mostly ones that are allowed."""
    good = st.lists(override(allowed), max_size=most)
    any_kind = st.lists(st.one_of(override(allowed), override(anything)), max_size=most)
    return st.builds(
        Drawn,
        st.sampled_from(PRINTERS),
        st.sampled_from(MATERIALS),
        st.one_of(good, good, any_kind).map(tuple),
    )


@st.composite
def override(draw: Any, values: Any) -> str:
    """One key with a value."""
    key = draw(st.sampled_from(KEYS))
    return f"{key.short}={draw(values(key))}"


def allowed(key: Key) -> st.SearchStrategy[str]:
    """Values within the key's own bounds, whatever others it may contradict."""
    if key.kind == "number":
        low, high = ends(key)
        inside = st.floats(low, high, exclude_min=key.above_low, exclude_max=key.below_high)
        near = st.sampled_from([clipped(key, USUAL[key.key] * factor) for factor in FACTORS])
        return st.one_of(near, near, inside).map(repr) | st.sampled_from(key.choices or ("null",))
    if key.kind == "integer":
        low, high = (int(end) for end in ends(key))
        return st.integers(low, min(high, low + 20)).map(str) | st.just(str(high))
    if key.kind == "choice":
        return st.sampled_from(key.choices)
    if key.kind == "switch":
        return st.sampled_from(["true", "false"])
    if key.kind == "text":
        return st.text(st.characters(codec="utf-8", categories=["L", "N", "P", "Zs"]), max_size=40)
    return lists(key)


def anything(key: Key) -> st.SearchStrategy[str]:
    """Values beyond the bounds, of another kind, or none."""
    beyond = [json.dumps(end) for end in past(key)]
    return st.one_of(st.sampled_from(ODD + beyond), st.text(max_size=20), st.floats().map(repr))


def lists(key: Key) -> st.SearchStrategy[str]:
    """Lists as long as the usual one or not, of numbers or tables like its own."""
    usual = USUAL[key.key] or [0.0, 0.0]
    entry = (
        st.sampled_from(usual) | st.floats(allow_nan=False, allow_infinity=False) | st.booleans()
    )
    return st.one_of(st.just(usual), st.lists(entry, max_size=8)).map(json.dumps)


def ends(key: Key) -> tuple[float, float]:
    """Bounds; where the schema has none, ten times what is usual."""
    usual = abs(USUAL[key.key]) or 1.0
    low = -10 * usual if key.low is None else key.low
    return low, max(low, 10 * usual) if key.high is None else key.high


def clipped(key: Key, value: float) -> float:
    """The value that is allowed and nearest."""
    low, high = ends(key)
    low = math.nextafter(low, math.inf) if key.above_low else low
    high = math.nextafter(high, -math.inf) if key.below_high else high
    return min(max(value, low), high)


def past(key: Key) -> list[float]:
    """Numbers just beyond the bounds, and bounds that are left out."""
    found = []
    if key.low is not None:
        found.append(key.low if key.above_low else math.nextafter(key.low, -math.inf))
    if key.high is not None:
        found.append(key.high if key.below_high else math.nextafter(key.high, math.inf))
    return found


def _usual(key: Key) -> Any:
    """A value as good machines have it: the paper's printer's, the default, or a bound."""
    is_number = key.kind in ("number", "integer")
    for value in (_STATED.get(key.key), key.default, key.low, key.high):
        if value is not None and not (is_number and isinstance(value, str)):
            return value
    return 1.0 if is_number else None


KEYS = describe()
_STATED = dict(flat(Settings.load().model_dump(mode="json")))
USUAL = {key.key: _usual(key) for key in KEYS}

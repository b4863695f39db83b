"""Bytes of an answer: a head in JSON, and arrays as they lie in memory."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Final

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy.typing as npt

    Array = npt.NDArray[Any]

#: Arrays begin at multiples of so many bytes, so that a page can look at them where they lie.
ALIGNMENT: Final = 8
_LENGTH_BYTES: Final = 4


def encoded(head: Mapping[str, Any], arrays: Mapping[str, Array] | None = None) -> bytes:
    """Return an answer: u32 length of the head, the head, arrays; all little-endian.

    Parameters
    ----------
    head
        What JSON can say. ``arrays`` is added: name → type, shape and offset from the head's end.
    arrays
        Numbers, of any shape.
    """
    contiguous = {
        name: np.ascontiguousarray(array, array.dtype.newbyteorder("<"))
        for name, array in (arrays or {}).items()
    }
    # Offsets stand in the head, whose length depends on them: they are counted from its end.
    places: dict[str, dict[str, Any]] = {}
    end = 0
    for name, array in contiguous.items():
        start = _aligned(end)
        places[name] = {"type": array.dtype.str[1:], "shape": array.shape, "offset": start}
        end = start + array.nbytes
    text = json.dumps({**head, "arrays": places}, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (_aligned(_LENGTH_BYTES + len(text)) - _LENGTH_BYTES - len(text))
    out = bytearray(len(text).to_bytes(_LENGTH_BYTES, "little") + text)
    begin = len(out)
    for name, array in contiguous.items():
        out += bytes(begin + places[name]["offset"] - len(out))
        out += array.tobytes()
    return bytes(out)


def decoded(answer: bytes) -> tuple[dict[str, Any], dict[str, Array]]:
    """Return head and arrays of what `encoded` gave."""
    begin = _LENGTH_BYTES + int.from_bytes(answer[:_LENGTH_BYTES], "little")
    head: dict[str, Any] = json.loads(answer[_LENGTH_BYTES:begin])
    arrays = {}
    for name, place in head.pop("arrays").items():
        count = int(np.prod(place["shape"]))
        found = np.frombuffer(answer, "<" + place["type"], count, begin + place["offset"])
        arrays[name] = found.reshape(place["shape"])
    return head, arrays


def _aligned(place: int) -> int:
    return -(-place // ALIGNMENT) * ALIGNMENT

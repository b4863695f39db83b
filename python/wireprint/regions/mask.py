"""Triangles, each of them marked or not."""

import base64
import binascii
from functools import cached_property
from typing import Annotated, Any, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import PlainSerializer, PlainValidator, model_validator

from wireprint._core import Facets
from wireprint.regions.shapes import Flags, Floats, Shape

#: Coordinates beyond this make no sense in any unit; the core refuses them in models, too.
_LARGEST = 1e9


def _array(dtype: str, columns: int) -> Any:
    """Field of a little-endian array, in JSON the base64 of its bytes."""
    kind, shape = np.dtype(dtype), (-1, columns) if columns > 1 else (-1,)

    def read(value: Any) -> npt.NDArray[Any]:
        given = _unpacked(value, kind, columns).reshape(shape) if isinstance(value, str) else value
        if not isinstance(given, np.ndarray) or given.ndim != len(shape):
            raise ValueError(f"must be an array of shape {shape}")
        integers = np.issubdtype(kind, np.integer) and np.issubdtype(given.dtype, np.integer)
        if not (integers or given.dtype == kind) or given.shape[1:] != shape[1:]:
            raise ValueError(f"has dtype {given.dtype} and shape {given.shape}")
        if given.dtype == kind and not given.flags.writeable and given.flags.owndata:
            # Nobody can change it any more, and it may be large.
            return given
        fixed = np.array(given, kind)
        if not np.array_equal(fixed, given, equal_nan=kind.kind == "f"):
            raise ValueError(f"has numbers that do not fit {kind.name}")
        fixed.setflags(write=False)
        return fixed

    def written(value: npt.NDArray[Any]) -> str:
        return base64.b64encode(value.tobytes()).decode()

    return Annotated[
        npt.NDArray[Any], PlainValidator(read), PlainSerializer(written, when_used="json")
    ]


def _unpacked(text: str, kind: np.dtype[Any], columns: int) -> npt.NDArray[Any]:
    """Return the numbers of which a text is the base64."""
    try:
        content = base64.b64decode(text, validate=True)
    except binascii.Error as error:
        raise ValueError(f"no base64: {error}") from error
    if len(content) % (columns * kind.itemsize):
        raise ValueError(f"its {len(content)} bytes are no {columns} {kind.name} in each row")
    # A byte of a bool may be anything but 0.
    return np.frombuffer(content, kind) if kind.kind != "b" else np.frombuffer(content, "u1") != 0


class Mask(Shape):
    """All points whose nearest triangle is marked.

    The triangles are the mask's own, so it outlives repair, welding and slicing of the model that
    they were painted on.
    """

    noun = "paint of the file"
    kind: Literal["mask"] = "mask"
    #: float64 of shape (V, 3), mm or the unit of the file that was painted.
    vertices: _array("<f8", 3)  # type: ignore[valid-type]
    #: uint32 of shape (T, 3): indices of vertices.
    faces: _array("<u4", 3)  # type: ignore[valid-type]
    #: bool of shape (T,).
    marked: _array("|b1", 1)  # type: ignore[valid-type]

    @model_validator(mode="after")
    def _arrays_fit_together(self) -> Self:
        if len(self.marked) != len(self.faces) or not len(self.faces):
            raise ValueError(f"{len(self.marked)} of {len(self.faces)} faces are marked or not")
        if self.faces.max() >= len(self.vertices):
            raise ValueError(f"faces names vertex {self.faces.max()} of {len(self.vertices)}")
        if not (np.abs(self.vertices) <= _LARGEST).all():
            raise ValueError("vertices holds a number that is not finite, or absurd")
        return self

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        covered: Flags = self.marked[self._facets.nearest(np.ascontiguousarray(points))]
        return covered

    @cached_property
    def _facets(self) -> Facets:
        return Facets(self.vertices, self.faces)

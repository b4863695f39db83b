"""Scenes of glTF files: their primitives, each where its node puts it."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import ModelError

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

#: How a binary file (``.glb``) begins, and what its pieces are called.
MAGIC: Final = b"glTF"
JSON: Final = 0x4E4F534A
BIN: Final = 0x004E4942
#: glTF is in metres.
MM: Final = 1000.0
#: The mode of a primitive that names none.
TRIANGLES: Final = 4
_TYPES: Final = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTH: Final = {"SCALAR": 1, "VEC3": 3}
#: What reading something else than a glTF file as one ends in.
_DAMAGES: Final = (
    LookupError,
    TypeError,
    ValueError,
    AttributeError,
    ArithmeticError,
    RecursionError,
    struct.error,
)


@dataclass(frozen=True)
class Primitive:
    """Lines or triangles of a scene."""

    mode: int
    #: Positions in the scene, mm, along the file's own axes.
    places: npt.NDArray[np.float64]
    #: Which of them follow each other.
    order: npt.NDArray[Any]


def primitives(text: bytes, most_corners: int) -> Iterator[Primitive]:
    """Yield what stands in the first scene of a ``.gltf`` or ``.glb`` file.

    Parameters
    ----------
    text
        The file.
    most_corners
        Of all primitives: nodes may repeat a mesh, and so be many more than the file is long.

    Raises
    ------
    ModelError
        It is damaged, its data lie in another file, or it has too many corners.
    """
    with _damage_named():
        document, binary = _parts(text)
        corners = 0
        for matrix, primitive in _standing(document):
            about = document["accessors"][primitive.get("indices", _positions(primitive))]
            corners += about["count"]
            if corners > most_corners:
                msg = f"its nodes repeat meshes to more than {most_corners} corners"
                raise ModelError(msg)
            places = _accessor(document, binary, _positions(primitive)).astype(np.float64)
            order = np.arange(len(places))
            if "indices" in primitive:
                order = _accessor(document, binary, primitive["indices"]).ravel()
                if order.dtype.kind != "u":
                    raise ModelError("a damaged glTF file: indices are no unsigned numbers")
            with np.errstate(over="ignore", invalid="ignore"):
                places = MM * (places @ matrix[:3, :3].T + matrix[:3, 3])
            if not np.isfinite(places).all():
                raise ModelError("a damaged glTF file: a position is no number")
            if len(order) and int(order.max()) >= len(places):
                raise ModelError(f"a damaged glTF file: there is no position {order.max()}")
            yield Primitive(primitive.get("mode", TRIANGLES), places, order)


@contextmanager
def _damage_named() -> Iterator[None]:
    try:
        yield
    except _DAMAGES as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"a damaged glTF file: {type(error).__name__} {error}") from None


def _parts(text: bytes) -> tuple[dict[str, Any], bytes]:
    if not text.startswith(MAGIC):
        return json.loads(text), b""
    document: dict[str, Any] = {}
    binary, at = b"", 12
    while at + 8 <= len(text):
        length, kind = struct.unpack_from("<II", text, at)
        chunk = text[at + 8 : at + 8 + length]
        if kind == JSON:
            document = json.loads(chunk)
        elif kind == BIN:
            binary = chunk
        at += 8 + length
    return document, binary


def _standing(document: dict[str, Any]) -> Iterator[tuple[npt.NDArray[np.float64], dict[str, Any]]]:
    """Yield the primitives of a scene, each with the matrix of its node."""
    nodes = document.get("nodes", [])
    held = {child for node in nodes for child in node.get("children", [])}
    scene = document.get("scenes", [{}])[document.get("scene", 0)]
    roots = scene.get("nodes", [number for number in range(len(nodes)) if number not in held])
    todo = [(number, np.eye(4)) for number in roots]
    seen = set()
    while todo:
        number, above = todo.pop()
        if number in seen:
            raise ModelError(f"node {number} has two parents, or is its own")
        seen.add(number)
        node = nodes[number]
        matrix = above @ _matrix(node)
        todo += [(child, matrix) for child in node.get("children", [])]
        if "mesh" in node:
            for primitive in document["meshes"][node["mesh"]]["primitives"]:
                yield matrix, primitive


def _positions(primitive: dict[str, Any]) -> int:
    number: int = primitive["attributes"]["POSITION"]
    return number


def _matrix(node: dict[str, Any]) -> npt.NDArray[np.float64]:
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, :3] *= np.array(node.get("scale", (1.0, 1.0, 1.0)))
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


def _accessor(document: dict[str, Any], binary: bytes, number: int) -> npt.NDArray[Any]:
    about = document["accessors"][number]
    view = document["bufferViews"][about["bufferView"]]
    data = _buffer(document["buffers"][view["buffer"]], binary)
    kind, width = np.dtype(_TYPES[about["componentType"]]).newbyteorder("<"), _WIDTH[about["type"]]
    start = view.get("byteOffset", 0) + about.get("byteOffset", 0)
    stride = view.get("byteStride", kind.itemsize * width)
    count = int(about["count"])
    if stride < kind.itemsize * width:
        raise ModelError(f"a damaged glTF file: the stride of accessor {number} is {stride}")
    if count < 0 or start + max(0, count - 1) * stride + kind.itemsize * width > len(data):
        raise ModelError("a glTF file that was cut off: its data end too early")
    return np.ndarray((count, width), kind, data, start, (stride, kind.itemsize))


def _buffer(buffer: dict[str, Any], binary: bytes) -> bytes:
    uri = buffer.get("uri")
    if uri is None:
        return binary
    head, comma, data = uri.partition(",")
    if not (comma and head.startswith("data:")):
        raise ModelError(f"its data lie in {uri!r}; write it as one file (.glb)")
    try:
        return base64.b64decode(data)
    except binascii.Error as error:
        raise ModelError(f"its data are no base64: {error}") from None

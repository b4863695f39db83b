"""Struts as lines in glTF files: ``.gltf`` with data of its own, and ``.glb``."""

from __future__ import annotations

import base64
import binascii
import json
import struct
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

_MAGIC: Final = b"glTF"
_JSON: Final = 0x4E4F534A
_BIN: Final = 0x004E4942
_LINES, _LOOP, _STRIP = 1, 2, 3
_TYPES: Final = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTH: Final = {"SCALAR": 1, "VEC3": 3}
#: glTF is in metres.
_MM: Final = 1000.0
_DEEPEST: Final = 50


def read_gltf(text: bytes) -> Graph:
    """Read the lines of all meshes in a scene, each where its node puts it; metres become mm.

    Raises
    ------
    ModelError
        It is damaged, its data lie in another file, or it has no lines.
    """
    try:
        document, binary = _parts(text)
        segments = list(_segments(document, binary))
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, struct.error) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"a damaged glTF file: {type(error).__name__} {error}") from None
    if not segments:
        raise ModelError("it has no lines: primitives of mode 1, 2 or 3")
    # glTF's y points up.
    ends = _MM * np.concatenate(segments)[..., [0, 2, 1]] * (1.0, -1.0, 1.0)
    return Graph.of_segments(ends)


def write_glb(graph: Graph) -> bytes:
    """Write one mesh of lines in the order of printing, metres, y up."""
    nodes = (graph.nodes[:, [0, 2, 1]] * (1.0, 1.0, -1.0) / _MM).astype("<f4")
    edges = graph.edges.astype("<u4")
    binary = nodes.tobytes() + edges.tobytes()
    low = nodes.min(axis=0).tolist() if len(nodes) else [0.0] * 3
    high = nodes.max(axis=0).tolist() if len(nodes) else [0.0] * 3
    document = {
        "asset": {"version": "2.0", "generator": "wireprint"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "struts"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": _LINES}]}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": nodes.nbytes},
            {"buffer": 0, "byteOffset": nodes.nbytes, "byteLength": edges.nbytes},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": len(nodes),
                "type": "VEC3",
                "min": low,
                "max": high,
            },
            {"bufferView": 1, "componentType": 5125, "count": edges.size, "type": "SCALAR"},
        ],
    }
    head = json.dumps(document).encode()
    head += b" " * (-len(head) % 4)
    chunks = struct.pack("<II", len(head), _JSON) + head
    chunks += struct.pack("<II", len(binary), _BIN) + binary
    return struct.pack("<4sII", _MAGIC, 2, 12 + len(chunks)) + chunks


def _parts(text: bytes) -> tuple[dict[str, Any], bytes]:
    if not text.startswith(_MAGIC):
        return json.loads(text), b""
    document: dict[str, Any] = {}
    binary, at = b"", 12
    while at + 8 <= len(text):
        length, kind = struct.unpack_from("<II", text, at)
        chunk = text[at + 8 : at + 8 + length]
        if kind == _JSON:
            document = json.loads(chunk)
        elif kind == _BIN:
            binary = chunk
        at += 8 + length
    return document, binary


def _segments(document: dict[str, Any], binary: bytes) -> Iterator[npt.NDArray[np.float64]]:
    nodes = document.get("nodes", [])
    scene = document.get("scenes", [{}])[document.get("scene", 0)]
    roots = scene.get("nodes", range(len(nodes)))
    todo = [(number, np.eye(4), 0) for number in roots]
    while todo:
        number, above, depth = todo.pop()
        if depth > _DEEPEST:
            raise ModelError("nodes lie in each other without end")
        node = nodes[number]
        matrix = above @ _matrix(node)
        todo += [(child, matrix, depth + 1) for child in node.get("children", [])]
        if "mesh" not in node:
            continue
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            mode = primitive.get("mode", 4)
            if mode not in (_LINES, _LOOP, _STRIP):
                continue
            places = _accessor(document, binary, primitive["attributes"]["POSITION"])
            places = places.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
            order = np.arange(len(places))
            if "indices" in primitive:
                order = _accessor(document, binary, primitive["indices"]).ravel()
            yield places[_pairs(order, mode)]


def _pairs(order: npt.NDArray[Any], mode: int) -> npt.NDArray[Any]:
    if mode == _LINES:
        return order[: len(order) // 2 * 2].reshape(-1, 2)
    following = np.roll(order, -1)
    pairs = np.column_stack([order, following])
    return pairs if mode == _LOOP else pairs[:-1]


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

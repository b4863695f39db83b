"""Struts as lines in glTF files: ``.gltf`` with data of its own, and ``.glb``."""

from __future__ import annotations

import json
import struct
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import gltf
from wireprint._core import ModelError
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    import numpy.typing as npt

_LINES, _LOOP, _STRIP = 1, 2, 3
#: More struts than anybody prints have fewer.
_MOST_CORNERS: Final = 2_000_000


def read_gltf(text: bytes) -> Graph:
    """Read the lines of all meshes in a scene, each where its node puts it; metres become mm.

    Raises
    ------
    ModelError
        It is damaged, its data lie in another file, or it has no lines.
    """
    segments = [
        found.places[_pairs(found.order, found.mode)]
        for found in gltf.primitives(text, _MOST_CORNERS)
        if found.mode in (_LINES, _LOOP, _STRIP)
    ]
    if not segments:
        raise ModelError("it has no lines: primitives of mode 1, 2 or 3")
    # glTF's y points up.
    return Graph.of_segments(np.concatenate(segments)[..., [0, 2, 1]] * (1.0, -1.0, 1.0))


def write_glb(graph: Graph) -> bytes:
    """Write one mesh of lines in the order of printing, metres, y up."""
    nodes = (graph.nodes[:, [0, 2, 1]] * (1.0, 1.0, -1.0) / gltf.MM).astype("<f4")
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
    chunks = struct.pack("<II", len(head), gltf.JSON) + head
    chunks += struct.pack("<II", len(binary), gltf.BIN) + binary
    return struct.pack("<4sII", gltf.MAGIC, 2, 12 + len(chunks)) + chunks


def _pairs(order: npt.NDArray[Any], mode: int) -> npt.NDArray[Any]:
    if mode == _LINES:
        return order[: len(order) // 2 * 2].reshape(-1, 2)
    following = np.roll(order, -1)
    pairs = np.column_stack([order, following])
    return pairs if mode == _LOOP else pairs[:-1]

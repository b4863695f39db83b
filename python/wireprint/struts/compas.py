"""Struts as JSON: COMPAS' graphs and networks, Choreo's, and plain ``{"nodes": …, "edges": …}``."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint._core import ModelError
from wireprint.struts import choreo
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping


def read_json(text: bytes) -> Graph:
    """Read a graph of COMPAS (1 or 2, a ``Graph``, ``Network`` or ``VolMesh``-free scene of it).

    Raises
    ------
    ModelError
        It is no JSON, or holds no graph.
    """
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise ModelError(f"it is no JSON: {error}") from None
    if isinstance(document, dict) and {"nodes", "edges"} <= document.keys():
        return _plain(document)
    if choreo.is_choreo(document):
        return choreo.read(document)
    for data in _tables(document):
        if isinstance(data.get("node"), dict) and isinstance(data.get("edge"), dict):
            return _of_compas(data)
    msg = (
        'it holds neither a graph of COMPAS ("node", "edge") nor one of Choreo ("node_list", '
        '"element_list") nor "nodes" and "edges"'
    )
    raise ModelError(msg)


def write_json(graph: Graph) -> bytes:
    """Write a graph as COMPAS 2 reads it; order, radius, time and normal are edge attributes."""
    node = {
        str(number): {"x": float(x), "y": float(y), "z": float(z)}
        for number, (x, y, z) in enumerate(graph.nodes)
    }
    edge: dict[str, dict[str, Any]] = {name: {} for name in node}
    for number, (a, b) in enumerate(graph.edges.tolist()):
        about: dict[str, Any] = {"order": number}
        if len(graph.radius_mm):
            about["radius"] = float(graph.radius_mm[number])
        if len(graph.time_s):
            about["time"] = float(graph.time_s[number])
        if len(graph.normals):
            about["normal"] = graph.normals[number].tolist()
        edge[str(a)][str(b)] = about
    data = {
        "attributes": {"name": "struts", "unit": "mm"},
        "default_node_attributes": {"x": 0.0, "y": 0.0, "z": 0.0},
        "default_edge_attributes": {},
        "node": node,
        "edge": edge,
        "max_node": len(node) - 1,
    }
    return json.dumps({"dtype": "compas.datastructures/Graph", "data": data}).encode() + b"\n"


def _tables(value: Any, depth: int = 0) -> Iterator[Mapping[str, Any]]:
    """Yield every object of a document, from outside to inside."""
    if depth > 20:
        return
    if isinstance(value, dict):
        yield value
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    for one in inner:
        yield from _tables(one, depth + 1)


def _plain(document: Mapping[str, Any]) -> Graph:
    radius = document.get("radius_mm", document.get("radius", []))
    try:
        return Graph(document["nodes"], document["edges"], np.array(radius, np.float64))
    except (TypeError, ValueError, OverflowError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"nodes, edges or radius are no arrays of numbers: {error}") from None


def _of_compas(data: Mapping[str, Any]) -> Graph:
    defaults = data.get("default_node_attributes") or {}
    numbers = {name: number for number, name in enumerate(data["node"])}
    found: list[tuple[int, int, Mapping[str, Any]]] = []
    try:
        nodes = [
            [float((about or {}).get(axis, defaults.get(axis, 0.0))) for axis in "xyz"]
            for about in data["node"].values()
        ]
        for start, ends in data["edge"].items():
            for end, about in (ends or {}).items():
                # COMPAS 1 names both directions of an edge, one of them without attributes.
                found.append((numbers[start], numbers[end], about or {}))
        found.sort(key=lambda one: one[2].get("order", 0))
        radius = [one[2].get("radius") for one in found]
        known = np.array(radius, np.float64) if radius and None not in radius else np.empty(0)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise ModelError(f"a node or an edge of it is none: {error}") from None
    return Graph(np.array(nodes), np.array([one[:2] for one in found]), known)

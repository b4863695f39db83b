"""Struts as lines in OBJ files, and as edges in PLY files (ASCII)."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from wireprint._core import ModelError
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Iterator


def read_obj(text: bytes) -> Graph:
    """Read the vertices and ``l`` elements of an OBJ file.

    Raises
    ------
    ModelError
        A line of it is none; the message tells which.
    """
    nodes: list[list[float]] = []
    edges: list[tuple[int, int]] = []
    for number, words in _words(text):
        try:
            if words[0] == "v":
                nodes.append([float(word) for word in words[1:4]])
            elif words[0] == "l":
                places = [_index(word, len(nodes)) for word in words[1:]]
                edges += itertools.pairwise(places)
        except (ValueError, IndexError):
            raise ModelError(f"line {number}: {' '.join(words)!r} is no OBJ") from None
    if any(len(node) != 3 for node in nodes):
        raise ModelError("a vertex has fewer than three coordinates")
    return Graph(np.array(nodes), np.array(edges))


def write_obj(graph: Graph) -> bytes:
    """Write vertices, and a line for each strut in the order of printing."""
    lines = ["# struts in the order of printing, mm"]
    lines += [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in graph.nodes]
    lines += [f"l {a + 1} {b + 1}" for a, b in graph.edges]
    return ("\n".join(lines) + "\n").encode()


def read_ply(text: bytes) -> Graph:
    """Read the elements ``vertex`` and ``edge`` of an ASCII PLY file.

    Raises
    ------
    ModelError
        It is binary, or a line of it is none; the message tells which.
    """
    lines = list(_words(text))
    elements: list[tuple[str, int, list[str]]] = []
    body = iter(lines)
    for number, words in body:
        if words[0] == "format" and words[1:2] != ["ascii"]:
            raise ModelError("a binary PLY file; write struts as ASCII PLY, or as OBJ")
        if words[0] == "element" and len(words) == 3:
            elements.append((words[1], _count(words[2], number), []))
        elif words[0] == "property" and elements:
            if len(words) < 3:
                raise ModelError(f"line {number}: a property has a type and a name")
            elements[-1][2].append(words[-1] if words[1] != "list" else f"list {words[-1]}")
        elif words[0] == "end_header":
            break
    found: dict[str, list[dict[str, float]]] = {}
    for name, count, properties in elements:
        rows = found.setdefault(name, [])
        for _ in range(count):
            number, words = next(body, (0, []))
            if not words:
                raise ModelError(f"it ends before its {count} of {name!r} do")
            if any(one.startswith("list ") for one in properties):
                continue
            try:
                rows.append(dict(zip(properties, map(float, words), strict=True)))
            except ValueError:
                raise ModelError(f"line {number}: it is no {name} with {properties}") from None
    try:
        nodes = [[row[axis] for axis in "xyz"] for row in found.get("vertex", [])]
        edges = [[int(row["vertex1"]), int(row["vertex2"])] for row in found.get("edge", [])]
    except KeyError as error:
        raise ModelError(f"a vertex or an edge without {error.args[0]}") from None
    except (ValueError, OverflowError) as error:
        raise ModelError(f"the end of an edge is no number of a vertex: {error}") from None
    radius = [row["radius"] for row in found.get("edge", []) if "radius" in row]
    return Graph(np.array(nodes), np.array(edges), np.array(radius))


def write_ply(graph: Graph) -> bytes:
    """Write vertices and edges, with radius and time of each where they are known."""
    extra = [name for name in ("radius", "time") if len(_column(graph, name))]
    lines = [
        "ply",
        "format ascii 1.0",
        "comment struts in the order of printing; mm, s",
        f"element vertex {len(graph.nodes)}",
        *(f"property double {axis}" for axis in "xyz"),
        f"element edge {len(graph)}",
        "property int vertex1",
        "property int vertex2",
        *(f"property double {name}" for name in extra),
        "end_header",
        *(f"{x:.9g} {y:.9g} {z:.9g}" for x, y, z in graph.nodes),
    ]
    columns = [_column(graph, name) for name in extra]
    for number, (a, b) in enumerate(graph.edges):
        more = "".join(f" {column[number]:.9g}" for column in columns)
        lines.append(f"{a} {b}{more}")
    return ("\n".join(lines) + "\n").encode()


def _column(graph: Graph, name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    return graph.radius_mm if name == "radius" else graph.time_s


def _words(text: bytes) -> Iterator[tuple[int, list[str]]]:
    for number, line in enumerate(text.decode(errors="replace").splitlines(), start=1):
        words = line.split("#")[0].split()
        if words:
            yield number, words


def _index(word: str, count: int) -> int:
    """Return a vertex number from 0; OBJ counts from 1, or back from the last."""
    number = int(word.split("/")[0])
    return number - 1 if number > 0 else count + number


def _count(word: str, line: int) -> int:
    if not word.isdecimal() or len(word) > 9:
        raise ModelError(f"line {line}: {word!r} is no number of elements")
    return int(word)

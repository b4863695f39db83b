"""Struts in files: which format is which."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint._core import ModelError
from wireprint.naming import named
from wireprint.struts import beams, compas, gltf, lines

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.struts.graph import Graph

_READERS: Final[dict[str, Callable[[bytes], Graph]]] = {
    "obj": lines.read_obj,
    "ply": lines.read_ply,
    "gltf": gltf.read_gltf,
    "glb": gltf.read_gltf,
    "json": compas.read_json,
}
#: Suffixes of files that are read.
READ: Final = (*_READERS, "3mf")
#: Suffixes of files that are written.
WRITTEN: Final = ("obj", "ply", "glb", "json", "3mf")


def read_struts(path: str | os.PathLike[str]) -> Graph:
    """Read struts: lines of OBJ, PLY or glTF, a graph of COMPAS, beams of 3MF.

    Parameters
    ----------
    path
        The file; its suffix tells the format. 3MF and glTF state their unit; others are in mm.

    Returns
    -------
    Graph
        Near nodes welded, each strut once.

    Raises
    ------
    ModelError
        It cannot be read, or holds no struts.
    OSError
        It is not there.
    """
    path = Path(path)
    suffix = path.suffix[1:].lower()
    if suffix not in READ:
        known = ", ".join(name.upper() for name in READ)
        raise ModelError(f"{path}: struts come as one of {known}")
    with named(path):
        found = beams.read_3mf(path) if suffix == "3mf" else _READERS[suffix](path.read_bytes())
        found = found.tidied()
        if not len(found):
            raise ModelError("it holds no struts: no lines, and no edges")
        return found


def struts_as(graph: Graph, suffix: str, radius_mm: float) -> bytes:
    """Return struts in a format, in the order of printing.

    Parameters
    ----------
    graph
        The struts.
    suffix
        One of `WRITTEN`.
    radius_mm
        Radius where the format needs one and the graph tells none.

    Returns
    -------
    bytes
        The file.
    """
    if suffix == "3mf":
        return beams.write_3mf(graph, radius_mm)
    writers = {
        "obj": lines.write_obj,
        "ply": lines.write_ply,
        "glb": gltf.write_glb,
        "json": compas.write_json,
    }
    return writers[suffix](graph)

"""Struts as the beam lattice of a 3MF file."""

from __future__ import annotations

import io
import zipfile
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.struts.beam_model import BEAM, CORE, BeamModel
from wireprint.struts.graph import Graph
from wireprint.threemf.archive import Archive

if TYPE_CHECKING:
    from pathlib import Path

_RELATION: Final = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"


def read_3mf(path: Path) -> Graph:
    """Read the beams of all lattices that a 3MF file builds, each where it stands.

    Raises
    ------
    ModelError
        It is damaged, or has no beams.
    """
    found: list[Graph] = []
    with Archive(path) as archive:
        for name in archive.names():
            if name.lower().endswith(".model"):
                found += archive.read(name, lambda chunks: list(BeamModel(chunks).built()))
    if not found:
        raise ModelError("it holds no beam lattice (3MF Beam Lattice Extension)")
    ends = np.concatenate([graph.ends for graph in found])
    radius = np.concatenate([graph.radius_mm for graph in found])
    return Graph.of_segments(ends, radius_mm=radius)


def write_3mf(graph: Graph, radius_mm: float) -> bytes:
    """Write one object with a beam lattice, beams in the order of printing, mm.

    Parameters
    ----------
    graph
        The struts.
    radius_mm
        Radius of those whose own is not told.
    """
    radii = graph.radius_mm if len(graph.radius_mm) else np.full(len(graph), radius_mm)
    shortest = float(np.linalg.norm(np.diff(graph.ends, axis=1), axis=2).min(initial=1.0))
    vertices = "".join(f'<vertex x="{x:.6g}" y="{y:.6g}" z="{z:.6g}"/>' for x, y, z in graph.nodes)
    beams = "".join(
        f'<b:beam v1="{a}" v2="{b}" r1="{r:.6g}"/>'
        for (a, b), r in zip(graph.edges.tolist(), radii, strict=True)
    )
    model = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<model unit="millimeter" xmlns="{CORE}" xmlns:b="{BEAM}" requiredextensions="b">'
        f'<resources><object id="1" type="model"><mesh><vertices>{vertices}</vertices><triangles/>'
        f'<b:beamlattice radius="{radius_mm:.6g}" minlength="{shortest / 2:.6g}" cap="sphere">'
        f"<b:beams>{beams}</b:beams></b:beamlattice></mesh></object></resources>"
        '<build><item objectid="1"/></build></model>'
    )
    types = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.'
        'relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.'
        '3dmanufacturing-3dmodel+xml"/></Types>'
    )
    relations = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
        f'<Relationship Id="r1" Type="{_RELATION}" Target="/3D/3dmodel.model"/></Relationships>'
    )
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in (
            ("[Content_Types].xml", types),
            ("_rels/.rels", relations),
            ("3D/3dmodel.model", model),
        ):
            # The same input, the same bytes: no time of today.
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), text)
    return buffer.getvalue()

"""Writes a mesh as a 3MF package, with parts of other kinds beside it; same input, same bytes."""

from __future__ import annotations

import io
import zipfile
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final
from xml.sax.saxutils import quoteattr

import numpy as np

from wireprint.text import one_line
from wireprint.threemf.scene import MODEL_TYPE, RELATIONSHIPS, USUAL_MODEL

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import numpy.typing as npt

    from wireprint._core import Mesh

#: Namespace of the core specification.
CORE: Final = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#: The earliest time that a zip archive can state.
_TIME = (1980, 1, 1, 0, 0, 0)
_DEFLATE_LEVEL = 6
#: Where PrusaSlicer keeps which facets are which part, and what the package calls that.
_PARTS: Final = "Metadata/Slic3r_PE_model.config"
_PARTS_KIND: Final = "https://github.com/prusa3d/PrusaSlicer/3mf-parts"
_XML = '<?xml version="1.0" encoding="UTF-8"?>\n'
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_MODEL_CONTENT = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"
_RELATIONSHIPS_CONTENT = "application/vnd.openxmlformats-package.relationships+xml"


@dataclass(frozen=True)
class Extra:
    """A part besides the model."""

    name: str
    #: Its MIME type.
    content_type: str
    #: Type of the relationship that the package has to it, a URI.
    relationship: str
    content: bytes


@dataclass(frozen=True)
class Body:
    """A body of an assembly."""

    name: str
    #: Corners, mm, shape (V, 3), and facets, counter-clockwise from outside, shape (F, 3).
    vertices: npt.NDArray[np.float64]
    faces: npt.NDArray[np.integer[Any]]


def assembly(bodies: Sequence[Body]) -> bytes:
    """Return a 3MF file of one object with a part for each body, each in its place.

    PrusaSlicer and its kin are told in their own form which facets are which part: what the core
    specification has for it, components, they take for objects of their own, and PrusaSlicer 2.5
    ends there. All others find the whole as one mesh.
    """
    starts = np.cumsum([0, *(len(body.vertices) for body in bodies)])
    vertices = np.concatenate([body.vertices for body in bodies])
    shifted = [body.faces + start for body, start in zip(bodies, starts, strict=False)]
    config = Extra(_PARTS, "text/xml", _PARTS_KIND, "".join(_parts(bodies)).encode())
    return _zipped("".join(_model(vertices, np.concatenate(shifted))), config)


def _parts(bodies: Sequence[Body]) -> Iterator[str]:
    yield f'{_XML}<config>\n<object id="1" instances_count="1">\n'
    first = 0
    for body in bodies:
        last = first + len(body.faces) - 1
        yield f'<volume firstid="{first}" lastid="{last}">\n'
        yield f'<metadata type="volume" key="name" value={quoteattr(one_line(body.name))}/>\n'
        yield '<metadata type="volume" key="volume_type" value="ModelPart"/>\n</volume>\n'
        first = last + 1
    yield "</object>\n</config>\n"


def package(mesh: Mesh, extra: Extra) -> bytes:
    """Return a 3MF file: a mesh in mm, and another part.

    Coordinates are written so that reading them gives the very same numbers.
    """
    return _zipped("".join(_model(mesh.vertices, mesh.faces)), extra)


def _zipped(model: str, extra: Extra) -> bytes:
    parts = {
        "[Content_Types].xml": _content_types(extra).encode(),
        RELATIONSHIPS: _relationships(extra).encode(),
        USUAL_MODEL: model.encode(),
        extra.name: extra.content,
    }
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in parts.items():
            info = zipfile.ZipInfo(name, _TIME)
            info.compress_type, info.create_system = zipfile.ZIP_DEFLATED, 0
            archive.writestr(info, content, compresslevel=_DEFLATE_LEVEL)
    return file.getvalue()


def _content_types(extra: Extra) -> str:
    return (
        f'{_XML}<Types xmlns="{_PACKAGE}/content-types">\n'
        f'<Default Extension="rels" ContentType="{_RELATIONSHIPS_CONTENT}"/>\n'
        f'<Default Extension="model" ContentType="{_MODEL_CONTENT}"/>\n'
        f'<Override PartName="/{extra.name}" ContentType="{extra.content_type}"/>\n'
        "</Types>\n"
    )


def _relationships(extra: Extra) -> str:
    return (
        f'{_XML}<Relationships xmlns="{_PACKAGE}/relationships">\n'
        f'<Relationship Id="model" Target="/{USUAL_MODEL}" Type="{MODEL_TYPE}"/>\n'
        f'<Relationship Id="extra" Target="/{extra.name}" Type="{extra.relationship}"/>\n'
        "</Relationships>\n"
    )


def _model(vertices: npt.NDArray[np.float64], faces: npt.NDArray[Any]) -> Iterator[str]:
    yield f'{_XML}<model unit="millimeter" xml:lang="en-US" xmlns="{CORE}">\n<resources>\n'
    yield '<object id="1" type="model">\n<mesh>\n<vertices>\n'
    for x, y, z in vertices.tolist():
        yield f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>\n'
    yield "</vertices>\n<triangles>\n"
    for a, b, c in faces.tolist():
        yield f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n'
    yield "</triangles>\n</mesh>\n</object>\n</resources>\n"
    yield '<build>\n<item objectid="1"/>\n</build>\n</model>\n'

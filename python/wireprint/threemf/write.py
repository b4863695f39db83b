"""Writes a mesh as a 3MF package, with parts of other kinds beside it; same input, same bytes."""

from __future__ import annotations

import io
import zipfile
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint.threemf.scene import MODEL_TYPE, RELATIONSHIPS, USUAL_MODEL

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint._core import Mesh

#: Namespace of the core specification.
CORE: Final = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#: The earliest time that a zip archive can state.
_TIME = (1980, 1, 1, 0, 0, 0)
_DEFLATE_LEVEL = 6
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


def package(mesh: Mesh, extra: Extra) -> bytes:
    """Return a 3MF file: a mesh in mm, and another part.

    Coordinates are written so that reading them gives the very same numbers.
    """
    parts = {
        "[Content_Types].xml": _content_types(extra).encode(),
        RELATIONSHIPS: _relationships(extra).encode(),
        USUAL_MODEL: "".join(_model(mesh)).encode(),
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


def _model(mesh: Mesh) -> Iterator[str]:
    yield f'{_XML}<model unit="millimeter" xml:lang="en-US" xmlns="{CORE}">\n<resources>\n'
    yield '<object id="1" type="model">\n<mesh>\n<vertices>\n'
    for x, y, z in mesh.vertices.tolist():
        yield f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>\n'
    yield "</vertices>\n<triangles>\n"
    for a, b, c in mesh.faces.tolist():
        yield f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n'
    yield "</triangles>\n</mesh>\n</object>\n</resources>\n"
    yield '<build>\n<item objectid="1"/>\n</build>\n</model>\n'

"""A model part of a 3MF file: its objects, what they are made of, and what shall be built."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from wireprint.threemf import xml

if TYPE_CHECKING:
    from wireprint.threemf.archive import Archive

#: Namespace of the core specification.
CORE: Final = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#: Millimetres per unit (3MF core specification 1.3, table 3-1 "unit").
UNITS_MM: Final = {
    "micron": 0.001,
    "millimeter": 1.0,
    "centimeter": 10.0,
    "inch": 25.4,
    "foot": 304.8,
    "meter": 1000.0,
}
#: Where a tag's painting stands: PrusaSlicer's attribute, and that of Bambu Studio and OrcaSlicer.
PAINT: Final = ("http://schemas.slic3r.org/3mf/2017/06 mmu_segmentation", "paint_color")
#: The production extension's reference to another part.
_PATH: Final = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path"
#: Namespace of triangle sets, 3MF core specification 1.3, chapter 4.3.
_SETS: Final = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"
_IDENTITY: Final = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Placed:
    """An object that is placed: by the build, or as a component of another one."""

    object_id: str
    #: Twelve numbers, row by row: (x, y, z, 1) · matrix is where a point goes.
    transform: tuple[float, ...]
    #: The part that has the object, if it is another one.
    path: str | None


@dataclass
class Object:
    """A mesh, or components."""

    #: Flat: x, y, z of each vertex.
    vertices: array[float] = field(default_factory=lambda: array("d"))
    #: Flat: three indices a triangle; unchecked.
    triangles: array[int] = field(default_factory=lambda: array("q"))
    #: Painting by the index of its triangle.
    paint: dict[int, str] = field(default_factory=dict)
    #: Ranges of triangles, first and last, by the names of triangle sets.
    sets: dict[str, list[tuple[int, int]]] = field(default_factory=dict)
    components: list[Placed] = field(default_factory=list)


@dataclass
class Part:
    """One model part."""

    unit_mm: float = 1.0
    objects: dict[str, Object] = field(default_factory=dict)
    items: list[Placed] = field(default_factory=list)


def read_part(archive: Archive, name: str) -> Part:
    """Read a model part.

    Raises
    ------
    ModelError
        There is no such part, or it is no model.
    """
    place = f"{archive.path}: {name.removeprefix('/')}"
    reader = _Reader()
    xml.parse(archive.chunks(name), place, reader.tables)
    return reader.part


class _Reader:
    """Fills a part, tag by tag."""

    def __init__(self) -> None:
        self.part = Part()
        self._object: Object | None = None
        self._set: list[tuple[int, int]] | None = None

    def tables(self, namespace: str) -> xml.Tables:
        """Tell what takes in which tag, given the namespace of the first one."""
        core: xml.Starts = {
            "vertex": self._vertex,
            "triangle": self._triangle,
            "component": self._component,
            "item": self._item,
            "object": self._begin_object,
            "model": self._model,
        }
        sets: xml.Starts = {
            "triangleset": self._begin_set,
            "ref": self._ref,
            "refrange": self._ref_range,
        }
        starts = {f"{namespace} {tag}".strip(): take for tag, take in core.items()}
        starts |= {f"{_SETS} {tag}": take for tag, take in sets.items()}
        ends: xml.Ends = {
            f"{namespace} object".strip(): self._end_object,
            f"{_SETS} triangleset": self._end_set,
        }
        return starts, ends

    def _model(self, attributes: xml.Attributes) -> None:
        unit = attributes.get("unit", "millimeter")
        if unit not in UNITS_MM:
            raise ValueError(f"unknown unit {unit!r}")
        self.part.unit_mm = UNITS_MM[unit]

    def _begin_object(self, attributes: xml.Attributes) -> None:
        name = attributes["id"]
        if name in self.part.objects:
            raise ValueError(f"another one has the id {name!r}")
        self._object = self.part.objects[name] = Object()

    def _end_object(self) -> None:
        self._object = None

    def _vertex(self, attributes: xml.Attributes) -> None:
        if self._object is not None:
            x, y, z = float(attributes["x"]), float(attributes["y"]), float(attributes["z"])
            self._object.vertices.extend((x, y, z))

    def _triangle(self, attributes: xml.Attributes) -> None:
        if self._object is None:
            return
        triangles = self._object.triangles
        if len(attributes) > 3:  # more than its corners
            for attribute in PAINT:
                if painting := attributes.get(attribute):
                    self._object.paint[len(triangles) // 3] = painting
        a, b, c = int(attributes["v1"]), int(attributes["v2"]), int(attributes["v3"])
        triangles.extend((a, b, c))

    def _component(self, attributes: xml.Attributes) -> None:
        if self._object is not None:
            self._object.components.append(_placed(attributes))

    def _item(self, attributes: xml.Attributes) -> None:
        self.part.items.append(_placed(attributes))

    def _begin_set(self, attributes: xml.Attributes) -> None:
        if self._object is not None:
            name = attributes.get("name") or attributes["identifier"]
            self._set = self._object.sets.setdefault(name, [])

    def _end_set(self) -> None:
        self._set = None

    def _ref(self, attributes: xml.Attributes) -> None:
        if self._set is not None:
            index = int(attributes["index"])
            self._set.append((index, index))

    def _ref_range(self, attributes: xml.Attributes) -> None:
        if self._set is not None:
            self._set.append((int(attributes["startindex"]), int(attributes["endindex"])))


def _placed(attributes: xml.Attributes) -> Placed:
    transform: tuple[float, ...] = _IDENTITY
    if text := attributes.get("transform"):
        transform = tuple(map(float, text.split()))
        if len(transform) != len(_IDENTITY):
            raise ValueError(f"a transform has {len(_IDENTITY)} numbers, not {len(transform)}")
    return Placed(attributes["objectid"], transform, attributes.get(_PATH))

"""A 3MF model part with beam lattices: read a piece at a time, and built.

Notes
-----
3MF Consortium, *Beam Lattice Extension*, version 1.2: ``beamlattice`` within a mesh, with the radii
of both ends of each beam. *Core Specification*, 1.3: objects are placed by components and items.
"""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final
from xml.parsers import expat

import numpy as np

from wireprint._core import ModelError
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    import numpy.typing as npt

CORE: Final = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
BEAM: Final = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"
_MM: Final = {
    "micron": 0.001,
    "millimeter": 1.0,
    "centimeter": 10.0,
    "inch": 25.4,
    "foot": 304.8,
    "meter": 1000.0,
}
#: Of all that is built: components may repeat an object, and so be more than the file is long.
_MOST_BEAMS: Final = 1_000_000
#: Components within components.
_DEEPEST: Final = 50
#: Between a namespace and a name.
_AFTER: Final = " "


@dataclass
class _Object:
    """A mesh with beams, or components."""

    places: array[float] = field(default_factory=lambda: array("d"))
    beams: array[int] = field(default_factory=lambda: array("q"))
    radii: array[float] = field(default_factory=lambda: array("d"))
    #: Radius of beams that tell none, in the part's unit.
    radius: float = 0.0
    components: list[tuple[str, npt.NDArray[np.float64]]] = field(default_factory=list)

    def graph(self, scale: float) -> Graph:
        """Return the beams, mm."""
        nodes = scale * np.array(self.places).reshape(-1, 3)
        return Graph(nodes, np.array(self.beams).reshape(-1, 2), scale * np.array(self.radii))


class BeamModel:
    """What a model part says of beams."""

    def __init__(self, chunks: Iterable[bytes]) -> None:
        """Read the part.

        Raises
        ------
        ModelError
            It is damaged.
        """
        self._unit_mm = 1.0
        self._objects: dict[str, _Object] = {}
        self._items: list[tuple[str, npt.NDArray[np.float64]]] = []
        self._object = _Object()
        parser = expat.ParserCreate(namespace_separator=_AFTER)
        parser.StartElementHandler = self._begin
        parser.StartDoctypeDeclHandler = _refuse_types
        try:
            for chunk in chunks:
                parser.Parse(chunk, False)
            parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise ModelError(f"damaged XML: {error}") from None
        except (KeyError, ValueError, OverflowError) as error:
            if isinstance(error, ModelError):
                raise
            msg = f"line {parser.CurrentLineNumber}: a damaged element: {error}"
            raise ModelError(msg) from None

    def _begin(self, name: str, given: Mapping[str, str]) -> None:
        space, _, name = name.rpartition(_AFTER)
        one = self._object
        if space == BEAM and name == "beam":
            one.beams.extend((int(given["v1"]), int(given["v2"])))
            one.radii.append(float(given.get("r1", one.radius)))
        elif space == BEAM and name == "beamlattice":
            one.radius = float(given.get("radius", 0.0))
        elif space != CORE:
            return
        elif name == "vertex":
            one.places.extend(float(given[axis]) for axis in "xyz")
        elif name == "model":
            self._unit_mm = _MM[given.get("unit", "millimeter")]
        elif name == "object":
            self._object = self._objects[given["id"]] = _Object()
        elif name in ("component", "item"):
            if any(key.endswith(f"{_AFTER}path") for key in given):
                raise ModelError("it builds objects of other parts, which are not read")
            placed = self._items if name == "item" else one.components
            placed.append((given["objectid"], _matrix(given)))

    def built(self) -> Iterator[Graph]:
        """Yield the lattices where they are built; all as they are where nothing is built.

        Raises
        ------
        ModelError
            An object is not there, holds itself, or there are too many beams.
        """
        items = self._items or [(name, np.eye(4)) for name in self._objects]
        sizes: dict[str, int] = {}
        if sum(self._size(name, sizes, 0) for name, _ in items) > _MOST_BEAMS:
            raise ModelError(f"objects are built too often: more than {_MOST_BEAMS} beams")
        todo = list(reversed(items))
        while todo:
            name, matrix = todo.pop()
            one = self._objects[name]
            if one.radii:
                yield _placed(one.graph(self._unit_mm), matrix, self._unit_mm)
            todo += [(inner, own @ matrix) for inner, own in reversed(one.components)]

    def _size(self, name: str, sizes: dict[str, int], depth: int) -> int:
        """Count the beams and the objects that one is built of, without building them."""
        if depth > _DEEPEST:
            raise ModelError(f"object {name!r} holds itself")
        if name not in self._objects:
            raise ModelError(f"object {name!r} is built, but not there")
        if name not in sizes:
            one = self._objects[name]
            inner = sum(self._size(part, sizes, depth + 1) for part, _ in one.components)
            sizes[name] = 1 + len(one.radii) + inner
        return sizes[name]


def _refuse_types(*_: object) -> None:
    raise ModelError("a document type in 3MF: it is not allowed there")


def _matrix(given: Mapping[str, str]) -> npt.NDArray[np.float64]:
    """Return the matrix of an item: (x, y, z, 1) · matrix is where a point goes."""
    matrix = np.eye(4)
    if "transform" in given:
        matrix[:, :3] = np.array(given["transform"].split(), np.float64).reshape(4, 3)
    return matrix


def _placed(graph: Graph, matrix: npt.NDArray[np.float64], unit_mm: float) -> Graph:
    with np.errstate(over="ignore", invalid="ignore"):
        nodes = graph.nodes @ matrix[:3, :3] + unit_mm * matrix[3, :3]
        factor = abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
    return Graph(nodes, graph.edges, factor * graph.radius_mm)

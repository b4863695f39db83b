"""A print or a model as one page that turns in a browser and loads nothing else."""

from __future__ import annotations

import base64
import html
import json
import math
from importlib import resources
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint.view_styles import Entry

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from wireprint._core import Mesh, Strands
    from wireprint.view_marks import Group
    from wireprint.view_styles import Rgb

#: Coordinates are sent as this many steps over the longest extent: 3 µm on 200 mm.
STEPS: Final = 65535
#: Diameters are sent as multiples of this, mm; a byte holds the thickest that is drawn.
DIAMETER_STEP_MM: Final = 0.012
#: The page knows this many kinds of strands; others are shown as the last one.
MOST_KINDS: Final = 64
GRID_MM: Final = 10.0
MOST_GRID_LINES: Final = 60


class Page:
    """The data of a page, and the page.

    Parameters
    ----------
    title
        Headline.
    size_text
        Size of the object.
    angles
        Azimuth and elevation that it is seen from first, degrees.
    """

    def __init__(self, title: str, size_text: str, angles: tuple[float, float]) -> None:
        self.title = title
        self.data: dict[str, Any] = {
            "title": title,
            "size": size_text,
            "camera": [round(math.radians(angle), 5) for angle in angles],
            "low": [0.0] * 3,
            "span": [1.0] * 3,
            "legend": [],
            "strands": "",
            "strand_count": 0,
            "diameter_step": DIAMETER_STEP_MM,
            "travels": "",
            "travel_after": "",
            "vertices": "",
            "faces": "",
            "face_count": 0,
            "groups": [],
            "grid": [],
            "marks": [],
            "weak": [],
        }

    def add_strands(
        self,
        strands: Strands,
        colours: Sequence[Rgb | None],
        entries: Sequence[Entry],
        travel: Entry | None,
    ) -> None:
        """Add the strands that have a colour, a line of the legend for each entry, and travels.

        Parameters
        ----------
        strands
            What is laid.
        colours
            Colour of each of their labels.
        entries
            Legend; strands belong to the entry of their label.
        travel
            Legend of the travels, which can be switched on; none leaves them out.
        """
        kinds = {entry.label: i for i, entry in enumerate(entries)}
        of_label = np.array([kinds.get(label, -1) for label in strands.labels], np.int64)
        of_label[[colour is None for colour in colours]] = -1
        kind = of_label[strands.features]
        shown = kind >= 0
        ends = strands.segments[shown]
        self._fit(ends.reshape(-1, 3))
        packed = np.zeros(len(ends), [("ends", "<u2", (2, 3)), ("style", "u1", 2), ("pad", "<u2")])
        packed["ends"] = self._quantised(ends)
        packed["style"][:, 0] = np.minimum(kind[shown], MOST_KINDS - 1)
        packed["style"][:, 1] = np.clip(strands.diameters[shown] / DIAMETER_STEP_MM, 1, 255)
        self.data["strands"] = _base64(packed)
        self.data["strand_count"] = len(ends)
        self.data["legend"] += [_legend(entry, kind=i) for i, entry in enumerate(entries)]
        if travel is not None:
            self._add_travels(strands, shown)
            self.data["legend"].append(_legend(travel, kind=None))

    def add_mesh(self, mesh: Mesh, colour: Rgb) -> None:
        """Add a model's triangles."""
        self._fit(mesh.vertices)
        self._add_faces(self._quantised(mesh.vertices), mesh.faces)
        self.data["groups"] = [_line(Entry("", "", colour)) | {"count": len(mesh.faces)}]

    def add_groups(self, groups: Sequence[Group]) -> None:
        """Add groups of triangles, a line of the legend for each."""
        corners = np.concatenate([group.corners.reshape(-1, 3) for group in groups])
        self._fit(corners)
        # Three times 16 bits as one number: rows are slow to compare.
        x, y, z = self._quantised(corners).astype(np.uint64).T
        packed, faces = np.unique(x << 32 | y << 16 | z, return_inverse=True)
        vertices = np.stack([packed >> 32, packed >> 16, packed], axis=1).astype("<u2")
        self._add_faces(vertices, faces.reshape(-1, 3))
        self.data["groups"] = [
            _line(group.entry) | {"count": len(group.corners)} for group in groups
        ]

    def _add_faces(
        self, vertices: npt.NDArray[np.uint16], faces: npt.NDArray[np.integer[Any]]
    ) -> None:
        # WebGL wants attributes at multiples of four bytes.
        self.data["vertices"] = _base64(np.pad(vertices, ((0, 0), (0, 1))))
        self.data["faces"] = _base64(np.asarray(faces, "<u4"))
        self.data["face_count"] = len(faces)

    def add_marks(self, points: Sequence[tuple[float, float, float]]) -> None:
        """Add points that are marked in red and that nothing hides."""
        self.data["marks"] = [round(value, 3) for point in points for value in point]

    def add_weak(self, points: Sequence[tuple[float, float, float]]) -> None:
        """Add points that are marked as weak, likewise."""
        self.data["weak"] = [round(value, 3) for point in points for value in point]

    def text(self) -> str:
        """Return the page."""
        template = resources.files("wireprint").joinpath("view.html").read_text(encoding="utf-8")
        # In the element that holds the data, some words that begin with "<" would be obeyed.
        data = json.dumps(self.data, separators=(",", ":")).replace("<", "\\u003c")
        head, tail = template.split("$DATA")
        return head.replace("$TITLE", html.escape(self.title)) + data + tail

    def _fit(self, points: npt.NDArray[np.float64]) -> None:
        """Let coordinates and the bed span what is shown."""
        if not len(points):
            return
        low, high = points.min(axis=0), points.max(axis=0)
        self.data["low"] = low.tolist()
        self.data["span"] = np.maximum(high - low, 1e-6).tolist()
        self.data["grid"] = _grid(low, high)

    def _quantised(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.uint16]:
        share = (points - self.data["low"]) / self.data["span"]
        steps: npt.NDArray[np.uint16] = np.rint(np.clip(share, 0.0, 1.0) * STEPS).astype("<u2")
        return steps

    def _add_travels(self, strands: Strands, shown: npt.NDArray[np.bool_]) -> None:
        """Add the travels, each with the number of shown strands that come before it."""
        before = np.concatenate([[0], np.cumsum(shown)])
        self.data["travels"] = _base64(strands.travels.astype("<f4"))
        self.data["travel_after"] = _base64(before[strands.travel_after].astype("<u4"))


def _grid(low: npt.NDArray[np.float64], high: npt.NDArray[np.float64]) -> list[float]:
    """Lines on the bed, ten millimetres apart, or a power of ten of that for what is large."""
    coarser = np.log10(max((high - low)[:2].max() / GRID_MM / MOST_GRID_LINES, 1e-9))
    step = GRID_MM * 10.0 ** max(0.0, np.ceil(coarser))
    first = np.floor(low[:2] / step - 0.4) * step
    last = np.ceil(high[:2] / step + 0.4) * step
    xs, ys = (np.arange(a, b + step / 2, step) for a, b in zip(first, last, strict=True))
    across = [[[x, first[1], 0.0], [x, last[1], 0.0]] for x in xs]
    along = [[[first[0], y, 0.0], [last[0], y, 0.0]] for y in ys]
    grid: list[float] = np.ravel(across + along).tolist()
    return grid


def _line(entry: Entry) -> dict[str, Any]:
    """Return a line of the legend."""
    return {
        "name": entry.name,
        "colour": _unit(entry.colour),
        "amount": entry.amount,
        "on": True,
    }


def _legend(entry: Entry, kind: int | None) -> dict[str, Any]:
    """Return a line for strands of a kind, or for travels, which are not shown at first."""
    return _line(entry) | {"kind": kind, "travel": kind is None, "on": kind is not None}


def _unit(colour: Rgb) -> list[float]:
    return [round(channel / 255, 4) for channel in colour]


def _base64(array: npt.NDArray[Any]) -> str:
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")

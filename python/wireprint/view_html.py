"""A print or a model as one page that turns in a browser and loads nothing else.

The page is the window's own (`web/`), told by its file what a session would tell.
"""

from __future__ import annotations

import base64
import hashlib
import html
import re
import zlib
from importlib import resources
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import __version__
from wireprint.view_replay import Replay, replay, told_of, untimed
from wireprint.view_texels import DIAMETER_STEP_MM, MOST_KINDS, box_of, heights_of, packed
from wireprint.window.answer import encoded

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy.typing as npt

    from wireprint._core import Mesh, Strands
    from wireprint.view_marks import Group
    from wireprint.view_styles import Entry, Rgb

    Floats = npt.NDArray[np.float64]
    Points = Sequence[tuple[float, float, float]]

#: A bed that nobody told is so much larger than what stands on it, mm, and goes by so much.
_BED_STEP_MM: Final = 10.0


class Page:
    """What a page is told, and the page.

    Parameters
    ----------
    title
        Headline.
    size_mm
        Size of the object.
    angles
        Azimuth and elevation that it is seen from first, degrees.
    still
        PNG that is shown until it turns, and where it cannot.
    """

    def __init__(
        self, title: str, size_mm: Sequence[float], angles: tuple[float, float], still: bytes
    ) -> None:
        self._title, self._size_mm, self._still = title, list(size_mm), still
        #: Middle of the bed, to which everything is told: mm.
        self._centre = np.zeros(3)
        self._breaches: Points = ()
        self._called = ""
        self._weak: Points = ()
        self._words = ""
        self._told: list[bytes] = []
        self._tell(
            "welcome",
            name=title,
            version=__version__,
            camera=angles,
            size_mm=self._size_mm,
            printers=[],
            materials=[],
        )

    def add_marks(self, points: Points, called: str = "breach") -> None:
        """Mark points in red, which nothing hides; before anything is shown."""
        self._breaches, self._called = points, called

    def add_weak(self, points: Points) -> None:
        """Mark points as weak, likewise."""
        self._weak = points

    def add_words(self, title: str, sections: Mapping[str, Sequence[str]]) -> None:
        """Say something below what is shown, once it is opened.

        Parameters
        ----------
        title
            What is said while it is closed.
        sections
            Sentences by their headings.
        """
        told = [f"<summary>{html.escape(title)}</summary>"]
        for heading, sentences in sections.items():
            listed = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in sentences)
            told.append(f"<h2>{html.escape(heading)}</h2><ul>{listed}</ul>")
        self._words = f'<details id="words">{"".join(told)}</details>'

    def add_strands(
        self,
        strands: Strands,
        colours: Sequence[Rgb | None],
        entries: Sequence[Entry],
        *,
        travels: bool,
        gcode: bytes | None,
        coloured_by: str = "feature",
    ) -> None:
        """Show the strands that have a colour.

        Parameters
        ----------
        strands
            What is laid.
        colours
            Colour of each of their labels.
        entries
            Legend; strands belong to the entry of their label.
        travels
            Whether ways without extrusion can be switched on.
        gcode
            The text that they are of, if there is one: it tells times, layers and the printer.
        coloured_by
            What the legend's entries tell apart.
        """
        kinds = {entry.label: i for i, entry in enumerate(entries)}
        of_label = np.array([kinds.get(label, -1) for label in strands.labels], np.int64)
        of_label[[colour is None for colour in colours]] = -1
        kind = of_label[strands.features]
        shown = kind >= 0
        lines = strands.lines
        known = untimed(len(strands)) if gcode is None or lines is None else replay(gcode, lines)
        ends = strands.segments
        self._set_bed(known, ends[shown].reshape(-1, 3))
        self._tell_print(strands, known, shown, kind, entries, travels, coloured_by)

    def add_mesh(self, mesh: Mesh) -> None:
        """Show a model."""
        self._tell_model(mesh, [], np.zeros((0, 3, 3)))

    def add_groups(self, mesh: Mesh, groups: Sequence[Group]) -> None:
        """Show a model with what is marked on it, which is the last of its groups."""
        self._tell_model(mesh, [group.entry for group in groups], groups[-1].corners)

    def text(self) -> str:
        """Return the page."""
        return _page(self._title, self._still, self._words, b"".join(map(_counted, self._told)))

    def _tell(self, event: str, arrays: dict[str, Any] | None = None, **head: Any) -> None:
        self._told.append(encoded({"event": event, **head}, arrays))

    def _set_bed(self, known: Replay | None, points: Floats) -> None:
        """Tell the printer's bed, or one that fits, and put its middle in the middle."""
        if known is not None and known.settings is not None:
            about = told_of(known.settings)
            self._centre[:2] = known.settings.printer.bed.centre_mm
        else:
            size_mm, self._centre[:2] = _fitting_bed(points)
            about = {"bed": {"round": False, "size_mm": size_mm, "high": 0.0}, "head": None}
        printer = known.settings.printer.name if known and known.settings else ""
        # Nothing can be changed: there are no marks, and no settings.
        nothing: dict[str, Any] = {
            "items": [],
            "can_undo": False,
            "can_redo": False,
            "settings": {},
            "automatic": {},
            "differs": {},
            "material": "",
        }
        self._tell("state", revision=0, printer=printer, **nothing, **about)
        self._tell("current", revision=0)

    def _tell_print(
        self,
        strands: Strands,
        known: Replay,
        shown: npt.NDArray[np.bool_],
        kind: npt.NDArray[np.int64],
        entries: Sequence[Entry],
        travels: bool,
        coloured_by: str,
    ) -> None:
        ends = strands.segments[shown] - self._centre
        low, span = box_of(ends) if len(ends) else (np.zeros(3), np.ones(3))
        slabs, kinds = known.slabs[shown], np.minimum(kind[shown], MOST_KINDS - 1)
        begin_s, end_s = known.begin_s[shown], known.end_s[shown]
        laid_s = np.maximum(end_s - begin_s, 1e-6)
        arrays = {
            "strands": packed(ends, low, span, kinds, strands.diameters[shown], slabs),
            "when": np.stack([begin_s, end_s], axis=1).astype("<f4"),
            "speed": (np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / laid_s).astype("<f4"),
        }
        if travels:
            before = np.concatenate([[0], np.cumsum(shown)])
            arrays["travels"] = (strands.travels - self._centre).astype("<f4")
            arrays["after"] = before[strands.travel_after].astype("<u4")
        self._tell(
            "print",
            arrays,
            figures=known.figures,
            regions=None,
            refused="",
            made_s=None,
            labels=[_label(entry) for entry in entries],
            coloured_by=coloured_by,
            low=low.tolist(),
            span=span.tolist(),
            diameter_step_mm=DIAMETER_STEP_MM,
            slabs_mm=heights_of(ends, slabs) if len(ends) else [0.0],
            motion=np.eye(4).tolist(),
            breaches=[
                {"rule": self._called, "words": _place(place), "at_mm": self._moved(place)}
                for place in self._breaches
            ],
            weak=[self._moved(place) for place in self._weak],
            total_s=known.total_s,
            timed=known.timed,
        )

    def _tell_model(self, mesh: Mesh, entries: Sequence[Entry], painted: Floats) -> None:
        self._set_bed(None, mesh.vertices)
        shares = [{"name": entry.name, "amount": entry.amount} for entry in entries]
        vertices = (mesh.vertices - self._centre).astype("<f4")
        self._tell(
            "model",
            {"vertices": vertices, "faces": mesh.faces.astype("<u4")},
            name=self._title,
            size_mm=self._size_mm,
            repaired=[],
            warnings=[],
            shares=shares,
        )
        self._tell("paint", {"corners": (painted - self._centre).astype("<f4")})

    def _moved(self, place: tuple[float, float, float]) -> list[float]:
        moved: list[float] = (np.array(place) - self._centre).round(3).tolist()
        return moved


def _fitting_bed(points: Floats) -> tuple[list[float], list[float]]:
    """Return size and middle of a bed for what stands there, mm."""
    if not len(points):
        return [_BED_STEP_MM] * 2, [0.0, 0.0]
    low, high = points.min(axis=0)[:2], points.max(axis=0)[:2]
    step = _BED_STEP_MM
    while (high - low).max() > 1000 * step:
        step *= 10
    first, last = np.floor(low / step - 0.4) * step, np.ceil(high / step + 0.4) * step
    return (last - first).tolist(), ((first + last) / 2).tolist()


def _label(entry: Entry) -> dict[str, Any]:
    return {
        "label": entry.label,
        "name": entry.name,
        "colour": entry.colour,
        "length_mm": entry.length_mm or 0.0,
    }


def _place(place: tuple[float, float, float]) -> str:
    return ", ".join(f"{value:.1f}" for value in place) + " mm"


def _counted(told: bytes) -> bytes:
    return len(told).to_bytes(4, "little") + told


def _page(title: str, still: bytes, words: str, told: bytes) -> str:
    """Return the page's text: the program and what it is told, deflated, and a policy of hashes."""
    static = resources.files("wireprint.window").joinpath("static")
    program = static.joinpath("studio.js").read_bytes()
    template = resources.files("wireprint").joinpath("view.html").read_text(encoding="utf-8")
    loader = _between(template, "script type=module")
    style = _between(template, "style")
    policy = (
        f"default-src 'none'; script-src {_hash(loader.encode())} {_hash(program)}; "
        f"style-src {_hash(style.encode())}; img-src data: blob:; "
        "base-uri 'none'; form-action 'none'"
    )
    # Text of others comes last, so that what stands in it is put in for nothing.
    parts = {
        "POLICY": policy,
        "LICENCES": static.joinpath("licences.txt").read_text(encoding="utf-8"),
        "STILL": base64.b64encode(still).decode("ascii"),
        "PROGRAM": _deflated(program),
        "DATA": _deflated(told),
        "TITLE": html.escape(title),
        "WORDS": words,
    }
    return re.sub(r"\$([A-Z]+)\b", lambda found: parts[found[1]], template)


def _between(template: str, tag: str) -> str:
    """Return what stands in the one element of a tag."""
    begin = template.index(f"<{tag}>") + len(tag) + 2
    return template[begin : template.index(f"</{tag.split()[0]}>", begin)]


def _hash(content: bytes) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(content).digest()).decode('ascii')}'"


def _deflated(content: bytes) -> str:
    return base64.b64encode(zlib.compress(content, 9)).decode("ascii")

"""From a region to runs of zigzag sections: which stretch of which contour is layers."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from wireprint._core import nearest
from wireprint.records import Record, sealed

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from collections.abc import Set as AbstractSet

    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Turning by half a circle counts as this distance, mm, where points of one layer are matched with
#: those of another: the two sides of a thin wall must not be taken for each other.
_TURN_MM = 10.0
#: A section is layers where this share of its area is covered.
_HALF = 0.5


@dataclass(frozen=True)
class Section:
    """A run of zigzag sections: a stretch of the contour that ends a slab."""

    slab: int
    #: Strip of the slab.
    strip: int
    #: Contour in the slice at the slab's top, as in ``Wireframe.contours_below``; −1: a strip that
    #: has none there.
    contour: int
    #: From where to where along the contour, mm; it may run on past its first point.
    from_mm: float
    to_mm: float
    #: Whether its strip is layers through and through.
    whole: bool
    #: Area of its surface, mm².
    area_mm2: float
    #: A point in its middle, mm.
    place_mm: tuple[float, float, float]

    @property
    def length_mm(self) -> float:
        """Length along the contour, mm."""
        return self.to_mm - self.from_mm


@dataclass(frozen=True, repr=False)
class Runs(Record):
    """What a region comes to on the layers of a model."""

    runs: tuple[Section, ...]
    #: Runs that are not to be had, and why.
    dropped: tuple[tuple[Section, str], ...]
    #: Number of the run that each sample belongs to, −1 for none, shape (S,).
    of_sample: Ints

    def without(self, numbers: Mapping[int, str]) -> Runs:
        """Return the runs without those of some numbers, which are dropped for a reason each."""
        kept = [number for number in range(len(self.runs)) if number not in numbers]
        renumbered = np.full(len(self.runs) + 1, -1)
        renumbered[kept] = np.arange(len(kept))
        dropped = [(self.runs[number], numbers[number]) for number in sorted(numbers)]
        return Runs(
            tuple(self.runs[number] for number in kept),
            (*self.dropped, *dropped),
            renumbered[self.of_sample],
        )


@dataclass(frozen=True, repr=False)
class Strips(Record):
    """The samples of all layers, by the strip of the slab that they lie on."""

    cut: Cut
    samples: Samples
    #: Slab and strip of what begins in the air.
    born: AbstractSet[tuple[int, int]]
    #: Runs shorter than this are dropped, mm.
    least_mm: float
    #: For each slab, mm: gaps between runs shorter than this have no room for a zigzag and join
    #: them.
    gap_mm: Floats
    #: Slab × count + strip of each sample, −1 for none, and the samples in that order.
    key: Ints
    order: Ints
    count: int
    #: Whether each sample lies at the top of its slab.
    is_top: Bools
    #: Of strips that were asked for: the section of each of their samples; see `nearest`.
    known: dict[int, Ints] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        cut: Cut,
        samples: Samples,
        born: AbstractSet[tuple[int, int]],
        least_mm: float,
        gap_mm: Floats,
    ) -> Strips:
        """Sort samples by their strips."""
        layer = cut.layer[samples.contour]
        slab, strip = cut.slab[layer], cut.strip[samples.contour]
        count = int(strip.max(initial=0)) + 1
        key = np.where(strip < 0, -1, slab * count + strip)
        order = np.argsort(key, kind="stable")
        is_top = cut.is_last()[layer]
        return cls(cut, samples, born, least_mm, gap_mm, key, order, count, is_top)

    def touched(self, covered: Bools) -> Iterator[tuple[int, int, Ints]]:
        """Give the slab, the strip and the samples of each strip that is covered somewhere."""
        touched = np.unique(self.key[covered])
        touched = touched[touched >= 0]
        keys = self.key[self.order]
        begins, ends = (np.searchsorted(keys, touched, side) for side in ("left", "right"))
        for value, begin, end in zip(touched.tolist(), begins, ends, strict=True):
            yield *divmod(value, self.count), self.order[begin:end]

    def nearest(self, slab: int, strip: int, which: Ints, sections: Ints) -> Ints:
        """Return, for each sample of a strip, the number of the section that it belongs to."""
        place = slab * self.count + strip
        if place not in self.known:
            self.known[place] = sealed(self._nearest(which, sections))
        return self.known[place]

    def _nearest(self, which: Ints, sections: Ints) -> Ints:
        middle, normal = self.samples.middle, self.samples.normal

        def features(which: Ints) -> Floats:
            return np.hstack([middle[which, :2], _TURN_MM / 2 * normal[which, :2]])

        found = nearest(features(which), features(sections)).astype(np.int64)
        # A section's own sample is its own, whatever else is as near.
        found[np.searchsorted(which, sections)] = np.arange(len(sections))
        return found


def runs_of(strips: Strips, covered: Bools) -> Runs:
    """Turn what is covered of the surface into runs.

    Parameters
    ----------
    strips
        The model's samples.
    covered
        Which of them the region covers, shape (S,).

    Notes
    -----
    A section is a piece of the contour at a slab's top, no longer than half a strand, with all
    of the slab's surface that it is nearest to. It is layers where half of its area, or more, is
    covered.
    """
    finder = _Finder(strips, covered)
    for slab, strip, which in strips.touched(covered):
        if (slab, strip) in strips.born:
            finder.drop_born(slab, strip, which)
        else:
            finder.add(slab, strip, which)
    return Runs(tuple(finder.runs), tuple(finder.dropped), finder.of_sample)


class _Finder:
    """Goes through the strips that a region touches."""

    def __init__(self, strips: Strips, covered: Bools) -> None:
        self.strips, self.covered = strips, covered
        self.cut, self.samples = strips.cut, strips.samples
        self.least_mm, self.gap_mm = strips.least_mm, strips.gap_mm
        self.runs: list[Section] = []
        self.dropped: list[tuple[Section, str]] = []
        self.of_sample: Ints = np.full(len(covered), -1)

    def drop_born(self, slab: int, strip: int, which: Ints) -> None:
        """Note a strip that begins in the air: its layers would."""
        if self._share(which) >= _HALF:
            self.dropped.append((self._whole(slab, strip, -1, which), "mid_air"))

    def add(self, slab: int, strip: int, which: Ints) -> None:
        """Add the runs of a strip."""
        sections = which[self.strips.is_top[which]]
        if not len(sections):
            if self._share(which) >= _HALF:
                self._add_whole(slab, strip, [], which)
            return
        if self.covered[which].all():
            contours = np.unique(self.samples.contour[sections]).tolist()
            self._add_whole(slab, strip, contours, which)
            return
        nearest = self.strips.nearest(slab, strip, which, sections)
        area = np.bincount(nearest, self.samples.area[which], len(sections))
        covered = np.bincount(
            nearest, self.samples.area[which] * self.covered[which], len(sections)
        )
        painted = covered >= _HALF * area
        contour = self.samples.contour[sections]
        contours = np.unique(contour).tolist()
        stretches: list[tuple[int, Ints]] = []
        for number in contours:
            own = np.flatnonzero(contour == number)
            self._drop_short(painted, slab, strip, number, own, sections)
            self._close_gaps(painted, sections, own, number, self.gap_mm[slab])
            stretches += [(number, run) for run in self._stretches(painted, own, number)]
        if painted.all():
            self._add_whole(slab, strip, contours, which)
            return
        run_of_section = np.full(len(sections), -1)
        for number, run in stretches:
            inside = np.isin(nearest, run)
            section = self._partial(slab, strip, number, sections[run], which[inside])
            run_of_section[run] = len(self.runs)
            self.runs.append(section)
        self.of_sample[which] = run_of_section[nearest]

    def _share(self, which: Ints) -> float:
        area = self.samples.area[which]
        return float(np.sum(area * self.covered[which]) / max(np.sum(area), 1e-12))

    def _drop_short(
        self, painted: Bools, slab: int, strip: int, contour: int, own: Ints, sections: Ints
    ) -> None:
        """Wipe runs that are too short to print, once gaps as short are closed."""
        self._close_gaps(painted, sections, own, contour, self.least_mm)
        for run in self._stretches(painted, own, contour):
            if len(run) < len(own) and self._length(sections[run]) < self.least_mm:
                section = self._partial(slab, strip, contour, sections[run], sections[run])
                self.dropped.append((section, "short_run"))
                painted[run] = False

    def _close_gaps(
        self, painted: Bools, sections: Ints, own: Ints, contour: int, longest_mm: float
    ) -> None:
        for gap in self._stretches(~painted, own, contour):
            if len(gap) < len(own) and self._length(sections[gap]) < longest_mm:
                painted[gap] = True

    def _length(self, which: Ints) -> float:
        return float(np.sum(self.samples.end[which] - self.samples.begin[which]))

    def _stretches(self, mask: Bools, own: Ints, contour: int) -> list[Ints]:
        """Return the runs of true values among a contour's sections, around its first point too."""
        inside = mask[own]
        cuts = np.flatnonzero(inside[1:] != inside[:-1]) + 1
        parts = [part for part in np.split(own, cuts) if mask[part[0]]]
        around = inside[0] and inside[-1] and len(parts) > 1 and self.cut.closed[contour]
        if around:
            parts = [*parts[1:-1], np.concatenate([parts[-1], parts[0]])]
        return parts

    def _add_whole(self, slab: int, strip: int, contours: list[int], which: Ints) -> None:
        self.of_sample[which] = len(self.runs)
        first = contours[0] if len(contours) == 1 else -1
        self.runs.append(self._whole(slab, strip, first, which))

    def _whole(self, slab: int, strip: int, contour: int, which: Ints) -> Section:
        area, samples = self.samples.area[which], self.samples
        own = samples.contour == contour
        length = self._length(np.flatnonzero(own))
        heaviest = which[len(which) // 2]
        return Section(
            slab,
            strip,
            self._in_slice(contour),
            0.0,
            length,
            True,
            float(np.sum(area)),
            _point(samples.middle[heaviest]),
        )

    def _partial(self, slab: int, strip: int, contour: int, run: Ints, which: Ints) -> Section:
        samples = self.samples
        begin = float(samples.begin[run[0]])
        length = self._length(run)
        return Section(
            slab,
            strip,
            self._in_slice(contour),
            begin,
            begin + length,
            False,
            float(np.sum(samples.area[which])),
            _point(samples.middle[run[len(run) // 2]]),
        )

    def _in_slice(self, contour: int) -> int:
        if contour < 0:
            return -1
        return int(contour - self.cut.slice_offsets[self.cut.layer[contour]])


def _point(row: Floats) -> tuple[float, float, float]:
    x, y, z = row.tolist()
    return x, y, z

"""What is painted in a 3MF file, as a region in the file's own frame and unit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from wireprint._core import MOST_DIGITS, ModelError
from wireprint.regions.mask import Mask
from wireprint.regions.region import Region
from wireprint.threemf.instance import joined
from wireprint.threemf.roles import Role

if TYPE_CHECKING:
    from collections.abc import Collection
    from typing import TypeAlias

    import numpy.typing as npt

    from wireprint.threemf.instance import Instance
    from wireprint.threemf.scene import Scene

    _Flags: TypeAlias = npt.NDArray[np.bool_]


def painted(scene: Scene, states: Collection[int] = (), sets: Collection[str] = ()) -> Region:
    """Return what is painted in a scene.

    Parameters
    ----------
    scene
        What a 3MF file places.
    states
        Numbers of extruders whose paint counts; none: that of all.
    sets
        Names of triangle sets that count as painted, too.

    Raises
    ------
    ModelError
        There is no set of such a name, a set has triangles that its object lacks, or a painting is
        damaged.
    """
    digits = sum(instance.mesh.painting.digits for instance in scene.instances)
    if digits > MOST_DIGITS:
        raise ModelError(f"it is painted in {digits} digits (at most {MOST_DIGITS})")
    known = scene.set_names
    for name in sets:
        if name not in known:
            there = f"it has {', '.join(map(repr, known))}" if known else "it has none"
            raise ModelError(f"there is no triangle set {name!r}; {there}")
    if not sets and not digits:
        return Region()
    mask = _Mask(states, sets)
    for instance in scene.instances:
        mask.take(instance)
    return mask.region()


class _Mask:
    """Gathers the triangles of a scene, split ones replaced by what they are split into."""

    def __init__(self, states: Collection[int], sets: Collection[str]) -> None:
        self._states = np.array(sorted(states), np.uint8)
        self._sets = sets
        self._count = 0
        self._vertices: list[npt.NDArray[np.float64]] = []
        self._faces: list[npt.NDArray[np.uint32]] = []
        self._marked: list[_Flags] = []

    def region(self) -> Region:
        """Return what was gathered."""
        marked = joined(self._marked)
        if not marked.any():
            return Region()
        vertices, faces = joined(self._vertices), joined(self._faces)
        self._vertices, self._faces = [], []
        for array in (vertices, faces, marked):
            array.setflags(write=False)
        return Region().add(Mask(vertices=vertices, faces=faces, marked=marked))

    def take(self, instance: Instance) -> None:
        """Gather one instance's triangles; those of negative parts count as not painted."""
        faces, vertices, marked = instance.mesh.faces, instance.vertices, self._in_sets(instance)
        whole, whole_states, owners, corners, states = instance.mesh.painting.leaves(
            vertices, faces
        )
        printed, cut = instance.of_role(Role.PART), instance.of_role(Role.NEGATIVE)
        marked[whole] |= self._counts(whole_states)
        marked &= printed
        unsplit = printed | cut
        unsplit[owners] = False
        self._add(vertices, faces[unsplit], marked[unsplit])
        kept = (printed | cut)[owners]
        owners, states = owners[kept], states[kept]
        split = np.flatnonzero(np.repeat(kept, 3)).astype(np.uint32).reshape(-1, 3)
        if len(owners):
            self._add(corners, split, marked[owners] | self._counts(states) & printed[owners])

    def _add(
        self, vertices: npt.NDArray[np.float64], faces: npt.NDArray[np.uint32], marked: _Flags
    ) -> None:
        self._vertices.append(vertices)
        self._faces.append(faces + np.uint32(self._count) if self._count else faces)
        self._marked.append(marked)
        self._count += len(vertices)

    def _counts(self, states: npt.NDArray[np.uint8]) -> _Flags:
        """Tell which states mark a triangle."""
        return np.isin(states, self._states) if len(self._states) else states > 0

    def _in_sets(self, instance: Instance) -> _Flags:
        """Tell which triangles are in one of the sets."""
        count = len(instance.mesh.faces)
        # Where ranges begin and end: inside are those where more have begun than have ended.
        steps = np.zeros(count + 1, np.int64)
        for name in self._sets:
            ranges = instance.mesh.sets.get(name)
            if ranges is None:
                continue
            first, last = ranges.T
            wrong = np.flatnonzero((first > last) | (last >= count))
            if len(wrong):
                raise ModelError(
                    f"triangle set {name!r} names triangles {first[wrong[0]]} to {last[wrong[0]]}, "
                    f"but its object has {count}"
                )
            np.add.at(steps, first, 1)
            np.add.at(steps, last + 1, -1)
        return np.cumsum(steps[:-1]) > 0

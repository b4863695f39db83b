"""What is painted in a 3MF file, as a region in the file's own frame and unit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.regions.mask import Mask
from wireprint.regions.region import Region
from wireprint.threemf.paint import decoded

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator
    from typing import TypeAlias

    import numpy.typing as npt

    from wireprint.threemf.scene import Instance, Scene

    #: Weights of the corners of each leaf, and whether it is marked.
    _Leaves: TypeAlias = tuple[npt.NDArray[np.float64], npt.NDArray[np.bool_]]

#: Most digits of all paintings of a file, and so most triangles that they split into.
MOST_DIGITS: Final = 1 << 21


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
    digits = sum(len(text) for mesh in scene.instances for text in mesh.mesh.paint.values())
    if digits > MOST_DIGITS:
        raise ModelError(f"it is painted in {digits} digits (at most {MOST_DIGITS})")
    known = set_names(scene)
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


def set_names(scene: Scene) -> list[str]:
    """Names of all triangle sets, each once, in the order of the file."""
    return list(dict.fromkeys(name for mesh in scene.instances for name in mesh.mesh.sets))


class _Mask:
    """Gathers the triangles of a scene, split ones replaced by what they are split into."""

    def __init__(self, states: Collection[int], sets: Collection[str]) -> None:
        self._states = np.array(sorted(states), np.uint8)
        self._sets = sets
        self._count = 0
        self._vertices: list[npt.NDArray[np.float64]] = []
        self._faces: list[npt.NDArray[np.int64]] = []
        self._marked: list[npt.NDArray[np.bool_]] = []

    def region(self) -> Region:
        """Return what was gathered."""
        marked = np.concatenate(self._marked)
        if not marked.any():
            return Region()
        vertices = np.concatenate(self._vertices)
        faces = np.concatenate(self._faces).astype(np.uint32)
        return Region().add(Mask(vertices=vertices, faces=faces, marked=marked))

    def take(self, instance: Instance) -> None:
        """Gather one instance's triangles."""
        faces, vertices = instance.faces, instance.vertices
        marked, whole = self._in_sets(instance), np.ones(len(faces), np.bool_)
        leaves, leaves_marked = [], []
        for index, (weights, found) in self._painted(instance):
            if len(found) == 1:
                marked[index] |= found[0]
            else:
                whole[index] = False
                leaves.append((weights @ vertices[faces[index]]).reshape(-1, 3))
                leaves_marked.append(found | marked[index])
        self._add(vertices, faces[whole], marked[whole])
        if leaves:
            corners = np.concatenate(leaves)
            split = np.arange(len(corners)).reshape(-1, 3)
            self._add(corners, split, np.concatenate(leaves_marked))

    def _add(
        self,
        vertices: npt.NDArray[np.float64],
        faces: npt.NDArray[np.int64],
        marked: npt.NDArray[np.bool_],
    ) -> None:
        self._vertices.append(vertices)
        self._faces.append(faces + self._count)
        self._marked.append(marked)
        self._count += len(vertices)

    def _in_sets(self, instance: Instance) -> npt.NDArray[np.bool_]:
        """Tell which triangles are in one of the sets."""
        inside = np.zeros(len(instance.faces), np.bool_)
        for name in self._sets:
            for first, last in instance.mesh.sets.get(name, ()):
                if not 0 <= first <= last < len(inside):
                    raise ModelError(
                        f"triangle set {name!r} names triangles {first} to {last}, "
                        f"but its object has {len(inside)}"
                    )
                inside[first : last + 1] = True
        return inside

    def _painted(self, instance: Instance) -> Iterator[tuple[int, _Leaves]]:
        """Yield each painted triangle: its index, and weights and whether to mark of its leaves."""
        for index, text in instance.mesh.paint.items():
            try:
                weights, states = decoded(text)
            except ValueError as error:
                raise ModelError(f"the painting of triangle {index}: {error}") from error
            hit = np.isin(states, self._states) if len(self._states) else states > 0
            yield index, (weights, hit)

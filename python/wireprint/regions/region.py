"""A region: marks in order, each of which adds or erases; the last one that covers a point wins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from wireprint._core import SettingError

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.regions.shapes import Shape

#: Rows of an affine map: placed = (x, y, z, 1) · rows. Tuples, so that marks are immutable.
Affine: TypeAlias = tuple[
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
]
#: Most that a map may stretch or shrink; anything beyond is a mistake.
_MOST_STRETCH = 1e9


@dataclass(frozen=True)
class Mark:
    """One shape that adds to a region, or erases from it."""

    shape: Shape
    erase: bool = False
    #: Rows of the map from the shape's own frame to the model's; None: they are the same.
    frame: Affine | None = None

    def covers(
        self, points: npt.NDArray[np.float64], normals: npt.NDArray[np.float64]
    ) -> npt.NDArray[np.bool_]:
        """Tell which points the shape covers.

        Parameters
        ----------
        points, normals
            See `wireprint.regions.Region.covers`.

        Returns
        -------
        numpy.ndarray
            bool of shape (N,).
        """
        if self.frame is None:
            return self.shape.covers(points, normals)
        frame = np.asarray(self.frame)
        linear, shift = frame[:, :3], frame[:, 3]
        own = np.linalg.solve(linear, (points - shift).T).T
        # A plane's normal goes with the transpose of the inverse; back again, with the transpose.
        turned = normals @ linear
        length = np.linalg.norm(turned, axis=1, keepdims=True)
        return self.shape.covers(own, np.divide(turned, length, where=length > 0, out=turned))

    def transformed(self, matrix: npt.NDArray[np.float64]) -> Mark:
        """Return the mark after an affine map.

        Parameters
        ----------
        matrix
            (4, 4), see `Region.transformed`.

        Returns
        -------
        Mark
            The same shape elsewhere.
        """
        frame = np.eye(4)
        if self.frame is not None:
            frame[:3] = self.frame
        first, second, third = ((*map(float, row),) for row in (matrix @ frame)[:3])
        return Mark(self.shape, self.erase, (first, second, third))  # type: ignore[arg-type]


@dataclass(frozen=True)
class Region:
    """Which parts of a model's surface are printed as layers.

    Immutable; empty, and then false, where nothing was ever added.

    Examples
    --------
    >>> from wireprint.regions import Region, Sphere, ZRange
    >>> region = Region().add(ZRange(low_mm=20)).erase(Sphere(centre_mm=(0, 0, 30), radius_mm=4))
    >>> up = np.array([[0.0, 0.0, 1.0]] * 3)
    >>> region.covers(np.array([[0.0, 0.0, 10.0], [0, 0, 30], [9, 0, 30]]), up)
    array([False, False,  True])
    """

    marks: tuple[Mark, ...] = ()

    def __bool__(self) -> bool:
        """Whether any mark adds something."""
        return any(not mark.erase for mark in self.marks)

    def add(self, what: Shape | Region) -> Region:
        """Return the region with a shape, or with another region's marks after its own.

        Parameters
        ----------
        what
            What is marked, too.

        Returns
        -------
        Region
            A new one; this one stays as it is.
        """
        if isinstance(what, Region):
            return Region(self.marks + what.marks)
        return Region((*self.marks, Mark(what)))

    def erase(self, shape: Shape) -> Region:
        """Return the region without what a shape covers.

        Parameters
        ----------
        shape
            What is wire again.

        Returns
        -------
        Region
            A new one; this one stays as it is.
        """
        return Region((*self.marks, Mark(shape, erase=True)))

    def covers(
        self, points: npt.NDArray[np.float64], normals: npt.NDArray[np.float64]
    ) -> npt.NDArray[np.bool_]:
        """Tell which points of the surface lie in the region.

        Parameters
        ----------
        points
            float64 of shape (N, 3), mm, in the placed model's frame.
        normals
            float64 of shape (N, 3): the surface's outward unit normals there.

        Returns
        -------
        numpy.ndarray
            bool of shape (N,).

        Raises
        ------
        SettingError
            Where an array has another dtype or shape, or holds a number that is not finite.
        """
        _check("points", points)
        _check("normals", normals)
        if points.shape != normals.shape:
            msg = f"points has shape {points.shape}, but normals has shape {normals.shape}"
            raise SettingError(msg)
        return self.covers_known(points, normals)

    def covers_known(
        self, points: npt.NDArray[np.float64], normals: npt.NDArray[np.float64]
    ) -> npt.NDArray[np.bool_]:
        """Tell the same of arrays that were checked, or made here.

        Parameters
        ----------
        points, normals
            See `wireprint.regions.Region.covers`.

        Returns
        -------
        numpy.ndarray
            bool of shape (N,).
        """
        covered = np.zeros(len(points), np.bool_)
        for mark in self.marks:
            # A mark can only change points that are not as it would leave them.
            open_ = np.flatnonzero(covered == mark.erase)
            if len(open_) == len(points):
                covered = mark.covers(points, normals) != mark.erase
            elif len(open_):
                covered[open_[mark.covers(points[open_], normals[open_])]] = not mark.erase
        return covered

    def transformed(self, matrix: npt.ArrayLike) -> Region:
        """Return the region after an affine map.

        Parameters
        ----------
        matrix
            (4, 4): takes a point of the old frame, as a column with a 1 below, to the new frame.

        Returns
        -------
        Region
            A new one, in the new frame.

        Raises
        ------
        SettingError
            Where the matrix is no affine map, or flattens space.
        """
        affine = np.asarray(matrix, np.float64)
        if affine.shape != (4, 4) or not np.array_equal(affine[3], (0, 0, 0, 1)):
            msg = f"matrix has shape {affine.shape}; it must be (4, 4) with a last row of 0 0 0 1"
            raise SettingError(msg)
        if not np.isfinite(affine).all() or flattens(affine):
            msg = "matrix is not finite, or flattens space"
            raise SettingError(msg)
        if np.array_equal(affine, np.eye(4)):
            return self
        return Region(tuple(mark.transformed(affine) for mark in self.marks))


def flattens(affine: npt.ArrayLike) -> bool:
    """Whether a map, given by its upper rows, leaves less than space."""
    return bool(np.linalg.cond(np.asarray(affine)[:3, :3]) > _MOST_STRETCH)


def _check(name: str, array: npt.NDArray[np.float64]) -> None:
    if array.dtype != np.float64 or array.ndim != 2 or array.shape[1] != 3:
        msg = (
            f"{name} has dtype {array.dtype} and shape {array.shape}; "
            "it must be a float64 array of shape (N, 3)"
        )
        raise SettingError(msg)
    if not np.isfinite(array).all():
        msg = f"{name} holds a number that is not finite"
        raise SettingError(msg)

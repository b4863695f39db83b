"""Whatever a caller holds as a model (a file, arrays, trimesh's meshes) becomes ours."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, runtime_checkable

from wireprint._core import Mesh, ModelError, SettingError
from wireprint.model import Model, load_model

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


@runtime_checkable
class Faceted(Protocol):
    """What has vertices and faces, such as a ``trimesh.Trimesh``; coordinates in mm."""

    @property
    def vertices(self) -> Any:
        """Positions, (N, 3)."""

    @property
    def faces(self) -> Any:
        """Vertex indices of each triangle, (M, 3)."""


#: What stands for a model: a file's path, a mesh, a model with marks, vertices and faces.
ModelLike: TypeAlias = (
    "str | os.PathLike[str] | Mesh | Model | Faceted | tuple[npt.ArrayLike, npt.ArrayLike]"
)


def as_model(given: ModelLike, **placement: Any) -> Model:
    """Return a model on the bed, with what its file says besides.

    Parameters
    ----------
    given
        See `as_mesh`.
    **placement
        See `as_mesh`.

    Returns
    -------
    Model
        Without marks or settings, unless it is read from a 3MF file.

    Raises
    ------
    ModelError, SettingError
        See `as_mesh`.
    """
    if isinstance(given, Model):
        return given
    if isinstance(given, str | os.PathLike):
        return load_model(given, **placement)
    from wireprint.regions import Region

    return Model(as_mesh(given, **placement), Region(), None)


def as_mesh(given: ModelLike, **placement: Any) -> Mesh:
    """Return a mesh on the bed, repaired.

    Parameters
    ----------
    given
        Path of a model file; a pair of vertices and faces, as arrays or lists of any real and any
        integer type, in mm; an object that has both, such as a ``trimesh.Trimesh``, or a scene of
        trimesh's; a mesh or model, which is returned as it is.
    **placement
        How it is placed: what `wireprint.load_mesh` takes.

    Returns
    -------
    Mesh
        As `wireprint.load_mesh` returns it.

    Raises
    ------
    ModelError
        It is none of these, or an array has the wrong shape or holds what is no coordinate or no
        index; the message names the first that is wrong.
    SettingError
        An argument is out of its bounds, or says how to place what is placed already.

    Examples
    --------
    >>> as_mesh(([[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]],
    ...          [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])).size_mm
    [9.0, 9.0, 9.0]
    """
    if isinstance(given, Mesh | Model):
        if placement:
            msg = f"{next(iter(placement))} is for what is not placed yet; a Mesh is"
            raise SettingError(msg)
        return given if isinstance(given, Mesh) else given.mesh
    if isinstance(given, str | os.PathLike):
        from wireprint.mesh import load_mesh

        return load_mesh(given, **placement)
    if not isinstance(given, Faceted) and callable(whole := getattr(given, "to_mesh", None)):
        # A scene: its bodies, each where it stands.
        given = whole()
    if isinstance(given, Faceted):
        given = (given.vertices, given.faces)
    if not isinstance(given, tuple | list) or len(given) != 2:
        what = type(given).__name__
        msg = (
            f"a model is a path, a Mesh, (vertices, faces) or an object that has both; {what} is "
            "none of these"
        )
        raise ModelError(msg)
    vertices, faces = given
    positions = _vertices(vertices)
    units = placement.pop("units", "mm")
    if units != "mm":
        from wireprint.mesh import mm_per

        placement["scale"] = placement.get("scale", 1.0) * mm_per(units)
    return Mesh.from_arrays(positions, _faces(faces, len(positions)), **placement)


def _vertices(given: npt.ArrayLike) -> npt.NDArray[np.float64]:
    import numpy as np

    found = _array("vertices", given)
    if found.dtype.kind not in "fiu":
        raise ModelError(f"vertices are of {found.dtype}; they must be real numbers, mm")
    _three("vertices", found, "N", "x, y and z of each")
    found = np.ascontiguousarray(found, np.float64)
    wrong = ~np.isfinite(found).all(axis=1)
    if wrong.any():
        row = int(wrong.argmax())
        msg = f"vertex {row} is {found[row].tolist()}: a coordinate must be finite"
        raise ModelError(f"{msg} ({int(wrong.sum())} of {len(found)} are not)")
    return found


def _faces(given: npt.ArrayLike, vertices: int) -> npt.NDArray[np.int64]:
    import numpy as np

    found = _array("faces", given)
    if found.dtype.kind not in "iu" and found.size:
        msg = f"faces are of {found.dtype}; they must be whole numbers, indices of vertices from 0"
        raise ModelError(msg)
    _three("faces", found, "M", "three indices each; triangulate polygons first")
    wrong = ((found < 0) | (found >= vertices)).any(axis=1)
    if wrong.any():
        row = int(wrong.argmax())
        msg = f"face {row} is {found[row].tolist()}: there are vertices 0 to {vertices - 1}"
        raise ModelError(msg)
    return np.ascontiguousarray(found, np.int64)


def _array(name: str, given: npt.ArrayLike) -> npt.NDArray[Any]:
    import numpy as np

    try:
        return np.asarray(given)
    except ValueError:
        msg = f"{name} are rows of different lengths; they must be an array of three columns"
        raise ModelError(msg) from None


def _three(name: str, found: npt.NDArray[Any], rows: str, what: str) -> None:
    if not found.size:
        raise ModelError(f"{name} are empty: there is nothing to print")
    if found.ndim != 2 or found.shape[1] != 3:
        msg = f"{name} have shape {found.shape}; it must be ({rows}, 3): {what}"
        raise ModelError(msg)

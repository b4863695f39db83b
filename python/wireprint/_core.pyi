"""The extension module: what the Rust core offers to Python."""

import os
from typing import ClassVar, TypeAlias, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "GcodeError",
    "Mesh",
    "ModelError",
    "Scene",
    "SettingError",
    "UnprintableError",
    "WireprintError",
    "__version__",
]

__version__: str

class WireprintError(ValueError):
    exit_code: ClassVar[int]

class ModelError(WireprintError): ...
class SettingError(WireprintError): ...
class UnprintableError(WireprintError): ...
class GcodeError(WireprintError): ...

@final
class Mesh:
    @staticmethod
    def load_stl(
        path: str | os.PathLike[str],
        *,
        scale: float = 1.0,
        up: str = "z",
        rotate: tuple[float, float, float] = ...,
        height_mm: float | None = None,
    ) -> Mesh: ...
    @staticmethod
    def from_arrays(
        vertices: npt.NDArray[np.float64],
        faces: npt.NDArray[np.int64],
        *,
        scale: float = 1.0,
        up: str = "z",
        rotate: tuple[float, float, float] = ...,
        height_mm: float | None = None,
    ) -> Mesh: ...
    @property
    def vertices(self) -> npt.NDArray[np.float64]: ...
    @property
    def faces(self) -> npt.NDArray[np.uint32]: ...
    @property
    def neighbours(self) -> npt.NDArray[np.uint32]: ...
    @property
    def bounds(self) -> npt.NDArray[np.float64]: ...
    @property
    def volume(self) -> float: ...
    @property
    def area(self) -> float: ...

_Rgb: TypeAlias = tuple[int, int, int]

@final
class Scene:
    def __new__(cls, *, floor: bool = False) -> Scene: ...
    def add_strands(
        self,
        segments: npt.NDArray[np.float64],
        kinds: npt.NDArray[np.uint8],
        palette: list[_Rgb | None],
        radius_mm: float,
    ) -> None: ...
    def add_lines(
        self, segments: npt.NDArray[np.float64], colour: _Rgb, width_px: float
    ) -> None: ...
    def add_marks(
        self, points: npt.NDArray[np.float64], colour: _Rgb, radius_mm: float
    ) -> None: ...
    def add_mesh(self, mesh: Mesh, colour: _Rgb, *, edges: _Rgb | None = None) -> None: ...
    def render(
        self,
        size: tuple[int, int],
        camera: tuple[float, float, float],
        *,
        supersample: int,
        margins: tuple[float, float, float, float],
        ground: _Rgb | None,
    ) -> tuple[bytes, float]: ...
    def png(
        self,
        size: tuple[int, int],
        camera: tuple[float, float, float],
        *,
        supersample: int,
        margins: tuple[float, float, float, float],
        ground: _Rgb | None,
    ) -> bytes: ...

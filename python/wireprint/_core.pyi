import os
from typing import ClassVar, final

import numpy as np
import numpy.typing as npt

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

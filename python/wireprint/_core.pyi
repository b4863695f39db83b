"""The extension module: what the Rust core offers to Python."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, ClassVar, Literal, TypeAlias, TypedDict, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "FORMATS",
    "HOLE_PERIMETER",
    "KINDS",
    "MOST_DIGITS",
    "MOST_TRIANGLES",
    "MOST_VERTICES",
    "WELD_DISTANCE",
    "Certificate",
    "Estimate",
    "Facets",
    "FaultError",
    "Forecast",
    "GcodeError",
    "MemoryLimitError",
    "Mesh",
    "ModelError",
    "Painting",
    "Scene",
    "SettingError",
    "Slices",
    "Strands",
    "Thumbnails",
    "Toolpath",
    "Touchable",
    "UnprintableError",
    "Wireframe",
    "WireprintError",
    "__version__",
    "bgcode_text",
    "carve",
    "certify",
    "cooling_time",
    "estimate",
    "estimate_files",
    "find_relationship",
    "forecast",
    "format_moves",
    "frame",
    "growth",
    "heat_transfer",
    "holding_pause",
    "insert_progress",
    "lattice_toolpath",
    "memory_budget",
    "modes_after",
    "nearest",
    "nusselt_across",
    "nusselt_still",
    "order_lattice",
    "read_amf",
    "read_model_part",
    "read_slicer_config",
    "sags",
    "slice_mesh",
    "stroke_run",
    "tallest_slab",
    "toolpath",
    "wireframe",
    "within",
]

__version__: str

class WireprintError(ValueError):
    exit_code: ClassVar[int]

class ModelError(WireprintError): ...
class SettingError(WireprintError): ...
class UnprintableError(WireprintError): ...
class GcodeError(WireprintError): ...
class MemoryLimitError(WireprintError): ...
class FaultError(WireprintError): ...

FORMATS: tuple[str, ...]
KINDS: tuple[str, ...]
HOLE_PERIMETER: float
MOST_DIGITS: int
MOST_TRIANGLES: int
MOST_VERTICES: int
WELD_DISTANCE: float

@final
class Mesh:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Mesh: ...
    def _repr_png_(self) -> bytes: ...
    @staticmethod
    def load(
        path: str | os.PathLike[str],
        suffix: str,
        *,
        scale: float = 1.0,
        up: str = "z",
        rotate: tuple[float, float, float] = ...,
        height_mm: float | None = None,
        hole_perimeter: float = ...,
        weld_distance: float = ...,
    ) -> Mesh: ...
    @staticmethod
    def from_arrays(
        vertices: npt.NDArray[np.float64],
        faces: npt.NDArray[np.int64 | np.int32 | np.uint32],
        *,
        scale: float = 1.0,
        up: str = "z",
        rotate: tuple[float, float, float] = ...,
        height_mm: float | None = None,
        hole_perimeter: float = ...,
        weld_distance: float = ...,
        notes: Sequence[str] = ...,
    ) -> Mesh: ...
    @staticmethod
    def restored(
        vertices: npt.NDArray[np.float64],
        faces: npt.NDArray[np.int64 | np.int32 | np.uint32],
        paired: Sequence[Sequence[int]] = ...,
        *,
        notes: Sequence[str] = ...,
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
    def placement(self) -> npt.NDArray[np.float64]: ...
    @property
    def size_mm(self) -> list[float]: ...
    @property
    def reach_mm(self) -> float: ...
    def centred_in_circle(self) -> Mesh: ...
    def turn_into(self, width_mm: float, depth_mm: float) -> float | None: ...
    def scale_into(self, width_mm: float, depth_mm: float) -> float: ...
    def scaled_to(self, height_mm: float) -> Mesh: ...
    def poses(self) -> list[tuple[tuple[float, float, float], bool, float]]: ...
    def turned(self, rotate: tuple[float, float, float]) -> Mesh: ...
    @property
    def volume(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def report(self) -> dict[str, int]: ...

@final
class Facets:
    def __new__(
        cls, vertices: npt.NDArray[np.float64], faces: npt.NDArray[np.integer[Any]]
    ) -> Facets: ...
    def nearest(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.uint32]: ...

_Place: TypeAlias = tuple[str, tuple[float, ...], str | None, bool]
_Object: TypeAlias = tuple[
    npt.NDArray[np.float64],
    npt.NDArray[np.uint32],
    Painting,
    list[tuple[str, npt.NDArray[np.uint32]]],
    list[_Place],
    tuple[str, str, str | None, str | None],
]
_SlicersVolume: TypeAlias = tuple[tuple[int, int] | None, str | None, str, str]
_Leaves: TypeAlias = tuple[
    npt.NDArray[np.uint32],
    npt.NDArray[np.uint8],
    npt.NDArray[np.uint32],
    npt.NDArray[np.float64],
    npt.NDArray[np.uint8],
]

def read_model_part(
    chunks: Iterable[bytes],
) -> tuple[float, list[tuple[str, _Object]], list[_Place]]: ...
def read_amf(
    chunks: Iterable[bytes],
) -> tuple[
    float,
    list[tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32], bool, int]],
    list[str],
]: ...
def read_slicer_config(
    chunks: Iterable[bytes],
) -> tuple[
    list[tuple[str, str, list[_SlicersVolume]]],
    list[tuple[int, str, list[tuple[str, int]]]],
]: ...
def find_relationship(chunks: Iterable[bytes], kind: str) -> str | None: ...
def carve(
    body: tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]],
    tools: Sequence[tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]],
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]: ...

@final
class Painting:
    @property
    def digits(self) -> int: ...
    def leaves(
        self, vertices: npt.NDArray[np.float64], faces: npt.NDArray[np.integer[Any]]
    ) -> _Leaves: ...

@final
class Slices:
    @property
    def points(self) -> npt.NDArray[np.float64]: ...
    @property
    def offsets(self) -> npt.NDArray[np.int64]: ...
    @property
    def slice_offsets(self) -> npt.NDArray[np.int64]: ...
    @property
    def parent(self) -> npt.NDArray[np.int64]: ...
    @property
    def depth(self) -> npt.NDArray[np.uint32]: ...
    @property
    def area(self) -> npt.NDArray[np.float64]: ...
    @property
    def closed(self) -> npt.NDArray[np.bool_]: ...

def slice_mesh(
    mesh: Mesh,
    heights: npt.NDArray[np.float64],
    side: str = "below",
    *,
    min_length_mm: float = 0.0,
) -> Slices: ...

_Rgb: TypeAlias = tuple[int, int, int]

@final
class Strands:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Strands: ...
    @staticmethod
    def from_gcode(text: bytes) -> Strands: ...
    @staticmethod
    def from_toolpath(
        toolpath: Toolpath, labels: Sequence[str], filament_diameter_mm: float
    ) -> Strands: ...
    @staticmethod
    def from_arrays(
        segments: npt.NDArray[np.float64],
        features: npt.NDArray[np.uint16],
        labels: Sequence[str],
        diameter_mm: float,
    ) -> Strands: ...
    @property
    def labels(self) -> list[str]: ...
    @property
    def lengths(self) -> list[float]: ...
    def bounds(
        self, labels: Sequence[str]
    ) -> tuple[tuple[float, float, float], tuple[float, float, float]] | None: ...
    @property
    def segments(self) -> npt.NDArray[np.float64]: ...
    @property
    def travels(self) -> npt.NDArray[np.float64]: ...
    @property
    def travel_after(self) -> npt.NDArray[np.uint32]: ...
    @property
    def diameters(self) -> npt.NDArray[np.float64]: ...
    @property
    def features(self) -> npt.NDArray[np.uint16]: ...
    @property
    def lines(self) -> npt.NDArray[np.uint64] | None: ...
    def __len__(self) -> int: ...
    def thumbnails(
        self,
        palette: Sequence[_Rgb | None],
        sizes: Sequence[tuple[int, int, str]],
        camera: tuple[float, float, float],
        *,
        margin: float,
    ) -> Thumbnails: ...

@final
class Thumbnails:
    def files(self) -> list[bytes]: ...

@final
class Scene:
    def __new__(cls, *, floor: bool = False) -> Scene: ...
    def add_strands(
        self,
        strands: Strands,
        palette: Sequence[_Rgb | None],
        *,
        travel: _Rgb | None = None,
    ) -> None: ...
    def add_marks(
        self, points: Sequence[tuple[float, float, float]], colour: _Rgb, radius_mm: float
    ) -> None: ...
    def add_mesh(self, mesh: Mesh, colour: _Rgb) -> None: ...
    def add_facets(self, corners: npt.NDArray[np.float64], colour: _Rgb) -> None: ...
    def add_edges(self, mesh: Mesh, colour: _Rgb) -> None: ...
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

@final
class Estimate:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Estimate: ...
    @property
    def total_s(self) -> float: ...
    @property
    def moving_s(self) -> float: ...
    @property
    def dwell_s(self) -> float: ...
    @property
    def travel_s(self) -> float: ...
    @property
    def homing_s(self) -> float: ...
    @property
    def heating_s(self) -> float: ...
    @property
    def tool_change_s(self) -> float: ...
    @property
    def tool_changes(self) -> int: ...
    @property
    def by_feature(self) -> list[tuple[str, float]]: ...
    @property
    def by_layer(self) -> list[tuple[float | None, float]]: ...
    @property
    def filament_mm(self) -> float: ...
    @property
    def moves(self) -> int: ...
    @property
    def garbage_lines(self) -> int: ...
    @property
    def relative_assumed(self) -> bool: ...
    @property
    def per_move(
        self,
    ) -> (
        tuple[npt.NDArray[np.uint64], npt.NDArray[np.float64], npt.NDArray[np.uint16], list[str]]
        | None
    ): ...

def estimate(
    text: bytes,
    limits: Mapping[str, Any],
    firmware: str,
    *,
    allowances_s: tuple[float, float, float, float],
    per_move: bool,
) -> Estimate: ...
def estimate_files(
    paths: Sequence[str | os.PathLike[str]],
    limits: Mapping[str, Any],
    firmware: str,
    *,
    allowances_s: tuple[float, float, float, float],
    per_move: bool,
) -> list[Estimate | WireprintError]: ...

class _Figures(TypedDict):
    strand_mm: float
    travel_mm: float
    pauses: int
    pause_s: float
    filament_mm: float

@final
class Toolpath:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes, mesh: Mesh | None) -> Toolpath: ...
    def figures(self) -> _Figures: ...
    @staticmethod
    def from_arrays(
        *,
        start: tuple[float, float, float],
        to: npt.NDArray[np.float64],
        kind: npt.NDArray[np.uint8],
        speed: npt.NDArray[np.float64],
        filament: npt.NDArray[np.float64],
        pause: npt.NDArray[np.float64],
        air: npt.NDArray[np.bool_],
        slab: npt.NDArray[np.uint32],
    ) -> Toolpath: ...
    def __len__(self) -> int: ...
    def moved(self, by_mm: tuple[float, float, float]) -> Toolpath: ...
    @property
    def mesh(self) -> Mesh | None: ...
    @property
    def start(self) -> list[float]: ...
    @property
    def brim_rings(self) -> int: ...
    @property
    def top_mm(self) -> float: ...
    @property
    def to(self) -> npt.NDArray[np.float64]: ...
    @property
    def kind(self) -> npt.NDArray[np.uint8]: ...
    @property
    def speed(self) -> npt.NDArray[np.float64]: ...
    @property
    def filament(self) -> npt.NDArray[np.float64]: ...
    @property
    def pause(self) -> npt.NDArray[np.float64]: ...
    @property
    def air(self) -> npt.NDArray[np.bool_]: ...
    @property
    def slab(self) -> npt.NDArray[np.uint32]: ...

def tallest_slab(head: Mapping[str, object], strand_mm: float, most_mm: float) -> float: ...
def stroke_run(head: Mapping[str, object], strand_mm: float, height_mm: float) -> float: ...
def format_moves(
    toolpath: Toolpath,
    *,
    relative_extrusion: bool,
    prusa_words: bool,
    dwell: str,
    air_on: str,
    air_off: str,
    layer: str,
    retract: str,
    unretract: str,
) -> bytes: ...
def insert_progress(text: bytes, estimate: Estimate, template: str) -> bytes: ...

class _Terms(TypedDict):
    within_mm: float
    strand_mm: float
    level_sine: float
    caps: bool
    supports: bool
    span_limit_mm: float

class _Lids(TypedDict):
    #: Closed rings, and the slab of each: what lies within an odd number of those of a slab, the
    #: last layer there fills behind walls.
    lid_slabs: npt.NDArray[np.int64]
    lid_points: npt.NDArray[np.float64]
    lid_offsets: npt.NDArray[np.int64]

class _Layered(_Lids):
    strips: npt.NDArray[np.int64]
    stretches: npt.NDArray[np.int64]
    stretch_spans: npt.NDArray[np.float64]
    points: npt.NDArray[np.float64]
    offsets: npt.NDArray[np.int64]
    line_slabs: npt.NDArray[np.int64]
    line_flows: npt.NDArray[np.float64]
    flats: npt.NDArray[np.float64]
    flats_marked: npt.NDArray[np.bool_]
    line_inside: npt.NDArray[np.bool_]

class _Contours(TypedDict):
    points: npt.NDArray[np.float64]
    offsets: npt.NDArray[np.int64]
    slice_offsets: npt.NDArray[np.int64]
    parent: npt.NDArray[np.int64]
    depth: npt.NDArray[np.uint32]
    area: npt.NDArray[np.float64]
    closed: npt.NDArray[np.bool_]

class _Layers(_Contours):
    slab: npt.NDArray[np.int64]
    z: npt.NDArray[np.float64]
    thickness: npt.NDArray[np.float64]
    face: npt.NDArray[np.int64]
    strip: npt.NDArray[np.int64]

@final
class Wireframe:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes, mesh: Mesh) -> Wireframe: ...
    @property
    def slice_count(self) -> int: ...
    @property
    def post_count(self) -> int: ...
    @property
    def diagonal_count(self) -> int: ...
    @property
    def strand_count(self) -> int: ...
    @property
    def levels(self) -> npt.NDArray[np.float64]: ...
    @property
    def contours_above(self) -> _Contours: ...
    @property
    def contours_below(self) -> _Contours: ...
    @property
    def strips(self) -> list[list[tuple[list[int], list[int], float]]]: ...
    @property
    def posts(self) -> npt.NDArray[np.float64]: ...
    @property
    def post_places(self) -> npt.NDArray[np.uint32]: ...
    @property
    def strands(self) -> npt.NDArray[np.float64]: ...
    @property
    def strand_kinds(self) -> npt.NDArray[np.uint8]: ...
    @property
    def strand_slabs(self) -> npt.NDArray[np.uint32]: ...
    def layers(self, mesh: Mesh, thickness_mm: float, strand_mm: float) -> _Layers: ...
    @property
    def support_mm(self) -> float: ...
    def without(self, dropped: list[int], strand_mm: float) -> Wireframe: ...
    def beyond(self, standing: list[int]) -> Wireframe: ...
    def holding(
        self, parts: npt.NDArray[np.float64], within_mm: float
    ) -> npt.NDArray[np.int64]: ...
    @property
    def unprinted(
        self,
    ) -> list[tuple[str, float, float, float, tuple[float, float, float]]]: ...

def wireframe(
    mesh: Mesh,
    head: Mapping[str, object],
    params: Mapping[str, object],
    layered: _Layered | None = None,
    standing: npt.NDArray[np.float64] | None = None,
    plain: Wireframe | None = None,
) -> Wireframe: ...
def nearest(
    places: npt.NDArray[np.float64], among: npt.NDArray[np.float64]
) -> npt.NDArray[np.uint32]: ...

_Numbers: TypeAlias = npt.NDArray[np.int64]
#: Of lines: points, the layer of each, where each line's begin, and the group of each line.
_Route: TypeAlias = tuple[npt.NDArray[np.float64], _Numbers, _Numbers, _Numbers]
#: Segments, shape (S, 2, 2), or places, shape (P, 2), mm, and the layer of each.
_OnLayers: TypeAlias = tuple[npt.NDArray[np.float64], _Numbers]

@final
class Touchable:
    def __new__(
        cls, contours: _OnLayers, rims: _OnLayers, strand_mm: float, thickest_mm: float
    ) -> Touchable: ...
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Touchable: ...
    def anchored(self, route: _Route, loose: _OnLayers) -> _Route: ...

def within(
    places: npt.NDArray[np.float64],
    layers: _Numbers,
    reach_mm: npt.NDArray[np.float64],
    among: _OnLayers,
) -> npt.NDArray[np.bool_]: ...
def order_lattice(
    nodes: npt.NDArray[np.float64],
    edges: Sequence[Sequence[int]],
    struts: Sequence[int],
    knees: npt.NDArray[np.float64],
    head: Mapping[str, object],
    rules: Mapping[str, object],
    watch: Callable[[int], object] | None,
) -> tuple[list[tuple[int, bool, bool]], list[tuple[int, str]], int]: ...
def lattice_toolpath(
    strands: npt.NDArray[np.float64],
    floating: npt.NDArray[np.bool_],
    params: Mapping[str, object],
) -> Toolpath: ...
def toolpath(wireframe: Wireframe, params: Mapping[str, object]) -> Toolpath: ...

_Point: TypeAlias = tuple[float, float, float]
_Patch: TypeAlias = tuple[float, _Point, _Point, _Point]
_Coverage: TypeAlias = tuple[float, float, list[_Patch]]

@final
class Certificate:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Certificate: ...
    def after(self, line: int) -> Certificate: ...
    @property
    def ok(self) -> bool: ...
    @property
    def collisions(self) -> list[tuple[int, _Point, _Point, float, int | None]]: ...
    @property
    def floating_starts(self) -> list[tuple[int, _Point]]: ...
    @property
    def dangling_ends(self) -> list[tuple[int, _Point]]: ...
    @property
    def spans_over(self) -> list[tuple[int, _Point, _Point, float, bool]]: ...
    @property
    def out_of_bounds(self) -> list[tuple[int, _Point, str, float, float]]: ...
    @property
    def underfed(self) -> list[tuple[int, _Point, float, float, float]]: ...
    @property
    def hurried(self) -> list[tuple[int, _Point, float]]: ...
    @property
    def cold(self) -> list[tuple[int, _Point, float]]: ...
    @property
    def unhomed(self) -> list[tuple[int, _Point, list[bool]]]: ...
    @property
    def unjudged(self) -> list[tuple[int, str, str]]: ...
    @property
    def harmless(self) -> dict[str, int]: ...
    @property
    def preparing(self) -> dict[str, int]: ...
    @property
    def relative_assumed(self) -> bool: ...
    @property
    def moves(self) -> int: ...
    @property
    def garbage_lines(self) -> int: ...
    @property
    def strand_count(self) -> int: ...
    @property
    def max_span_mm(self) -> float: ...
    @property
    def max_free_end_mm(self) -> float: ...
    @property
    def strands(self) -> npt.NDArray[np.float64]: ...
    @property
    def strand_lines(self) -> npt.NDArray[np.uint64]: ...
    @property
    def strand_features(self) -> npt.NDArray[np.uint16]: ...
    @property
    def features(self) -> list[str]: ...
    @property
    def relaxed(self) -> npt.NDArray[np.float64]: ...
    @property
    def relaxed_strands(self) -> npt.NDArray[np.uint32]: ...
    def fidelity(
        self,
        mesh: Mesh,
        origin_mm: tuple[float, float, float],
        aside: set[str],
        inside: set[str],
        terms: _Terms,
        deviation: bool,
    ) -> tuple[_Coverage, tuple[tuple[float, float], tuple[float, float]] | None]: ...

_RuleName: TypeAlias = Literal["holds", "sags", "meets", "flows", "knots", "welds"]
_WorstRow: TypeAlias = tuple[float, int, _Point, float, float]
_Found: TypeAlias = tuple[_WorstRow | None, int, int]

@final
class Forecast:
    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]: ...
    @staticmethod
    def _restored(state: bytes) -> Forecast: ...
    @property
    def found(self) -> list[tuple[_RuleName, _Found]]: ...
    @property
    def weld_median(self) -> float: ...
    @property
    def frame_judged(self) -> bool: ...
    @property
    def layers_rigid(self) -> bool: ...
    @property
    def air_blows(self) -> bool: ...
    @property
    def lines(self) -> npt.NDArray[np.uint64]: ...
    @property
    def ends(self) -> npt.NDArray[np.float64]: ...
    @property
    def age_s(self) -> npt.NDArray[np.float64]: ...
    @property
    def temperature_c(self) -> npt.NDArray[np.float64]: ...
    @property
    def sag_mm(self) -> npt.NDArray[np.float64]: ...
    @property
    def compliance_mm_n(self) -> npt.NDArray[np.float64]: ...
    @property
    def flow_share(self) -> npt.NDArray[np.float64]: ...
    @property
    def weld(self) -> npt.NDArray[np.float64]: ...

def forecast(
    text: bytes, rules: Mapping[str, Any], estimate: Estimate, terms: Mapping[str, Any]
) -> Forecast: ...
def memory_budget() -> int: ...
def nusselt_still(rayleigh: float, prandtl: float) -> float: ...
def nusselt_across(reynolds: float, prandtl: float) -> float: ...
def heat_transfer(thermal: Mapping[str, float], strand_c: float, air_mm_s: float) -> float: ...
def cooling_time(thermal: Mapping[str, float], to_c: float, air_mm_s: float) -> float: ...
def holding_pause(
    matter: Mapping[str, float],
    air_mm_s: float,
    length_mm: float,
    speed_mm_s: float,
    pull_n: float,
    most_s: float,
) -> float: ...
def sags(
    matter: Mapping[str, float], air_mm_s: float, speed_mm_s: float, lengths_mm: Sequence[float]
) -> list[float]: ...
def bgcode_text(content: bytes) -> bytes: ...
def certify(text: bytes, rules: Mapping[str, Any]) -> Certificate: ...
def modes_after(
    text: bytes, rules: Mapping[str, Any]
) -> tuple[_Point, float, bool, float, bool]: ...
def frame(
    text: bytes, rules: Mapping[str, Any]
) -> tuple[
    npt.NDArray[np.float64],
    npt.NDArray[np.bool_],
    npt.NDArray[np.uint32],
    npt.NDArray[np.uint32],
    npt.NDArray[np.uint64],
]: ...
def growth(
    text: bytes, rules: Mapping[str, Any], modulus_mpa: float, most_work: float
) -> list[tuple[int, _Point, float]] | None: ...

"""Turns a model so that it prints best: least is left out, then least support, then least time."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import WireprintError
from wireprint.certificate import check
from wireprint.duration import duration
from wireprint.fitting import fits, placed
from wireprint.gcode import document
from wireprint.stages import toolpath, wireframe
from wireprint.threads import workers

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.settings import Settings

Angles = tuple[float, float, float]

#: Poses that are judged by printing them; of more, those are passed over that hang most.
MOST_JUDGED: Final = 8
#: What is compared, in this order: figure, what it is called, and how it is told.
_FIGURES: Final[tuple[tuple[str, str, Callable[[float], str]], ...]] = (
    ("breaches", "breaches of the rules", str),
    ("unprinted_mm2", "not printed", lambda area: f"{area:.0f} mm²"),
    ("uncovered_mm2", "not covered", lambda area: f"{area:.0f} mm²"),
    ("support_mm", "support", lambda length: f"{length / 1000:.2f} m"),
    ("print_time_s", "time", duration),
)
#: Differences up to these are none: shares of the surface, a length of support, a share of the
#: time. Rounding, and seams that lie elsewhere, turn no model.
_UNPRINTED_SHARE: Final = 0.001
_UNCOVERED_SHARE: Final = 0.02
_SUPPORT_MM: Final = 100.0
_TIME_SHARE: Final = 0.1
#: Digits of an angle in degrees; they are told as they are used, so that `--rotate` repeats them.
_DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class Pose:
    """A way to stand the model on the bed, with what printing it so comes to."""

    #: Turn about x, then y, then z from the pose that was given, degrees.
    rotate_deg: Angles
    #: Whether the model rests there by itself.
    rests: bool
    #: Area in plan that hangs over the air, mm²: the cheap measure.
    hanging_mm2: float
    #: Why it was not judged; None for those that were.
    passed_over: str | None = None
    #: Breaches of the rules.
    breaches: int | None = None
    #: Surface that would not be printed, mm².
    unprinted_mm2: float | None = None
    #: Surface that no strand is near to, mm².
    uncovered_mm2: float | None = None
    #: Length of the strands that only support others, mm.
    support_mm: float | None = None
    print_time_s: float | None = None

    def told(self) -> list[str]:
        """Tell the figures of a judged pose."""
        return [f"{called} {told(getattr(self, name))}" for name, called, told in _FIGURES]


@dataclass(frozen=True, repr=False)
class Orientation:
    """The pose that was chosen, and what it was chosen from."""

    #: The model in the chosen pose.
    mesh: Mesh
    chosen: Pose
    #: All poses, the given one first.
    poses: tuple[Pose, ...]

    @property
    def rotate_deg(self) -> Angles:
        """The turn about x, then y, then z, as ``load_mesh`` takes it."""
        return self.chosen.rotate_deg

    @property
    def why(self) -> str:
        """Say in what the chosen pose is better than the given one."""
        given, chosen = self.poses[0], self.chosen
        judged = sum(pose.passed_over is None for pose in self.poses)
        if chosen is given:
            return f"best of {judged} poses"
        if given.passed_over is not None:
            return f"as given it {given.passed_over}; best of {judged} poses"
        name, called, told = _difference(chosen, given, self.mesh.area) or _FIGURES[-1]
        before, after = (told(getattr(pose, name)) for pose in (given, chosen))
        return f"{called} {after} instead of {before}; best of {judged} poses"

    def __repr__(self) -> str:
        """Say what was chosen and why."""
        return f"<Orientation {self}>"

    def __str__(self) -> str:
        """Say what was chosen and why, in a line."""
        x, y, z = self.rotate_deg
        turned = f"turned by {x:g}, {y:g}, {z:g} degrees about x, y, z"
        return f"{turned if any(self.rotate_deg) else 'left as given'}: {self.why}"

    def to_dict(self) -> dict[str, Any]:
        """Return everything in JSON's types.

        Returns
        -------
        dict
            The turn, why, and all poses.
        """
        return {
            "rotate_deg": list(self.rotate_deg),
            "why": self.why,
            "poses": [asdict(pose) | {"rotate_deg": list(pose.rotate_deg)} for pose in self.poses],
        }


def orient(mesh: Mesh, settings: Settings) -> Orientation:
    """Find the pose in which a model is printed best.

    Candidates are the given pose, the other directions of the axes, and the poses in which the
    model rests by itself. Those that fit the bed, the least hanging first, are really wired, timed
    and judged; ties keep the pose that is given.

    Parameters
    ----------
    mesh, settings
        See `wireprint.make`.

    Returns
    -------
    Orientation
        The turned mesh, and the figures of all candidates. Where none fits the bed, the pose stays
        as it was given.
    """
    poses = [Pose(_rounded(angles), rests, hanging) for angles, rests, hanging in mesh.poses()]
    with ThreadPoolExecutor(workers()) as threads:
        poses = list(threads.map(lambda pose: _fitted(pose, mesh, settings), poses))
        fitting = sorted(
            (pose.hanging_mm2, index) for index, pose in enumerate(poses) if not pose.passed_over
        )
        # The given pose is the one to beat.
        judged = {0} | {index for _, index in fitting[: MOST_JUDGED - 1]}
        poses = list(
            threads.map(
                lambda index: _judged(poses[index], mesh, settings, wanted=index in judged),
                range(len(poses)),
            )
        )
    chosen = poses[0]
    for pose in poses[1:]:
        if _is_better(pose, chosen, mesh.area):
            chosen = pose
    return Orientation(_turned(mesh, chosen), chosen, tuple(poses))


def _rounded(angles: Angles) -> Angles:
    # Adding zero makes a negative one positive.
    x, y, z = (round(angle, _DIGITS) + 0.0 for angle in angles)
    return x, y, z


def _turned(mesh: Mesh, pose: Pose) -> Mesh:
    return mesh if pose.rotate_deg == (0, 0, 0) else mesh.turned(pose.rotate_deg)


def _fitted(pose: Pose, mesh: Mesh, settings: Settings) -> Pose:
    """Pass a pose over that does not fit the bed."""
    if fits(placed(_turned(mesh, pose), settings).mesh, settings):
        return pose
    return replace(pose, passed_over="does not fit the bed")


def _judged(pose: Pose, mesh: Mesh, settings: Settings, *, wanted: bool) -> Pose:
    """Wire, time and judge a pose."""
    if pose.passed_over is not None:
        return pose
    if not wanted:
        return replace(pose, passed_over="hangs more than others")
    try:
        turned = placed(_turned(mesh, pose), settings).mesh
        wire = wireframe(turned, settings)
        text = document.body(toolpath(wire, settings), settings, datetime.fromtimestamp(0, UTC))
        certificate = check(text, settings, turned, deviation=False)
    except WireprintError as error:
        return replace(pose, passed_over=f"fails: {error}")
    fidelity = certificate.fidelity
    uncovered_mm2 = 0.0 if fidelity is None else (1.0 - fidelity.coverage) * fidelity.area_mm2
    return replace(
        pose,
        breaches=sum(len(found) for found in certificate.breaches().values()),
        unprinted_mm2=sum((area for _, _, _, area, _ in wire.unprinted), 0.0),
        uncovered_mm2=uncovered_mm2,
        support_mm=wire.support_mm,
        print_time_s=document.timing(text, settings).total_s,
    )


def _is_better(pose: Pose, champion: Pose, area_mm2: float) -> bool:
    """Whether a pose leaves out less than another, or needs less support, or less time."""
    if pose.passed_over is not None:
        return False
    if champion.passed_over is not None:
        return True
    difference = _difference(pose, champion, area_mm2)
    if difference is None:
        return False
    name, _, _ = difference
    return bool(getattr(pose, name) < getattr(champion, name))


def _difference(
    one: Pose, other: Pose, area_mm2: float
) -> tuple[str, str, Callable[[float], str]] | None:
    """Return the first figure in which two judged poses differ."""
    times = [pose.print_time_s or 0.0 for pose in (one, other)]
    least = {
        "breaches": 0.0,
        "unprinted_mm2": _UNPRINTED_SHARE * area_mm2,
        "uncovered_mm2": _UNCOVERED_SHARE * area_mm2,
        "support_mm": _SUPPORT_MM,
        "print_time_s": _TIME_SHARE * max(times),
    }
    for figure in _FIGURES:
        name = figure[0]
        if abs(getattr(one, name) - getattr(other, name)) > least[name]:
            return figure
    return None

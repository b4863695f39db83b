"""The whole way from a mesh to G-code, stage by stage, for the command and for notebooks."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint import report
from wireprint._core import Mesh, SettingError, UnprintableError
from wireprint.certificate import check
from wireprint.clock import Clock
from wireprint.files import written_whole
from wireprint.finishing import Finishing, NothingPlannedError
from wireprint.fitting import fitted, placed
from wireprint.stages import origin_mm, wireframe
from wireprint.whole_file import to_gcode
from wireprint.wholeness import is_whole, refusal

if TYPE_CHECKING:
    import os
    from datetime import datetime

    from wireprint._core import Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.hybrid.sketch import Sketch
    from wireprint.inputs import ModelLike
    from wireprint.regions import Region
    from wireprint.remedies import Remedy
    from wireprint.settings import Settings
    from wireprint.standing import Standing
    from wireprint.verdict import Point
    from wireprint.wire_print import WirePrint


def make(
    mesh: ModelLike,
    settings: Settings | None = None,
    region: Region | None = None,
    *,
    date: datetime | None = None,
    clock: Clock | None = None,
    certify: bool = True,
    compare: bool = True,
    orient: bool = False,
    partial: bool = False,
    oversize: bool = False,
    weak: bool = False,
    kept: Sketch | None = None,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
) -> WirePrint:
    """Turn a model into a wire print.

    Parameters
    ----------
    mesh
        The model: a mesh, a file's path, vertices and faces, or what has both, such as a
        ``trimesh.Trimesh``; see `wireprint.as_mesh`.
    settings
        Printer, material and way of wiring; default: a project's own, else those of
        ``Settings.load()``.
    region
        What is printed as layers, in the coordinates of the placed mesh, after what is marked in
        the model's file; None, or an empty one: nothing else. Parts of it that cannot be printed so
        stay wire; `WirePrint.regions` names them.
    date
        Written into the file; default: as `document.dated` without a file.
    clock
        Measures the stages; one that already holds earlier ones is continued.
    certify
        Whether to judge the file by the rules of a printable one.
    compare
        Whether the verdict tells how far strands lie off the surface, too.
    orient
        Whether to turn the model into the pose that is printed best.
    partial
        Whether a print is wanted that leaves more of the surface bare than `wire.coverage_min`
        allows. Without `certify` nobody knows.
    oversize
        Whether a print is wanted that leaves the build volume.
    weak
        Whether to find out where the print gives way too easily while it grows.
    kept
        `WirePrint.sketch` of an earlier print of the same mesh with the same settings, which was
        not oriented: the print is the same without it, but takes longer.
    standing
        What stands on the bed already: the head keeps clear of it, strands that stand are not
        printed again, and the verdict is on all prints as one.
    at_mm
        Where the middle of the model's foot stands, from the middle of the bed, mm.

    Returns
    -------
    WirePrint
        The file, and everything that it was made from.

    Raises
    ------
    UnprintableError
        The model does not fit the printer; the message names the largest size that does. One that
        fits if it is turned about z is turned.
    IncompleteError
        Too much of the model would be left out, or all of it; the message names the parts, and a
        remedy that was tried.
    ModelError
        The model cannot be read, or no slice has a contour.
    """
    given, settings, region = _resolved(mesh, settings, region)

    def attempt(remedy: Remedy) -> Certificate | None:
        turn = orient or remedy.orient
        options: dict[str, Any] = {"compare": False, "orient": turn, "partial": True}
        options |= {"standing": standing, "at_mm": at_mm}
        return make(given, _as_it_is(remedy.settings), region, **options).certificate

    if region and (standing is not None or at_mm != (0.0, 0.0, 0.0)):
        raise SettingError("marks cannot be printed as layers onto what stands already")
    clock = clock or Clock()
    body, orientation = given, None
    if orient:
        from wireprint.orientation import orient as best

        with clock.stage("orient"):
            orientation = best(given, settings)
        body = orientation.mesh
    place = placed(body, settings) if oversize else fitted(body, settings)
    body = place.mesh
    if kept is not None:
        settings = kept.settings
    with clock.stage("wireframe"):
        if standing is not None:
            settings, planned = _onto(body, settings, standing, at_mm, clock)
        else:
            planned = wireframe(body, settings) if kept is None else kept.plain
    moved = None
    if region:
        from wireprint.hybrid.motion import motion

        x, y, z = (0.0, 0.0, 0.0) if orientation is None else orientation.rotate_deg
        moved = region.transformed(motion(given, body, (x, y, z + place.turn_deg)))
    finishing = Finishing(
        place=place,
        orientation=orientation,
        region=moved,
        kept=kept,
        date=date,
        clock=clock,
        certify=certify,
        compare=compare,
        weak=weak,
        standing=standing,
        at_mm=at_mm,
        lower=certify and standing is None and not (kept is not None and kept.judged),
    )
    try:
        made = finishing.of(settings, planned)
    except NothingPlannedError:
        left_out = report.unprinted(planned.unprinted, None, settings)
        raise refusal(None, left_out, settings, None if partial else attempt) from None
    certificate = made.certificate
    if certificate is not None and not partial and not is_whole(certificate, made.settings):
        raise refusal(certificate, made.unprinted(), settings, attempt)
    return made


def _resolved(
    given: ModelLike, settings: Settings | None, region: Region | None
) -> tuple[Mesh, Settings, Region | None]:
    """Return a mesh on the bed, with the settings and marks of its file where it has some."""
    if not isinstance(given, Mesh):
        from wireprint.inputs import as_model

        model = as_model(given)
        settings = model.settings if settings is None else settings
        if model.region:
            region = model.region if region is None else model.region.add(region)
        given = model.mesh
    if settings is None:
        from wireprint.settings import Settings

        settings = Settings.load()
    return given, settings, region


def _as_it_is(settings: Settings) -> Settings:
    """Return settings that print a model without a second plan, for remedies that must help so."""
    return settings.but(overrides=["wire.coverage_goal=0", "wire.braced_goal=0"])


def _onto(
    mesh: Mesh, settings: Settings, standing: Standing, at_mm: Point, clock: Clock
) -> tuple[Settings, Wireframe]:
    """Return what is left to print of a model, part of which may stand already, and its settings.

    Where some of it does, it is planned as if nothing stood, for what stands is its own; else clear
    of what stands. What stands may have been planned anew, with lower slabs: it is held against
    both plans.

    Raises
    ------
    UnprintableError
        Nothing is left.
    """
    origin = origin_mm(settings, at_mm)
    plain = wireframe(mesh, settings)
    plans = [(settings, plain)]
    if standing.is_within(mesh.size_mm, origin):
        from wireprint.replanning import replanned

        other = replanned(mesh, settings, plain, None, clock.step)
        # Of equals the one that is printed today.
        plans = plans if other is None else [other, *plans]
    done = [standing.printed_of(plan, origin) for _, plan in plans]
    best = max(range(len(plans)), key=lambda number: len(done[number]))
    if not done[best]:
        return settings, wireframe(mesh, settings, None, standing, at_mm)
    own, plan = plans[best]
    if len(done[best]) == plan.strand_count:
        raise UnprintableError("all of it stands already: there is nothing left to print")
    return own, plan.beyond(done[best])


def write_gcode(
    path: str | os.PathLike[str],
    toolpath: Toolpath,
    settings: Settings,
    *,
    partial: bool = False,
    **options: Any,
) -> None:
    """Write what `to_gcode` gives to a file: all of it, or nothing.

    Parameters
    ----------
    path
        The file; an older one is replaced.
    toolpath, settings, **options
        See `to_gcode`.
    partial
        Whether a print is wanted that leaves more of the model bare than `wire.coverage_min`
        allows. A toolpath that was made from arrays has no model to be held against.

    Raises
    ------
    IncompleteError
        See `make`.
    """
    text = to_gcode(toolpath, settings, **options)
    mesh = toolpath.mesh
    if mesh is not None and not partial:

        def attempt(remedy: Remedy) -> Certificate | None:
            tried = _as_it_is(remedy.settings)
            return make(mesh, tried, compare=False, orient=remedy.orient, partial=True).certificate

        certificate = check(text, settings, mesh, deviation=False)
        if not is_whole(certificate, settings):
            bare = report.unprinted((), certificate.fidelity, settings)
            raise refusal(certificate, bare, settings, attempt)
    written_whole(Path(path), text)

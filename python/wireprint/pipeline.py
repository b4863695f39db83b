"""The whole way from a mesh to G-code, stage by stage, for the command and for notebooks."""

from __future__ import annotations

import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint import report
from wireprint._core import Mesh, SettingError, UnprintableError
from wireprint.certificate import check
from wireprint.files import written_whole
from wireprint.fitting import fitted, placed
from wireprint.gcode import document, file
from wireprint.slimness import strand_of
from wireprint.stages import origin_mm, toolpath, wireframe
from wireprint.timing import Filament
from wireprint.wholeness import is_whole, refusal

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Iterable, Iterator
    from datetime import datetime

    from wireprint._core import Estimate, Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.gcode.document import Thumbnail
    from wireprint.gcode.file import Written
    from wireprint.hybrid.prove import Proved
    from wireprint.hybrid.sketch import Sketch
    from wireprint.inputs import ModelLike
    from wireprint.orientation import Orientation
    from wireprint.regions import Region
    from wireprint.remedies import Remedy
    from wireprint.settings import Settings
    from wireprint.standing import Standing
    from wireprint.verdict import Point
    from wireprint.weakness import Weak


@dataclass
class Clock:
    """Time that each stage takes to compute."""

    on_stage: Callable[[str], None] | None = None
    #: Called with the steps of long stages, too; like `on_stage` it may raise to give up.
    on_step: Callable[[str], None] | None = None
    timings_s: dict[str, float] = field(default_factory=dict)

    def step(self, name: str) -> None:
        """Announce a step of a stage."""
        if self.on_step is not None:
            self.on_step(name)

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Announce a stage and measure it, s."""
        if self.on_stage is not None:
            self.on_stage(name)
        begin = time.perf_counter()
        yield
        self.timings_s[name] = time.perf_counter() - begin


@dataclass(frozen=True, repr=False)
class WirePrint:
    """A model with everything that was made from it."""

    settings: Settings
    #: The model as it stands on the bed.
    mesh: Mesh
    wireframe: Wireframe
    toolpath: Toolpath
    #: What of it is layers; None where nothing was marked.
    regions: Proved | None
    #: The whole file.
    gcode: bytes
    estimate: Estimate
    #: The verdict on the file; None where it was not asked for.
    certificate: Certificate | None
    #: Seconds per stage.
    timings_s: dict[str, float]
    #: How the model was turned, where that was left to us.
    orientation: Orientation | None = None
    #: By how much it was turned about z to fit the bed, degrees.
    turn_to_fit_deg: float = 0.0
    #: Where it gives way too easily while it grows; None where that was not asked for, or is too
    #: much work to find out.
    weak: tuple[Weak, ...] | None = None
    #: The wire print without marks, before strands that break the rules were left out of it: what
    #: broke them may well be layers once something is marked. None: `wireframe`.
    planned: Wireframe | None = None

    @property
    def sketch(self) -> Sketch:
        """What marks do not change, to be kept for the next print."""
        if self.regions is not None:
            return self.regions.plan.sketch
        return _sketch(self.mesh, self.planned or self.wireframe, self.settings)

    def figures(self) -> dict[str, Any]:
        """Tell what people want to know, under the keys of ``wireprint slice --json``.

        Returns
        -------
        dict
            Values that JSON knows.
        """
        moves = self.toolpath.figures()
        filament, filament_mm = Filament.of(self.settings), self.estimate.filament_mm
        return {
            "size_mm": self.mesh.size_mm,
            "orientation": None if self.orientation is None else self.orientation.to_dict(),
            "turn_to_fit_deg": self.turn_to_fit_deg,
            "slices": self.wireframe.slice_count,
            "posts": self.wireframe.post_count,
            "strand_mm": moves["strand_mm"],
            "travel_mm": moves["travel_mm"],
            "strand": strand_of(self.settings),
            "brim_rings": self.toolpath.brim_rings,
            "pauses": moves["pauses"],
            "pause_s": moves["pause_s"],
            "filament_mm": filament_mm,
            "filament_g": filament.grams(filament_mm),
            "filament_cost": filament.cost(filament_mm),
            "print_time_s": self.estimate.total_s,
            **self._verdict(),
            "repaired": report.repairs(self.mesh),
            "unprinted": self.unprinted(),
            "weak": None if self.weak is None else [asdict(place) for place in self.weak],
            "regions": None if self.regions is None else report.regions(self.regions),
            "warnings": [*report.warnings(self.mesh), *report.slowed(self.settings)],
            "timings_s": self.timings_s,
        }

    def unprinted(self) -> list[report.Unprinted]:
        """List what is not printed: what the certificate finds bare, and what planning left out.

        Returns
        -------
        list of Unprinted
            Parts, the largest first.
        """
        fidelity = None if self.certificate is None else self.certificate.fidelity
        return report.unprinted(self.wireframe.unprinted, fidelity, self.settings)

    def _told(self) -> str:
        """Say time, filament and verdict."""
        from wireprint.notebook import told

        figures = {
            "print_time_s": self.estimate.total_s,
            "filament_g": Filament.of(self.settings).grams(self.estimate.filament_mm),
        }
        return told(figures | self._verdict())

    def __repr__(self) -> str:
        """Say what it comes to; the parts are attributes."""
        return f"<WirePrint {self.settings.printer.name}: {self._told()}>"

    def _repr_png_(self) -> bytes:
        """Draw the picture that a notebook shows."""
        from wireprint.notebook import picture

        return picture(self)

    def _repr_html_(self) -> str:
        """Draw it, and say time, filament and verdict below."""
        from wireprint.notebook import page

        return page(self, self._told())

    def _verdict(self) -> dict[str, Any]:
        """Return whether the file keeps the rules, and how faithful it is."""
        certificate = self.certificate
        if certificate is None:
            return {}
        breaches = {name: len(found) for name, found in certificate.breaches().items()}
        verdict: dict[str, Any] = {"certified": certificate.ok, "breaches": breaches}
        if certificate.fidelity is not None:
            verdict["whole"] = is_whole(certificate, self.settings)
            verdict["coverage"] = certificate.fidelity.coverage
            if certificate.fidelity.deviation_mm is not None:
                verdict["deviation_mm"] = certificate.fidelity.deviation_mm
                verdict["chord_deviation_mm"] = certificate.fidelity.chord_deviation_mm
        return verdict


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
        return make(given, remedy.settings, region, **options).certificate

    def judged(text: bytes) -> Certificate:
        return check(text, settings, body, deviation=compare, standing=standing, at_mm=at_mm)

    def written(path: Toolpath) -> Written:
        remarks = [] if orientation is None else [str(orientation)]
        remarks += [str(place)] if place.turn_deg else []
        return _written(path, begun, date, [*remarks, *started])

    if region and (standing is not None or at_mm != (0.0, 0.0, 0.0)):
        raise SettingError("marks cannot be printed as layers onto what stands already")
    clock = clock or Clock()
    begun: Settings = settings
    started: tuple[str, ...] = ()
    if standing is not None:
        from wireprint.beginning import over

        begun, started = over(settings, standing)
    body, orientation = given, None
    if orient:
        from wireprint.orientation import orient as best

        with clock.stage("orient"):
            orientation = best(given, settings)
        body = orientation.mesh
    place = placed(body, settings) if oversize else fitted(body, settings)
    body = place.mesh
    with clock.stage("wireframe"):
        if standing is not None:
            planned = _onto(body, settings, standing, at_mm)
        else:
            planned = wireframe(body, settings) if kept is None else kept.plain
    strands, regions = planned, None
    if region:
        from wireprint.hybrid.motion import motion
        from wireprint.hybrid.prove import proved

        with clock.stage("regions"):
            x, y, z = (0.0, 0.0, 0.0) if orientation is None else orientation.rotate_deg
            moved = region.transformed(motion(given, body, (x, y, z + place.turn_deg)))
            sketch = kept or _sketch(body, planned, settings)
            regions = proved(sketch, moved, clock.step, write=written)
            strands = regions.wireframe
    if not strands.strand_count:
        left_out = report.unprinted(strands.unprinted, None, settings)
        raise refusal(None, left_out, settings, None if partial else attempt)
    with clock.stage("toolpath"):
        if regions is not None:
            path = regions.toolpath
        else:
            path = toolpath(strands, settings, standing, at_mm)
    with clock.stage("gcode"):
        gcode, estimate = written(path) if regions is None else regions.written
    certificate = None
    if certify:
        with clock.stage("check"):
            if regions is None:
                certificate = judged(gcode)
            else:
                certificate = regions.verdict.compared(body, deviation=compare)
        if not certificate.ok:
            from wireprint.mending import mended

            with clock.stage("mend"):
                left = mended(strands, certificate, settings, standing, at_mm)
            if left is not None:
                strands, path = left, toolpath(left, settings, standing, at_mm)
                gcode, estimate = mended_file = written(path)
                certificate = judged(gcode)
                regions = regions and replace(
                    regions,
                    wireframe=strands,
                    toolpath=path,
                    written=mended_file,
                    verdict=certificate,
                )
    places = None
    if weak:
        from wireprint.weakness import find_weak

        with clock.stage("weak"):
            places = find_weak(gcode, settings)
    made = WirePrint(
        settings,
        body,
        strands,
        path,
        regions,
        gcode,
        estimate,
        certificate,
        clock.timings_s,
        orientation,
        place.turn_deg,
        places,
        planned,
    )
    if certificate is not None and not partial and not is_whole(certificate, settings):
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


def _onto(mesh: Mesh, settings: Settings, standing: Standing, at_mm: Point) -> Wireframe:
    """Return what is left to print of a model, part of which may stand already.

    Where some of it does, it is planned as if nothing stood, for what stands is its own; else clear
    of what stands.

    Raises
    ------
    UnprintableError
        Nothing is left.
    """
    plain = wireframe(mesh, settings)
    done = standing.printed_of(plain, origin_mm(settings, at_mm))
    if not done:
        return wireframe(mesh, settings, None, standing, at_mm)
    if len(done) == plain.strand_count:
        raise UnprintableError("all of it stands already: there is nothing left to print")
    return plain.beyond(done)


def _sketch(mesh: Mesh, plain: Wireframe, settings: Settings) -> Sketch:
    from wireprint.hybrid.sketch import Sketch

    return Sketch(mesh, plain, settings)


def to_gcode(
    toolpath: Toolpath,
    settings: Settings,
    *,
    date: datetime | None = None,
    remarks: Iterable[str] = (),
) -> bytes:
    """Return a whole G-code file: header, start, moves with progress, end, footer.

    Parameters
    ----------
    toolpath
        The moves.
    settings
        The settings that they were made with.
    date
        Written into the file; default: as `document.dated` without a file.
    remarks
        Lines of the header of their own.

    Returns
    -------
    bytes
        The text.

    Raises
    ------
    UnprintableError
        A figure of a move is not finite.
    """
    return _written(toolpath, settings, date, remarks).text


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
            other = make(mesh, remedy.settings, compare=False, orient=remedy.orient, partial=True)
            return other.certificate

        certificate = check(text, settings, mesh, deviation=False)
        if not is_whole(certificate, settings):
            bare = report.unprinted((), certificate.fidelity, settings)
            raise refusal(certificate, bare, settings, attempt)
    written_whole(Path(path), text)


def _written(
    path: Toolpath, settings: Settings, date: datetime | None, remarks: Iterable[str] = ()
) -> Written:
    # The pictures take as long as all the text: they are drawn beside it.
    thumbnails = _thumbnails(path, settings)
    return file.write(path, settings, date, thumbnails, remarks)


def _thumbnails(path: Toolpath, settings: Settings) -> Callable[[], list[Thumbnail]]:
    """Begin to draw the pictures; what is returned waits for them."""
    sizes = settings.printer.gcode.thumbnails
    if not sizes:
        return list
    from wireprint import view

    drawn = view.begin_thumbnails(view.strands_of(path, settings), sizes)
    # What is left of a size behind width and height is the picture's form.
    return lambda: [
        document.Thumbnail(*made, *size[2:]) for made, size in zip(drawn(), sizes, strict=True)
    ]

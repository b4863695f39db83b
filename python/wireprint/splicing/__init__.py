"""Wire put into another program's G-code, slab by slab between its layers, and judged as one file.

Each slab of the wire is begun once all layers that end below it are printed, and before those that
lie above: so the wire stands on what is below it, and carries what comes after it. The other
program's own lines are kept as they are; between them stand runs of ours, which find and leave the
printer as those lines expect it. Where wire comes last, the printer's own end sequence ends the
print, for the other program's does not know how high it has become.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.fitting import fitted
from wireprint.gcode import document
from wireprint.mending import ROUNDS
from wireprint.splicing.handover import Layers
from wireprint.splicing.runs import without_priming
from wireprint.splicing.supports import barred, carrying
from wireprint.stages import origin_mm, toolpath, wireframe
from wireprint.standing import Standing
from wireprint.stopped import Stopped, stopped_text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings
    from wireprint.verdict import Point

#: Distances between the strands of decks that are tried under layers, in strands, where these begin
#: or end beside wider ones.
_DECKS: Final = (2.5, 2.0, 1.5)
#: No less is a setting, mm.
_CLOSEST_MM: Final = 0.51


@dataclass(frozen=True, repr=False)
class Spliced:
    """A file that two programs made, with the verdict on the whole of it."""

    #: Those that it was made with.
    settings: Settings
    mesh: Mesh
    wireframe: Wireframe
    #: The whole file.
    gcode: bytes
    #: The verdict on it.
    certificate: Certificate
    print_time_s: float
    #: Heights at which wire was put in, mm, ascending.
    heights_mm: tuple[float, ...]
    #: What the other program left to chance, in sentences.
    remarks: tuple[str, ...]

    def __repr__(self) -> str:
        """Say what it comes to."""
        verdict = "certified" if self.certificate.ok else "not certified"
        return f"<Spliced at {len(self.heights_mm)} heights, {self.print_time_s:.0f} s, {verdict}>"


def splice(
    mesh: Mesh,
    layers: bytes,
    settings: Settings,
    *,
    supports: bool = False,
    at_mm: Point = (0.0, 0.0, 0.0),
    name: str = "the other file",
) -> Spliced:
    """Print a model as wire within the G-code of another program.

    Parameters
    ----------
    mesh
        What is wired: supports, a core, or a part of its own.
    layers
        The G-code of the other program, for the same printer and nozzle.
    settings
        Printer and material; start and end are the other file's own.
    supports
        Whether only what would carry the model is wire, for layers of the same model. Where the
        layers begin or end beside its strands, these are laid closer.
    at_mm
        Where the middle of the model's foot stands, from the middle of the bed, mm; its z is the
        height of the layers that it stands on.
    name
        What the other file is called in errors.

    Returns
    -------
    Spliced
        The file and its certificate, which may well find breaches.

    Raises
    ------
    SettingError
        The other file leaves the printer as no move of ours can be put there.
    UnprintableError
        The model does not fit, nothing of it can be printed, or the other file prints nothing.
    """
    best: Spliced | None = None
    for own in _with_decks(settings) if supports else (settings,):
        found = _spliced(mesh, layers, own, supports, at_mm, name)
        if found.certificate.ok:
            return found
        if best is None or _breaches(found) < _breaches(best):
            best = found
    return best or found


def _with_decks(settings: Settings) -> Iterator[Settings]:
    """Return the settings, and with closer decks: layers begin and end in more places on these."""
    yield settings
    for strands in _DECKS:
        spacing_mm = max(_CLOSEST_MM, strands * settings.strand_mm)
        if spacing_mm < settings.wire.cap_spacing_mm:
            wire = settings.wire.model_copy(update={"cap_spacing_mm": spacing_mm})
            yield settings.model_copy(update={"wire": wire})


def _breaches(found: Spliced) -> int:
    return sum(map(len, found.certificate.breaches().values()))


def _spliced(
    mesh: Mesh, layers: bytes, settings: Settings, supports: bool, at_mm: Point, name: str
) -> Spliced:
    given = Layers(layers, name, settings)
    below = None
    if at_mm[2] > 0:
        text = stopped_text(layers, Stopped(z_mm=at_mm[2]), settings)
        below = Standing(((name, text),), settings=settings)
    body = fitted(mesh, settings).mesh
    frame = wireframe(body, settings, None, below, at_mm, bearing=supports)
    if supports:
        frame = carrying(frame, body, settings.strand_mm)
    # Who wants supports alone does not ask how much of the model is wire.
    model = None if supports else body
    left_out = 0
    for _ in range(ROUNDS):
        path = without_priming(toolpath(frame, settings, below, at_mm))
        if not len(path):
            raise UnprintableError("nothing of the model can be printed as wire")
        text, heights = given.with_wire(path)
        certificate = check(text, settings, model, deviation=False, at_mm=at_mm)
        out = barred(frame, certificate, origin_mm(settings, at_mm)) if supports else []
        if not out or len(out) == frame.strand_count:
            break
        # What it is tied to is the model's own wire, which is not printed.
        left_out += len(out)
        frame = frame.beyond(out)
    remarks = list(given.remarks)
    if left_out:
        remarks.append(
            f"{left_out} strands of supports are left out where the layers need the room"
        )
    time_s = document.timing(text, settings).total_s
    return Spliced(settings, body, frame, text, certificate, time_s, heights, tuple(remarks))

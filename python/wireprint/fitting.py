"""How a model fits its printer: centred, turned about z if need be, or how large it may be."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint._core import UnprintableError

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.settings import Settings

#: Excess over the bed that is rounding, mm: far below the digits of G-code.
_ROUNDING_MM: Final = 1e-6
#: Digits of a turn in degrees, so that it can be told as it is used.
_DIGITS: Final = 4
#: Significant digits of the height that is proposed to what is too large.
_HEIGHT_DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class Placed:
    """A model where it is printed, about the bed's centre."""

    mesh: Mesh
    #: By how much it was turned about z to fit, degrees.
    turn_deg: float = 0.0

    def __str__(self) -> str:
        """Say how it was turned."""
        return f"turned by {self.turn_deg:g} degrees about z to fit the bed"


def placed(mesh: Mesh, settings: Settings) -> Placed:
    """Put a model where it fits the bed, if it does not as it stands.

    Parameters
    ----------
    mesh
        The model, its bounding box centred at x = y = 0.
    settings
        Their printer's bed counts.

    Returns
    -------
    Placed
        The same mesh where it fits, or where nothing helps. On a round bed else moved, so that the
        smallest circle around it is centred; on a rectangular one turned about z, as little as
        will do.
    """
    bed = settings.printer.bed
    if _lies_on(mesh, settings):
        return Placed(mesh)
    if bed.diameter_mm is not None:
        return Placed(mesh.centred_in_circle())
    least = mesh.turn_into(*bed.size_mm)
    if least is None:
        return Placed(mesh)
    # Rounded away from the last angle that does not fit; where that is too far, as it is.
    rounded = math.copysign(math.ceil(abs(least) * 10**_DIGITS) / 10**_DIGITS, least)
    for turn_deg in (rounded, least):
        turned = mesh.turned((0.0, 0.0, turn_deg))
        if _lies_on(turned, settings):
            return Placed(turned, turn_deg)
    return Placed(mesh)


def fits(mesh: Mesh, settings: Settings) -> bool:
    """Whether a model that was placed lies on the bed, and travels above it are in reach."""
    low_enough = mesh.size_mm[2] <= _height_mm(settings) + _ROUNDING_MM
    return low_enough and _lies_on(mesh, settings)


def fitted(mesh: Mesh, settings: Settings) -> Placed:
    """Put a model where it fits, as `placed` does, or say how large it may be.

    Raises
    ------
    UnprintableError
        It fits nowhere; the message names the greatest height at which it does, which was tried.
    """
    found = placed(mesh, settings)
    if fits(found.mesh, settings):
        return found
    printer = settings.printer
    width, depth, height = mesh.size_mm
    words = [
        f"the model ({width:.1f} × {depth:.1f} × {height:.1f} mm) does not fit the build volume of "
        f"{printer.name} ({printer.bed})"
    ]
    if height > _height_mm(settings):
        words.append(f" less the {settings.wire.travel_lift_mm:g} mm by which travels clear it")
    if printer.bed.shape == "rectangular" and not _lies_on(found.mesh, settings):
        words.append(", however it is turned about z")
    largest_mm = _largest_mm(mesh, settings)
    if largest_mm is not None:
        share = 100 * largest_mm / height
        words.append(f"; {share:.4g} % of its size does, which was tried: --height {largest_mm:g}")
    raise UnprintableError("".join(words))


def _largest_mm(mesh: Mesh, settings: Settings) -> float | None:
    """Return the greatest height, mm, at which a model fits; None where none is found."""
    bed, height = settings.printer.bed, mesh.size_mm[2]
    if bed.diameter_mm is not None:
        factor = bed.diameter_mm / 2 / mesh.centred_in_circle().reach_mm
    else:
        factor = mesh.scale_into(*bed.size_mm)
    largest = min(factor * height, _height_mm(settings))
    if not 0 < largest < math.inf:
        return None
    unit = 10.0 ** (math.floor(math.log10(largest)) + 1 - _HEIGHT_DIGITS)
    for short in (0, 1):
        tried = round((math.floor(largest / unit) - short) * unit, 9)
        if tried > 0 and fits(placed(mesh.scaled_to(tried), settings).mesh, settings):
            return tried
    return None


def _height_mm(settings: Settings) -> float:
    """Greatest height of a model above which the head can still travel, mm."""
    return settings.printer.bed.height_mm - settings.wire.travel_lift_mm


def _lies_on(mesh: Mesh, settings: Settings) -> bool:
    bed = settings.printer.bed
    if bed.diameter_mm is not None:
        return mesh.reach_mm <= bed.diameter_mm / 2 + _ROUNDING_MM
    width, depth, _ = mesh.size_mm
    return width <= bed.size_mm[0] + _ROUNDING_MM and depth <= bed.size_mm[1] + _ROUNDING_MM

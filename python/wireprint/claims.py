"""What a file may say of a printer that is known: nothing that makes its certificate weaker."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from wireprint import catalogue

if TYPE_CHECKING:
    from wireprint.settings import Settings
    from wireprint.settings.head import Head
    from wireprint.settings.printer import Bed, Printer

#: A head that reaches no less than another: which of two figures, of those that make its shape.
_LARGER: Final = {
    "tip_radius_mm": max,
    "slant_deg": min,
    "cone_height_mm": min,
    "block_radius_mm": max,
    "carriage_height_mm": min,
    "carriage_radius_mm": max,
}
#: Limits of the machine that a file may lower: group and key.
_LIMITS: Final = (("motion", "max_velocity"), ("extruder", "max_flow_mm3_s"))
#: Nozzles that are sold for most hot ends, mm; ``--nozzle`` fits them.
_NOZZLES_MM: Final = (0.25, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0)
_WAY_OUT: Final = "--printer names another"


def allowed(own: Settings) -> tuple[Settings, tuple[str, ...]]:
    """Return a file's own settings as far as its printer, if it is known, can be meant by them.

    A file cannot bring a head smaller than that of the printer that it names, nor a larger bed,
    higher limits, other macros or another way home: whoever has such a printer names it by himself.

    Returns
    -------
    settings
        What the file is judged by.
    remarks
        What was changed in them, in sentences.
    """
    if own.printer.name not in catalogue.names("printers"):
        return own, ()
    printer = own.printer
    known = _as_sold(own, printer.head.nozzle_mm)
    gcode = printer.gcode.model_copy(update={"macros": known.gcode.macros})
    changed: dict[str, Any] = {"homing": known.homing, "gcode": gcode}
    remarks = []
    head, smaller = _union(printer.head, known.head)
    changed["head"] = head
    if smaller:
        remarks.append(
            f"the file's own settings make the head smaller than that of {known.name} "
            f"({', '.join(smaller)}), whose head it is judged by; {_WAY_OUT}"
        )
    if not _holds(known.bed, printer.bed):
        changed["bed"] = known.bed
        remarks.append(
            f"the file's own settings make the build volume larger than that of {known.name} "
            f"({known.bed}), by which it is judged; {_WAY_OUT}"
        )
    changed |= _lowered(printer, known)
    if lowered := [f"{group}.{key}" for group, key in _LIMITS if group in changed]:
        remarks.append(
            f"the file's own settings raise limits of {known.name} ({', '.join(lowered)}), by "
            f"whose own it is judged; {_WAY_OUT}"
        )
    judged = own.model_copy(update={"printer": printer.model_copy(update=changed)})
    return judged, tuple(remarks)


def _as_sold(own: Settings, nozzle_mm: float) -> Printer:
    """Return the printer that a file names, with the nozzle that it names if such ones are made."""
    fitted = nozzle_mm if any(abs(nozzle_mm - one) < 1e-9 for one in _NOZZLES_MM) else None
    return own.load(own.printer.name, nozzle_mm=fitted).printer


def _union(own: Head, known: Head) -> tuple[Head, list[str]]:
    """Return a head that reaches as far as both, and where the first one reaches less."""
    figures = {
        key: larger(getattr(own, key), getattr(known, key)) for key, larger in _LARGER.items()
    }
    smaller = [
        f"head.{key} {getattr(own, key):g}, not {figure:g}"
        for key, figure in figures.items()
        if getattr(own, key) != figure
    ]
    missing = tuple(part for part in known.parts if part not in own.parts)
    smaller += [f"no {part}" for part in missing]
    return own.model_copy(update={**figures, "parts": (*own.parts, *missing)}), smaller


def _holds(known: Bed, own: Bed) -> bool:
    """Whether one build volume holds another."""
    if own == known:
        return True
    wider = (size > most for size, most in zip(own.size_mm, known.size_mm, strict=True))
    as_round = own.shape == known.shape or known.shape == "rectangular"
    same_place = own.origin == known.origin
    return same_place and as_round and own.height_mm <= known.height_mm and not any(wider)


def _lowered(own: Printer, known: Printer) -> dict[str, Any]:
    """Return the groups in which the file asks for more than the machine has, as it has them."""
    changed = {}
    for group, key in _LIMITS:
        most = getattr(getattr(known, group), key)
        if getattr(getattr(own, group), key) > most:
            changed[group] = getattr(own, group).model_copy(update={key: most})
    return changed

"""What the volumes of a 3MF file are for, in the words of the specification and of slicers."""

from __future__ import annotations

from enum import StrEnum
from typing import Final


class Role(StrEnum):
    """What a volume is for; the value is what people read."""

    PART = "part"
    NEGATIVE = "negative part"
    MODIFIER = "modifier"
    ENFORCER = "support enforcer"
    BLOCKER = "support blocker"
    SUPPORT = "support"
    OTHER = "object of type 'other'"
    UNKNOWN = "volume of an unknown kind"


#: Words of PrusaSlicer and its kin (``volume_type``), and of Bambu Studio and OrcaSlicer
#: (``subtype``).
_SLICERS: Final = {
    "ModelPart": Role.PART,
    "NegativeVolume": Role.NEGATIVE,
    "ParameterModifier": Role.MODIFIER,
    "SupportEnforcer": Role.ENFORCER,
    "SupportBlocker": Role.BLOCKER,
    "normal_part": Role.PART,
    "negative_part": Role.NEGATIVE,
    "modifier_part": Role.MODIFIER,
    "support_enforcer": Role.ENFORCER,
    "support_blocker": Role.BLOCKER,
}
#: Flags that Cura sets on meshes.
_CURA: Final = {
    "infill_mesh": Role.MODIFIER,
    "cutting_mesh": Role.MODIFIER,
    "anti_overhang_mesh": Role.BLOCKER,
    "support_mesh": Role.SUPPORT,
}
#: Types of objects, 3MF core specification 1.3, section 4.1.
_TYPES: Final = {
    "model": Role.PART,
    "surface": Role.PART,
    "support": Role.SUPPORT,
    "solidsupport": Role.SUPPORT,
    "other": Role.OTHER,
}


def of_slicer(word: str) -> Role:
    """Return the role of a volume by a slicer's word for it."""
    return _SLICERS.get(word, Role.UNKNOWN)


def of_object(kind: str, flag: str | None) -> Role:
    """Return the role of an object by its type, and by the flag that Cura may have set."""
    if flag is not None:
        return _CURA.get(flag, Role.UNKNOWN)
    return _TYPES.get(kind, Role.UNKNOWN)

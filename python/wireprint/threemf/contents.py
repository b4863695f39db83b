"""What a 3MF file holds, what of it is taken, and what is left out."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Final

from wireprint.threemf.roles import Role

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

#: Most names that a sentence tells, and most characters of one.
_MOST_NAMES: Final = 3
_MOST_CHARACTERS: Final = 40


@dataclass(frozen=True)
class Body:
    """A volume on the plate that is taken, or an item that is not."""

    name: str
    #: What it is for, or why it is left out.
    role: str
    triangles: int
    #: Copies of it.
    count: int


@dataclass(frozen=True)
class PlateContents:
    """What lies on a plate."""

    number: int
    name: str
    #: Names of the objects on it that are to be printed; may be empty.
    objects: tuple[str, ...]
    #: Whether it is the one that is taken.
    taken: bool


@dataclass(frozen=True)
class Contents:
    """What a file holds; of its bodies only those of the plate that is taken."""

    #: Empty where the file knows no plates.
    plates: tuple[PlateContents, ...]
    bodies: tuple[Body, ...]

    def sentences(self) -> list[str]:
        """Say what is not simply printed: other plates, what is cut out, what is left out."""
        return list(self._sentences())

    def _sentences(self) -> Iterator[str]:
        if len(self.plates) > 1:
            taken = next(plate.number for plate in self.plates if plate.taken)
            others = ", ".join(str(plate.number) for plate in self.plates if not plate.taken)
            yield f"plate {taken} alone is taken, of {len(self.plates)}; --plate takes {others}"
        counts: Counter[str] = Counter()
        names: dict[str, list[str]] = {}
        for body in self.bodies:
            counts[body.role] += body.count
            names.setdefault(body.role, []).append(body.name)
        for role, count in counts.items():
            if role != Role.PART:
                verb = "cut out" if role == Role.NEGATIVE else "left out"
                yield f"{verb}: {count} × {role}{_listed(names[role])}"

    def to_dict(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        return asdict(self)


def counted(found: Iterable[tuple[str, str, int]]) -> tuple[Body, ...]:
    """Count bodies by name, role and number of triangles, in the order in which they come."""
    return tuple(Body(*one, count) for one, count in Counter(found).items())


def shown(name: str) -> str:
    """Return a name as people may see it: not too long, and nothing that a terminal would obey."""
    return repr(name if len(name) <= _MOST_CHARACTERS else name[: _MOST_CHARACTERS - 1] + "…")


def _listed(names: list[str]) -> str:
    """Return the first names in parentheses; nothing where there is none."""
    known = [shown(name) for name in dict.fromkeys(names) if name]
    more = ", …" if len(known) > _MOST_NAMES else ""
    return f" ({', '.join(known[:_MOST_NAMES])}{more})" if known else ""

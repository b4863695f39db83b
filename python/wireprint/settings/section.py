"""What the groups of settings have in common."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

Millimetres = Annotated[float, Field(ge=0.1, le=2000)]


def _one_printable_line(name: str) -> str:
    """Refuse what would end a comment in G-code, or that a terminal would obey."""
    if not name.isprintable():
        raise ValueError("a name is one line of printable characters")
    return name


#: Written into comments of G-code, onto pages and into terminals.
Name = Annotated[str, Field(min_length=1, max_length=100), AfterValidator(_one_printable_line)]


class Section(BaseModel):
    """A group of settings: immutable, and no key passes that it does not know."""

    # A group's own validator is built only if it is used by itself: half the time at start.
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)

"""Records that are kept from print to print: nobody writes to their arrays."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

Value = TypeVar("Value")


class Record:
    """What frozen dataclasses have in common whose fields are arrays or other records."""

    def __post_init__(self: DataclassInstance) -> None:
        """Make all arrays read-only."""
        for field in fields(self):
            sealed(getattr(self, field.name))

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take over what a copy or a pickle holds, whose arrays could be written to."""
        vars(self).update(state)
        for value in state.values():
            sealed(value)

    def __repr__(self) -> str:
        """Say what it is; the parts are attributes."""
        return f"<{type(self).__name__}>"


def sealed(value: Value) -> Value:
    """Make an array read-only, or those of a tuple, list or dict; return what was given."""
    if hasattr(value, "setflags"):
        # An array; numpy is not imported where there is none.
        value.setflags(write=False)
    elif isinstance(value, tuple | list):
        for one in value:
            sealed(one)
    elif isinstance(value, dict):
        for one in value.values():
            sealed(one)
    return value

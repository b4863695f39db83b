"""What a page asks of its session."""

# No `from __future__ import annotations` here, for pydantic's sake; see `settings`.

from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from wireprint._core import SettingError
from wireprint.regions.document import MarkEntry

#: Most bytes of a message: a stroke of ten thousand points takes two.
MOST_BYTES: Final = 1 << 24
#: Most letters of a name or value.
_MOST_LETTERS: Final = 5000

_Number = Annotated[int, Field(ge=0, lt=2**53)]
_Name = Annotated[str, Field(max_length=100)]
#: What a setting may be; the settings themselves know more.
_Value = (
    bool
    | int
    | float
    | Annotated[str, Field(max_length=_MOST_LETTERS)]
    | Annotated[list[Any], Field(max_length=100)]
    | None
)


class _Message(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    #: The page's own number, which the answer repeats.
    id: _Number = 0


class Open(_Message):
    """Tell everything that a page needs."""

    do: Literal["open"]


class AddMark(_Message):
    """Mark something, after all other marks."""

    do: Literal["mark"]
    mark: MarkEntry
    name: _Name | None = None


class ChangeMark(_Message):
    """Change a mark; what is not given stays."""

    do: Literal["change"]
    number: _Number
    mark: MarkEntry | None = None
    name: _Name | None = None
    on: bool | None = None


class MoveMark(_Message):
    """Put a mark to another place in the order."""

    do: Literal["move"]
    number: _Number
    to: _Number


class DeleteMark(_Message):
    """Take a mark away."""

    do: Literal["delete"]
    number: _Number


class Undo(_Message):
    """Take back the last change."""

    do: Literal["undo"]


class Redo(_Message):
    """Do again what was taken back."""

    do: Literal["redo"]


class Set(_Message):
    """Change one setting."""

    do: Literal["set"]
    #: Dotted, from the top of the settings.
    key: Annotated[str, Field(pattern=r"^\w+(\.\w+)+$", max_length=200)]
    #: None: the profile's.
    value: _Value = None


class Profile(_Message):
    """Take another printer or material that comes with the package."""

    do: Literal["profile"]
    printer: _Name | None = None
    material: _Name | None = None


class Schema(_Message):
    """Tell what can be set."""

    do: Literal["schema"]


class Export(_Message):
    """Give a file."""

    do: Literal["export"]
    kind: Literal["gcode", "project", "strokes"]
    #: Whether G-code is wanted that breaks the rules, or leaves much of the model bare.
    force: bool = False


class Save(_Message):
    """Write a file beside the model."""

    do: Literal["save"]
    kind: Literal["gcode", "project", "strokes"]
    force: bool = False
    #: What was answered when a file was in the way, once the user let it be written over.
    over: _Name | None = None


class Send(_Message):
    """Send the G-code to a host of the user's."""

    do: Literal["send"]
    #: Its name in the user's configuration: a page gives no address.
    host: _Name
    #: Whether it shall be printed at once.
    start: bool = False
    #: What was answered when it was asked about the start, once the user agreed.
    sure: _Name | None = None


class Forecast(_Message):
    """Tell what the strands of the print would do, by a model."""

    do: Literal["forecast"]


class Picture(_Message):
    """Draw the print, for a browser that cannot."""

    do: Literal["picture"]
    azimuth_deg: Annotated[float, Field(ge=-360, le=360)]
    elevation_deg: Annotated[float, Field(ge=-90, le=90)]
    width: Annotated[int, Field(ge=16, le=4096)]
    height: Annotated[int, Field(ge=16, le=4096)]


Message = Annotated[
    Open
    | AddMark
    | ChangeMark
    | MoveMark
    | DeleteMark
    | Undo
    | Redo
    | Set
    | Profile
    | Schema
    | Export
    | Save
    | Send
    | Forecast
    | Picture,
    Field(discriminator="do"),
]
_ADAPTER: Final[TypeAdapter[Message]] = TypeAdapter(Message)


def read(content: bytes) -> Message:
    """Return the message of a JSON text.

    Raises
    ------
    SettingError
        It is none.
    """
    try:
        return _ADAPTER.validate_json(content)
    except ValidationError as error:
        fault = error.errors(include_url=False, include_input=False)[0]
        where = ".".join(str(part) for part in fault["loc"][1:])
        what = fault["msg"].removeprefix("Value error, ")
        raise SettingError(f"{where}: {what}" if where else what) from None

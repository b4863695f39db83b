"""Regions as JSON: ``strokes.json``."""

from pathlib import Path
from typing import Annotated, Any, Literal, Self, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from wireprint._core import SettingError, WireprintError
from wireprint.regions.mask import Mask
from wireprint.regions.region import Mark, Region, flattens
from wireprint.regions.shapes import Box, HalfSpace, Predicate, Sphere, ZRange
from wireprint.regions.stroke import Stroke

Model = TypeVar("Model", bound=BaseModel)

#: Most marks of a region.
MOST_MARKS = 10_000
#: Most bytes of a file: a mask of two million triangles.
MOST_BYTES = 1 << 26
#: Most commas, and so nearly most numbers, which take far more memory than their text does. A
#: mask's triangles are one string.
MOST_COMMAS = 1 << 20

AnyShape = Annotated[Box | Sphere | HalfSpace | ZRange | Stroke | Mask, Field(discriminator="kind")]
#: A number of a matrix; its scale is a unit's at most.
_Factor = Annotated[float, Field(ge=-1e9, le=1e9, allow_inf_nan=False)]
_Row = tuple[_Factor, _Factor, _Factor, _Factor]


class MarkEntry(BaseModel):
    """One mark."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    shape: AnyShape
    erase: bool = False
    #: Rows of the matrix that takes the shape to the model; None: it is there.
    frame: tuple[_Row, _Row, _Row] | None = None

    @model_validator(mode="after")
    def _frame_keeps_space(self) -> Self:
        if self.frame is not None and flattens(self.frame):
            raise ValueError("frame flattens space")
        return self


class Document(BaseModel):
    """Marks in order; lengths in mm, in the placed model's frame."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    format: Literal["wireprint-strokes"] = "wireprint-strokes"
    version: Literal[1] = 1
    marks: Annotated[tuple[MarkEntry, ...], Field(max_length=MOST_MARKS)] = ()

    @classmethod
    def of(cls, region: Region) -> "Document":
        """Return a region's document.

        Raises
        ------
        SettingError
            It has a predicate, which is a program and no data.
        """
        for mark in region.marks:
            if isinstance(mark.shape, Predicate):
                raise SettingError("a region with a predicate cannot be written to a file")
        entries = [{"shape": m.shape, "erase": m.erase, "frame": m.frame} for m in region.marks]
        return validated(cls, {"marks": entries}, "the region")

    def region(self) -> Region:
        """Return the region of the document."""
        return Region(tuple(Mark(entry.shape, entry.erase, entry.frame) for entry in self.marks))


def to_json(region: Region) -> bytes:
    """Return a region as JSON.

    Raises
    ------
    SettingError
        It has a predicate, or is too large.
    """
    content = Document.of(region).model_dump_json(indent=1, exclude_none=True).encode() + b"\n"
    check_size(content, "the region", SettingError)
    return content


def from_json(content: bytes, place: str) -> Region:
    """Return the region of a JSON document.

    Parameters
    ----------
    content
        What `to_json` gives, or was written by hand.
    place
        The file, for errors.

    Raises
    ------
    SettingError
        It is too large, no JSON, of another version, or a number is out of its bounds.
    """
    return validated(Document, content, place).region()


def read(path: Path) -> Region:
    """Return the region of a JSON file.

    Raises
    ------
    SettingError
        It cannot be read; see `from_json`.
    """
    try:
        with path.open("rb") as file:
            return from_json(file.read(MOST_BYTES + 1), str(path))
    except OSError as error:
        raise SettingError(f"{path}: {error.strerror}") from error


def check_size(content: bytes, place: str, fault: type[WireprintError]) -> None:
    """Refuse JSON that would take too much memory."""
    if len(content) > MOST_BYTES:
        raise fault(f"{place}: has more than {MOST_BYTES} bytes")
    if content.count(b",") > MOST_COMMAS:
        raise fault(f"{place}: has more than {MOST_COMMAS} numbers")


def validated(
    model: type[Model], value: bytes | Any, place: str, fault: type[WireprintError] = SettingError
) -> Model:
    """Validate JSON or Python data; the first error becomes a `fault` that tells where it is."""
    if isinstance(value, bytes):
        check_size(value, place, fault)
    try:
        if isinstance(value, bytes):
            return model.model_validate_json(value)
        return model.model_validate(value)
    except ValidationError as error:
        faults = error.errors(include_url=False, include_input=False)
        where = ".".join(str(part) for part in faults[0]["loc"])
        more = f" (and {len(faults) - 1} more)" if len(faults) > 1 else ""
        what = faults[0]["msg"].removeprefix("Value error, ")
        what = what[:1].lower() + what[1:]
        msg = f"{place}: {where}{': ' if where else ''}{what}{more}"
        raise fault(msg) from None

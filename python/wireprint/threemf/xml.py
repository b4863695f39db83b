"""XML read as a stream of tags, with a guard against hostile documents."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypeAlias
from xml.parsers import expat

from wireprint._core import ModelError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    Attributes: TypeAlias = dict[str, str]
    Starts: TypeAlias = dict[str, Callable[[Attributes], None]]
    Ends: TypeAlias = dict[str, Callable[[], None]]
    Tables: TypeAlias = tuple[Starts, Ends]

#: Most tags inside one another; a 3MF needs eight.
MOST_DEEP: Final = 32
#: Most bytes of one tag or comment; a triangle that was painted finely has some thousands.
MOST_TAG: Final = 1 << 22


def parse(chunks: Iterable[bytes], place: str, tables: Callable[[str], Tables]) -> None:
    """Hand each tag to what takes it in.

    A document type, the only place where entities can be defined, is refused, as 3MF asks for.

    Parameters
    ----------
    chunks
        The document, in pieces.
    place
        File and part, for errors.
    tables
        Given the namespace of the first tag, tells what takes in the starts, with their
        attributes, and the ends of tags. Their names are ``namespace name``, those of attributes
        without a namespace just ``name``.

    Raises
    ------
    ModelError
        The document is no well-formed XML, or hostile, or a tag's attributes make no sense.
    """
    deep = 0
    starts: Starts = {}
    ends: Ends = {}

    def opened(name: str, attributes: Attributes) -> None:
        nonlocal deep, starts, ends
        deep += 1
        if deep > MOST_DEEP:
            raise ModelError(f"{place}: its XML is nested more than {MOST_DEEP} deep")
        if not starts:
            starts, ends = tables(name.rpartition(" ")[0])
        take = starts.get(name)
        if take is not None:
            try:
                take(attributes)
            except KeyError as error:
                raise fault(name, f"has no attribute {error}") from error
            except (ValueError, OverflowError) as error:
                raise fault(name, f"makes no sense: {error}") from error

    def closed(name: str) -> None:
        nonlocal deep
        deep -= 1
        take = ends.get(name)
        if take is not None:
            take()

    def fault(name: str, text: str) -> ModelError:
        line, tag = parser.CurrentLineNumber, name.rpartition(" ")[2]
        return ModelError(f"{place}: line {line}: a <{tag}> {text}")

    def refuse(*_: object) -> None:
        raise ModelError(f"{place}: its XML has a document type, which 3MF forbids")

    parser = expat.ParserCreate(namespace_separator=" ")
    parser.StartElementHandler = opened
    parser.EndElementHandler = closed
    parser.StartDoctypeDeclHandler = refuse
    fed = 0
    try:
        for chunk in chunks:
            parser.Parse(chunk)
            fed += len(chunk)
            if fed - max(parser.CurrentByteIndex, 0) > MOST_TAG:
                raise ModelError(f"{place}: its XML has a tag of more than {MOST_TAG} bytes")
        parser.Parse(b"", True)
    except ModelError:
        raise
    except (expat.ExpatError, LookupError, ValueError) as error:  # the latter two: its encoding
        raise ModelError(f"{place}: its XML is damaged: {error}") from error

"""One model that is worked on: messages go in, answers and events come out."""

from __future__ import annotations

import sys
import traceback
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint import catalogue
from wireprint._core import SettingError, WireprintError
from wireprint.regions import document
from wireprint.regions.document import MarkEntry
from wireprint.window import messages, outputs, telling
from wireprint.window.answer import encoded
from wireprint.window.dispatch import Dispatch
from wireprint.window.foretelling import Foretelling
from wireprint.window.workshop import Workshop

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.regions import Mark
    from wireprint.window.history import History
    from wireprint.window.source import Source


class Session:
    """Answers the messages of windows on a model.

    Parameters
    ----------
    source
        The model and its settings.
    tell
        Takes events, from any thread: name and bytes.
    """

    def __init__(self, source: Source, tell: Callable[[str, bytes], None]) -> None:
        self._source = source
        self.workshop = Workshop(source, tell)
        self._dispatch = Dispatch(tell)
        self._foretelling = Foretelling(tell)

    def start(self) -> None:
        """Begin to read, print and watch the model."""
        self.workshop.start()

    def stop(self) -> None:
        """End the threads."""
        self.workshop.stop()

    def welcome(self) -> list[bytes]:
        """Return what a page is told first: what it may ask for, and all that is known."""
        return [telling.welcome(self._source, self._dispatch.offered()), *self.workshop.known()]

    def handle(self, content: bytes) -> bytes:
        """Do what a message asks, and return its answer; a fault is an answer, too."""
        number = 0
        try:
            message = messages.read(content)
            number = message.id
            return self._answer(message)
        except (WireprintError, OSError) as error:
            return encoded({"re": number, "error": str(error)})
        except Exception as error:
            traceback.print_exc(file=sys.stderr)
            kind = type(error).__name__
            return encoded({"re": number, "error": f"unexpected {kind}: a fault of wireprint"})

    def _answer(self, message: messages.Message) -> bytes:
        head: dict[str, Any] = {"re": message.id}
        match message:
            case messages.Open():
                return self.welcome()[0]
            case messages.Schema():
                from wireprint.window import panel

                return encoded({**head, "fields": panel.fields(), "sections": panel.SECTIONS})
            case messages.Export():
                file = np.frombuffer(self._content(message), np.uint8)
                name = outputs.name_of(message.kind, self._source.name)
                return encoded({**head, "name": name}, {"file": file})
            case messages.Save():
                return encoded({**head, **self._saved_beside(message)})
            case messages.Send():
                name = outputs.name_of("gcode", self._source.name)
                sent = self._dispatch.send(message, self.workshop.printed(), name)
                return encoded({**head, **sent})
            case messages.Forecast():
                revision, printed = self.workshop.newest()
                if printed is not None:
                    self._foretelling.ask(revision, printed, self.workshop.now()[2])
                return encoded({**head, "there": printed is not None})
            case messages.Picture(azimuth_deg=azimuth, elevation_deg=elevation):
                size = message.width, message.height
                png = outputs.picture(self.workshop.printed(), (azimuth, elevation), size)
                return encoded(head, {"file": np.frombuffer(png, np.uint8)})
            case _:
                return encoded({**head, **self._edited(message)})

    def _edited(self, message: messages.Message) -> dict[str, Any]:
        """Change the history, and ask for a new print."""
        number, revision = self.workshop.edit(lambda history: _change(history, message))
        added = {} if number is None else {"number": number}
        return added | {"revision": revision}

    def _content(self, message: messages.Export | messages.Save) -> bytes:
        """Return the bytes of a file.

        Raises
        ------
        UnprintableError
            G-code that breaks the rules or leaves much bare is only given by force.
        """
        mesh, state, settings = self.workshop.now()
        if message.kind == "strokes":
            return outputs.strokes(state)
        if message.kind == "project":
            return outputs.project(mesh, settings, state)
        return outputs.gcode(self.workshop.printed(), message.force)

    def _saved_beside(self, message: messages.Save) -> dict[str, Any]:
        """Write a file beside the model, or tell that another one is in the way."""
        path = self._source.path
        if path is None:
            raise SettingError("this model has no file, and so no place beside it")
        name = outputs.name_of(message.kind, self._source.name)
        return {
            "name": name,
            "exists": outputs.save(path, name, self._content(message), message.over),
        }


def _change(history: History, message: messages.Message) -> int | None:
    """Do what a message asks; return the number of a mark that was added."""
    match message:
        case messages.AddMark():
            return history.add(_mark(message.mark), message.name)
        case messages.ChangeMark(number=number, mark=entry, name=name, on=on):
            history.change(number, None if entry is None else _mark(entry), name, on)
        case messages.MoveMark():
            history.move(message.number, message.to)
        case messages.DeleteMark():
            history.delete(message.number)
        case messages.Undo():
            history.undo()
        case messages.Redo():
            history.redo()
        case messages.Set():
            history.set(message.key, message.value)
        case messages.Profile():
            _known("printers", message.printer)
            _known("materials", message.material)
            history.profile(message.printer, message.material)
    return None


def _known(kind: catalogue.Kind, name: str | None) -> None:
    """Refuse what is no profile of the package: files are not named by a page."""
    if name is not None and name not in catalogue.names(kind):
        raise SettingError(f"{name!r} is none of the {kind}")


def _mark(entry: MarkEntry) -> Mark:
    return document.Document(marks=(entry,)).region().marks[0]

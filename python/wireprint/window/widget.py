"""The window as a notebook's widget: the same program, told by the kernel's comm."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from importlib import resources
from typing import TYPE_CHECKING, Any

import anywidget
import traitlets

from wireprint.window import outputs
from wireprint.window.session import Session

if TYPE_CHECKING:
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.window.source import Source


class Widget(anywidget.AnyWidget):
    """A model, its print and the brush, in a notebook's cell.

    Parameters
    ----------
    source
        The model and its settings.
    height_px
        Height of the view, pixels.
    """

    _esm = resources.files("wireprint.window").joinpath("static", "studio.js").read_text("utf-8")
    height_px = traitlets.Int(560).tag(sync=True)

    def __init__(self, source: Source, height_px: int = 560) -> None:
        super().__init__(height_px=height_px)
        # Answers take their time, and come in the order of what was asked.
        self._hand = ThreadPoolExecutor(1, "answer")
        self._session = Session(source, lambda _, content: self._tell(content))
        self.on_msg(lambda _, content, __: self._hand.submit(self._answer, content))
        self._session.start()

    @property
    def region(self) -> Region:
        """What is marked now."""
        return self._session.workshop.now()[1].region

    @property
    def settings(self) -> Settings:
        """The settings as they are now."""
        return self._session.workshop.now()[2]

    def gcode(self, *, force: bool = False) -> bytes:
        """Return the G-code of what is marked now.

        Parameters
        ----------
        force
            Whether it is wanted even if it breaks the rules or leaves much of the model bare.

        Raises
        ------
        UnprintableError
            There is none, or it is not to be printed as it is.
        """
        return outputs.gcode(self._session.workshop.printed(), force)

    def close(self) -> None:
        """End the threads and the view."""
        self._session.stop()
        self._hand.shutdown(wait=False, cancel_futures=True)
        super().close()

    def _tell(self, content: bytes) -> None:
        self.send({}, buffers=[content])

    def _answer(self, content: Any) -> None:
        text = str(content)
        if _opens(text):
            for known in self._session.welcome():
                self._tell(known)
        else:
            self._tell(self._session.handle(text.encode()))


def _opens(text: str) -> bool:
    """Whether a view begins to listen, and wants to be told what is known."""
    try:
        message = json.loads(text)
    except ValueError:
        return False
    return isinstance(message, dict) and message.get("do") == "open"

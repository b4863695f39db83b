"""A window without a browser."""

import json
import threading
import time
from pathlib import Path

from wireprint.cli.marks import Marks
from wireprint.cli.options import Chosen
from wireprint.cli.studio import _source
from wireprint.window.answer import decoded
from wireprint.window.session import Session

#: How the command places a model unless it is told otherwise.
AS_IT_IS = {
    "file_format": None,
    "scale": 1.0,
    "units": "mm",
    "up": "z",
    "rotate": (0.0, 0.0, 0.0),
    "height_mm": None,
}
#: A window rests whose threads sleep at so many looks, each so long after the other, s.
_LOOKS, _APART_S = 10, 0.02
#: Longest that anything is waited for, s; nothing takes as long unless it is broken.
PATIENCE_S = 120.0


def source_of(path, overrides=(), fill=(), **placement):
    chosen = Chosen(None, None, (), tuple(overrides))
    marks = Marks(tuple(fill), (), (), ())
    return _source(Path(path), chosen, marks, AS_IT_IS | placement)


class Talk:
    """A session, and all that it told."""

    def __init__(self, source):
        self.told = []
        self.session = Session(source, lambda name, content: self.told.append((name, content)))

    def __enter__(self):
        self.session.start()
        self.wait("print")
        return self

    def __exit__(self, *_):
        self.session.stop()

    def ask(self, do, **values):
        content = json.dumps({"do": do, "id": 7, **values}).encode()
        head, arrays = decoded(self.session.handle(content))
        assert head.get("re", 7) in (7, 0)
        return head, arrays

    def edit(self, do, **values):
        """Change something, and wait for the print of it."""
        head, _ = self.ask(do, **values)
        assert "error" not in head, head["error"]
        self.wait("current", lambda one: one["revision"] >= head["revision"])
        return head

    def wait(self, event, fits=lambda _: True):
        """Return the newest event of a name whose head and arrays fit."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            for name, content in reversed(self.told):
                head, arrays = decoded(content)
                if name == event and fits(head | arrays):
                    return head, arrays
            time.sleep(0.01)
        raise AssertionError(f"no {event}; told {[name for name, _ in self.told]}")

    def rest(self):
        """Wait until nothing is done any more: after a print, the next one is prepared."""
        end, asleep = time.monotonic() + PATIENCE_S, 0
        while asleep < _LOOKS:
            assert time.monotonic() < end, "it never rests"
            time.sleep(_APART_S)
            asleep = asleep + 1 if _others_sleep() else 0

    def gcode(self, **values):
        head, arrays = self.ask("export", kind="gcode", **values)
        assert "error" not in head, head["error"]
        return arrays["file"].tobytes()


def _others_sleep():
    """Tell whether no thread but this one runs, or would if a processor were free; needs /proc."""
    own = threading.get_native_id()
    others = (task for task in Path("/proc/self/task").iterdir() if int(task.name) != own)
    return all(_sleeps(task) for task in others)


def _sleeps(task):
    """Tell whether a thread sleeps; one that has ended since it was listed does."""
    try:
        told = (task / "stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return True
    return told.rpartition(")")[2].split()[0] == "S"

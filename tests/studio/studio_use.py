"""A window's use over hours, in minutes: strokes, undo, printers, settings, files saved anew."""

import gc
import os
import random
import statistics
import time
from dataclasses import dataclass
from pathlib import Path

from studio_strokes import flank

from wireprint import examples

#: Printers and materials that are taken in turns.
_PROFILES = (("kossel-mini", "abs"), ("voron-2.4", "pla"), ("prusa-mk4s", "petg"))
#: What is done, and how often beside the others.
_DEEDS = {
    "paint": 8,
    "shape": 2,
    "undo": 5,
    "redo": 2,
    "delete": 2,
    "set": 1,
    "profile": 1,
    "save": 1,
}
#: Deeds at the beginning that are not compared: caches fill.
WARMING = 30
#: What it may grow by after that, MB.
MOST_MB = 50.0
#: Strokes of a probe: heights on the front of the cube, mm.
_PROBED_MM = (8.0, 11.0, 14.0, 17.0, 20.0)


@dataclass(frozen=True)
class Probe:
    """What the same few strokes take on the same model, whatever was done before."""

    #: Memory that the process holds while the window rests, MB.
    resident_mb: float
    #: Processor time of a stroke to its print, s, the median.
    stroke_s: float


def resident_mb():
    """Return the memory that this process holds, MB."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


class Use:
    """Random deeds in a window on a cube, each awaited."""

    def __init__(self, talk, model, seed):
        self.talk, self.model, self.random = talk, model, random.Random(seed)

    def probe(self):
        """Return what strokes take on the cube, on one printer and without any other mark."""
        self._save("cube")
        self.talk.edit("profile", printer=_PROFILES[0][0], material=_PROFILES[0][1])
        self.talk.edit("set", key="wire.skirt_rings", value=None)
        for number in self._marked():
            self.talk.edit("delete", number=number)
        strokes_s = []
        for z_mm in _PROBED_MM:
            self.talk.rest()
            begin = time.process_time()
            self.talk.edit("mark", mark={"shape": flank(z_mm), "erase": False})
            strokes_s.append(time.process_time() - begin)
        self.talk.rest()
        self._forget()
        return Probe(resident_mb(), statistics.median(strokes_s))

    def deed(self):
        """Do something, and wait for its print."""
        kinds = list(_DEEDS)
        name = self.random.choices(kinds, [_DEEDS[kind] for kind in kinds])[0]
        getattr(self, f"_{name}")()
        self._forget()

    def _forget(self):
        """Forget all but the newest event of each kind, as a page does."""
        known = len(self.talk.told)
        newest = {name: (name, event) for name, event in self.talk.told[:known]}
        self.talk.told[:known] = newest.values()

    def _marked(self):
        return [item["number"] for item in self.talk.wait("state")[0]["items"]]

    def _paint(self):
        shape = flank(self.random.uniform(6, 22), self.random.uniform(2, 5))
        mark = {"shape": shape, "erase": self.random.random() < 0.2}
        self.talk.edit("mark", mark=mark)
        # Not more than a user would keep.
        if len(self._marked()) > 6:
            self._delete()

    def _shape(self):
        low = self.random.uniform(2, 18)
        self.talk.edit("mark", mark={"shape": {"kind": "z", "low_mm": low, "high_mm": low + 5}})

    def _undo(self):
        if self.talk.wait("state")[0]["can_undo"]:
            self.talk.edit("undo")

    def _redo(self):
        if self.talk.wait("state")[0]["can_redo"]:
            self.talk.edit("redo")

    def _delete(self):
        for number in self._marked()[:1]:
            self.talk.edit("delete", number=number)

    def _set(self):
        now = self.talk.wait("state")[0]["settings"]["wire.skirt_rings"]
        self.talk.edit("set", key="wire.skirt_rings", value=(now + 1) % 4)

    def _profile(self):
        now = self.talk.wait("state")[0]["printer"]
        printer, material = self.random.choice([one for one in _PROFILES if one[0] != now])
        self.talk.edit("profile", printer=printer, material=material)

    def _save(self, name=None):
        """Save the model anew, mostly as another one."""
        name = name or self.random.choice(("cube", "sphere"))
        self.model.write_bytes(examples.stl(name))
        state, _ = self.talk.wait("state")
        revision = state["revision"]
        # The same bytes within one tick of the clock are no change.
        os.utime(self.model, ns=(time.time_ns(), time.time_ns()))
        self.talk.wait("current", lambda one: one["revision"] > revision)

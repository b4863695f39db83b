"""Prints of our own on every printer, which tests damage line by line."""

import re
import tempfile
from functools import cache
from pathlib import Path

import wireprint
from wireprint import Settings, examples

#: One of each kind of machine and firmware.
PRINTERS = ["kossel-mini", "printrbot-simple", "prusa-mk4s", "voron-2.4"]
LABEL = re.compile(r";TYPE:(\w+)")


@cache
def lines_of(printer, model="cube"):
    """The lines of a certified print, from 0."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{model}.stl"
        path.write_bytes(examples.stl(model))
        mesh = wireprint.load_mesh(path)
    text = wireprint.make(mesh, Settings.load(printer), compare=False).gcode
    return tuple(text.decode().split("\n"))


@cache
def strands_of(printer, label=None, model="cube"):
    """Indices of the lines that lay strands under a label, in order."""
    found, current = [], None
    for index, line in enumerate(lines_of(printer, model)):
        if match := LABEL.match(line):
            current = match[1]
        if re.match(r"G1 [XYZ].* E[\d.]", line) and current and label in (None, current):
            found.append(index)
    return tuple(found)


def within(printer, share):
    """Index of a strand's line: from the second at 0 to the last at 1."""
    found = strands_of(printer)
    return found[1 + int(share * (len(found) - 2))]


def judge(lines, printer):
    """The verdict on lines, by a printer's own profile."""
    return wireprint.check("\n".join(lines).encode(), printer)


def first_line(found):
    """The first line that a verdict names."""
    return min(breach.line for breaches in found.breaches().values() for breach in breaches)

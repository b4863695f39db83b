"""Ways to evaluate a model that only tests need; workers import them from here."""

import os
import time

#: Width of the cube that is fatal to its worker, mm.
FATAL_MM = 13.0


def quick(model, settings, row):
    """Tell the width alone."""
    row["size_x_mm"] = model.mesh.size_mm[0]


def slow(model, settings, row):
    """Take long enough for somebody to interfere."""
    time.sleep(0.3)
    quick(model, settings, row)


def fatal(model, settings, row):
    """Die of one model, as a worker does that runs out of memory."""
    if abs(model.mesh.size_mm[0] - FATAL_MM) < 1e-3:
        os._exit(9)
    slow(model, settings, row)


def endless(model, settings, row):
    """Never come back from one model."""
    if abs(model.mesh.size_mm[0] - FATAL_MM) < 1e-3:
        time.sleep(600)
    quick(model, settings, row)


def faulty(model, settings, row):
    """Fail in a way that nobody foresaw."""
    quick(model, settings, row)
    raise ZeroDivisionError("by zero")

"""How many threads and processes to use."""

from __future__ import annotations

import os


def cores() -> int:
    """Count the cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def workers() -> int:
    """Return how many threads the core may use, too: one variable limits both."""
    limit = os.environ.get("RAYON_NUM_THREADS", "")
    if limit.isdecimal() and int(limit):
        return int(limit)
    return cores()

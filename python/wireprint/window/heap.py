"""Memory that is free, given back to the system while a window waits.

Prints are made by several threads, and the C library's allocator keeps what each of them frees for
more of the same: a window would seem to grow by tens of megabytes that hold nothing.
"""

from __future__ import annotations

import ctypes
import sys


def give_back() -> None:
    """Give free memory back, where the C library can: glibc's ``malloc_trim``."""
    if not sys.platform.startswith("linux"):
        return
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)

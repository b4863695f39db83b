"""Times as people read them."""

from __future__ import annotations


def duration(seconds: float) -> str:
    """Write a time as people read it: ``2:26`` or ``1:59:07``."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"

"""Files that are either written whole or not at all."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path


def written_whole(path: Path, content: bytes) -> None:
    """Write a file aside and rename it into place; nothing is left behind on failure.

    Parameters
    ----------
    path
        Where the file shall stand; an older one there is replaced.
    content
        The whole of it.
    """
    aside = path.with_name(f".{path.name}.{os.urandom(4).hex()}.part")
    try:
        aside.write_bytes(content)
        os.replace(aside, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        error.filename = os.fspath(path)
        error.filename2 = None
        raise

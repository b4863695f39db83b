"""Errors that name the file they are about."""

from __future__ import annotations

import os
from contextlib import contextmanager
from typing import TYPE_CHECKING

from wireprint._core import WireprintError

if TYPE_CHECKING:
    from collections.abc import Iterator


@contextmanager
def named(
    path: str | os.PathLike[str] | None, kind: type[WireprintError] = WireprintError
) -> Iterator[None]:
    """Put a file's name, if there is one, before errors of a kind that do not begin with it."""
    try:
        yield
    except kind as error:
        if path is None or str(error).startswith(os.fspath(path)):
            raise
        name = os.fspath(path)
        raise type(error)(f"{name}: {error}") from error

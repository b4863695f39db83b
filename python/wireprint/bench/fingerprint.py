"""What code a worker would run: rows of different code do not belong in one table."""

from __future__ import annotations

import hashlib
from pathlib import Path


def fingerprint() -> tuple[str, str]:
    """Return the version of wireprint and a hash over all of its code and profiles."""
    import wireprint

    digest = hashlib.sha256()
    package = Path(wireprint.__file__).parent
    for path in sorted(package.rglob("*")):
        if path.suffix in {".py", ".toml", ".so", ".pyd", ".html"} and path.is_file():
            digest.update(path.relative_to(package).as_posix().encode())
            digest.update(path.read_bytes())
    return wireprint.__version__, digest.hexdigest()[:16]

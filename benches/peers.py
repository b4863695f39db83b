"""The programs that benchmarks measure against."""

import os
import shutil

import pytest

from shared_models import SHARED


def cura_wire():
    """Return the command that runs CuraEngine's wire mode; a test skips where that is absent."""
    script = SHARED / "peers" / "cura_wire.sh"
    if not (shutil.which("CuraEngine") and script.exists() and "CURA_DEFS_HOME" in os.environ):
        pytest.skip("CuraEngine, its script or CURA_DEFS_HOME is absent")
    return ["bash", script]

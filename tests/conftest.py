"""Fixtures for all tests."""

import os
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def shared():
    """The folder of shared models and golden files, which is no part of the project."""
    default = Path(__file__).parents[2] / "shared"
    folder = Path(os.environ.get("WIREPRINT_SHARED", default))
    if not folder.is_dir():
        pytest.skip(f"{folder} is absent; set WIREPRINT_SHARED")
    return folder

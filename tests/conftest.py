"""Fixtures for all tests."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import settings

from wireprint import examples

# A busy machine makes no test wrong.
# CI takes the same examples at every run: what it refuses, it refuses for a reason in the change.
settings.register_profile("patient", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("patient")


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory):
    """Keep the tests' settings out of the user's cache, and the user's defaults out of them."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setenv("XDG_CONFIG_HOME", str(tmp_path_factory.mktemp("config")))
        yield


@pytest.fixture(scope="session")
def shared():
    """The folder of shared models and golden files, which is no part of the project."""
    default = Path(__file__).parents[2] / "shared"
    folder = Path(os.environ.get("WIREPRINT_SHARED", default))
    if not folder.is_dir():
        pytest.skip(f"{folder} is absent; set WIREPRINT_SHARED")
    return folder


@pytest.fixture
def cube(tmp_path):
    """A cube of 28 mm as a file of the test's own."""
    model = tmp_path / "cube.stl"
    model.write_bytes(examples.stl("cube"))
    return model


@pytest.fixture(scope="session")
def cube_stl(tmp_path_factory):
    """The same as a file that no test may change."""
    model = tmp_path_factory.mktemp("models") / "cube.stl"
    model.write_bytes(examples.stl("cube"))
    return model


@pytest.fixture(scope="session")
def run_python():
    """Run code in an interpreter of its own and return what it prints."""

    def run(code):
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run

"""Measurements run only when they are asked for."""

import pytest
import trimesh


def pytest_collection_modifyitems(config, items):
    """Skip what measures before any fixture of it is made."""
    if config.getoption("benchmark_enable"):
        return
    skip = pytest.mark.skip(reason="a measurement: run with --benchmark-enable")
    for item in items:
        if "benchmark" in getattr(item, "fixturenames", ()):
            item.add_marker(skip)


@pytest.fixture(scope="session")
def million(tmp_path_factory):
    """A binary STL of 1.31 million facets, in the incoherent order of repeated subdivision."""
    path = tmp_path_factory.mktemp("bench") / "sphere.stl"
    trimesh.creation.icosphere(subdivisions=8, radius=39).export(path)
    return path

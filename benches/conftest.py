"""Measurements run only when they are asked for."""

import pytest


def pytest_collection_modifyitems(config, items):
    """Skip what measures before any fixture of it is made."""
    if config.getoption("benchmark_enable"):
        return
    skip = pytest.mark.skip(reason="a measurement: run with --benchmark-enable")
    for item in items:
        if "benchmark" in getattr(item, "fixturenames", ()):
            item.add_marker(skip)

"""Fixtures for the window's tests."""

import pytest
from studio_talk import Talk, source_of


@pytest.fixture
def source(cube):
    return source_of(cube)


@pytest.fixture
def talk(source):
    with Talk(source) as talk:
        yield talk

"""Fixtures for the window's tests."""

import pytest
from studio_page import FLAGS, browser_or_skip
from studio_talk import Talk, source_of


# No longer than a module: one thread has one player, and others want their own.
@pytest.fixture(scope="module")
def browser():
    playwright = pytest.importorskip("playwright.sync_api")
    path = browser_or_skip()
    with playwright.sync_playwright() as player:
        launched = player.chromium.launch(executable_path=path, args=list(FLAGS))
        yield launched
        launched.close()


@pytest.fixture
def source(cube):
    return source_of(cube)


@pytest.fixture
def talk(source):
    with Talk(source) as talk:
        yield talk

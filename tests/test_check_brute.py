"""The certificate of random files against a judge by brute force that shares no code with it.

``tests/fuzz/check_brute.py`` does the same with hundreds of files.
"""

import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parent / "fuzz"))

import check_brute
from brute import Judge

from wireprint.rules import rules_of

RULES = {"collisions", "floating_starts", "dangling_ends", "spans_over", "hurried", "underfed"}


@pytest.fixture(scope="module")
def cases(tmp_path_factory):
    folder = tmp_path_factory.mktemp("brute")
    return [check_brute.case(seed, folder) for seed in range(24)]


def test_nothing_is_missed_and_nothing_made_up(cases):
    assert [check_brute.differences(*case) for case in cases] == [[]] * len(cases)


def test_the_random_files_break_every_rule_of_geometry(cases):
    found = set()
    for lines, settings in cases:
        verdict = Judge(lines, settings, rules_of(settings)).judge()
        found |= {rule for rule, at in verdict.found.items() if at}
    assert found >= RULES

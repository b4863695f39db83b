"""The targets of cargo-fuzz: each is built, has its seeds and its words."""

import sys
import tomllib
from pathlib import Path

FUZZ = Path(__file__).parents[1] / "rust/fuzz"
sys.path.append(str(Path(__file__).parent / "fuzz"))


def targets():
    return {
        one["name"]: one["path"] for one in tomllib.loads((FUZZ / "Cargo.toml").read_text())["bin"]
    }


def test_every_target_is_built():
    files = {f"fuzz_targets/{path.name}" for path in (FUZZ / "fuzz_targets").iterdir()}
    assert files == set(targets().values())


def test_every_target_has_seeds():
    from seeds import seeds

    found = seeds()
    assert set(found) == set(targets())
    assert all(all(files) for files in found.values())

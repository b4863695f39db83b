"""Every number among the settings is held between bounds that a machine can have."""

import json

import pytest
from annotated_types import Ge, Gt, Le, Lt
from pydantic import BaseModel

from command import run
from wireprint import SettingError
from wireprint.pipeline import make
from wireprint.settings import Settings


def numbers(model, prefix=""):
    """Dotted key and field of every number, those in tuples and sections included."""
    for name, field in model.model_fields.items():
        yield from _numbers(field.annotation, field.metadata, f"{prefix}{name}")


def _numbers(annotation, metadata, key):
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield from numbers(annotation, f"{key}.")
        return
    if annotation in (int, float):
        yield key, metadata
        return
    inner = getattr(annotation, "__metadata__", ())
    arguments = getattr(annotation, "__args__", ())
    if hasattr(annotation, "__origin__") and inner:
        yield from _numbers(annotation.__origin__, [*metadata, *inner], key)
        return
    for one in arguments:
        if one is not Ellipsis and one is not type(None):
            yield from _numbers(one, metadata, key)


def constraints(metadata):
    for one in metadata:
        yield one
        yield from getattr(one, "metadata", ())


def test_every_number_has_a_bound_on_either_side():
    found = dict(numbers(Settings))
    assert len(found) > 100
    for key, metadata in found.items():
        kinds = list(constraints(metadata))
        assert any(isinstance(one, Ge | Gt) for one in kinds), f"{key} has no lower bound"
        assert any(isinstance(one, Le | Lt) for one in kinds), f"{key} has no upper bound"


def test_no_length_or_speed_may_be_as_small_as_it_likes():
    for key, metadata in numbers(Settings):
        if key.endswith(("_mm", "_mm_s", "_velocity", "_accel")):
            lower = [one for one in constraints(metadata) if isinstance(one, Ge | Gt)]
            assert all(isinstance(one, Ge) or one.gt > 0 for one in lower), key


@pytest.mark.parametrize(
    "key",
    [
        "head.cone_height_mm=1e-300",
        "wire.slab_min_mm=1e-3",
        "motion.endstop_height=1e308",
        "layerwise.layer_height_mm=1e-9",
        "speeds.print_mm_s=1e-300",
        "layerwise.frame.pitch_mm=1e-6",
    ],
)
def test_absurd_numbers_are_refused_by_key(key):
    with pytest.raises(SettingError, match=key.split("=")[0].split(".")[-1]):
        Settings.load(overrides=[key])


@pytest.mark.parametrize(
    ("printer", "overrides"),
    [("kossel-mini", ["speeds.print_mm_s=60"]), ("prusa-mk4s", ["head.nozzle_mm=1.0"])],
)
def test_what_the_hot_end_does_not_melt_is_printed_more_slowly(cube, printer, overrides):
    target = cube.with_suffix(".gcode")
    options = [argument for key in overrides for argument in ("--set", key)]
    done = run("slice", cube, "-o", target, "--printer", printer, "--json", *options)
    assert done.exit_code == 0, done.output
    figures = json.loads(done.stdout)
    assert figures["certified"]
    assert any("more than the hot end melts" in note for note in figures["warnings"])


def test_a_speed_within_the_flow_limit_is_kept(cube):
    from wireprint.mesh import load_mesh

    settings = Settings.load()
    assert settings.print_mm_s == settings.printer.speeds.print_mm_s
    assert make(load_mesh(cube), settings).figures()["warnings"] == []

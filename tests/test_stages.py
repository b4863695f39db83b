"""Settings reach the core by their own names: nothing is missing, nothing is left over."""

from __future__ import annotations

import pytest
import trimesh

from wireprint import _core, stages
from wireprint._core import SettingError
from wireprint.settings import Settings

SETTINGS = Settings.load()
#: What is none by default need not be given.
MAY_BE_NONE = {"climb", "brim_rings"}


@pytest.fixture(scope="module")
def mesh():
    box = trimesh.creation.box((10.0, 10.0, 10.0))
    return _core.Mesh.from_arrays(box.vertices, box.faces)


def _wire():
    return SETTINGS.wire.model_dump() | stages._of_wire(SETTINGS)


def _path():
    own = (SETTINGS.wire, SETTINGS.printer.speeds, SETTINGS.printer.extruder)
    given = {name: value for section in own for name, value in section.model_dump().items()}
    return given | stages._of_path(SETTINGS)


def _without(values, name):
    return {key: value for key, value in values.items() if key != name}


@pytest.mark.parametrize("name", sorted(stages._of_wire(SETTINGS).keys() - MAY_BE_NONE))
def test_the_wireframe_takes_all_that_is_resolved_for_it(mesh, name):
    head = SETTINGS.printer.head.model_dump()
    with pytest.raises(SettingError, match=f"missing field `{name}`"):
        _core.wireframe(mesh, head, _without(_wire(), name))


@pytest.mark.parametrize("name", sorted(stages._of_path(SETTINGS).keys() - MAY_BE_NONE))
def test_the_toolpath_takes_all_that_is_resolved_for_it(mesh, name):
    wireframe = stages.wireframe(mesh, SETTINGS)
    with pytest.raises(SettingError, match=f"missing field `{name}`"):
        _core.toolpath(wireframe, _without(_path(), name))


def test_a_word_that_the_core_does_not_know_is_told_with_those_it_knows(mesh):
    head = SETTINGS.printer.head.model_dump()
    with pytest.raises(SettingError, match=r"`spiral`.*`zigzag`.*`peaks`"):
        _core.wireframe(mesh, head, _wire() | {"pattern": "spiral"})


def test_a_value_of_another_kind_is_refused(mesh):
    head = SETTINGS.printer.head.model_dump()
    with pytest.raises(SettingError, match="must be real number"):
        _core.wireframe(mesh, head, _wire() | {"span_limit_mm": "far"})


def test_a_head_that_none_can_be_is_refused_by_the_core_as_well(mesh):
    head = SETTINGS.printer.head.model_dump() | {"slant_deg": 90.0}
    with pytest.raises(SettingError, match="slant"):
        _core.wireframe(mesh, head, _wire())

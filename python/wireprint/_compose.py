"""Settings from profiles, files and single keys, with errors that name key, file and line."""

from __future__ import annotations

import difflib
import tomllib
from pathlib import Path
from types import UnionType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError

from wireprint import lineage, nozzles, toml
from wireprint._core import SettingError
from wireprint.toml import Key

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from wireprint import catalogue

Model = TypeVar("Model", bound=BaseModel)
Origins: TypeAlias = dict[Key, str]


def compose(
    model: type[Model],
    base: dict[str, Any],
    printer: str | None,
    material: str | None,
    load: Iterable[str | Path],
    overrides: Iterable[str],
    nozzle_mm: float | None = None,
) -> Model:
    """Merge the layers from left to right and validate the result.

    A printer or material takes the whole place of that of the base; a nozzle comes after them.
    """
    values = dict(base)
    origins: Origins = {}
    if printer is not None:
        values.pop("printer", None)
        _add_profile(values, origins, "printers", printer)
    if material is not None:
        values.pop("material", None)
        _add_profile(values, origins, "materials", material)
    if nozzle_mm is not None:
        _add_nozzle(values, origins, nozzle_mm)
    for path in load:
        _add_loaded(model, values, origins, Path(path))
    for override in overrides:
        _add_override(model, values, origins, override)
    return validate(model, values, origins)


def validate(model: type[Model], values: Mapping[str, Any], origins: Origins) -> Model:
    """Validate a mapping; the first fault becomes a `SettingError`."""
    try:
        return model.model_validate(values)
    except ValidationError as error:
        # An unknown key is often why another one is missing.
        unknown = "extra_forbidden"
        faults = sorted(error.errors(include_url=False), key=lambda fault: fault["type"] != unknown)
        key = tuple(str(part) for part in faults[0]["loc"])
        more = f" (and {len(faults) - 1} more)" if len(faults) > 1 else ""
        if faults[0]["type"] == unknown:
            what = f"unknown key{_suggestion(model, key)}"
        else:
            what = faults[0]["msg"].removeprefix("Value error, ")
            what = what[:1].lower() + what[1:]
        msg = f"{_place(origins, key)}{_shown(model, key)}{what}{more}"
        raise SettingError(msg) from None


def _add_profile(values: dict[str, Any], origins: Origins, kind: catalogue.Kind, name: str) -> None:
    prefix = (kind.removesuffix("s"),)
    for file in lineage.generations(kind, name):
        toml.merge(values, _nest(prefix, file.table))
        origins[prefix] = f"{file.path.name}: "
        for key, line in file.lines.items():
            _note(origins, prefix + key, f"{file.path.name}:{line}: ")


def _add_nozzle(values: dict[str, Any], origins: Origins, nozzle_mm: float) -> None:
    """Lay over a printer what another nozzle changes."""
    for key, value in nozzles.changed(values.get("printer"), nozzle_mm).items():
        toml.merge(values, _nest(("printer", *key), value))
        _note(origins, ("printer", *key), f"--nozzle {nozzle_mm:g}: ")


def _add_loaded(
    model: type[BaseModel], values: dict[str, Any], origins: Origins, path: Path
) -> None:
    text, table = toml.read(path)
    lines = dict(toml.lines_of_keys(text))
    for name, value in table.items():
        place = f"{path.name}:{lines.get((name,), 1)}: "
        key = _anchor(model, (name,), place)
        toml.merge(values, _nest(key, value))
    for key, line in lines.items():
        place = f"{path.name}:{line}: "
        _note(origins, _anchor(model, key, place), place)


def _add_override(
    model: type[BaseModel], values: dict[str, Any], origins: Origins, override: str
) -> None:
    name, equals, text = override.partition("=")
    place = f"--set {override}: "
    if not equals or not name.strip():
        msg = f"{place}expected key=value"
        raise SettingError(msg)
    key = _anchor(model, tuple(name.strip().split(".")), place)
    toml.merge(values, _nest(key, _value(text.strip())))
    _note(origins, key, place)


def _note(origins: Origins, key: Key, place: str) -> None:
    """Keep where a key was given; keys stand in the order in which they were given last."""
    origins.pop(key, None)
    origins[key] = place


def _value(text: str) -> Any:
    """Return a value as TOML reads it; a bare word is a string."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        return text


def _anchor(model: type[BaseModel], key: Key, place: str) -> Key:
    """Full key from the top of the settings: a printer's tables may stand without ``printer.``."""
    fields = model.model_fields
    if key[0] in fields:
        return key
    printer = _model_in(fields["printer"].annotation)
    if printer is not None and key[0] in printer.model_fields:
        return ("printer", *key)
    full = [path for path in _leaves(model) if path[-len(key) :] == key]
    if len(full) == 1:
        return full[0]
    shown = ".".join(key)
    if full:
        candidates = " or ".join(_dotted(model, path) for path in full)
        msg = f"{place}{shown} is ambiguous: {candidates}?"
    else:
        msg = f"{place}unknown key {shown}{_suggestion(model, key)}"
    raise SettingError(msg)


def keys(model: type[BaseModel]) -> list[str]:
    """Return every key as a user writes it."""
    return [_dotted(model, path) for path in _leaves(model)]


def _leaves(model: type[BaseModel], prefix: Key = ()) -> list[Key]:
    keys: list[Key] = []
    for name, field in model.model_fields.items():
        below = _model_in(field.annotation)
        keys += [(*prefix, name)] if below is None else _leaves(below, (*prefix, name))
    return keys


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """Return the model of an annotation ``M`` or ``M | None``; a list of models has none."""
    either = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else ()
    for candidate in (annotation, *either):
        if isinstance(candidate, type) and issubclass(candidate, BaseModel):
            return candidate
    return None


def _suggestion(model: type[BaseModel], key: Key) -> str:
    """Keys that look like this one: first among all full keys, then by the last part alone."""
    leaves = {_dotted(model, path): path for path in _leaves(model)}
    close = difflib.get_close_matches(_dotted(model, key), leaves, n=2, cutoff=0.75)
    if not close:
        tails = {path[-1]: dotted for dotted, path in leaves.items()}
        close = [tails[name] for name in difflib.get_close_matches(key[-1], tails, n=2)]
    return f"; did you mean {' or '.join(close)}?" if close else ""


def _shown(model: type[BaseModel], key: Key) -> str:
    return f"{_dotted(model, key)}: " if key else ""


def _dotted(model: type[BaseModel], key: Key) -> str:
    """Return the key as a user writes it, without the ``printer.`` that may be left out."""
    may_leave_out = len(key) > 1 and key[0] == "printer" and "printer" in model.model_fields
    if key == ("printer", "name"):  # A material has one, too.
        may_leave_out = False
    return ".".join(key[1:] if may_leave_out else key)


def _place(origins: Origins, key: Key) -> str:
    """Where the key, or else the innermost table around it, was given.

    What is wrong with a table as a whole is laid to what was put into it last.
    """
    for length in range(len(key), 0, -1):
        within = [place for given, place in origins.items() if given[:length] == key[:length]]
        if within:
            whole, last = origins.get(key[:length], ""), within[-1]
            return whole if whole.partition(":")[0] == last.partition(":")[0] else last
    return ""


def _nest(key: Key, value: Any) -> dict[str, Any]:
    for part in reversed(key):
        value = {part: value}
    nested: dict[str, Any] = value
    return nested

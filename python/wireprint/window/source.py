"""Where a window's model and settings come from."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from datetime import datetime
    from pathlib import Path

    from wireprint.model import Model
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Source:
    """A model, and how it is read."""

    #: What it is called: its file's name.
    name: str
    #: Its file, which is watched, and beside which others can be written; None: it has none.
    path: Path | None
    #: Reads the file, places the model, and adds what is marked on it.
    load: Callable[[], Model]
    #: Settings for a printer and a material by name (None: as the window was opened) and those
    #: of a project, if the model is one.
    settings: Callable[[str | None, str | None, Settings | None], Settings]
    #: What G-code is dated.
    dated: Callable[[], datetime]

    @classmethod
    def of(cls, model: Model, settings: Settings, name: str) -> Source:
        """Return a model that is in memory, with the settings to begin with."""
        from wireprint.gcode.document import dated

        def composed(printer: str | None, material: str | None, _: Settings | None) -> Settings:
            return settings.but(printer, material) if printer or material else settings

        return cls(name, None, lambda: model, composed, lambda: dated(None))

    def compose(
        self,
        saved: Settings | None,
        printer: str | None,
        material: str | None,
        changed: Mapping[str, Any],
    ) -> Settings:
        """Return settings with single ones changed, by dotted key.

        Raises
        ------
        SettingError
            A profile is not there, or a value is refused.
        """
        settings = self.settings(printer, material, saved)
        if not changed:
            return settings
        overrides = [f"{key}={json.dumps(value)}" for key, value in changed.items()]
        try:
            return settings.but(overrides=overrides)
        except SettingError as error:
            # A page has no options; it shows the words at the field.
            words = str(error)
            for override in overrides:
                words = words.removeprefix(f"--set {override}: ")
            raise SettingError(words) from None

"""Where a window's model and settings come from."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from datetime import datetime
    from pathlib import Path

    from wireprint.model import Model
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Source:
    """A model's file, and how it is read."""

    path: Path
    #: Reads the file, places the model, and adds what is marked on it.
    load: Callable[[], Model]
    #: Settings for a printer and a material by name (None: as the window was opened) and those
    #: of a project, if the model is one.
    settings: Callable[[str | None, str | None, Settings | None], Settings]
    #: What G-code is dated.
    dated: Callable[[], datetime]

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
        return settings.but(overrides=[f"{key}={json.dumps(v)}" for key, v in changed.items()])

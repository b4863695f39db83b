"""The forecast of a window's print, for those who look at it: computed beside all else.

It takes far longer than a stroke, and is asked for print by print; only the newest is computed.
"""

from __future__ import annotations

import sys
import threading
import traceback
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint._core import WireprintError
from wireprint.window.answer import encoded

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.settings import Settings
    from wireprint.window.outputs import Printed


class Foretelling:
    """Forecasts prints, on a thread that lives as long as there is one to forecast.

    Parameters
    ----------
    tell
        Takes events, from any thread: name and bytes.
    """

    def __init__(self, tell: Callable[[str, bytes], None]) -> None:
        self._tell = tell
        self._guard = threading.Lock()
        self._wanted: tuple[int, Printed, Settings] | None = None
        self._works = False

    def ask(self, revision: int, printed: Printed, settings: Settings) -> None:
        """Have the print of a change forecast; one that was asked for and not begun is not."""
        with self._guard:
            self._wanted = (revision, printed, settings)
            if self._works:
                return
            self._works = True
        threading.Thread(target=self._work, name="forecast", daemon=True).start()

    def _work(self) -> None:
        while True:
            with self._guard:
                wanted, self._wanted = self._wanted, None
                if wanted is None:
                    self._works = False
                    return
            self._tell("forecast", _told(*wanted))


def _told(revision: int, printed: Printed, settings: Settings) -> bytes:
    """Return what a print would do, or why that is not known."""
    head: dict[str, Any] = {"event": "forecast", "revision": revision, "error": ""}
    try:
        found, arrays = _forecast(printed, settings)
        return encoded(head | found, arrays)
    except WireprintError as error:
        head["error"] = str(error)
    except Exception as error:
        # The window outlives a fault, and says so.
        traceback.print_exc(file=sys.stderr)
        head["error"] = f"unexpected {type(error).__name__}: a fault of wireprint"
    return encoded(head)


def _forecast(printed: Printed, settings: Settings) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return a forecast: rules in sentences, and each figure of each strand in printing order.

    Figures are shares of the amount at which they are worst drawn, ``most``; −1: there is none.
    """
    from wireprint.forecast import simulate
    from wireprint.forecast_scales import RULES, scale_of
    from wireprint.forecast_words import sentences

    found = simulate(printed.gcode, settings)
    figures, arrays = {}, {}
    for figure in RULES:
        scale = scale_of(found, figure)
        most = scale.edges[-1]
        shares = np.minimum(scale.values / most, 1.0)
        arrays[figure] = np.nan_to_num(shares, nan=-1.0).astype("<f4")
        figures[figure] = {
            "name": scale.quantity,
            "unit": scale.unit,
            "most": scale.written(most),
        }
    return {"trust": found.trust, "figures": figures, "sentences": sentences(found)}, arrays

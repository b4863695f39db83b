"""What a window works on: a model, its marks and settings, and every state that they were in."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from wireprint._core import SettingError
from wireprint.regions import Region
from wireprint.regions.document import MOST_MARKS

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from wireprint.regions import Mark
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Item:
    """A line in the list of marks."""

    #: Stays the mark's, whatever becomes of the order.
    number: int
    mark: Mark
    name: str
    on: bool = True


@dataclass(frozen=True)
class State:
    """What one can undo to; immutable, and states share what they have in common."""

    items: tuple[Item, ...] = ()
    #: Names of profiles; None: what the window was opened with.
    printer: str | None = None
    material: str | None = None
    #: Settings that differ from those.
    changed: tuple[tuple[str, Any], ...] = ()

    @property
    def region(self) -> Region:
        """What is marked: the marks that are switched on."""
        return Region(tuple(item.mark for item in self.items if item.on))


class History:
    """The states of a window, and the one that is shown.

    Parameters
    ----------
    compose
        Makes settings of a printer, a material (None: those it was opened with) and single
        settings by dotted key.
    region
        Marks to begin with.
    """

    def __init__(
        self,
        compose: Callable[[str | None, str | None, Mapping[str, Any]], Settings],
        region: Region,
    ) -> None:
        self._compose = compose
        self._next = 0
        self._state = State(tuple(self._item(mark) for mark in region.marks))
        self._past: list[State] = []
        self._future: list[State] = []
        self.settings = self._settings_of(self._state)

    @property
    def state(self) -> State:
        """The state that is shown."""
        return self._state

    @property
    def can_undo(self) -> bool:
        """Whether there is a state before this one."""
        return bool(self._past)

    @property
    def can_redo(self) -> bool:
        """Whether a state was taken back."""
        return bool(self._future)

    def add(self, mark: Mark, name: str | None) -> int:
        """Mark something; return the mark's number."""
        if len(self._state.items) >= MOST_MARKS:
            raise SettingError(f"there are {MOST_MARKS} marks; delete some first")
        item = self._item(mark, name)
        self._go(replace(self._state, items=(*self._state.items, item)))
        return item.number

    def change(self, number: int, mark: Mark | None, name: str | None, on: bool | None) -> None:
        """Change a mark; what is None stays."""
        place, item = self._find(number)
        changed = Item(
            number,
            item.mark if mark is None else mark,
            item.name if name is None else name,
            item.on if on is None else on,
        )
        items = list(self._state.items)
        items[place] = changed
        if changed != item:
            self._go(replace(self._state, items=tuple(items)))

    def move(self, number: int, to: int) -> None:
        """Put a mark to another place in the order, from 0."""
        place, item = self._find(number)
        items = list(self._state.items)
        del items[place]
        items.insert(min(to, len(items)), item)
        if tuple(items) != self._state.items:
            self._go(replace(self._state, items=tuple(items)))

    def delete(self, number: int) -> None:
        """Take a mark away."""
        place, _ = self._find(number)
        items = self._state.items
        self._go(replace(self._state, items=items[:place] + items[place + 1 :]))

    def set(self, key: str, value: Any) -> None:
        """Change a setting; None: the profile's own value again."""
        changed = {name: kept for name, kept in self._state.changed if name != key}
        if value is not None:
            changed[key] = value
        self._go(replace(self._state, changed=tuple(changed.items())))

    def profile(self, printer: str | None, material: str | None) -> None:
        """Take another printer, material or both; settings that were changed stay so."""
        state = self._state
        self._go(
            replace(
                state,
                printer=printer or state.printer,
                material=material or state.material,
            )
        )

    def undo(self) -> None:
        """Go back by one state, if there is one."""
        if self._past:
            self._future.append(self._state)
            self._show(self._past.pop())

    def redo(self) -> None:
        """Go forward by one state, if one was taken back."""
        if self._future:
            self._past.append(self._state)
            self._show(self._future.pop())

    def profiles_settings(self) -> Settings:
        """Return the settings as they would be if none had been changed here."""
        return self._compose(self._state.printer, self._state.material, {})

    def _go(self, state: State) -> None:
        # Settings that are refused leave everything as it is.
        settings = self._settings_after(state)
        self._past.append(self._state)
        self._future.clear()
        self._state, self.settings = state, settings

    def _show(self, state: State) -> None:
        self._state, self.settings = state, self._settings_after(state)

    def _settings_after(self, state: State) -> Settings:
        """Return a state's settings: the very same object where they do not change."""
        now = self._state
        if (state.printer, state.material, state.changed) == (
            now.printer,
            now.material,
            now.changed,
        ):
            return self.settings
        return self._settings_of(state)

    def _settings_of(self, state: State) -> Settings:
        return self._compose(state.printer, state.material, dict(state.changed))

    def _item(self, mark: Mark, name: str | None = None) -> Item:
        self._next += 1
        return Item(self._next, mark, name or f"{mark.shape.noun} {self._next}")

    def _find(self, number: int) -> tuple[int, Item]:
        for place, item in enumerate(self._state.items):
            if item.number == number:
                return place, item
        raise SettingError(f"there is no mark {number}")

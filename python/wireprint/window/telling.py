"""What a page is told of a session: who it talks with, the model, the state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint import catalogue, report
from wireprint._core import __version__
from wireprint.regions import Region, document
from wireprint.view_replay import told_of
from wireprint.window.answer import encoded

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.window.history import History, Item
    from wireprint.window.source import Source


def welcome(source: Source, offered: dict[str, Any]) -> bytes:
    """Tell what a page may ask for; `offered`: which hosts there are to send to."""
    return encoded(
        {
            "event": "welcome",
            "name": source.name,
            "version": __version__,
            "printers": catalogue.names("printers"),
            "materials": catalogue.names("materials"),
            "saves": source.path is not None,
            **offered,
        }
    )


def model(name: str, mesh: Mesh) -> bytes:
    """Tell a model: its triangles, and what was repaired."""
    head = {
        "event": "model",
        "name": name,
        "size_mm": mesh.size_mm,
        "repaired": report.repairs(mesh),
        "warnings": report.warnings(mesh),
    }
    arrays = {"vertices": mesh.vertices.astype("<f4"), "faces": mesh.faces.astype("<u4")}
    return encoded(head, arrays)


def state(revision: int, history: History) -> bytes:
    """Tell marks and settings as they are."""
    from wireprint.window import panel

    now, settings = history.state, history.settings
    return encoded(
        {
            "event": "state",
            "revision": revision,
            "items": [_item(item) for item in now.items],
            "can_undo": history.can_undo,
            "can_redo": history.can_redo,
            "printer": settings.printer.name,
            "material": settings.material.name,
            "settings": panel.values(settings),
            "automatic": panel.automatic(settings),
            "differs": panel.differing(settings, history.profiles_settings()),
            **told_of(settings),
        }
    )


def words(event: str, text: str, **head: Any) -> bytes:
    """Tell something in words."""
    return encoded({"event": event, "words": text, **head})


def _item(item: Item) -> dict[str, Any]:
    """Return a line of the list of marks; paint goes without its points."""
    entry = document.Document.of(Region((item.mark,))).marks[0].model_dump(mode="json")
    shape = entry["shape"]
    if shape["kind"] == "stroke":
        shape = {"kind": "stroke", "radius_mm": shape["radius_mm"]}
    elif shape["kind"] == "mask":
        shape = {"kind": "mask"}
    return {
        "number": item.number,
        "name": item.name,
        "on": item.on,
        "erase": item.mark.erase,
        "shape": shape,
        "frame": entry["frame"],
    }

"""Struts in the JSON of Choreo and pychoreo: ``node_list`` and ``element_list``.

Its form: yijiangh/assembly_instances, ``extrusion``, on which robots' orders are compared.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Mapping

#: Names of units, and how many mm each has.
_UNITS: Final = {
    "millimeter": 1.0,
    "mm": 1.0,
    "centimeter": 10.0,
    "cm": 10.0,
    "meter": 1000.0,
    "m": 1000.0,
}


def is_choreo(document: Any) -> bool:
    """Whether a document of JSON has that form."""
    return isinstance(document, dict) and {"node_list", "element_list"} <= document.keys()


def read(document: Mapping[str, Any]) -> Graph:
    """Read a graph, in mm.

    Raises
    ------
    ModelError
        A node or an element is none, or the unit is not known.
    """
    unit = str(document.get("unit", "millimeter")).lower()
    if unit not in _UNITS:
        raise ModelError(f"its unit {unit[:40]!r} is none of {', '.join(_UNITS)}")
    try:
        names = [one.get("node_id", n) for n, one in enumerate(document["node_list"])]
        nodes = [[float(one["point"][axis]) for axis in "XYZ"] for one in document["node_list"]]
        numbers = {name: number for number, name in enumerate(names)}
        edges = [[numbers[end] for end in one["end_node_ids"]] for one in document["element_list"]]
        return Graph(np.array(nodes) * _UNITS[unit], np.array(edges))
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        if isinstance(error, ModelError):
            raise
        raise ModelError(f"a node or an element of it is none: {error}") from None

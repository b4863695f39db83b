"""Strut graphs: read, put into an order in which they can be printed, written."""

from wireprint.struts.files import READ, WRITTEN, read_struts, struts_as
from wireprint.struts.graph import Graph
from wireprint.struts.order import OrderedGraph, order

__all__ = ["READ", "WRITTEN", "Graph", "OrderedGraph", "order", "read_struts", "struts_as"]

"""A small strut graph in every format that is read."""

from wireprint.struts import READ, Graph, struts_as

#: A pyramid of 12 mm.
PYRAMID = Graph(
    [[0, 0, 0], [12, 0, 0], [12, 12, 0], [0, 12, 0], [6, 6, 9]],
    [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]],
)
GRAPHS = {kind: struts_as(PYRAMID, kind, 0.35) for kind in READ if kind != "gltf"}
GRAPHS["gltf"] = GRAPHS["glb"]

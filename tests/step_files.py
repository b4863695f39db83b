"""STEP files of simple solids, written entity by entity."""

import numpy as np

HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('made by hand','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
"""
QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


class Step:
    """The entities of a file, each named by its number."""

    def __init__(self, unit="SI_UNIT(.MILLI.,.METRE.)"):
        """Begin with units and the axes of the world."""
        self.lines = []
        length = self.add(f"(LENGTH_UNIT()NAMED_UNIT(*){unit})")
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        fine = self.add(
            f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-5),{length},"
            "'distance_accuracy_value','')"
        )
        self.context = self.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
            f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({fine}))"
            f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('',''))"
        )
        self.world = self.axes((0, 0, 0))
        self.application = self.add("APPLICATION_CONTEXT('mechanical design')")

    def add(self, text):
        self.lines.append(f"#{len(self.lines) + 1}={text};")
        return f"#{len(self.lines)}"

    def text(self):
        return HEADER + "\n".join(self.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"

    def point(self, at):
        return self.add(f"CARTESIAN_POINT('',({numbers(at)}))")

    def direction(self, along):
        return self.add(f"DIRECTION('',({numbers(along)}))")

    def axes(self, at, z=(0, 0, 1), x=(1, 0, 0)):
        place = f"{self.point(at)},{self.direction(z)},{self.direction(x)}"
        return self.add(f"AXIS2_PLACEMENT_3D('',{place})")

    def vertex(self, at):
        return self.add(f"VERTEX_POINT('',{self.point(at)})")

    def line(self, start, end):
        along = np.subtract(end, start)
        length = float(np.linalg.norm(along))
        vector = self.add(f"VECTOR('',{self.direction(along / length)},{length!r})")
        return self.add(f"LINE('',{self.point(start)},{vector})")

    def edge(self, start, end, curve):
        return self.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")

    def face(self, edges, surface, along=".T."):
        """A face within a loop of edges, each with whether it is followed forwards."""
        oriented = [
            self.add(f"ORIENTED_EDGE('',*,*,{edge},.{'T' if forwards else 'F'}.)")
            for edge, forwards in edges
        ]
        loop = self.add(f"EDGE_LOOP('',({','.join(oriented)}))")
        bound = self.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},{along})")

    def solid(self, faces):
        shell = self.add(f"CLOSED_SHELL('',({','.join(faces)}))")
        return self.add(f"MANIFOLD_SOLID_BREP('solid',{shell})")

    def box(self, size, at=(0, 0, 0)):
        corners = [
            np.multiply([i & 1, i >> 1 & 1, i >> 2], size).astype(float) + at for i in range(8)
        ]
        vertices = [self.vertex(corner) for corner in corners]
        edges, faces = {}, []
        for quad in QUADS:
            sides = list(zip(quad, quad[1:] + quad[:1], strict=True))
            for a, b in map(sorted, sides):
                if (a, b) not in edges:
                    curve = self.line(corners[a], corners[b])
                    edges[a, b] = self.edge(vertices[a], vertices[b], curve)
            along, up = (corners[b] - corners[a] for a, b in sides[:2])
            normal = np.cross(along, up)
            plane = self.plane(
                corners[quad[0]], normal / np.linalg.norm(normal), along / np.linalg.norm(along)
            )
            loop = [(edges[min(side), max(side)], side[0] < side[1]) for side in sides]
            faces.append(self.face(loop, plane))
        return self.solid(faces)

    def plane(self, at, normal, along):
        return self.add(f"PLANE('',{self.axes(at, normal, along)})")

    def cylinder(self, radius, height):
        low, high = (radius, 0, 0), (radius, 0, height)
        ends = [self.vertex(low), self.vertex(high)]
        rims = [
            self.edge(end, end, self.add(f"CIRCLE('',{self.axes((0, 0, z))},{float(radius)!r})"))
            for end, z in zip(ends, (0, height), strict=True)
        ]
        seam = self.edge(*ends, self.line(low, high))
        axes = self.axes((0, 0, 0))
        side = self.add(f"CYLINDRICAL_SURFACE('',{axes},{float(radius)!r})")
        around = [(rims[0], True), (seam, True), (rims[1], False), (seam, False)]
        return self.solid(
            [
                self.face(around, side),
                self.face([(rims[0], False)], self.plane((0, 0, 0), (0, 0, -1), (1, 0, 0))),
                self.face([(rims[1], True)], self.plane((0, 0, height), (0, 0, 1), (1, 0, 0))),
            ]
        )

    def shape(self, *items, kind="ADVANCED_BREP_SHAPE_REPRESENTATION"):
        inside = ",".join([self.world, *items])
        return self.add(f"{kind}('',({inside}),{self.context})")

    def product(self, name, shape):
        """Make a shape that of a product; return the product's definition."""
        context = self.add(f"PRODUCT_CONTEXT('',{self.application},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        stage = self.add(
            f"PRODUCT_DEFINITION_CONTEXT('part definition',{self.application},'design')"
        )
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
        held = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({held},{shape})")
        return definition

    def put(self, part, part_shape, whole, whole_shape, at):
        """Put a part into an assembly."""
        turn = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{self.world},{self.axes(at)})")
        relation = self.add(
            f"(REPRESENTATION_RELATIONSHIP('','',{part_shape},{whole_shape})"
            f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({turn})"
            "SHAPE_REPRESENTATION_RELATIONSHIP())"
        )
        used = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',{whole},{part},$)")
        held = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{used})")
        self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{held})")


def numbers(values):
    return ",".join(repr(float(value)) for value in values)


def box(size, unit="SI_UNIT(.MILLI.,.METRE.)"):
    step = Step(unit)
    step.product("box", step.shape(step.box(size)))
    return step.text()


def cylinder(radius, height):
    step = Step()
    step.product("cylinder", step.shape(step.cylinder(radius, height)))
    return step.text()


def assembly(size, places):
    """The same box at several places."""
    step = Step()
    part_shape = step.shape(step.box(size))
    part = step.product("box", part_shape)
    whole_shape = step.shape(kind="SHAPE_REPRESENTATION")
    whole = step.product("whole", whole_shape)
    for at in places:
        step.put(part, part_shape, whole, whole_shape, at)
    return step.text()

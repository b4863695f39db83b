"""3MF files made by hand, and an encoder of painted triangles."""

import zipfile

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
SLIC3R = "http://schemas.slic3r.org/3mf/2017/06"
SETS = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"
MODEL = "3D/3dmodel.model"

CUBE_FACES = [
    (int(a), int(b), int(c))
    for p, q, r, s in ["0231", "4576", "0154", "2673", "0462", "1375"]
    for a, b, c in [(p, q, r), (p, r, s)]
]


def cube_object(size=1, identity=1, attributes=None, after=""):
    """A cube from the origin on; `attributes` by the index of its triangle."""
    vertices = "".join(
        f'<vertex x="{size * (i & 1)}" y="{size * (i >> 1 & 1)}" z="{size * (i >> 2)}"/>'
        for i in range(8)
    )
    triangles = "".join(
        f'<triangle v1="{a}" v2="{b}" v3="{c}" {(attributes or {}).get(index, "")}/>'
        for index, (a, b, c) in enumerate(CUBE_FACES)
    )
    return (
        f'<object id="{identity}"><mesh><vertices>{vertices}</vertices>'
        f"<triangles>{triangles}</triangles>{after}</mesh></object>"
    )


CUBE_OBJECT = cube_object()
ITEM = '<item objectid="1"/>'


def item(identity, shift):
    return f'<item objectid="{identity}" transform="1 0 0 0 1 0 0 0 1 {shift}"/>'


def model(resources=CUBE_OBJECT, items=ITEM, unit="millimeter", head=""):
    spaces = f'xmlns="{CORE}" xmlns:p="{PRODUCTION}" xmlns:slic3rpe="{SLIC3R}" xmlns:t="{SETS}"'
    return (
        f'{head}<model unit="{unit}" {spaces}><resources>{resources}</resources>'
        f"<build>{items}</build></model>"
    )


def write_3mf(path, resources=CUBE_OBJECT, items=ITEM, unit="millimeter", parts=None):
    write_zip(path, {MODEL: model(resources, items, unit), **(parts or {})})
    return path


def write_zip(path, parts, compression=zipfile.ZIP_DEFLATED):
    """Write an archive of parts, each given as a whole or in pieces."""
    with zipfile.ZipFile(path, "w", compression) as archive:
        for name, content in parts.items():
            with archive.open(name, "w", force_zip64=True) as part:
                for piece in [content] if isinstance(content, str | bytes) else content:
                    part.write(piece.encode() if isinstance(piece, str) else piece)
    return path


def relationships(target, kind):
    return (
        '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
        f'<Relationship Id="a" Target="{target}" Type="{kind}"/></Relationships>'
    )


def encoded(tree):
    """The string of a painted triangle.

    A tree is a state, or a list: the corner that its split is counted from, then its two to four
    children.
    """
    return "".join(reversed(list(_digits(tree))))


def _digits(tree):
    if isinstance(tree, int):
        yield from f"{tree << 2:X}" if tree < 3 else f"C{tree - 3:X}"
        return
    corner, *children = tree
    yield f"{corner << 2 | len(children) - 1:X}"
    for child in reversed(children):
        yield from _digits(child)


def leaves(tree, triangle):
    """The triangles of a painted one with their states, by cutting its sides in the middle."""
    if isinstance(tree, int):
        return [(triangle, tree)]
    corner, *children = tree
    a, b, c = triangle[corner:] + triangle[:corner]
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    parts = {
        2: [[a, b, bc], [bc, c, a]],
        3: [[a, ab, ca], [ab, b, ca], [b, c, ca]],
        4: [[a, ab, ca], [ab, b, bc], [bc, c, ca], [ab, bc, ca]],
    }[len(children)]
    return [
        leaf for child, part in zip(children, parts, strict=True) for leaf in leaves(child, part)
    ]

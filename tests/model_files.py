"""A cube of 20 mm from the origin on in every dialect of OBJ, PLY, OFF, STL and AMF that is read.

Each dialect is a name, a suffix and bytes; `docs/formats.md` tells of each by its name.
"""

import io
import struct
import zipfile

SIDE = 20
POINTS = [(SIDE * (i & 1), SIDE * (i >> 1 & 1), SIDE * (i >> 2)) for i in range(8)]
QUADS = [tuple(map(int, quad)) for quad in ["0231", "4576", "0154", "2673", "0462", "1375"]]
TRIANGLES = [face for a, b, c, d in QUADS for face in ((a, b, c), (a, c, d))]
#: Strips that cover the cube, with restarts: a band around it, then what is left of it.
STRIPS = [[0, 1, 4, 5, 6, 7, 2, 3, 0, 1], [0, 4, 2, 6], [1, 3, 5, 7]]


def text_lines(rows, before="", after=""):
    return "".join(f"{before}{' '.join(map(str, row))}{after}\n" for row in rows)


# --- OBJ


def obj(points="v {} {} {}\n", faces=None):
    faces = faces or text_lines(([i + 1 for i in quad] for quad in QUADS), "f ")
    return "".join(points.format(*point) for point in POINTS) + faces


NEGATIVE = text_lines(([i - 8 for i in quad] for quad in QUADS), "f ")
OBJ = {
    "obj-quads": obj(),
    "obj-triangles": obj(faces=text_lines(([i + 1 for i in t] for t in TRIANGLES), "f ")),
    "obj-negative-indices": obj(faces=NEGATIVE),
    "obj-indices-of-both-signs": obj(
        faces="v 90 90 90\n"
        + text_lines(([i - 9 if i % 2 else i + 1 for i in q] for q in QUADS), "f ")
    ),
    "obj-textures-and-normals": "mtllib a.mtl\nvt 0 0\nvn 0 0 1\nusemtl b\ns off\ng c d\n"
    + obj(faces=text_lines(([f"{i + 1}/1/1" for i in quad] for quad in QUADS), "f ")),
    "obj-normals-alone": "vn 0 0 1\n"
    + obj(faces=text_lines(([f"{i + 1}//1" for i in quad] for quad in QUADS), "f ")),
    "obj-colours": obj("v {} {} {} 0.5 0.25 1\n"),
    "obj-weights": obj("v {} {} {} 1.0\n"),
    "obj-faces-before-vertices": text_lines(([i + 1 for i in q] for q in QUADS), "f ")
    + "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS),
    "obj-tabs": obj().replace(" ", "\t"),
    "obj-indents": obj("  v   {} {} {}  \n"),
    "obj-comments-after-values": obj("v {} {} {} # a corner\n"),
    "obj-continued-lines": obj("v {} \\\n  {} \\ \n {}\n").replace(" 4 2", " \\\n4 2"),
    "obj-exponents": obj("v {}e0 +{}. {}.0E+00\n"),
    "obj-crlf": obj().replace("\n", "\r\n"),
    "obj-cr": obj().replace("\n", "\r"),
    "obj-no-last-line-end": obj().rstrip(),
    "obj-byte-order-mark": "\ufeff" + obj(),
    "obj-utf-16": (obj("# ö\nv {} {} {}\n")).encode("utf-16"),
    "obj-utf-16-big-endian": b"\xfe\xff" + obj().encode("utf-16-be"),
    "obj-latin-1": ("# Größe in mm\no Gehäuse\n" + obj()).encode("latin-1"),
    "obj-lines-and-points": obj() + "l 1 2 3\np 4\n",
}

# --- PLY


def ply_header(form="ascii", vertices=8, faces=6, point="float", extra="", lists="uchar int"):
    axes = "".join(f"property {point} {axis}\n" for axis in "xyz")
    return (
        f"ply\nformat {form} 1.0\ncomment made by hand\nobj_info none\nelement vertex {vertices}\n"
        f"{axes}{extra}element face {faces}\nproperty list {lists} vertex_indices\n"
    )


def ply_text(faces=QUADS):
    return text_lines(POINTS) + text_lines([len(face), *face] for face in faces)


def ply_bytes(order, faces=QUADS, point="f", length="B", index="i", extra=b""):
    content = b"".join(struct.pack(f"{order}3{point}", *one) + extra for one in POINTS)
    for face in faces:
        content += struct.pack(f"{order}{length}", len(face))
        content += struct.pack(f"{order}{len(face)}{index}", *face)
    return content


END = "end_header\n"
MIXED_FACES = [*QUADS[:3], *TRIANGLES[6:]]
STRIP = [corner for strip in STRIPS for corner in [*strip, -1]][:-1]
PLY = {
    "ply-ascii": ply_header() + END + ply_text(),
    "ply-little-endian": (ply_header("binary_little_endian") + END).encode() + ply_bytes("<"),
    "ply-big-endian": (ply_header("binary_big_endian") + END).encode() + ply_bytes(">"),
    "ply-doubles": (
        ply_header("binary_big_endian", point="float64", lists="uint32 uint16") + END
    ).encode()
    + ply_bytes(">", point="d", length="I", index="H"),
    "ply-quads-and-triangles": (ply_header("binary_little_endian", faces=9) + END).encode()
    + ply_bytes("<", MIXED_FACES),
    "ply-colours-and-lists": (
        ply_header(
            "binary_little_endian", extra="property uchar red\nproperty list uchar short views\n"
        )
        + END
    ).encode()
    + ply_bytes("<", extra=b"\x07" + struct.pack("<Bhh", 2, 5, 6)),
    "ply-vertex-index": (ply_header() + END).replace("vertex_indices", "vertex_index") + ply_text(),
    "ply-other-elements": ply_header()
    + "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement empty 4000000000\n"
    + END
    + ply_text()
    + "0 1\n",
    "ply-axes-in-another-order": "ply\nformat ascii 1.0\nelement material 1\nproperty int a\n"
    "element vertex 8\nproperty float z\nproperty float nx\nproperty float x\nproperty double y\n"
    "element face 6\nproperty list uchar float uv\nproperty list char uint vertex_indices\n"
    + END
    + "5\n"
    + text_lines((z, "nan", x, y) for x, y, z in POINTS)
    + text_lines([2, 0.5, 1, 4, *quad] for quad in QUADS),
    "ply-tristrips": ply_header(faces=1, lists="int int").replace("face", "tristrips")
    + END
    + text_lines([*POINTS, [len(STRIP), *STRIP]]),
    "ply-values-across-lines": ply_header()
    + END
    + " ".join(ply_text().split()[:30])
    + "\n"
    + " ".join(ply_text().split()[30:]),
    "ply-crlf": (ply_header("binary_little_endian") + END).replace("\n", "\r\n").encode()
    + ply_bytes("<"),
    "ply-cr": (ply_header("binary_little_endian") + END).replace("\n", "\r").encode()
    + ply_bytes("<"),
    "ply-latin-1": (ply_header().replace("hand", "Größe") + END + ply_text()).encode("latin-1"),
    "ply-trailing-bytes": (ply_header("binary_little_endian") + END).encode()
    + ply_bytes("<")
    + b"\x00",
}
# --- OFF


def off(head="OFF\n8 6 0\n", points=POINTS, faces=None):
    return head + text_lines(points) + text_lines(faces or ([4, *quad] for quad in QUADS))


def off_bytes(keyword="OFF", extra=b"", scale=1.0, homogeneous=False):
    content = f"{keyword} BINARY\n".encode() + struct.pack(">3i", 8, 6, 12)
    for point in POINTS:
        place = [*(x * scale for x in point), *([scale] if homogeneous else [])]
        content += struct.pack(f">{len(place)}f", *place) + extra
    for quad in QUADS:
        content += struct.pack(">5ii3f", 4, *quad, 3, 0.5, 0.25, 1)
    return content


OFF = {
    "off-quads": off(),
    "off-triangles": off("OFF\n8 12 18\n", faces=([3, *face] for face in TRIANGLES)),
    "off-counts-beside-the-keyword": off("OFF 8 6 0\n"),
    "off-no-keyword": off("8 6 0\n"),
    "off-no-number-of-edges": off("OFF\n8 6\n"),
    "off-comments": off("# first\nOFF\n\n# counts\n8 6 0 # edges\n") + "# last\n",
    "off-colours-of-faces": off(faces=([4, *quad, 255, 128, 0, 255] for quad in QUADS)),
    "off-colours-of-vertices": off("COFF\n8 6 0\n", [(*p, 255, 0, 0, 255) for p in POINTS]),
    "off-normals-and-textures": off("STCNOFF\n8 6 0\n", [(*p, *[0] * 9) for p in POINTS]),
    "off-homogeneous": off("4OFF\n8 6 0\n", [(2 * x, 2 * y, 2 * z, 2) for x, y, z in POINTS]),
    "off-values-across-lines": " ".join(off().split()),
    "off-latin-1": ("OFF\n# Größe\n" + off("8 6 0\n")).encode("latin-1"),
    "off-cr": off().replace("\n", "\r"),
    "off-binary": off_bytes(),
    "off-binary-with-normals": off_bytes("NOFF", bytes(12)),
    "off-binary-homogeneous": off_bytes("4OFF", scale=2.0, homogeneous=True),
}

# --- STL


def stl(open_facet=" facet normal 0 0 0\n  outer loop\n", close="  endloop\n endfacet\n", name="a"):
    facets = "".join(
        open_facet + text_lines((POINTS[i] for i in face), "   vertex ") + close
        for face in TRIANGLES
    )
    return f"solid {name}\n{facets}endsolid {name}\n"


def stl_bytes(count=12, header=b"", tail=b""):
    content = header.ljust(80, b"\0") + struct.pack("<I", count)
    for face in TRIANGLES:
        content += struct.pack("<12fH", 0, 0, 0, *(x for i in face for x in POINTS[i]), 0)
    return content + tail


STL = {
    "stl-binary": stl_bytes(),
    "stl-binary-named-solid": stl_bytes(header=b"solid of some program"),
    "stl-binary-count-0": stl_bytes(count=0),
    "stl-binary-tail": stl_bytes(tail=b"\1"),
    "stl-ascii": stl(),
    "stl-ascii-capitals": stl().upper(),
    "stl-ascii-nan-normals": stl(" facet normal -1.#IND nan -nan(ind)\n  outer loop\n"),
    "stl-ascii-text-after-endloop": stl(close="  endloop 1\n endfacet 2\n"),
    "stl-ascii-no-endsolid": stl().rpartition("endsolid")[0],
    "stl-ascii-two-solids": stl(name="a b").rpartition("endsolid")[0] + "solid b\nendsolid b\n",
    "stl-ascii-control-z": stl() + "\x1a",
    "stl-ascii-byte-order-mark": "\ufeff" + stl(),
    "stl-ascii-cr": stl().replace("\n", "\r"),
    "stl-ascii-one-line-a-facet": stl(" facet normal 0 0 0 outer loop\n", " endloop endfacet\n"),
}

# --- AMF


def amf(root="amf unit='millimeter'", factor=1, inside="", after=""):
    vertices = "".join(
        "<vertex><coordinates><x>{}</x><y>{}</y><z>{}</z></coordinates></vertex>".format(
            *(factor * c for c in point)
        )
        for point in POINTS
    )
    triangles = "".join(
        "<triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>".format(*t) for t in TRIANGLES
    )
    return (
        f"<?xml version='1.0' encoding='utf-8'?>\n<{root}>\n<object id='1'><mesh>"
        f"<vertices>{vertices}</vertices><volume>{triangles}</volume>{inside}</mesh></object>"
        f"{after}</amf>\n"
    )


def zipped(name, content):
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(name, content)
    return held.getvalue()


SUPPORT = "<volume type='support'><triangle><v1>0</v1><v2>1</v2><v3>7</v3></triangle></volume>"
SETTINGS = (
    "<volume><metadata type='slic3r.modifier'>1</metadata>"
    "<triangle><v1>0</v1><v2>1</v2><v3>7</v3></triangle></volume>"
)
PLACED = (
    "<constellation id='2'><instance objectid='1'><deltax>20</deltax><deltay>0</deltay>"
    "<rx>0</rx><ry>0</ry><rz>90</rz></instance></constellation>"
)
AMF = {
    "amf-plain": amf(),
    "amf-zip": zipped("model.amf", amf()),
    "amf-no-unit": amf("amf version='1.1'"),
    "amf-microns": amf("amf unit='micron'", 1000),
    "amf-constellation": amf(after=PLACED),
    "amf-colours": amf(inside="<color><r>1</r><g>0</g><b>0</b></color>"),
    "amf-volume-for-supports": amf(inside=SUPPORT),
    "amf-volume-for-settings": amf(inside=SETTINGS),
}

DIALECTS = {
    name: (name.partition("-")[0], content if isinstance(content, bytes) else content.encode())
    for group in (OBJ, PLY, OFF, STL, AMF)
    for name, content in group.items()
}

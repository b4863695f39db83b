"""Writes binary G-code, in every packing of its specification."""

import struct
import zlib

TEXT = b"""G90
M83
; a remark
G1 X10.5 Y-20 E1.25 F1500
G1 X0 Y0 Z0.2 E-.8
M117 \xc3\xbcber alles
G1 X100 Y100 F6000
"""
#: Characters of MeatPack's halves, in their order.
HALVES = "0123456789. \nGX"
NONE, DEFLATE, SHRINK_11, SHRINK_12 = range(4)
PLAIN, MEATPACK, MEATPACK_WITH_COMMENTS = range(3)


def shrunk(content, window):
    """Heatshrink, lookahead 4: copies where four bytes were seen before."""
    bits, at = "", 0
    while at < len(content):
        seen = content.rfind(content[at : at + 4], max(0, at - (1 << window)), at)
        if seen >= 0 and at + 4 <= len(content):
            bits += f"0{at - seen - 1:0{window}b}{3:04b}"
            at += 4
        else:
            bits += f"1{content[at]:08b}"
            at += 1
    bits += "0" * (-len(bits) % 8)
    return int(bits, 2).to_bytes(len(bits) // 8, "big")


def meatpacked(content, spaceless):
    """MeatPack, two characters at a time."""
    table = HALVES.replace(" ", "E") if spaceless else HALVES
    half = {ord(sign): value for value, sign in enumerate(table)}
    found = b"\xff\xff\xfb" + (b"\xff\xff\xf7" if spaceless else b"")
    content += b"\n" * (len(content) % 2)
    for first, second in zip(content[::2], content[1::2], strict=True):
        found += bytes([half.get(first, 15) | half.get(second, 15) << 4])
        found += bytes(sign for sign in (first, second) if sign not in half)
    return found


def block(kind, content, compression=NONE, encoding=PLAIN, checked=True, size=None):
    packed = {
        NONE: lambda: content,
        DEFLATE: lambda: zlib.compress(content),
        SHRINK_11: lambda: shrunk(content, 11),
        SHRINK_12: lambda: shrunk(content, 12),
    }[compression]()
    head = struct.pack("<HHI", kind, compression, len(content) if size is None else size)
    head += b"" if compression == NONE else struct.pack("<I", len(packed))
    head += struct.pack("<H", encoding) + (struct.pack("<HH", 16, 16) if kind == 5 else b"")
    whole = head + packed
    return whole + (struct.pack("<I", zlib.crc32(whole)) if checked else b"")


def bgcode(*blocks, checked=True, version=1):
    return b"GCDE" + struct.pack("<IH", version, checked) + b"".join(blocks)


def whole(compression=SHRINK_12, encoding=MEATPACK, checked=True):
    """A file as PrusaSlicer writes it, its G-code in two blocks."""
    lines = TEXT.splitlines(keepends=True)
    parts = [b"".join(lines[:3]), b"".join(lines[3:])]
    if encoding != PLAIN:
        parts = [meatpacked(part, spaceless=False) for part in parts]
    options = {"checked": checked}
    return bgcode(
        block(0, b"Producer=PrusaSlicer 2.8.0\n", **options),
        block(3, b"printer_model=MK4S\n", DEFLATE, **options),
        block(5, b"\x89PNG", encoding=1, **options),
        block(4, b"estimated printing time (normal mode)=1m 2s\n", **options),
        block(2, b"layer_height=0.2\n", DEFLATE, **options),
        *(block(1, part, compression, encoding, **options) for part in parts),
        checked=checked,
    )

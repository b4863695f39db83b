"""What a page of a file is told."""

import base64
import re
import zlib

from wireprint.window.answer import decoded


def held(page, name):
    """Return the bytes of what a page holds deflated."""
    found = re.search(rf'<script type="text/plain" id="{name}">(.*?)</script>', page, re.S)
    return zlib.decompress(base64.b64decode(found[1]))


def told_by(page):
    """Return head and arrays of each event, by its name."""
    rest, events = held(page, "data"), {}
    while rest:
        length = int.from_bytes(rest[:4], "little")
        head, arrays = decoded(rest[4 : 4 + length])
        events[head.pop("event")] = head, arrays
        rest = rest[4 + length :]
    return events

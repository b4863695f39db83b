"""What the print of a random part must be like, and what of that it is not."""

import re

import numpy as np

from wireprint._core import Mesh, WireprintError
from wireprint.pipeline import make

#: Least share of the outer surface that is covered.
COVERED = 0.99


def shortcomings(part, settings):
    """Print a part; tell what is wrong with the print, in a few words each.

    Returns
    -------
    list of str
        Rules broken, surface that is bare with what was said of it, height that is missing; or why
        the part was refused, its figures left out. Empty: whole and certified.
    """
    vertices, faces = part.mesh()
    try:
        made = make(Mesh.from_arrays(vertices, faces.astype(np.int64)), settings, partial=True)
    except WireprintError as error:
        return ["refused: " + re.sub(r"[-−\d.,]+", "#", str(error)).split(":")[0][:80]]
    told = made.figures()
    found = [f"breach of {name}" for name, count in told["breaches"].items() if count]
    if told["coverage"] < COVERED:
        reasons = sorted({piece["reason"] for piece in told["unprinted"]})
        found.append("bare, said to be " + " and ".join(reasons) if reasons else "bare, not said")
    low_mm = vertices[:, 2].max() - made.wireframe.strands[:, :, 2].max()
    if low_mm > settings.printer.head.nozzle_mm + settings.slab_min_mm:
        found.append("too low")
    return found

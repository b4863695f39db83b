"""CAD models (STEP, IGES) as meshes, through Open CASCADE.

A process of its own makes the facets: a kernel of exact surfaces may take its own time and memory,
or end with whoever called it.
"""

from __future__ import annotations

import importlib.util
import math
import re
import subprocess
import sys
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import gltf
from wireprint._core import Mesh, ModelError, SettingError, memory_budget
from wireprint.naming import named
from wireprint.threemf.instance import joined

if TYPE_CHECKING:
    from pathlib import Path

_KERNEL: Final = "Open CASCADE"
_WAY_OUT: Final = "export it as STL or 3MF"
#: How a process ends whose time is over: by a signal of its own, or by force.
_STOPPED: Final = (-24, -9)
#: What each suffix is called by the kernel.
KINDS: Final = {"step": "step", "stp": "step", "iges": "iges", "igs": "iges"}
#: Metres, glTF's unit, that a length of the kernel's scene stands for: its IGES reader names no
#: unit to its glTF writer, which then leaves millimetres as they are.
_METRES: Final = {"step": 1.0, "iges": 1e-3}
#: How far facets may lie from the surface, mm: less than any strand is thick by a tenth; and how
#: far neighbours may be turned, radians (Open CASCADE's own default is half).
DEFLECTION_MM: Final = 0.02
DEFLECTION_RAD: Final = 0.2
#: Of processor time; a file that takes longer for its size is damaged: s, and s for each byte.
_PATIENCE_S: Final = 8.0
_PATIENCE_S_PER_BYTE: Final = 1e-4
#: Of waiting, on a machine that does other things, too.
_WAITING: Final = 20
#: What the kernel itself takes before it has read anything, bytes.
_KERNEL_BYTES: Final = 200 << 20
#: Of all facets.
_MOST_CORNERS: Final = 60_000_000
#: What the process does. The kernel writes its messages to stdout, where the facets go.
_FACETED: Final = """
import os, sys
kind, linear, angular, most_bytes, most_s = sys.argv[1:]
try:
    import resource
    for name, most in (("DATA", most_bytes), ("CPU", most_s), ("CORE", 0)):
        resource.setrlimit(getattr(resource, "RLIMIT_" + name), (int(most), int(most)))
except (ImportError, OSError, ValueError):
    pass
out = os.fdopen(os.dup(1), "wb")
os.dup2(2, 1)
import cascadio
model = sys.stdin.buffer.read()
out.write(cascadio.load(model, kind, float(linear), float(angular), use_parallel=False))
out.close()
"""


def cad_mesh(path: Path, suffix: str, **placement: Any) -> Mesh:
    """Read a CAD model, repair its mesh and place it.

    Parameters
    ----------
    path
        The file.
    suffix
        One of `KINDS`.
    **placement
        What `Mesh.from_arrays` takes; `scale` is a factor on the unit that the file states.

    Raises
    ------
    ModelError
        The file is damaged, or makes no surface.
    SettingError
        There is no kernel: the extra ``step`` is not installed.
    """
    if importlib.util.find_spec("cascadio") is None:
        msg = (
            f"{path}: a CAD model needs Open CASCADE: pip install 'wireprint[step]', or export it "
            "as STL or 3MF"
        )
        raise SettingError(msg)
    with named(path):
        scene = _scene(path, KINDS[suffix])
        vertices: list[Any] = []
        faces: list[Any] = []
        count = 0
        for found in gltf.primitives(scene, _MOST_CORNERS):
            if found.mode == gltf.TRIANGLES:
                vertices.append(found.places * _METRES[KINDS[suffix]])
                faces.append(found.order.reshape(-1, 3).astype(np.uint32) + np.uint32(count))
                count += len(found.places)
        if not faces:
            raise ModelError("it holds no solid and no surface")
        return Mesh.from_arrays(joined(vertices), joined(faces), **placement)


def _scene(path: Path, kind: str) -> bytes:
    """Return a model as a glTF scene, z up.

    Raises
    ------
    ModelError
        The kernel cannot read it.
    """
    try:
        with path.open("rb") as file:
            most_s = math.ceil(_PATIENCE_S + _PATIENCE_S_PER_BYTE * path.stat().st_size)
            most = (memory_budget() + _KERNEL_BYTES, most_s)
            done = subprocess.run(  # noqa: S603
                [sys.executable, "-c", _FACETED, kind]
                + [str(number) for number in (DEFLECTION_MM, DEFLECTION_RAD, *most)],
                stdin=file,
                capture_output=True,
                check=False,
                timeout=_WAITING * most_s,
            )
    except OSError as error:
        raise ModelError(f"cannot be read: {error.strerror}") from error
    except subprocess.TimeoutExpired:
        raise ModelError(f"{_KERNEL} is not done after {_WAITING * most_s} s; {_WAY_OUT}") from None
    if done.returncode == 0 and done.stdout:
        return done.stdout
    if done.returncode in _STOPPED:
        raise ModelError(f"{_KERNEL} is not done after {most_s} s of work; {_WAY_OUT}")
    why = _why(done.stderr) or (
        f"{_KERNEL} fails over it" if done.returncode else "no solid and no surface is in it"
    )
    raise ModelError(f"no {kind.upper()} that can be read: {why}; {_WAY_OUT}")


def _why(said: bytes) -> str:
    """Return what the kernel complains of; empty: nothing."""
    text = said.decode(errors="replace")
    if "MemoryError" in text or "bad_alloc" in text:
        return f"{_KERNEL} needs more memory than WIREPRINT_MEMORY allows"
    found = re.search(r"ERR \w+ : (?:Undefined Parsing: )?([^*]+?)\s*\*", text)
    return found[1] if found else ""

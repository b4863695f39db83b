"""The package's modules import each other without a circle, wherever the import stands.

What is imported for type checkers alone counts, too; only the package's table of names does not.
"""

import ast
import graphlib
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "python" / "wireprint"


def modules():
    """Return each module's dotted name with its file; a package stands for its ``__init__``."""
    found = {"wireprint._core": PACKAGE / "_core.pyi"}
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imported(node, known):
    """Yield the modules that a piece of code names in its imports."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from (name.name for name in child.names if name.name in known)
        elif isinstance(child, ast.ImportFrom) and child.module in known:
            for name in child.names:
                inner = f"{child.module}.{name.name}"
                yield inner if inner in known else child.module
        else:
            yield from imported(child, known)


def graph():
    known = modules()
    return {
        name: set(imported(ast.parse(path.read_text(encoding="utf-8")), known)) - {name}
        for name, path in known.items()
        if name != "wireprint"
    }


def test_no_modules_import_each_other_in_a_circle():
    found = graph()
    assert sum(map(len, found.values())) > len(found)
    try:
        graphlib.TopologicalSorter(found).prepare()
    except graphlib.CycleError as error:
        raise AssertionError(" → ".join(error.args[1])) from None


def test_a_circle_would_be_found():
    tree = ast.parse("def f():\n    from b import c\nif TYPE_CHECKING:\n    import d\n")
    assert set(imported(tree, {"b", "b.c", "d"})) == {"b.c", "d"}

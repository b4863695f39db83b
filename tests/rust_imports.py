"""Which file of the Rust core imports from which, read from its `use` statements and paths.

A name counts as imported from the file that defines it, whichever modules hand it on; a module that
merely hands names on (`pub use`) does not import them. Tests within the files do not count.
"""

import re
from dataclasses import dataclass, field

#: Comments, strings and characters; a lifetime is no character.
_NOISE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|r(\#*)".*?"\1|"(?:\\.|[^"\\])*"|'(?:\\[^']*|[^'\\])'""", re.DOTALL
)
_TESTS = re.compile(r"#\[cfg\(test\)\]\s*(?:pub(?:\([^)]*\))?\s+)?(?:#\[[^]]*\]\s*)*")
_USE = re.compile(r"(?:^|(?<=[;{}\n\]]))\s*(pub(?:\([^)]*\))?\s+)?use\s+([^;]+);")
_ITEM = re.compile(
    r"\b(?:fn|struct|enum|union|trait|type|const|static|macro_rules!)\s+(?:mut\s+)?([A-Za-z_]\w*)"
)
_TYPE = re.compile(r"\b(?:struct|enum|union|trait|type)\s+([A-Z]\w*)\s*[;:<({=]")
_PATH = re.compile(r"(?<![\w:])[A-Za-z_]\w*(?:\s*::\s*[A-Za-z_]\w*)+")
_NAME = re.compile(r"[A-Za-z_]\w*")


@dataclass
class Module:
    """A file as a module: what it defines, what it brings into scope, what its code names."""

    path: tuple[str, ...]
    items: set[str] = field(default_factory=set)
    #: Name in scope → path as written, and whether it is handed on.
    uses: dict[str, tuple[tuple[str, ...], bool]] = field(default_factory=dict)
    #: Modules of which everything is brought into scope.
    globs: list[tuple[str, ...]] = field(default_factory=list)
    names: set[str] = field(default_factory=set)
    paths: set[tuple[str, ...]] = field(default_factory=set)


def imports(root):
    """Edges from file to file, as names relative to `root` (a crate's `src`), sorted."""
    modules, files = {}, {}
    for file in sorted(root.rglob("*.rs")):
        path = _module_path(file.relative_to(root))
        modules[path] = read(path, file.read_text(encoding="utf-8"))
        files[path] = file.relative_to(root).as_posix()
    tests = _test_files(root)
    hidden = {path for path in modules if any(path[: len(test)] == test for test in tests)}
    edges = {
        (files[path], files[target])
        for path, module in modules.items()
        if path not in hidden
        for target in _targets(module, modules)
        if target != path
    }
    return sorted(edges)


def types(root):
    """The types that each file defines for itself or others, by name, but those of tests."""
    tests = _test_files(root)
    found = {}
    for file in sorted(root.rglob("*.rs")):
        own = file.relative_to(root)
        path = _module_path(own)
        if any(path[: len(test)] == test for test in tests):
            continue
        code = _without_tests(_NOISE.sub(" ", file.read_text(encoding="utf-8")))
        # What a trait or its implementations call `Item` is no type of its own.
        for name in re.findall(r"^(?:pub(?:\([^)]*\))? )?" + _TYPE.pattern, code, re.MULTILINE):
            found.setdefault(name, []).append(own.as_posix())
    return found


def read(path, text):
    """A module from its source."""
    code = _without_tests(_NOISE.sub(" ", text))
    module = Module(path)
    for match in _USE.finditer(code):
        for written, alias in _flat(match[2]):
            if written[-1] == "*":
                module.globs.append(written[:-1])
            elif alias != "_":
                module.uses[alias] = written, bool(match[1])
            else:
                module.paths.add(written)
    body = _USE.sub(";", code)
    module.items = set(_ITEM.findall(body))
    module.names = set(_NAME.findall(body))
    module.paths |= {tuple(re.split(r"\s*::\s*", path)) for path in _PATH.findall(body)}
    return module


def _module_path(file):
    parts = [*file.parts[:-1], file.stem]
    return tuple(parts[:-1] if parts[-1] in ("mod", "lib") else parts)


def _test_files(root):
    """Modules that are declared for tests alone."""
    declared = re.compile(
        r"#\[cfg\(test\)\]\s*(?:#\[[^]]*\]\s*)*(?:pub(?:\([^)]*\))?\s+)?mod\s+(\w+)\s*;"
    )
    return {
        (*_module_path(file.relative_to(root)), name)
        for file in root.rglob("*.rs")
        for name in declared.findall(file.read_text(encoding="utf-8"))
    }


def _without_tests(code):
    """Drop each item that stands under `#[cfg(test)]`, to its closing brace or semicolon."""
    kept, end = [], 0
    for match in _TESTS.finditer(code):
        if match.start() < end:
            continue
        kept.append(code[end : match.start()])
        depth, end = 0, match.end()
        for end in range(match.end(), len(code)):
            depth += {"{": 1, "}": -1}.get(code[end], 0)
            if depth == 0 and code[end] in ";}":
                break
        end += 1
    return "".join([*kept, code[end:]])


def _flat(tree):
    """Yield the paths of a use tree, each with the name that it gives."""
    tree = tree.strip()
    if "{" not in tree:
        path, _, alias = (part.strip() for part in re.sub(r"\s+as\s+", "|", tree).partition("|"))
        parts = tuple(part.strip() for part in path.split("::") if part.strip())
        if parts:
            yield parts, alias or parts[-1]
        return
    head, _, rest = tree.partition("{")
    inner, depth, start = rest[: rest.rindex("}")], 0, 0
    prefix = tuple(part.strip() for part in head.split("::") if part.strip())
    for place, char in enumerate([*inner, ","]):
        depth += {"{": 1, "}": -1}.get(char, 0)
        if char == "," and depth == 0:
            for parts, alias in _flat(inner[start:place]):
                own = parts[0] == "self" and len(parts) == 1
                yield (
                    prefix + (() if own else parts),
                    prefix[-1] if own and alias == "self" else alias,
                )
            start = place + 1


def _targets(module, modules):
    """Yield the modules in whose files what a module uses is defined."""
    for name, (written, handed_on) in module.uses.items():
        if not handed_on or name in module.names:
            yield from _definition(_absolute(module, written, modules), modules)
    for written in module.paths:
        first, *rest = written
        if first in module.uses:
            written = (*module.uses[first][0], *rest)
        yield from _definition(_absolute(module, written, modules), modules)
    for written in module.globs:
        source = modules.get(_absolute(module, written, modules))
        if source is not None:
            for name in module.names & {*source.items, *source.uses}:
                yield from _definition((*source.path, name), modules)


def _absolute(module, written, modules):
    """A path from the crate's root; None for what lies in other crates."""
    here = module.path
    if written[0] == "crate":
        return written[1:]
    if written[0] in ("self", "super"):
        while written and written[0] in ("self", "super"):
            here = here[:-1] if written[0] == "super" else here
            written = written[1:]
        return here + written
    if (*here, written[0]) in modules or written[0] in module.items:
        return here + written
    return None


def _definition(path, modules, seen=()):
    """Yield the module that defines what a path names; none for a mere module, or if unknown."""
    if path is None or path in seen:
        return
    for length in range(len(path), -1, -1):
        if path[:length] in modules:
            break
    module, rest = modules[path[:length]], path[length:]
    if not rest:
        return
    name, *inner = rest
    if name in module.items:
        yield module.path
    elif name in module.uses:
        written = (*module.uses[name][0], *inner)
        yield from _definition(_absolute(module, written, modules), modules, (*seen, path))
    else:
        for written in module.globs:
            source = _absolute(module, written, modules)
            if source is not None:
                yield from _definition(source + rest, modules, (*seen, path))

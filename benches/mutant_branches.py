"""Breakages of Rust sources as branches: each is taken where the environment names its number.

What `cargo mutants` would change in the text is found in the syntax tree and becomes
`if broken(N) { changed } else { original }`, so that many breakages need one build.
"""

import re

import tree_sitter_rust
from tree_sitter import Language, Parser

#: The environment variable that names the breakage to take; 0 or none for none.
CHOSEN = "WIREPRINT_MUTANT"
#: Asks for a breakage; in the crate's root.
ASK = f"""
/// Whether the breakage of this number is taken.
#[doc(hidden)]
pub fn broken(number: u32) -> bool {{
    static CHOSEN: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    let told = || std::env::var("{CHOSEN}").ok().and_then(|told| told.parse().ok()).unwrap_or(0);
    *CHOSEN.get_or_init(told) == number
}}
"""
#: A breakage in the text.
NUMBER = re.compile(r"\bbroken\((\d+)\)")
PARSER = Parser(Language(tree_sitter_rust.language()))


def write(path, content):
    """Write a file, if that changes it: builds go by the time of the last change."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != content:
        path.write_bytes(content)


def branch(tree, mutants):
    """Rewrite the sources below `tree`; gives those of the mutants that could be made branches.

    A mutant is as `cargo mutants --list --json` tells it; the sources are as it found them.
    """
    made = {}
    for name in sorted({mutant["file"] for mutant in mutants.values()}):
        source = (tree / name).read_bytes()
        own = {n: mutant for n, mutant in mutants.items() if mutant["file"] == name}
        writer = Branches(source, own)
        write(tree / name, writer.text(writer.root).encode())
        made |= {n: own[n] for n in sorted(writer.made)}
    root = tree / "rust/core/src/lib.rs"
    write(root, root.read_bytes() + ASK.encode())
    return {n: made[n] for n in mutants if n in made}


def without(tree, mutants, errors):
    """Leave out the mutants that do not compile.

    `errors` are pairs of a path below `tree`, as `branch` left it, line and column there.
    """
    gone = set()
    for path, line, column in errors:
        lines = (tree / path).read_text().split("\n")
        # An error in a constant lies in the question itself.
        reach = column + len("crate::")
        before = [at[1] for at in NUMBER.finditer(lines[line - 1]) if at.start() < reach]
        # A branch comes behind its number, what a `match` lacks before its arms.
        behind = NUMBER.findall("\n".join([lines[line - 1][column:], *lines[line:]]))
        arms = [n for n in behind if mutants[int(n)]["genre"] == "MatchArm"]
        gone |= {int(n) for n in before[-1:] or arms[:1]}
    if not gone:
        raise SystemExit(f"errors in no mutant: {sorted(errors)[:5]}")
    return {n: mutant for n, mutant in mutants.items() if n not in gone}


class Branches:
    """Source with its mutants, written as branches on the way through its syntax tree."""

    def __init__(self, source, mutants):
        self.source = source
        self.root = PARSER.parse(source).root_node
        self.made = set()
        self.at = {}
        for number, mutant in mutants.items():
            if node := self.place(mutant):
                self.at.setdefault(node.id, []).append((number, mutant))

    def place(self, mutant):
        """Find the node that a mutant changes as a whole; None where there is none of its kind."""
        start, end = (self.byte(mutant["span"][side]) for side in ("start", "end"))
        node = self.root.descendant_for_byte_range(start, end)
        kinds = {
            "BinaryOperator": ("binary_expression", "compound_assignment_expr"),
            "UnaryOperator": ("unary_expression",),
            "StructField": ("field_initializer", "shorthand_field_initializer"),
            "MatchArm": ("match_arm",),
            "MatchArmGuard": ("match_pattern",),
            "FnValue": ("function_item",),
        }[mutant["genre"]]
        # The operator of a chain with `let` belongs to no expression of its own.
        while node and node.type not in kinds:
            if node.type in ("let_chain", "const_item", "static_item"):
                return None
            node = node.parent
        return None if node and self.is_constant(node) else node

    def is_constant(self, node):
        """Whether a node is part of a constant, which can ask nothing."""
        while node and node.type not in ("const_item", "static_item"):
            node = node.parent
        return node is not None

    def byte(self, place):
        """Offset of a line and column, both of which count from 1, columns in characters."""
        lines = self.source.split(b"\n")
        before = sum(len(line) + 1 for line in lines[: place["line"] - 1])
        line = lines[place["line"] - 1].decode()
        return before + len(line[: place["column"] - 1].encode())

    def text(self, node):
        """Text of a node, with the branches of all mutants in it."""
        parts, at = [], node.start_byte
        for child in node.children:
            parts += [self.raw(at, child.start_byte), self.text(child)]
            at = child.end_byte
        parts.append(self.raw(at, node.end_byte))
        text = "".join(parts)
        for number, mutant in self.at.get(node.id, []):
            changed = getattr(self, mutant["genre"])(node, text, f"crate::broken({number})", mutant)
            if changed:
                text = changed
                self.made.add(number)
        return text

    def raw(self, start, end):
        """Text between two offsets."""
        return self.source[start:end].decode()

    def BinaryOperator(self, node, text, asked, mutant):  # noqa: N802, named by cargo mutants
        """Another operator between the same operands."""
        left, right = (self.text(node.child_by_field_name(side)) for side in ("left", "right"))
        if node.type == "compound_assignment_expr":
            changed = f"{left} {mutant['replacement']} {right}"
        else:
            changed = f"({left}) {mutant['replacement']} ({right})"
        return f"(if {asked} {{ {changed} }} else {{ {text} }})"

    def UnaryOperator(self, node, text, asked, mutant):  # noqa: N802
        """No operator."""
        return f"(if {asked} {{ {self.text(node.children[-1])} }} else {{ {text} }})"

    def StructField(self, node, text, asked, mutant):  # noqa: N802
        """The field of the struct that the others come from."""
        base = next((c for c in node.parent.children if c.type == "base_field_initializer"), None)
        name = self.raw(node.children[0].start_byte, node.children[0].end_byte)
        value = node.child_by_field_name("value")
        if base is None or name.startswith("#"):
            return None
        own = self.text(value) if value else name
        return (
            f"{name}: (if {asked} {{ ({self.text(base.children[-1])}).{name} }} else {{ {own} }})"
        )

    def MatchArm(self, node, text, asked, mutant):  # noqa: N802
        """An arm that is never taken."""
        pattern = node.child_by_field_name("pattern")
        own = self.text(pattern)
        if pattern.child_by_field_name("condition"):
            return None
        return text.replace(own, f"{own} if !{asked}", 1)

    def MatchArmGuard(self, node, text, asked, mutant):  # noqa: N802
        """A guard that always or never lets through."""
        condition = node.child_by_field_name("condition")
        if condition is None or condition.type in ("let_chain", "let_condition"):
            return None
        own = self.text(condition)
        # Another breakage of the same guard may stand around it already.
        head, tail = text[: text.rindex(own)], text[text.rindex(own) + len(own) :]
        always = mutant["replacement"] == "true"
        changed = f"({asked} || {own})" if always else f"(!{asked} && ({own}))"
        return head + changed + tail

    def FnValue(self, node, text, asked, mutant):  # noqa: N802
        """A function that does nothing but return a value."""
        returned = node.child_by_field_name("return_type")
        if returned and self.raw(returned.start_byte, returned.end_byte).startswith("impl"):
            return None
        if any(child.type == "function_modifiers" for child in node.children):
            return None
        # Nothing is broken in a signature, so it is as it was, whatever the body has become.
        head = self.raw(node.start_byte, node.child_by_field_name("body").start_byte)
        body = text[len(head) :]
        return f"{head}{{ if {asked} {{ return {mutant['replacement']}; }} {body[1:]}"

"""Expressions of PrusaSlicer's and OrcaSlicer's placeholders: numbers, texts and choices."""

from __future__ import annotations

import math
import operator
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


_MOST_DEPTH: Final = 40
_TOKEN: Final = re.compile(
    r"\s*(?:(\d+\.?\d*|\.\d+)|([A-Za-z_]\w*)|\"((?:[^\"\\]|\\.)*)\"|(=~|!~)|(\/(?:[^/\\]|\\.)*\/)"
    r"|(==|!=|<>|<=|>=|&&|\|\||[-+*/%<>!?:(),\[\]=]))"
)


#: A pattern that finds one of several words anywhere.
_WORDS: Final = re.compile(r"/(?:\.\*)?\(?([\w @.\-|]+)\)?(?:\.\*)?/")


class Unknown(Exception):  # noqa: N818 - a way to say so, not a failure
    """A placeholder that nothing is known of."""


@dataclass(frozen=True)
class Ours:
    """A name of our own sequences, such as ``nozzle_c``, and the number that it stands for."""

    name: str
    #: None: it differs from print to print, so nothing can be computed from it.
    number: float | None = None
    #: Whether it stands for what is computed from it, too: a height differs from print to print.
    follows: bool = False


@dataclass(frozen=True)
class Missing:
    """What nothing is known of; it may stand where it is not asked for after all."""

    name: str


#: What an expression amounts to: a number, a truth value, a text, one of our own names, or nothing.
Value = float | bool | str | Ours | Missing


class _Parser:
    """Reads one expression by recursive descent; precedence as in C."""

    def __init__(self, text: str, lookup: Callable[[str, int | None], Value]) -> None:
        self.tokens: list[tuple[str, str]] = []
        at = 0
        while at < len(text.rstrip()):
            found = _TOKEN.match(text, at)
            if not found:
                raise Unknown(text)
            kinds = ("number", "name", "text", "sign", "pattern", "sign")
            kind, value = next(
                (kind, group)
                for kind, group in zip(kinds, found.groups(), strict=True)
                if group is not None
            )
            self.tokens.append((kind, value))
            at = found.end()
        self.at = 0
        self.depth = 0
        self.lookup = lookup
        self.text = text

    def whole(self) -> Value:
        value = self.choice()
        if self.at != len(self.tokens):
            raise Unknown(self.text)
        return value

    def peek(self) -> str:
        kind, value = self.tokens[self.at] if self.at < len(self.tokens) else ("", "")
        return value if kind in ("sign", "name") else ""

    def take(self, *signs: str) -> str:
        sign = self.peek()
        if sign and sign in signs:
            self.at += 1
            return sign
        return ""

    def need(self, sign: str) -> None:
        if not self.take(sign):
            raise Unknown(self.text)

    def choice(self) -> Value:
        self.depth += 1
        if self.depth > _MOST_DEPTH:
            raise Unknown(self.text)
        value = self.either()
        if self.take("?"):
            first = self.choice()
            self.need(":")
            second = self.choice()
            value = first if is_true(value) else second
        self.depth -= 1
        return value

    def either(self) -> Value:
        value = self.both()
        while self.take("or", "||"):
            other = self.both()
            value = is_true(value) or is_true(other)
        return value

    def both(self) -> Value:
        value = self.compared()
        while self.take("and", "&&"):
            other = self.compared()
            value = is_true(value) and is_true(other)
        return value

    def compared(self) -> Value:
        value = self.sum()
        while sign := self.take("==", "=", "!=", "<>", "<=", ">=", "<", ">", "=~", "!~"):
            if sign in ("=~", "!~"):
                value = self.matched(value, sign)
                continue
            value = _compared(sign, value, self.sum())
        return value

    def matched(self, value: Value, sign: str) -> bool:
        kind, pattern = self.tokens[self.at] if self.at < len(self.tokens) else ("", "")
        # No pattern of others is run as one: those that mean plain words are looked for as such.
        words = _WORDS.fullmatch(pattern)
        if kind != "pattern" or not isinstance(value, str) or words is None:
            raise Unknown(self.text)
        self.at += 1
        found = any(word in value for word in words[1].split("|"))
        return found is (sign == "=~")

    def sum(self) -> Value:
        value = self.product()
        while sign := self.take("+", "-"):
            other = self.product()
            if sign == "+" and (isinstance(value, str) or isinstance(other, str)):
                value = _as_text(value) + _as_text(other)
            else:
                found = _number(value) + _number(other) * (1 if sign == "+" else -1)
                value = _still_ours(found, value, other)
        return value

    def product(self) -> Value:
        value = self.factor()
        while sign := self.take("*", "/", "%"):
            other = self.factor()
            left, right = _number(value), _number(other)
            if sign != "*" and right == 0:
                raise Unknown(self.text)
            if sign == "%":
                found = math.fmod(left, right)
            else:
                found = left * right if sign == "*" else left / right
            value = _still_ours(found, value, other)
        return value

    def factor(self) -> Value:
        if self.take("-"):
            return -_number(self.factor())
        if self.take("+"):
            return _number(self.factor())
        if self.take("!", "not"):
            return not is_true(self.factor())
        if self.take("("):
            value = self.choice()
            self.need(")")
            return value
        if self.at >= len(self.tokens):
            raise Unknown(self.text)
        kind, value = self.tokens[self.at]
        self.at += 1
        if kind == "number":
            return float(value)
        if kind == "text":
            return value
        if kind != "name":
            raise Unknown(self.text)
        if value in ("true", "false"):
            return value == "true"
        if value == "is_nil" and self.take("("):
            of = self.choice()
            self.need(")")
            return isinstance(of, Missing) or of == "nil"
        if self.take("("):
            return self.called(value)
        index = None
        if self.take("["):
            index = int(_number(self.choice()))
            self.need("]")
        try:
            return self.lookup(value, index)
        except Unknown:
            return Missing(value)

    def called(self, name: str) -> Value:
        arguments = [self.choice()]
        while self.take(","):
            arguments.append(self.choice())
        self.need(")")
        numbers = [_number(value) for value in arguments]
        if name in ("min", "max"):
            return _still_ours(min(numbers) if name == "min" else max(numbers), *arguments)
        if name in ("int", "floor", "ceil", "round") and len(numbers) == 1:
            turned: dict[str, Callable[[float], float]] = {
                "int": math.trunc,
                "floor": math.floor,
                "ceil": math.ceil,
                "round": round,
            }
            return _still_ours(float(turned[name](numbers[0])), *arguments)
        if name in ("digits", "zdigits"):
            return _still_ours(numbers[0], arguments[0])
        raise Unknown(self.text)


def _still_ours(number: float, *of: Value) -> Value:
    """Return what was computed; from the height of a print comes a height above it."""
    above = [one for one in of if isinstance(one, Ours) and one.follows]
    return Ours(above[0].name, number, follows=True) if above else number


def _as_text(value: Value) -> str:
    """Return a value as the text that it becomes beside a text."""
    if isinstance(value, str):
        return value
    return f"{_number(value):.10g}"


def _number(value: Value) -> float:
    if isinstance(value, Ours):
        if value.number is None:
            raise Unknown(value.name)
        return value.number
    if isinstance(value, Missing):
        raise Unknown(value.name)
    if isinstance(value, str):
        try:
            return float(value)
        except ValueError:
            raise Unknown(value) from None
    return float(value)


def is_true(value: Value) -> bool:
    """Return whether a condition holds; a text is none."""
    if isinstance(value, str):
        raise Unknown(value)
    return bool(_number(value))


def _compared(sign: str, left: Value, right: Value) -> bool:
    if isinstance(left, str) and isinstance(right, str):
        pair: tuple[float | str, float | str] = (left, right)
    else:
        pair = (_number(left), _number(right))
    tests: Mapping[str, Callable[[object, object], bool]] = {
        "==": operator.eq,
        "=": operator.eq,
        "!=": operator.ne,
        "<>": operator.ne,
    }
    if sign in tests:
        return tests[sign](*pair)
    low, high = pair
    if isinstance(low, str) or isinstance(high, str):
        raise Unknown(sign)
    return {"<": low < high, ">": low > high, "<=": low <= high, ">=": low >= high}[sign]


def evaluated(text: str, lookup: Callable[[str, int | None], Value]) -> Value:
    """Return what an expression amounts to.

    Raises
    ------
    Unknown
        It asks for what is not known, or is none.
    """
    try:
        found = _Parser(text, lookup).whole()
    except (OverflowError, ValueError):
        raise Unknown(text) from None
    if isinstance(found, float) and not math.isfinite(found):
        raise Unknown(text)
    return found

"""Insert product signs, expand coordinates in parentheses, and expand chains of comparisons.

``(1+2i)(3+j)`` is a product. So is ``ij``, if ``i`` and ``j`` are names and ``ij`` is not. ``(0,1,0,0)`` is
``i``, and ``a == b == c`` is ``a == c and b == c``. Ambiguous texts are rejected.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NoReturn

from hfield.errors import NotationError, shorten
from hfield.syntax.typed import Letters, Typed

MAX_DEPTH = 100  # of parentheses and prefixes: each costs the parser three frames
_BASIS = frozenset("eijk")
_QUATERNIONS = frozenset("ijkpqruvw")
_SCALARS = ("norm", "trace", "scalar", "dot", "abs")
_FUNCTIONS = (
    *_SCALARS,
    "conj",
    "inv",
    "vector",
    "comm",
    "cross",
    "sqrt",
    "cos",
    "sin",
    "exp",
    "log",
)
_MATRICES = ("matrix", "column", "row", "transpose")
_KEYWORDS = frozenset(("and", "or", "not", "exists"))
# Words made of known letters that are not read as products.
_WORDS = frozenset(["pi", "exp", "sqrt", "tr", "re", "sp", "true", "every", "set", "yet"])
MAX_SPLIT = 4  # letters of a word read as a product, unless it consists of e, i, j and k
_LOGIC = ("=>", "<=>", ":", *_KEYWORDS)
_TYPED_COMPARISON = re.compile(r"[=<>!]+")
_COMPARISONS = ("==", "!=", "<=", ">=", "<", ">")
_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![\w.]))?)"
    r"|(?P<name>[^\W\d]\w*)|(?P<sign><=>|=>|==|!=|<=|>=|\*\*|\S))"
)


@dataclass(frozen=True)
class Vocabulary:
    """The known words: ``letters``, whose products need no sign, other ``names``, and ``functions``."""

    letters: frozenset[str]
    names: frozenset[str] = frozenset()
    functions: frozenset[str] = frozenset()

    @classmethod
    @lru_cache(maxsize=256)
    def of_statements(
        cls,
        letters: frozenset[str] = frozenset("pqruvwstxyzLMN"),
        names: frozenset[str] = frozenset(),
        functions: frozenset[str] = frozenset(),
    ) -> Vocabulary:
        """Return the words of statements, together with those of a field or an algebra."""
        short = {name for name in names if len(name) == 1}
        return cls(letters | _BASIS | short, names, functions.union(_FUNCTIONS, _MATRICES))

    @classmethod
    def of_names(cls, names: Iterable[str], functions: Iterable[str] = ()) -> Vocabulary:
        """Return the words of terms with these names and functions."""
        known = frozenset(names)
        letters = frozenset(name for name in known if len(name) == 1)
        return cls(letters, known, frozenset(functions).union(_FUNCTIONS))

    @property
    def has_coordinates(self) -> bool:
        """Whether i, j and k are known, so that coordinates can be written as a sum."""
        return self.letters >= {"i", "j", "k"}

    def factors(self, word: str) -> str:
        """Return the letters whose product is a word; nothing for a word that is a name or unknown."""
        if word in self.names or word in self.functions or word in _KEYWORDS or word in _WORDS:
            return ""
        if not self.letters.issuperset(word):
            return ""
        return word if len(word) <= MAX_SPLIT or _BASIS.issuperset(word) else ""

    def is_operand(self, word: str) -> bool:
        """Return whether a word is a value, or a product of values."""
        return word in self.names or bool(self.factors(word))


@dataclass
class _Token:
    kind: str  # "number", "name" or "sign"
    text: str
    letters: Letters  # with the blanks in front

    @property
    def is_spaced(self) -> bool:
        return len(self.letters.text) > len(self.text)

    @property
    def place(self) -> int:
        return self.letters.places[len(self.letters.text) - len(self.text)]


@dataclass
class _Group:
    """A pair of brackets; ``close`` is None if the text ends before the closing bracket."""

    open: _Token
    items: list[_Token | _Group] = field(default_factory=list)
    close: _Token | None = None

    @property
    def is_spaced(self) -> bool:
        return self.open.is_spaced

    @property
    def place(self) -> int:
        return self.open.place


_Items = list["_Token | _Group"]


def write_products(letters: Letters, source: str, vocabulary: Vocabulary) -> Typed:
    """Insert the product signs in a text; ``source`` is the typed text.

    Raises :class:`NotationError` if a product has two readings, or a coordinate is not a scalar.
    """
    items, depth = _grouped(letters)
    if depth > MAX_DEPTH:  # the parser refuses it
        return Typed(source, letters.text, letters.places)
    writer = _ProductWriter(source, vocabulary)
    written = writer.body(items)
    written += letters[len(letters.text.rstrip()) :]
    return Typed(source, written.text, written.places, tuple(writer.remarks))


def _grouped(letters: Letters) -> tuple[_Items, int]:
    """Return the tokens of a text, nested by brackets, and the depth of nesting."""
    items: _Items = []
    stack: list[tuple[_Items, _Group]] = []
    deepest = 0
    for found in _TOKEN.finditer(letters.text):
        kind = found.lastgroup or ""
        token = _Token(kind, found[kind], letters[found.start() : found.end()])
        if token.text in ("(", "["):
            group = _Group(token)
            items.append(group)
            stack.append((items, group))
            items = group.items
            deepest = max(deepest, len(stack))
        elif token.text in (")", "]") and stack:
            items, group = stack.pop()
            group.close = token
        else:
            items.append(token)
    return (stack[0][0] if stack else items), deepest


def _split(items: _Items, signs: Collection[str]) -> tuple[list[_Items], list[_Token]]:
    """Split items at tokens; return the parts, and the tokens between them."""
    parts: list[_Items] = [[]]
    between: list[_Token] = []
    for item in items:
        if isinstance(item, _Token) and item.text in signs:
            between.append(item)
            parts.append([])
        else:
            parts[-1].append(item)
    return parts, between


class _ProductWriter:
    """Rewrites one text; ``remarks`` report unexpected readings."""

    def __init__(self, source: str, vocabulary: Vocabulary) -> None:
        self.source, self.vocabulary = source, vocabulary
        self.remarks: dict[str, None] = {}

    def fail(self, message: str, place: int) -> NoReturn:
        raise NotationError(message, self.source, place)

    def body(self, items: _Items) -> Letters:
        """Write the content of brackets, or the whole text."""
        parts, commas = _split(items, (",",))
        written = [self.clause(parts[0])]
        for comma, part in zip(commas, parts[1:], strict=True):
            written += [comma.letters, self.clause(part)]
        return Letters.join(written)

    def clause(self, items: _Items) -> Letters:
        """Write a statement or a term; a chain of comparisons becomes a conjunction."""
        runs, words = _split(items, _LOGIC)
        written = [self.comparison(runs[0], False)]
        for word, run in zip(words, runs[1:], strict=True):
            written += [word.letters, self.comparison(run, word.text == "not")]
        return Letters.join(written)

    def comparison(self, items: _Items, negated: bool) -> Letters:
        """Write a comparison, or a chain of them."""
        terms, signs = _split(items, _COMPARISONS)
        sides = [self.term(term) for term in terms]
        operators = [sign.text for sign in signs]
        if len(signs) < 2 or "!=" in operators:
            written = [sides[0]]
            for sign, side in zip(signs, sides[1:], strict=True):
                written += [sign.letters, side]
            return Letters.join(written)
        if set(operators) == {"=="}:
            pairs = [(side, "==", sides[-1]) for side in sides[:-1]]
        else:
            pairs = list(zip(sides, operators, sides[1:], strict=False))
        for n, side in enumerate(map(Letters.strip, sides)):  # errors that name the typed text
            if not side.text:
                place = signs[max(n - 1, 0)].place
                where = "after" if n else "before"
                typed = _TYPED_COMPARISON.match(self.source, place)
                shown = typed[0] if typed else self.source[place]
                self.fail(f"expected a number, a name or '(' {where} {shown!r}", place)
            if side.text[-1] in "+-*/^":
                self.fail(
                    f"expected a number, a name or '(' after {side.text[-1]!r}", side.places[-1]
                )
        chain = Letters("", ())
        for left, operator, right in pairs:
            chain = chain + " and " if chain.text else chain
            chain = chain + left.strip() + f" {operator} " + right.strip()
        blanks = sides[0][: len(sides[0].text) - len(sides[0].text.lstrip())]
        if negated:
            place = chain.places[0]
            chain = Letters.written("(", place) + chain + ")"
        return blanks + chain + sides[-1][len(sides[-1].text.rstrip()) :]

    def term(self, items: _Items) -> Letters:
        """Write a term with a sign in each product."""
        parts: list[Letters] = []
        before = ""  # the preceding item: an "operand", a "function", "unknown", or a sign
        quotient: list[_Token | _Group] = []  # a summand with a "/", and the divisors so far
        start = 0  # of the summand
        last: _Token | _Group | None = None
        for n, item in enumerate(items):
            follows = items[n + 1] if n + 1 < len(items) else None
            kind = self.kind(item, before, follows)
            multiplies = kind in ("operand", "function") and not _is_number(item)
            if kind == "unknown" and last is not None and _is_number(last):
                multiplies = not item.is_spaced  # 2foo: the error will be about foo
            if before == "operand" and multiplies:
                if quotient:
                    self.need_one_reading(quotient, item)
                    quotient = []
                parts.append(Letters.written("*", item.place))
                parts.append(self.written(item, False).strip())
            else:
                parts.append(self.written(item, before in ("function", "unknown")))
            if isinstance(item, _Token) and item.kind == "sign":
                if item.text == "/":
                    quotient = [*items[start : n + 1]]
                elif quotient and isinstance(last, _Token) and last.kind == "sign":
                    quotient.append(item)  # a sign, or the second of an operator
                elif item.text in ("*", "+", "-"):
                    quotient = []
                elif quotient:
                    quotient.append(item)
                if item.text in ("+", "-") and before not in ("**", "^", "/", "*"):
                    start = n + 1
                before = item.text
            else:
                if quotient:
                    if self.is_product(item) and before in ("/", "-", "+"):
                        self.need_one_reading(quotient, item)
                    quotient.append(item)
                before = "operand" if kind == "index" else kind
            last = item
        return Letters.join(parts)

    def kind(self, item: _Token | _Group, before: str, follows: _Token | _Group | None) -> str:
        """Return what an item is: an ``operand``, a ``function``, ``unknown`` or a sign."""
        if isinstance(item, _Group):
            return "index" if item.open.text == "[" and before == "operand" else "operand"
        if item.kind != "name":
            return "operand" if item.kind == "number" else item.text
        is_called = isinstance(follows, _Group) and follows.open.text == "("
        if is_called and item.text in self.vocabulary.functions:
            return "function"
        return "operand" if self.vocabulary.is_operand(item.text) else "unknown"

    def is_product(self, item: _Token | _Group) -> bool:
        """Return whether an item is a word of several factors."""
        return (
            isinstance(item, _Token)
            and item.kind == "name"
            and len(self.vocabulary.factors(item.text)) > 1
        )

    def need_one_reading(self, quotient: _Items, item: _Token | _Group) -> None:
        """Raise for the ambiguous ``1/2x``, ``1/xy`` and ``x/2i``; ``1/2i`` and ``1/2 x`` divide first."""
        slash = max(n for n, part in enumerate(quotient) if _is_sign(part, "/"))
        signed = quotient[slash + 1 :]
        divisor = [part for part in signed if not _is_sign(part, "-") and not _is_sign(part, "+")]
        if divisor and _is_number(divisor[0]):
            if item.is_spaced:
                return
            in_basis = isinstance(item, _Token) and item.text in _BASIS
            if in_basis and len(divisor) == slash == 1 and _is_number(quotient[0]):
                return
        above = self.source[quotient[0].place : quotient[slash].place].strip()
        if divisor:
            below = self.source[signed[0].place : item.place].strip()
            factor = self.source[item.place : self.end(item)]
        else:  # a word of several letters
            word = self.source[(signed or [item])[0].place : self.end(item)]
            below, factor = word[: 1 + len(signed)], "*".join(word[1 + len(signed) :])
        readings = f"({above}/{below})*{factor} or {above}/({below}*{factor})"
        self.fail(f"a product after / has two readings: write {shorten(readings)}", item.place)

    def end(self, item: _Token | _Group) -> int:
        """Return where an item ends in the typed text."""
        if isinstance(item, _Group):
            return len(self.source) if item.close is None else item.close.place + 1
        return item.letters.places[-1] + 1

    def written(self, item: _Token | _Group, is_argument: bool) -> Letters:
        """Write one item; a group after a function is written as its arguments."""
        if isinstance(item, _Token):
            if item.kind == "number" and "e" in item.text:
                self.remarks[f"{item.text} is a decimal number, not a product with the unit e"] = (
                    None
                )
            return self.word(item) if item.kind == "name" else item.letters
        body = self.body(item.items)
        if item.close is None:
            return item.open.letters + body
        if item.open.text == "(" and not is_argument and self.vocabulary.has_coordinates:
            parts, commas = _split(item.items, (",",))
            if len(commas) == 3 and all(parts):
                return self.coordinates(item, parts)
        return item.open.letters + body + item.close.letters

    def word(self, token: _Token) -> Letters:
        """Write a name, or the product that it stands for."""
        word = token.text
        factors = self.vocabulary.factors(word)
        if len(word) == 1 or not factors:
            if (
                len(word) > 1
                and word in self.vocabulary.names
                and self.vocabulary.letters.issuperset(word)
            ):
                self.remarks[f"{word} is one name here, not the product {'*'.join(word)}"] = None
            return token.letters
        inside = [
            name
            for name in (*self.vocabulary.names, *self.vocabulary.functions)
            if len(name) > 1 and name.isidentifier() and name in word
        ]
        if inside:
            self.fail(
                f"{word} has two readings, since {min(inside)} is a name: write {'*'.join(factors)}, or the "
                f"product with {min(inside)}",
                token.place,
            )
        start = len(token.letters.text) - len(word)
        parts = [token.letters[: start + 1]]
        for n in range(start + 1, start + len(word)):
            parts += [Letters.written("*", token.letters.places[n]), token.letters[n : n + 1]]
        return Letters.join(parts)

    def coordinates(self, group: _Group, parts: list[_Items]) -> Letters:
        """Write four coordinates as a sum over the basis."""
        sum_ = Letters("", ())
        for part, unit in zip(parts, "eijk", strict=True):
            self.need_scalar(part)
            x = self.term(part).strip()
            if x.text == "0":
                continue
            sum_ = sum_ + " + " if sum_.text else sum_
            if unit == "e":
                sum_ = sum_ + x
            elif x.text == "1":
                sum_ = sum_ + Letters(unit, x.places)
            else:
                if not re.fullmatch(r"\w+", x.text):
                    x = Letters.written("(", x.places[0]) + x + ")"
                sum_ = sum_ + x + f"*{unit}"
        close = group.close.letters if group.close else Letters("", ())
        return (
            group.open.letters + (sum_ if sum_.text else Letters.written("0", group.place)) + close
        )

    def need_scalar(self, items: _Items) -> None:
        """Raise for a coordinate that contains a quaternion."""
        for n, item in enumerate(items):
            after = items[n + 1] if n + 1 < len(items) else None
            if isinstance(item, _Group):
                before = items[n - 1] if n else None
                if not (isinstance(before, _Token) and before.text in _SCALARS):
                    self.need_scalar(item.items)
            elif item.kind == "name" and _QUATERNIONS.issuperset(item.text):
                if isinstance(after, _Group) and after.open.text == "[":
                    continue
                if item.text not in self.vocabulary.names or item.text in "ijk":
                    self.fail(
                        f"a coordinate is a scalar, and {item.text} is a quaternion", item.place
                    )


def _is_sign(item: _Token | _Group, sign: str) -> bool:
    return isinstance(item, _Token) and item.text == sign


def _is_number(item: _Token | _Group) -> bool:
    return isinstance(item, _Token) and item.kind == "number"

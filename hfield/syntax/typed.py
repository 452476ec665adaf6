"""Texts rewritten before parsing, with the position in the typed text of each letter.

Signs, products and coordinates are rewritten in the grammar of the language. The parser finds errors in the
rewritten text; they are reported at the position in the typed text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from re import Match, Pattern

from hfield.errors import NotationError

_SIGN_READ = re.compile(r"[=<>!]+|\*\*|and|or|not")


@dataclass(frozen=True)
class Letters:
    """A text and, for each of its letters, the offset of its origin in the typed text.

    >>> Letters.of("q^2").replaced("^", "**").places
    (0, 1, 1, 2)
    """

    text: str
    places: tuple[int, ...]

    @classmethod
    def of(cls, text: str) -> Letters:
        """Return a text as it was typed."""
        return cls(text, tuple(range(len(text))))

    @classmethod
    def written(cls, text: str, place: int) -> Letters:
        """Return a text all of whose letters originate at ``place``."""
        return cls(text, (place,) * len(text))

    @classmethod
    def join(cls, parts: Iterable[Letters]) -> Letters:
        """Return the concatenation of parts."""
        parts = tuple(parts)
        return cls("".join(p.text for p in parts), tuple(n for p in parts for n in p.places))

    def __getitem__(self, part: slice) -> Letters:
        return Letters(self.text[part], self.places[part])

    def __add__(self, other: Letters | str) -> Letters:
        if isinstance(other, str):
            other = Letters.written(other, self.places[-1] if self.places else 0)
        return Letters(self.text + other.text, self.places + other.places)

    def strip(self) -> Letters:
        """Return the text without surrounding blanks."""
        start = len(self.text) - len(self.text.lstrip())
        return self[start : max(start, len(self.text.rstrip()))]

    def sub(
        self, pattern: Pattern[str], pieces: Callable[[Match[str]], Sequence[str | int]]
    ) -> Letters:
        """Replace each match by ``pieces(match)``: texts, and indices of groups to keep."""
        if pattern.search(self.text) is None:
            return self
        parts: list[Letters] = []
        end = 0
        for found in pattern.finditer(self.text):
            parts.append(self[end : found.start()])
            for piece in pieces(found):
                if isinstance(piece, int):
                    parts.append(self[slice(*found.span(piece))])
                else:
                    parts.append(Letters.written(piece, self.places[found.start()]))
            end = found.end()
        return Letters.join([*parts, self[end:]])

    def replaced(self, sign: str, letters: str) -> Letters:
        """Replace a sign everywhere."""
        parts: list[Letters] = []
        start = 0
        while (found := self.text.find(sign, start)) >= 0:
            parts += [self[start:found], Letters.written(letters, self.places[found])]
            start = found + len(sign)
        return Letters.join([*parts, self[start:]]) if parts else self


@dataclass(frozen=True)
class Typed:
    """A text as typed, ``source``, and the rewritten text that is parsed, ``text``.

    ``remarks`` are sentences about unexpected readings.
    """

    source: str
    text: str
    places: tuple[int, ...]
    remarks: tuple[str, ...] = ()

    def place(self, position: int) -> int:
        """Return the offset in the typed text for an offset in the rewritten text."""
        return self.places[position] if position < len(self.places) else len(self.source.rstrip())

    def in_typed_letters(self, reason: str, position: int) -> str:
        """Return the reason of an error with the offending sign as it was typed: ``=`` for ``==``."""
        found = _SIGN_READ.match(self.text, position)
        if found is None or repr(found[0]) not in reason:
            return reason
        last = self.places[found.end() - 1]
        typed = self.source[self.places[position] : last + 1]
        return reason.replace(repr(found[0]), repr(typed))

    @classmethod
    def implication(cls, parts: Sequence[Typed]) -> Typed:
        """Return the statement in which all parts but the last are hypotheses of the last."""
        if len(parts) == 1:
            return parts[0]
        source, text, places = "", "", []
        for part in parts:
            start = f"{' => ' if text else ''}("
            read = Letters(part.text, part.places).strip()
            places += [len(source)] * len(start) + [
                len(source) + len(start) + n for n in read.places
            ]
            text += f"{start}{read.text})"
            source += f"{start}{part.source})"
            places.append(len(source) - 1)
        return cls(source, text, tuple(places), tuple(r for part in parts for r in part.remarks))


@contextmanager
def reported_as_typed(*texts: Typed) -> Iterator[None]:
    """Report errors from reading these texts at the typed characters."""
    try:
        yield
    except NotationError as error:
        for typed in texts:
            if error.position is not None and error.text.strip() == typed.text.strip():
                # an analysis may have dropped blanks in front
                blanks = typed.text.find(error.text.strip()) - error.text.find(error.text.strip())
                position = error.position + blanks
                reason = typed.in_typed_letters(error.reason, position)
                raise NotationError(reason, typed.source, typed.place(position)) from None
        raise

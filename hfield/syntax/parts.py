"""Parts of a text that keep their positions, so that errors refer to the whole text."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NoReturn

from hfield.errors import NotationError, shorten

CLOSING = {"(": ")", "[": "]", "{": "}", "<": ">"}


@dataclass(frozen=True)
class SourceSpan:
    """The part of ``source`` from ``start`` to ``end``.

    >>> part = SourceSpan.of(" f(x, y) ")
    >>> function, inside = part.call()
    >>> function.text, [(x.text, x.start) for x in inside.split(",")]
    ('f', [('x', 3), ('y', 6)])
    """

    source: str
    start: int
    end: int

    @classmethod
    def of(cls, text: str) -> SourceSpan:
        """Return a whole text, without surrounding blanks."""
        return cls(text, 0, len(text)).strip()

    @property
    def text(self) -> str:
        """The characters of the part."""
        return self.source[self.start : self.end]

    def __getitem__(self, part: slice) -> SourceSpan:
        start, end, _ = part.indices(self.end - self.start)
        return SourceSpan(self.source, self.start + start, self.start + end)

    def strip(self) -> SourceSpan:
        """Return the part without surrounding blanks."""
        text = self.text
        start = len(text) - len(text.lstrip())
        return self[start : max(start, len(text.rstrip()))]

    def match(self, pattern: re.Pattern[str]) -> dict[str, SourceSpan] | None:
        """Return the named groups of a pattern that matches the whole part, or None."""
        found = pattern.fullmatch(self.text)
        if found is None:
            return None
        groups = ((name, found.span(name)) for name in pattern.groupindex)
        return {name: self[start:end].strip() for name, (start, end) in groups if start >= 0}

    def split(self, separator: str) -> list[SourceSpan]:
        """Split the text at a separator outside all brackets; ``<`` and ``>`` are brackets here."""
        text, open_brackets, start = self.text, list[tuple[str, int]](), 0
        parts: list[SourceSpan] = []
        for place, char in enumerate(text):
            if char in CLOSING:
                open_brackets.append((CLOSING[char], place))
            elif char in CLOSING.values():
                if not open_brackets or open_brackets.pop()[0] != char:
                    self[place:].fail(f"expected no {char!r} here: the brackets do not match")
            elif char == separator and not open_brackets:
                parts.append(self[start:place].strip())
                start = place + 1
        if open_brackets:
            closing, place = open_brackets[-1]
            self[place:].fail(f"the bracket that opens here lacks its {closing!r}")
        return [*parts, self[start:].strip()]

    def inside(self, opening: str = "[") -> SourceSpan | None:
        """Return the content of brackets around the whole part; None if there are none."""
        found = self.call(opening)
        return None if found is None or found[0].text else found[1]

    def call(self, opening: str = "(") -> tuple[SourceSpan, SourceSpan] | None:
        """Return the text before the last bracket group and the group's content, if the part ends with a
        group.
        """
        text, closing, depth = self.text, CLOSING[opening], 0
        if not text.endswith(closing):
            return None
        for place in range(len(text) - 1, -1, -1):
            depth += (text[place] in CLOSING.values()) - (text[place] in CLOSING)
            if not depth:
                break
        if depth or text[place] != opening:
            return None
        return self[:place].strip(), self[place + 1 : len(text) - 1].strip()

    def fail(self, reason: str) -> NoReturn:
        """Raise a :class:`NotationError` at the start of the part."""
        raise NotationError(reason, self.source, self.start)

    def __str__(self) -> str:
        return shorten(self.text, 60)

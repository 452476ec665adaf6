"""Split a text outside all brackets."""

from __future__ import annotations

from collections.abc import Iterator

from hfield.errors import NotationError, shorten

CLOSING = {"(": ")", "[": "]", "{": "}"}


def outside(text: str) -> Iterator[tuple[int, str]]:
    """Yield the characters outside all brackets, each with its position; brackets themselves are not yielded.

    Raises :class:`NotationError` if the brackets do not match.

    >>> "".join(char for _, char in outside("f(x,y), [z]"))
    'f, '
    """
    closing: list[str] = []
    for place, char in enumerate(text):
        if char in CLOSING:
            closing.append(CLOSING[char])
        elif char in CLOSING.values():
            if not closing or closing.pop() != char:
                raise NotationError(f"the brackets of {shorten(text)!r} do not match")
        elif not closing:
            yield place, char
    if closing:
        raise NotationError(f"{shorten(text)!r} lacks a closing {closing[-1]!r}")


def split(text: str, separator: str) -> list[str]:
    """Split a text at the separators outside all brackets. Raises :class:`NotationError`.

    >>> split("root(2,3), I", ",")
    ['root(2,3)', ' I']
    """
    parts, start = [], 0
    for place, char in outside(text):
        if char == separator:
            parts.append(text[start:place])
            start = place + 1
    return [*parts, text[start:]]


def is_balanced(text: str) -> bool:
    """Return whether the brackets of a text match."""
    try:
        return all(True for _ in outside(text))
    except NotationError:
        return False


def last_group(text: str) -> tuple[str, str, str]:
    """Split a text that ends with a bracket group: the text before, the opening bracket, the content.

    Return three empty texts if it does not end with one.

    >>> last_group("QQ[s]/(s^3-2)(x)")
    ('QQ[s]/(s^3-2)', '(', 'x')
    """
    opening = {")": "(", "]": "["}.get(text[-1:])
    depth = 0
    for n in range(len(text) - 1, -1, -1):
        depth += (text[n] in ")]") - (text[n] in "([")
        if opening is None or depth < 0:
            break
        if not depth:
            return (text[:n], opening, text[n + 1 : -1]) if text[n] == opening else ("", "", "")
    return "", "", ""

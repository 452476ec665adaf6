"""Reading whole numbers of a command line within bounds."""

from __future__ import annotations

from argparse import ArgumentTypeError
from collections.abc import Callable

from hfield.errors import shorten


def whole(least: int, most: int) -> Callable[[str], int]:
    """Return a reader, for argparse, of whole numbers from ``least`` to ``most``."""

    def read(text: str) -> int:
        word = text.strip().replace("_", "")
        fits = word.isascii() and word.isdecimal() and len(word) <= 18
        if not fits or not least <= int(word) <= most:
            raise ArgumentTypeError(
                f"expected a whole number from {least} to {most}, found {shorten(text.strip())!r}"
            )
        return int(word)

    return read

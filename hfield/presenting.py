"""Lay out an answer of facts and tables for a terminal and for LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from textwrap import wrap
from typing import Protocol

from hfield.errors import shorten
from hfield.latex import descriptions, words


class AnswerSection(Protocol):
    """A section of an answer, as text lines and as LaTeX; either may be empty."""

    def page(self, width: int) -> Sequence[str]:
        """Return the lines of the section."""

    def latex(self) -> str:
        """Return LaTeX for a document with amsmath."""


def page(parts: Iterable[AnswerSection], width: int) -> str:
    """Lay out sections on a page, with an empty line between them."""
    return "\n\n".join("\n".join(lines) for part in parts if (lines := part.page(width)))


def latex(parts: Iterable[AnswerSection]) -> str:
    """Write sections in LaTeX as paragraphs; a table belongs to the paragraph before it."""
    text = ""
    for part in parts:
        if written := part.latex():
            text += ("\n" if isinstance(part, TextTable) else "\n\n") * bool(text) + written
    return text


def hanging(head: str, text: str, width: int, whole: bool = False) -> list[str]:
    """Return a text as wrapped lines after its head, with a hanging indent.

    A word wider than the column is broken, unless ``whole`` is set.

    >>> hanging("basis  ", "1, i, j, 1/2 + i", 15)
    ['basis  1, i, j,', '       1/2 + i']
    """
    below = " " * len(head)
    return wrap(
        text,
        width,
        initial_indent=head,
        subsequent_indent=below,
        break_long_words=not whole,
        break_on_hyphens=False,
    )


def aligned(grid: Sequence[Sequence[str]], align: str, indent: str = "") -> list[str]:
    """Return a line for each row, the cells in columns; ``align`` has < or > for each column."""
    wide = [max(map(len, column)) for column in zip(*grid, strict=True)]
    return [
        indent + "  ".join(f"{cell:{a}{w}}" for cell, a, w in zip(row, align, wide, strict=True))
        for row in grid
    ]


@dataclass(frozen=True)
class LayoutBlock:
    """A block with its own layout: a function from a width to lines, and LaTeX."""

    page: Callable[[int], Sequence[str]]
    latex: Callable[[], str] = str


@dataclass(frozen=True)
class Facts:
    """Labels with their texts, indented below an optional title.

    A fact without a label continues the previous one. ``formulas`` maps labels to LaTeX that replaces the
    text.
    """

    facts: Sequence[tuple[str, str]]
    margin: int = 16
    title: str = ""
    formulas: Mapping[str, str] = field(default_factory=dict)

    def page(self, width: int) -> list[str]:
        """Return the title and the facts; below a title, words wider than the page are broken."""
        indent = "  " * bool(self.title)
        lines = [self.title] if self.title else []
        for label, text in self.facts:
            head = f"{indent}{label:<{self.margin}} "
            if self.title:
                text = " ".join(
                    shorten(word, max(width - len(head), 1)) for word in text.split(" ")
                )
            lines += hanging(head, text, width)
        return lines

    def latex(self) -> str:
        """Return a description list; with a title it is a paragraph."""
        pairs: list[tuple[str, str]] = []
        for label, text in self.facts:
            written = self.formulas.get(label) or words(text)
            if not label and pairs:
                label, before = pairs.pop()
                written = f"{before} {written}"
            pairs.append((label, written))
        listed = descriptions(pairs)
        return rf"\paragraph{{{self.title}}}" + f"\n\n{listed}" if self.title else listed


@dataclass(frozen=True)
class TextTable:
    """Rows of texts in columns; the last column wraps, and ``align`` has < or > for each of the others.

    In LaTeX ``columns`` is the alignment of the columns, and ``cells`` formats cells that are not words.
    ``title`` and ``below`` appear on pages only.
    """

    rows: Sequence[Sequence[str]]
    align: str
    columns: str
    head: Sequence[str] = ()
    title: str = ""
    below: str = ""
    indent: str = ""
    cells: Mapping[int, Callable[[str], str]] = field(default_factory=dict)

    def page(self, width: int) -> list[str]:
        """Return the lines of the table."""
        grid = [self.head, *self.rows] if self.head else self.rows
        starts = aligned([row[:-1] for row in grid], self.align, self.indent)
        lines = [self.title] if self.title else []
        for start, row in zip(starts, grid, strict=True):
            lines += hanging(f"{start}  ", row[-1], width, whole=True) or [start.rstrip()]
        return [*lines, self.below] if self.below else lines

    def latex(self) -> str:
        """Return a LaTeX tabular, with a line below its head."""
        lines = [rf"\begin{{tabular}}{{{self.columns}}}"]
        if self.head:
            lines.append(" & ".join(self.head[: len(self.columns)]) + r" \\ \hline")
        for row in self.rows:
            cells = enumerate(row[: len(self.columns)])
            lines.append(" & ".join(self.cells.get(n, words)(cell) for n, cell in cells) + r" \\")
        return "\n".join([*lines, r"\end{tabular}"])

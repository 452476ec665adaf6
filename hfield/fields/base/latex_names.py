"""Names of rings as LaTeX mathematics: ``GF(9)(t)`` is 𝔽₉(t)."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    pass


_LETTERS = {"QQ": r"\mathbb{Q}", "ZZ": r"\mathbb{Z}", "RR": r"\mathbb{R}", "CC": r"\mathbb{C}"}
_LETTERS |= {"RDF": r"\mathrm{RDF}", "CDF": r"\mathrm{CDF}", "F": "F", "universal": r"\forall"}
_RULES = [
    (re.compile(r"\bGF\((\d+)\^(\d+)[^()]*\)"), r"\\mathbb{F}_{\1^{\2}}"),
    (re.compile(r"\bGF\((\d+)[^()]*\)"), r"\\mathbb{F}_{\1}"),
    (re.compile(r"\bQp\((\d+)\)"), r"\\mathbb{Q}_{\1}"),
    (re.compile(r"\broot\(([^(),]*),\s*(\d+)\)"), r"\\sqrt[\2]{\1}"),
    (re.compile(r"\bsqrt\(([^()]*)\)"), r"\\sqrt{\1}"),
    (re.compile(r"\bzeta(\d+)"), r"\\zeta_{\1}"),
    (re.compile(r"\bI\b"), "i"),
    (re.compile(r"\^(\d+)"), r"^{\1}"),
    (re.compile(r"\*+"), " "),
]
_WORD = re.compile(rf"(?<!\\)\b({'|'.join(_LETTERS)})\b")


def latex_name(name: str) -> str:
    r"""Return the name of a ring, or of a column of the ledger, as LaTeX mathematics.

    >>> latex_name("GF(9)(t)"), latex_name("QQ(sqrt(-7))"), latex_name("QQ[x]/(x^3-2)")
    ('\\mathbb{F}_{9}(t)', '\\mathbb{Q}(\\sqrt{-7})', '\\mathbb{Q}[x]/(x^{3}-2)')
    """
    for pattern, meant in _RULES:
        name = pattern.sub(meant, name)
    return _WORD.sub(lambda found: _LETTERS[found[1]], name)

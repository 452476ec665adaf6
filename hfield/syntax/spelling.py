"""Mathematical signs, as answers are printed in them, back to the plain letters of the language."""

import re
import unicodedata

from hfield.errors import NotationError, shorten

_SIGNS = {"≠": "!=", "⇒": "=>", "⇔": "<=>", "∧": " and ", "∨": " or ", "¬": " not ", "∃": "exists "}
_SIGNS |= {"−": "-", "·": "*", "×": "*", "≤": "<=", "≥": ">="}
_FUNCTIONS = {"N": "norm", "tr": "trace", "Sc": "scalar", "Vec": "vector"}
_WORDS = ("and", "or", "not")
_FUNCTION = re.compile(rf"\b({'|'.join(_FUNCTIONS)})(?=\()")
# What begins with a name looks behind first, so that a long word is read once, not from each letter on.
_BAR = re.compile("(?<!\\w)(\\d*)([^\\W\\d]\\w*)\u0304")
_SUPERSCRIPTS = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER = re.compile(f"[{_SUPERSCRIPTS}]+")
_TO_DIGITS = str.maketrans(_SUPERSCRIPTS, "-0123456789")
_LETTER = rf"[^\W{_SUPERSCRIPTS}]"
_COORDINATE_OF_POWER = re.compile(
    rf"(?<!{_LETTER})(\d*)((?!\d){_LETTER}+[{_SUPERSCRIPTS}]+)([₀₁₂₃])"
)
_COORDINATE = re.compile("[₀₁₂₃]")
_EQUAL = re.compile("(?<![=!<>])=(?![=>])")
_MULTIPLE = re.compile(r"(\b\d+(?:\.\d+)?|\))([eijk])\b")


def plain(text: str) -> str:
    """Return a statement in the plain letters of the language; one that is in them stays as it is.

    >>> plain("[p, q̄]² ≠ 0 ⇒ N(p·q) = N(p)·N(q) ∧ p₀ = 0")
    'comm(p, conj(q))**2 != 0 => norm(p*q) == norm(p)*norm(q)  and  p[0] == 0'
    """
    # Letters with a bar of their own, such as ū, become a letter and a bar.
    text = "".join(unicodedata.normalize("NFD", c) if c.isalpha() else c for c in text)
    text = _BAR.sub(r"\1conj(\2)", text)
    text = _COORDINATE_OF_POWER.sub(r"\1(\2)\3", text)
    text = _POWER.sub(lambda found: "**" + found[0].translate(_TO_DIGITS), text)
    text = _COORDINATE.sub(lambda found: f"[{'₀₁₂₃'.index(found[0])}]", text)
    for sign, letters in _SIGNS.items():
        text = text.replace(sign, letters)
    text = _EQUAL.sub("==", text)
    text = _FUNCTION.sub(lambda found: _FUNCTIONS[found[1]], text)
    return _commutators(text)


def plain_element(text: str) -> str:
    """Return an element's text likewise; a multiple of i, j or k needs no sign of a product.

    >>> plain_element("1/5 − 2/5i + x²·k")
    '1/5 - 2/5*i + x**2*k'
    """
    return _MULTIPLE.sub(r"\1*\2", plain(text))


class _Bracket:
    """An open bracket: where, what closes it, and whether all its parts so far are commutators or rows."""

    def __init__(self, place: int, closing: str) -> None:
        self.place, self.closing = place, closing
        self.of_brackets = True
        self.empty = True  # nothing of this part has come yet

    def begin(self, is_bracket: bool) -> None:
        """Note that a part begins, or goes on after a bracket."""
        self.of_brackets = self.of_brackets and self.empty and is_bracket
        self.empty = False

    @property
    def is_matrix(self) -> bool:
        """Whether it is written as the rows of a matrix, once it closes."""
        return self.closing == ")" and self.of_brackets and not self.empty


def _commutators(text: str) -> str:
    """Write ``[x, y]`` as ``comm(x, y)``; a bracket after a name or a parenthesis is a coordinate's.

    Raises :class:`NotationError` for what could as well be the rows of a matrix.
    """
    letters: list[str] = []
    opened: list[_Bracket] = []
    last, spaced = "", False  # the word or the sign before, and whether a blank came after it
    for place, char in enumerate(text):
        shown = char
        if char == "[":
            after_operand = last not in _WORDS and (
                last[-1:].isalnum() or last[-1:] in ("_", ")", "]")
            )
            if opened:
                opened[-1].begin(not after_operand)
            opened.append(_Bracket(place, "]" if after_operand else ")"))
            shown = "[" if after_operand else "comm("
        elif char == "]" and opened:
            bracket = opened.pop()
            if bracket.is_matrix:
                raise _may_be_a_matrix(text[bracket.place : place + 1])
            shown = bracket.closing
        elif opened and char == ",":
            opened[-1].of_brackets &= not opened[-1].empty
            opened[-1].empty = True
        elif opened and not char.isspace():
            opened[-1].begin(False)
        letters.append(shown)
        if char.isalnum() or char == "_":
            last = last + char if not spaced and last[-1:].isalnum() else char
        elif not char.isspace():
            last = shown[-1]
        spaced = char.isspace()
    return "".join(letters)


def _may_be_a_matrix(text: str) -> NotationError:
    inside = shorten(text[1:-1].strip())
    return NotationError(
        f"{shorten(text)} is a matrix, or a commutator: for the commutator write comm({inside}); the matrix "
        f"is A.matrix({shorten(text)!r}) or, on the command line, hfield matrix; in a statement "
        "matrix(p, q, r, u)"
    )


ELSEWHERE = {
    **dict.fromkeys(("reduced_norm", "nrd", "N"), "norm"),
    **dict.fromkeys(("reduced_trace", "trd", "tr"), "trace"),
    **dict.fromkeys(("conjugate", "bar"), "conj"),
    **dict.fromkeys(("inverse", "inverse_of"), "inv"),
    **dict.fromkeys(("commutator", "bracket"), "comm"),
    **dict.fromkeys(("real", "Re", "scalar_part"), "scalar"),
    **dict.fromkeys(("imag", "Im", "vector_part"), "vector"),
}


def elsewhere(function: str) -> str:
    """Return how a function of the library, or of another system, is called in the language.

    >>> elsewhere("reduced_norm"), elsewhere("det")
    (', write norm', '')
    """
    if function == "sqrt":
        return ", but over a field that has the root, such as QQ(sqrt(2)), it is an element"
    return f", write {ELSEWHERE[function]}" if function in ELSEWHERE else ""

"""Mathematical signs, as answers are printed in them, back to the plain letters of the language."""

import re
import unicodedata

_SIGNS = {"≠": "!=", "⇒": "=>", "⇔": "<=>", "∧": " and ", "∨": " or ", "¬": " not ", "∃": "exists "}
_SIGNS |= {"−": "-", "·": "*", "×": "*"}
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


def _commutators(text: str) -> str:
    """Write ``[x, y]`` as ``comm(x, y)``; a bracket after a name or a parenthesis is a coordinate's."""
    letters: list[str] = []
    closing: list[str] = []
    last, spaced = "", False  # the word or the sign before, and whether a blank came after it
    for char in text:
        if char == "[":
            after_operand = last not in _WORDS and (
                last[-1:].isalnum() or last[-1:] in ("_", ")", "]")
            )
            closing.append("]" if after_operand else ")")
            char = "[" if after_operand else "comm("
        elif char == "]" and closing:
            char = closing.pop()
        letters.append(char)
        if char.isalnum() or char == "_":
            last = last + char if not spaced and last[-1:].isalnum() else char
        elif not char.isspace():
            last = char[-1]
        spaced = char.isspace()
    return "".join(letters)


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
    return f", write {ELSEWHERE[function]}" if function in ELSEWHERE else ""

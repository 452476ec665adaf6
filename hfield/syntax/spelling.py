"""Rewrite mathematical signs in the plain letters of the language."""

import re
import unicodedata
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from hfield.errors import NotationError, shorten
from hfield.syntax.products import Vocabulary, write_products
from hfield.syntax.typed import Letters, Typed

MAX_LENGTH = 20_000

_SIGNS = {"≠": "!=", "⇒": "=>", "⇔": "<=>", "∧": " and ", "∨": " or ", "¬": " not ", "∃": "exists "}
_SIGNS |= {"→": "=>", "⟹": "=>", "⟺": "<=>", "↔": "<=>", "≤": "<=", "≥": ">="}
_SIGNS |= dict.fromkeys("−–‐‑", "-") | dict.fromkeys("·×⋅∗", "*")
_COMMANDS = {  # of LaTeX
    **dict.fromkeys(("cdot", "times", "ast"), "*"),
    **dict.fromkeys(("ne", "neq"), "!="),
    **dict.fromkeys(("le", "leq"), "<="),
    **dict.fromkeys(("ge", "geq"), ">="),
    **dict.fromkeys(("Rightarrow", "implies", "Longrightarrow"), "=>"),
    **dict.fromkeys(("Leftrightarrow", "iff", "Longleftrightarrow"), "<=>"),
    **dict.fromkeys(("land", "wedge"), " and "),
    **dict.fromkeys(("lor", "vee"), " or "),
    **dict.fromkeys(("lnot", "neg"), " not "),
    **dict.fromkeys(("overline", "bar"), "conj"),
    **dict.fromkeys(("left", "right", "quad", "qquad"), ""),
    **dict.fromkeys(("frac", "dfrac", "tfrac"), "frac"),
    **dict.fromkeys(("lvert", "rvert", "vert", "lVert", "rVert", "Vert", "|"), "|"),
    "sqrt": "sqrt",
    "exists": "exists ",
}
_COMMAND = re.compile(r"\\([A-Za-z]+|\|)\s*|\\([,;:! ])|^\s*\$+|\$+\s*$")
_DOLLARS = re.compile(r"(?s)\s*\$.*\$\s*$")
_FUNCTIONS = {"N": "norm", "tr": "trace", "Sc": "scalar", "Vec": "vector"}
_FUNCTIONS |= {"Nrd": "norm", "nrd": "norm", "Tr": "trace", "Trd": "trace", "trd": "trace"}
_FUNCTIONS |= {"Re": "scalar", "Im": "vector"}
_OTHER_FUNCTIONS = ("conj", "inv", "abs", "dot", "cross", "comm")
_MODULUS = re.compile(r"[|‖]([^|‖]+)[|‖](\s*(?:\^|\*\*)\s*2(?!\d|\.|\s*(?:\^|\*\*)))?")
_ROOT = re.compile(r"√(\d+)|√(?=\()")
_WORDS = ("and", "or", "not")
# After a number, and N after small letters too: 2N(p) and pN(q) are products with norms.
_FUNCTION = re.compile(rf"(?:\b|(?<=\d)|(?<=[a-z])(?=N\())({'|'.join(_FUNCTIONS)})(?=\s*\()")
_BRACE = re.compile(r"frac\{|\^?\{|\}")
_COORDINATE_IN_BRACES = re.compile(r"_\{([0-3])\}")
_NUMBER_BEFORE = re.compile(r"(?<![\w^.])(\d+(?:\.\d*)?)\s*$")
_WITH_ARGUMENTS = re.compile(r"\\([dt]?frac|sqrt)(?![A-Za-z])")
_BAR_OF_LETTER = re.compile(r"\\(?:overline|bar)\s*([A-Za-z])")
_ROMAN = re.compile(r"\\(?:operatorname|math\w+|text)\s*\{([^{}]*)\}")
_FRACTION = re.compile(r"(\d+\s*|\w?)([½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅐⅛⅜⅝⅞⅑⅒])")
_SUPERSCRIPTS = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER = re.compile(f"([{_SUPERSCRIPTS}]+)(?=(\\d)?)")
_TO_DIGITS = str.maketrans(_SUPERSCRIPTS, "-0123456789")
# A bar and a coordinate belong to the last letter, with its digits: qq̄ is q·q̄, and pq²₀ is p·(q²)₀.
_LETTER = rf"[^\W\d_{_SUPERSCRIPTS}₀-₉][0-9_]*"
_BAR = re.compile(f"({_LETTER})[\u0304\u0305]")
_OPERAND_START, _OPERAND_END = re.compile(r"[\w(]"), re.compile(r"[\w)]$")
_COMPARISON = re.compile(r"[=<>!]|\b(?:and|or|not)\b")
_BAR_OF_GROUP = re.compile("\\)[\u0304\u0305]")
NAMES_OF_FUNCTIONS = {*_FUNCTIONS, *_FUNCTIONS.values(), *_OTHER_FUNCTIONS}
_ALL_FUNCTIONS = "|".join(NAMES_OF_FUNCTIONS)
_NAME_OF_FUNCTION = re.compile(rf"(?:\b|(?<=\d)|(?<=[a-z])(?=N\s*$))({_ALL_FUNCTIONS})\s*$")
_COORDINATE_OF_POWER = re.compile(f"({_LETTER}[{_SUPERSCRIPTS}]+)([₀₁₂₃])")
_COORDINATE = re.compile("[₀₁₂₃]")
_TIMES = re.compile(r"[a-z]\s*(?:×|\\times\b)\s*[a-z]")
_CROSS = "× is the product here; the cross product of p and q is cross(p, q)"
_EQUAL = re.compile("(?<![=!<>])=(?![=>])")
_OWN_BAR = re.compile("[^\\x00-\\x7f]")


@lru_cache(maxsize=4096)
def spell(text: str, vocabulary: Vocabulary) -> Typed:
    """Return a text in the plain letters of the language, with the origin of each letter.

    Raises :class:`NotationError` if a product has two readings, or a coordinate is not a scalar.

    >>> spell("i² = j² = ijk = -1", Vocabulary.of_statements()).text
    'i**2 == -1 and j**2 == -1 and i*j*k == -1'
    """
    letters = Letters.of(text)
    if len(text) > MAX_LENGTH:  # the parser refuses it
        return Typed(text, text, letters.places)
    try:
        typed = write_products(_signs_read(letters), text, vocabulary)
        return replace(typed, remarks=(*typed.remarks, _CROSS)) if _TIMES.search(text) else typed
    except NotationError as error:
        if error.position is not None or error.text:
            raise
        raise NotationError(error.reason, text) from None


def plain(text: str) -> str:
    """Return a statement in the plain letters of the language; one already in these letters is unchanged.

    >>> plain("[p, q̄]² ≠ 0 ⇒ N(p·q) = N(p)·N(q) ∧ p₀ = 0")
    'comm(p, conj(q))**2 != 0 => norm(p*q) == norm(p)*norm(q)  and  p[0] == 0'
    """
    return spell(text, Vocabulary.of_statements()).text


def plain_element(text: str) -> str:
    """Return an element's text in plain letters; the only known words are e, i, j and k.

    >>> plain_element("1/5 − 2/5i + x²·k")
    '1/5 - 2/5*i + x**2*k'
    """
    return spell(text, Vocabulary.of_names("eijk")).text


def _signs_read(letters: Letters) -> Letters:
    """Return a text with mathematical signs replaced by words and operators."""
    in_latex = "\\" in letters.text or _DOLLARS.match(letters.text) is not None
    if in_latex:
        letters = _with_braces(letters)
        letters = letters.sub(_BAR_OF_LETTER, lambda found: (_apart(found) + "conj(", 1, ")"))
        letters = letters.sub(_ROMAN, lambda found: (" ", 1, " "))
        letters = letters.sub(_COMMAND, _command)
    letters = letters.sub(_COORDINATE_IN_BRACES, lambda found: ("[", 1, "]"))
    if in_latex or "^{" in letters.text:
        letters = _without_braces(letters, in_latex)
    if not letters.text.isascii():
        letters = _without_signs(letters)
    _expect_one_reading_of_moduli(letters.text)
    letters = letters.sub(
        _MODULUS, lambda found: (_apart(found) + ("norm(" if found[2] else "abs("), 1, ")")
    )
    letters = letters.sub(_EQUAL, lambda found: ("==",))
    letters = letters.sub(_FUNCTION, lambda found: (_apart(found) + _FUNCTIONS[found[1]],))
    return _commutators(letters)


def _expect_one_reading_of_moduli(text: str) -> None:
    """Raise :class:`NotationError` for ``|p|q|r|``, which may be |p|·q·|r| or |p·|q|·r|."""
    for first, second in pairwise(_MODULUS.finditer(text)):
        between = text[first.end() : second.start()].strip()
        is_operand = _OPERAND_START.match(between) and _OPERAND_END.search(between)
        if is_operand and not _COMPARISON.search(between):
            p, r = first[1].strip(), second[1].strip()
            raise NotationError(
                f"{text[first.start() : second.end()]!r} has two readings: write "
                f"abs({p})*({between})*abs({r}) or abs({p}*abs({between})*{r})"
            )


def _without_signs(letters: Letters) -> Letters:
    """Return a text in ASCII, with signs that have a meaning replaced."""
    # Letters with a bar of their own, such as ū, become a letter and a bar.
    letters = letters.sub(_OWN_BAR, lambda found: (_decomposed(found[0]),))
    letters = letters.sub(_FRACTION, _fraction)
    letters = letters.sub(_BAR, lambda found: (_apart(found) + "conj(", 1, ")"))
    letters = _bars_of_groups(letters)
    letters = letters.sub(_COORDINATE_OF_POWER, lambda found: ("(", 1, ")", 2))
    letters = letters.sub(_POWER, _power)
    letters = letters.sub(_ROOT, lambda found: ("sqrt(", 1, ")") if found[1] else ("sqrt",))
    letters = letters.sub(_COORDINATE, lambda found: (f"[{'₀₁₂₃'.index(found[0])}]",))
    for sign, words in _SIGNS.items():
        letters = letters.replaced(sign, words)
    return letters


def _bars_of_groups(letters: Letters) -> Letters:
    """Write ``(p + q)̄`` as ``conj(p + q)``, and ``N(p)̄`` as ``conj(N(p))``."""
    while (found := _BAR_OF_GROUP.search(letters.text)) is not None:
        depth, start = 0, found.start()
        for start in range(found.start(), -1, -1):
            depth += (letters.text[start] == ")") - (letters.text[start] == "(")
            if not depth:
                break
        if depth:
            return letters
        if (name := _NAME_OF_FUNCTION.search(letters.text[:start])) is not None:
            start = name.start(1)  # the bar is over the value of a function
        blank = " " if letters.text[start - 1 : start].isalpha() else ""
        conj = Letters.written(f"{blank}conj", letters.places[start])
        group = letters[start : found.start() + 1]
        if name is not None:
            opening = Letters.written("(", letters.places[start])
            closing = Letters.written(")", letters.places[found.start()])
            group = Letters.join([opening, group, closing])
        letters = Letters.join([letters[:start], conj, group, letters[found.end() :]])
    return letters


def _decomposed(char: str) -> str:
    return unicodedata.normalize("NFD", char) if char.isalpha() else char


def _command(found: re.Match[str]) -> tuple[str, ...]:
    """Return the meaning of a LaTeX command; unknown commands are kept for the error message."""
    if found[1] is None:
        return ("" if "$" in found[0] else " ",)
    meaning = _COMMANDS.get(found[1], found[0])
    return (_apart(found) + meaning if meaning[:1].isalpha() else meaning,)


def _apart(found: re.Match[str]) -> str:
    """Return the blank that separates a word from a letter before it."""
    return " " if found.start() and found.string[found.start() - 1].isalpha() else ""


def _fraction(found: re.Match[str]) -> tuple[str | int, ...]:
    """Return a sign such as ½ as a quotient. Raises :class:`NotationError` for ``3½`` and ``p½``."""
    quotient = unicodedata.normalize("NFKC", found[2]).replace("⁄", "/")
    before = found[1].strip()
    if before.isdigit():
        raise _mixed(found[0], before, quotient)
    if before:
        raise NotationError(f"{found[0]} is not read as a product: write {before}*{quotient}")
    return (f"({quotient})",)


def _mixed(text: str, number: str, fraction: str) -> NotationError:
    return NotationError(
        f"{shorten(text)} has two readings: write {number} + {fraction} or {number}*{fraction}"
    )


def _power(found: re.Match[str]) -> tuple[str, ...]:
    """Return a power; a digit after it does not belong to the exponent.

    Raises :class:`NotationError` for ``²⁻¹``.
    """
    if "⁻" in found[1][1:] or found[1] == "⁻":
        raise NotationError(
            f"{shorten(found[1])} is not an integer: expected an exponent such as ² or ⁻¹"
        )
    return ("**" + found[1].translate(_TO_DIGITS), " " if found[2] else "")


def _with_braces(letters: Letters) -> Letters:
    r"""Write the arguments of fractions and roots in braces: ``\frac12`` is ``\frac{1}{2}``."""
    text = letters.text
    inserted: dict[int, str] = {}
    for found in _WITH_ARGUMENTS.finditer(text):
        place, first = found.end(), found.end()
        for _ in range(2 if found[1].endswith("frac") else 1):
            while text[place : place + 1].isspace():
                place += 1
            if found[1] == "sqrt" and text[place : place + 1] == "[":
                raise NotationError(r"only square roots are read: \sqrt{2}")
            if text[place : place + 1].isalnum():
                inserted[place] = inserted.get(place, "") + "{"
                place += 1
                inserted[place] = inserted.get(place, "") + "}"
            elif text[place : place + 1] == "{":
                place = _end_of_group(text, place)
            else:
                break
        number = _NUMBER_BEFORE.search(text, 0, found.start())
        if found[1] != "sqrt" and number and not re.search("[A-Za-z]", text[first:place]):
            shown = text[number.start() : place]
            raise _mixed(shown, number[1], text[found.start() : place])
    parts: list[Letters] = []
    start = 0
    for place, braces in sorted(inserted.items()):
        at = letters.places[min(place, len(text) - 1)]
        parts += [letters[start:place], Letters.written(braces, at)]
        start = place
    return Letters.join([*parts, letters[start:]])


def _end_of_group(text: str, place: int) -> int:
    """Return the offset after a group in braces, or the end of the text."""
    depth = 0
    for n in range(place, len(text)):
        depth += (text[n] == "{") - (text[n] == "}")
        if not depth:
            return n + 1
    return len(text)


def _without_braces(letters: Letters, in_latex: bool) -> Letters:
    """Write the groups of LaTeX, ``q^{-1}`` and ``frac{p}{2}``, in parentheses.

    Outside LaTeX only exponents may be in braces.
    """
    text = letters.text
    parts: list[Letters] = []
    closing: list[str] = []
    start = 0
    for found in _BRACE.finditer(text):
        if found.start() < start:
            continue
        place, end = letters.places[found.start()], found.end()
        before = letters[start : found.start()]
        if found[0] == "frac{":
            closing.append(")/(")
            shown = "(("
        elif found[0] == "}" and closing:
            shown = closing.pop()
            if shown == ")/(":
                second = text.find("{", found.end())
                if text[found.end() : second].strip() or second < 0:
                    raise NotationError(r"\frac takes two groups: \frac{1}{2}")
                closing.append("))")
                end = second + 1
        elif found[0] == "^{" or (in_latex and found[0] == "{"):
            closing.append(")")
            shown = found[0].replace("{", "(")
        else:
            shown = found[0]
        parts += [before, Letters.written(shown, place)]
        start = end
    return Letters.join([*parts, letters[start:]])


class _Bracket:
    """An open bracket: its position, its closing bracket, and whether all parts so far are commutators or
    rows.
    """

    def __init__(self, place: int, closing: str) -> None:
        self.place, self.closing = place, closing
        self.of_brackets = True
        self.empty = True  # nothing of this part has been read yet
        self.parts = 1
        self.nesting = 0  # parentheses that are open inside

    def end_part(self) -> None:
        """Record a comma."""
        self.of_brackets &= not self.empty
        self.empty = True
        self.parts += not self.nesting

    def begin(self, is_bracket: bool) -> None:
        """Record that a part begins, or continues after a bracket."""
        self.of_brackets = self.of_brackets and self.empty and is_bracket
        self.empty = False

    @property
    def is_matrix(self) -> bool:
        """Whether the closed bracket contains the rows of a matrix."""
        return self.closing == ")" and self.of_brackets and not self.empty


def _commutators(letters: Letters) -> Letters:
    """Write ``[x, y]`` as ``comm(x, y)``; a bracket after a name or a parenthesis is an index.

    Four parts in brackets are the coordinates of a quaternion. Raises :class:`NotationError` for text that
    could also be the rows of a matrix.
    """
    text = letters.text
    if "[" not in text:
        return letters
    shown = list(text)
    opened: list[_Bracket] = []
    last, spaced = "", False  # the word or the sign before, and whether a blank came after it
    for place, char in enumerate(text):
        if char == "[":
            after_operand = last not in _WORDS and (
                last[-1:].isalnum() or last[-1:] in ("_", ")", "]")
            )
            if opened:
                opened[-1].begin(not after_operand)
            opened.append(_Bracket(place, "]" if after_operand else ")"))
            shown[place] = "[" if after_operand else "comm("
        elif char == "]" and opened:
            bracket = opened.pop()
            if bracket.is_matrix:
                raise _may_be_a_matrix(text[bracket.place : place + 1])
            shown[place] = bracket.closing
            if bracket.closing == ")" and bracket.parts == 4:
                shown[bracket.place] = "("
        elif opened and char == ",":
            opened[-1].end_part()
        elif opened and not char.isspace():
            opened[-1].begin(False)
            opened[-1].nesting += (char == "(") - (char == ")")
        if char.isalnum() or char == "_":
            last = last + char if not spaced and last[-1:].isalnum() else char
        elif not char.isspace():
            last = shown[place][-1]
        spaced = char.isspace()
    return Letters.join(Letters.written(x, n) for x, n in zip(shown, letters.places, strict=True))


def _may_be_a_matrix(text: str) -> NotationError:
    inside = shorten(text[1:-1].strip())
    return NotationError(
        f"{shorten(text)} is a matrix, or a commutator: for the commutator write comm({inside}); the matrix "
        f"is A.matrix({shorten(text)!r}) or, on the command line, hfield matrix; in a statement "
        "matrix(p, q, r, u)"
    )


FOREIGN_FUNCTIONS = {
    "reduced_norm": "norm",
    "reduced_trace": "trace",
    **dict.fromkeys(("conjugate", "bar"), "conj"),
    **dict.fromkeys(("inverse", "inverse_of"), "inv"),
    **dict.fromkeys(("commutator", "bracket"), "comm"),
    **dict.fromkeys(("real", "scalar_part"), "scalar"),
    **dict.fromkeys(("imag", "vector_part"), "vector"),
}


def foreign_function_hint(function: str) -> str:
    """Return the name in the statement language of a function of hfield or of another system.

    >>> foreign_function_hint("reduced_norm"), foreign_function_hint("det")
    (', write norm', '')
    """
    if function == "abs":
        return ", the norm of q is norm(q)"
    if function == "sqrt":
        return ": work over a field that contains the root, such as QQ(sqrt(2))"
    return f", write {FOREIGN_FUNCTIONS[function]}" if function in FOREIGN_FUNCTIONS else ""

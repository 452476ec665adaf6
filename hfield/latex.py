r"""LaTeX from hfield's texts: words with mathematical signs, lists, tables, documents.

The output is ASCII and works in every LaTeX with amsmath and amssymb. The formulas themselves are written
from their trees (:mod:`hfield.prover.statements.printing`) and by the rings.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

from hfield.fields.base.latex_names import latex_name

_SIGNS = {
    "·": r"\cdot ", "×": r"\times ", "−": "-", "±": r"\pm ", "∓": r"\mp ", "≠": r"\neq ", "≤": r"\leq ",
    "≥": r"\geq ", "≈": r"\approx ", "≡": r"\equiv ", "≅": r"\cong ", "⇒": r"\Rightarrow ",
    "⇔": r"\Leftrightarrow ", "→": r"\to ", "↦": r"\mapsto ", "↔": r"\leftrightarrow ", "∈": r"\in ",
    "∉": r"\notin ", "∞": r"\infty ", "∧": r"\land ", "∨": r"\lor ", "¬": r"\lnot ", "∃": r"\exists ",
    "∀": r"\forall ", "∘": r"\circ ", "°": r"^{\circ}", "⟂": r"\perp ", "⊥": r"\perp ", "‖": r"\| ",
    "√": r"\surd ", "Σ": r"\Sigma ", "∪": r"\cup ", "∩": r"\cap ", "⊂": r"\subset ", "⟨": r"\langle ",
    "⟩": r"\rangle ", "†": r"\dagger ", "⋯": r"\cdots ", "∅": r"\varnothing ", "✓": r"\checkmark ",
    "✗": r"\times ", "ℚ": r"\mathbb{Q}", "ℤ": r"\mathbb{Z}", "ℝ": r"\mathbb{R}", "ℂ": r"\mathbb{C}",
    "ℍ": r"\mathbb{H}", "𝔽": r"\mathbb{F}", "ϕ": r"\phi ", "⊗": r"\otimes ", "∑": r"\sum ",
    "∏": r"\prod ", "′": r"^{\prime}", "'": r"^{\prime}", "…": r"\ldots ",
    "│": "|",
}  # fmt: skip
_LETTERS_RAISED, _LETTERS_LOWERED = "ⁿᵏᵗᵐⁱʲᵖˢ", "ₙₖₘᵢⱼₚₛₜₐₓ"
_SIGNS |= {c: f"^{{{unicodedata.normalize('NFKD', c)}}}" for c in _LETTERS_RAISED}
_SIGNS |= {c: f"_{{{unicodedata.normalize('NFKD', c)}}}" for c in _LETTERS_LOWERED}
_GREEK_NAMES = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "varepsilon", "ζ": "zeta", "η": "eta",
    "θ": "theta", "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi", "π": "pi",
    "ρ": "rho", "σ": "sigma", "ς": "varsigma", "τ": "tau", "υ": "upsilon", "φ": "varphi", "χ": "chi",
    "ψ": "psi", "ω": "omega", "Γ": "Gamma", "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi",
    "Π": "Pi", "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega",
}  # fmt: skip
_GREEK = {letter: rf"\{name} " for letter, name in _GREEK_NAMES.items()}
_RAISED, _LOWERED = "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹", "₋₊₀₁₂₃₄₅₆₇₈₉"
_LEVEL = str.maketrans(_RAISED + _LOWERED, "-+0123456789" * 2)
_OVER = {
    "\u0304": "overline",
    "\u0305": "overline",
    "\u20d7": "vec",
    "\u0302": "hat",
    "\u0303": "tilde",
}
_SCRIPTS = re.compile(f"([{_RAISED}]+)|([{_LOWERED}]+)")
_SIMPLE = "A-Za-zα-ω0-9"
_POWER = re.compile(rf"\^\{{([{_SIMPLE}+ -]+)\}}|\^\((-?[{_SIMPLE}]+)\)|\^(-?[{_SIMPLE}]+)")
_RUN_OF_SCRIPTS = re.compile(r"(?:[\^_]\{[^{}]*\}\s*){2,}")
_OVERLINED = re.compile(f"([^\\W_](?:[{_LOWERED}]|_{{[^{{}}]*}})*)([{''.join(_OVER)}]+)")
"""A letter, with its index, and the marks over it."""
_MATHEMATICAL = frozenset({*_SIGNS, *_GREEK, *_RAISED, *_LOWERED, *_OVER} - {"…", "†", "°", "'"})

_TEXT = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "%": r"\%", "#": r"\#",
    "_": r"\_", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}",
    ">": r"\textgreater{}", "|": r"\textbar{}", '"': r"\textquotedbl{}", "“": "``", "”": "''",
    "„": r"\quotedblbase{}", "‘": "`", "’": "'", "–": "--", "—": "---", "…": r"\ldots{}",
    "ł": r"\l{}", "Ł": r"\L{}", "ø": r"\o{}", "ß": r"\ss{}", "æ": r"\ae{}", "\u00a0": "~", "\u202f": r"\,",
    "†": r"\ensuremath{\dagger}", "°": r"\textdegree{}", "─": "--",
}  # fmt: skip
_IN_MATHEMATICS = {c: rf"\{c}" for c in "#%&$_{}"}
_IN_MATHEMATICS |= {"\\": r"\backslash ", "^": r"\wedge ", "~": r"\sim "}
_COMBINING = "\u0300\u0301\u0302\u0303\u0307\u0308\u030a\u030b\u030c\u0327\u0328"
_ACCENTS = dict(zip(_COMBINING, "`'^~.\"rHvck", strict=True))

_FUNCTIONS = {
    "norm",
    "conj",
    "inv",
    "trace",
    "comm",
    "dot",
    "cross",
    "abs",
    "scalar",
    "vector",
    "sqrt",
    "root",
    "cos",
    "sin",
}
_FUNCTIONS |= {"tr", "Sc", "Vec", "det", "dim", "tan", "exp"}
_INDEX = re.compile(r"(?<![^\W_])([^\W\d_])_([^\W_])(?![^\W_])")  # e_i
_INDICES = re.compile(r"(?<=[\w}])_\{([^{}]*)\}")  # a_{n+1}
_CONJUGATE = re.compile(rf"(?<![^\W_])conj\s+([^\W\d_][\d{_LOWERED}]*(?![^\W_])|conj\([^()]*\))")
"""The function before what it is taken of, without parentheses: conj q₁, conj conj q."""
_FIELD = re.compile(r"(QQ|ZZ|RR|CC|RDF|CDF|GF\(|Qp\()")
_LETTERS = re.compile(rf"[^\W\d_{_RAISED}{_LOWERED}{_LETTERS_RAISED}{_LETTERS_LOWERED}]+")
_PUNCTUATION = re.compile(r"^(.*?)([,;:.?!]*)$", re.DOTALL)
_UPRIGHT = {"cos", "sin", "tan", "det", "dim"}
_ARTICLES = ("−", "…", "...", *"aiouwzAI")  # words of sentences, English or Polish
_NUMBER = re.compile(r"[\[(]*-?[\d./,-]*[\])]*")
_UNITS = re.compile(r"[\[(]*[eijk]{2,}[\])]*")  # products of the basis, such as ijk
_OPERATORS = {"=", "==", "!=", "+", "-", "*", "/", "<", ">", "=>", "<=>", "<=", ">="}


def words(text: str) -> str:
    r"""Return a text in LaTeX, with its formulas between dollars and everything else escaped.

    >>> words("p·q̄ ≠ 0 over QQ(sqrt(2)), nie więcej")
    '$p\\cdot \\overline{q} \\neq 0$ over $\\mathbb{Q}(\\sqrt{2})$, nie wi\\k{e}cej'
    """
    text = _inside_out(_CONJUGATE, r"conj(\1)", unicodedata.normalize("NFC", text))
    tokens = text.split()
    kinds = [_is_mathematical(token) for token in tokens]
    order = [*range(len(tokens)), *reversed(range(len(tokens)))]
    for n in order:  # a number or an article's letter belongs to the mathematics beside it
        near = [m for m in (n - 1, n + 1) if 0 <= m < len(tokens) and kinds[m]]
        if (
            n and tokens[n - 1].endswith(",") and _depth(tokens[:n]) == 0
        ):  # "≠ 0, 1 would be" goes on
            near = [m for m in near if m > n]
        if _parted(tokens[n])[0] in _ARTICLES:
            near = [m for m in near if _leads(tokens[m]) or tokens[min(n, m)].endswith(",")]
        if kinds[n] is None and any(not re.search("[;:.?!]$", tokens[min(n, m)]) for m in near):
            kinds[n] = True
    out: list[str] = []
    run: list[str] = []
    for token, kind in zip(tokens, kinds, strict=True):
        body, end = _parted(token)
        if not kind:
            out += [*_dollars(run), _escaped(token)]
            run = []
        elif end and end != ",":
            out += _dollars([*run, body])
            out[-1] += end
            run = []
        else:
            run.append(token)
    return " ".join([*out, *_dollars(run)])


def mathematics(text: str) -> str:
    """Return a text in LaTeX math mode, without dollars."""
    text = "".join(unicodedata.normalize("NFD", c) if _barred(c) else c for c in text)
    text = re.sub(r"([A-Za-z]\w*)\[(\d+)\]", r"\1₍\2₎", text)
    text = (
        text.replace("**", "^")
        .replace("<=>", "⇔")
        .replace("=>", "⇒")
        .replace("!=", "≠")
        .replace("==", "=")
    )
    text = text.replace("<=", "≤").replace(">=", "≥")
    text = _POWER.sub(lambda m: f"⁽{m[1] or m[2] or m[3]}⁾", text)
    text = re.sub(r"(?<![A-Za-z\\])([A-Za-zα-ω])(\d+)", r"\1₍\2₎", text)
    text = _inside_out(_INDICES, r"₍\1₎", _INDEX.sub(r"\1₍\2₎", text))
    text = "".join(_IN_MATHEMATICS.get(c, c) for c in text)
    text = re.sub("⁽([^⁽⁾]*)⁾", r"^{\1}", text)
    text = _inside_out(re.compile("₍([^₍₎]*)₎"), r"_{\1}", text)
    text = _roots(_conjugates(_overlined_groups(text)))
    text = _OVERLINED.sub(_marked, text)
    text = _SCRIPTS.sub(lambda m: f"{'^' if m[1] else '_'}{{{m[0].translate(_LEVEL)}}}", text)
    text = re.sub(r"(?<![\\\w])([A-Za-z]{2,})(?=\()", _named, latex_name(text))
    text = re.sub(rf"(?<![\\\w{{])({'|'.join(_UPRIGHT)})(?=\s|$)", r"\\\1", text)
    text = "".join(_SIGNS.get(c) or _GREEK.get(c) or c for c in text)
    text = _RUN_OF_SCRIPTS.sub(_separated, text)
    text = "".join(c if c.isascii() else rf"\text{{{_character(c)}}}" for c in text)
    return " ".join(text.split())


_OPENING = {")": "(", "]": "[", "‖": "‖", "|": "|"}
_CLOSING = {opening: closing for closing, opening in _OPENING.items()}
_RADICAND = re.compile(rf"[−-]?\d+|\w+\(|\w[{''.join(_OVER)}{_LOWERED}]*|[(\[‖|]")


def _roots(text: str) -> str:
    """Write √ and sqrt( with the operand: a number, a letter, a value f(…), or a group."""
    text = re.sub(r"(?<![\w\\])sqrt\(", "√(", text)
    for at in reversed([n for n, c in enumerate(text) if c == "√"]):
        found = _RADICAND.match(text, at + 1)
        if found is None:
            continue
        grouped = found[0][-1] in _CLOSING
        end = _end_of_group(text, found.end() - 1) if grouped else found.end()
        if end is None:
            continue
        inside = text[at + 1 : end]
        if inside[0] == "(":
            inside = inside[1:-1]
        text = rf"{text[:at]}\sqrt{{{inside}}}{text[end:]}"
    return text


def _conjugates(text: str) -> str:
    """Write conj(…) as a bar over its argument."""
    for at in reversed([found.start() for found in re.finditer(r"(?<![\w\\])conj\(", text)]):
        end = _end_of_group(text, at + len("conj"))
        if end is not None:
            text = rf"{text[:at]}\overline{{{text[at + 5 : end - 1]}}}{text[end:]}"
    return text


def _end_of_group(text: str, start: int) -> int | None:
    """Return the end of the group that opens at ``start``, or None."""
    opening, closing = text[start], _CLOSING[text[start]]
    if opening == closing:
        end = text.find(closing, start + 1)
        return end + 1 if end > 0 else None
    depth = 0
    for n in range(start, len(text)):
        depth += (text[n] == opening) - (text[n] == closing)
        if not depth:
            return n + 1
    return None


def _marked(found: re.Match[str]) -> str:
    """Write a letter with accents, such as the conjugate of a conjugate."""
    written = found[1]
    for mark in found[2]:
        written = rf"\{_OVER[mark]}{{{written}}}"
    return written


def _overlined_groups(text: str) -> str:
    """Write an accent after a closing parenthesis over the whole parenthesised group."""
    text = text.replace("‾", "\u0304")
    for mark, name in _OVER.items():
        while (at := text.find(f"){mark}")) >= 0:
            depth, start = 0, at
            while start >= 0:
                depth += (text[start] == ")") - (text[start] == "(")
                if not depth:
                    break
                start -= 1
            if start < 0:
                return text
            text = rf"{text[:start]}\{name}{{{text[start + 1 : at]}}}{text[at + 2 :]}"
    return text


def _inside_out(pattern: re.Pattern[str], by: str, text: str) -> str:
    """Replace a pattern that may be nested, as in e_{i_1}, until no match is left."""
    while (after := pattern.sub(by, text)) != text:
        text = after
    return text


def _separated(found: re.Match[str]) -> str:
    """Put an empty group between two scripts of the same kind, as TeX requires."""
    out = ""
    used: set[str] = set()
    for script in re.findall(r"[\^_]\{[^{}]*\}", found[0]):
        if script[0] in used:
            out += "{}"
            used.clear()
        used.add(script[0])
        out += script
    return f"{out} " if found[0][-1].isspace() else out


def _named(found: re.Match[str]) -> str:
    return rf"\operatorname{{{found[1]}}}"


def _is_mathematical(token: str) -> bool | None:
    """Return whether a token is mathematics; None if that depends on its neighbours."""
    body, _ = _parted(token)
    if _leads(body) or body in _UPRIGHT or _FIELD.match(body.strip("([{")):
        return True
    if not body or body in _ARTICLES or _NUMBER.fullmatch(body) or _UNITS.fullmatch(body):
        return None
    runs = _LETTERS.findall(unicodedata.normalize("NFC", body))
    simple = all(run in _FUNCTIONS or len(run) <= 2 or _greek(run) for run in runs)
    if not simple:
        return False
    if any(char in _MATHEMATICAL or _barred(char) for char in body):
        return True
    if len(body) == 1 and body.isascii() and body.isalpha():
        return True
    return bool(_INDEX.search(body) or re.search(r"[=*^\[]|\w[+/]\w|\w\(\w", body))


def _barred(char: str) -> bool:
    return unicodedata.normalize("NFD", char)[1:] in _OVER


def _greek(run: str) -> bool:
    return any(char in _GREEK for char in run) and len(run) <= 4


def _depth(tokens: Sequence[str]) -> int:
    text = "".join(tokens)
    return text.count("(") - text.count(")")


def _leads(token: str) -> bool:
    return token in _OPERATORS or (token in _MATHEMATICAL and token != "−")


def _parted(token: str) -> tuple[str, str]:
    found = _PUNCTUATION.match(token)
    assert found
    return found[1], found[2]


def _dollars(run: Sequence[str]) -> list[str]:
    if not run:
        return []
    body, end = _parted(" ".join(run))
    opened = body.count("(") - body.count(")")
    if opened < 0 and body.endswith(
        ")" * -opened
    ):  # a parenthesis of the sentence, not of the formula
        body, end = body[:opened], body[opened:] + end
    start = ""
    if opened > 0 and body.startswith("(" * opened):
        body, start = body[opened:], body[:opened]
    return [f"{start}${mathematics(body)}${end}" if body else start + end]


def _escaped(token: str) -> str:
    letters: list[str] = []
    for char in unicodedata.normalize("NFC", token):
        letters.append(_character(char, letters))
    return "".join(letters)


def _character(char: str, before: list[str] | None = None) -> str:
    """Write one character of a text; a combining accent goes over the letter before it."""
    if char in _TEXT:
        return _TEXT[char]
    if char.isascii():
        return char
    if char in _OVER and before and before[-1].isalnum():
        return rf"\ensuremath{{\{_OVER[char]}{{{before.pop()}}}}}"
    if char in _SIGNS or char in _GREEK:
        return rf"\ensuremath{{{(_SIGNS.get(char) or _GREEK[char]).strip()}}}"
    if char in _RAISED or char in _LOWERED:
        return rf"\ensuremath{{{'^' if char in _RAISED else '_'}{{{char.translate(_LEVEL)}}}}}"
    base, *marks = list(unicodedata.normalize("NFD", char))
    if base.isascii() and len(marks) == 1 and marks[0] in _ACCENTS:
        return rf"\{_ACCENTS[marks[0]]}{{{base}}}"
    if base.isascii() and len(marks) == 1 and marks[0] in _OVER:
        return rf"\ensuremath{{\{_OVER[marks[0]]}{{{base}}}}}"
    plain = unicodedata.normalize("NFKD", char)
    if plain.isascii() and plain:
        return "".join(_TEXT.get(c, c) for c in plain)
    return rf"\texttt{{U+{ord(char):04X}}}"


def enumeration(items: Iterable[str]) -> str:
    """Return a numbered list in LaTeX; nothing if there are no items."""
    lines = [rf"\item {item}" for item in items]
    return "\n".join([r"\begin{enumerate}", *lines, r"\end{enumerate}"]) if lines else ""


def descriptions(pairs: Iterable[tuple[str, str]]) -> str:
    """Return a description list of plain labels with items in LaTeX."""
    lines = [rf"\item[{{{words(label)}}}] {text}" for label, text in pairs]
    return "\n".join([r"\begin{description}", *lines, r"\end{description}"]) if lines else ""


def long_table(columns: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table that may span pages; ``columns`` is in LaTeX notation, cells are already LaTeX."""
    lines = [" & ".join(row) + r" \\" for row in rows]
    top = " & ".join(head) + r" \\ \hline \endhead"
    return "\n".join([rf"\begin{{longtable}}{{{columns}}}", top, *lines, r"\end{longtable}"])


def document(body: str, title: str = "") -> str:
    """Return a whole document, for pdflatex with the packages amsmath, amssymb, geometry and longtable."""
    head = (
        *(r"\documentclass[11pt,a4paper]{article}", r"\usepackage[T1]{fontenc}"),
        *(r"\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}", r"\usepackage{textcomp}"),
        *(r"\usepackage{amsmath,amssymb,longtable}", r"\usepackage[margin=25mm]{geometry}"),
        *(r"\allowdisplaybreaks", r"\emergencystretch=3em", r"\begin{document}"),
    )
    named = [rf"\title{{{words(title)}}}", r"\author{}", r"\date{}", r"\maketitle"] if title else []
    return "\n".join([*head, *named, body.rstrip(), r"\end{document}"])

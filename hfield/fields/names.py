"""From text to ring: ``QQ``, ``ZZ/6``, ``GF(9, x^2+1)``, ``QQ(sqrt(2))``, ``GF(4)(t)``, ``QQ[x,y]``.

Spellings that need no quotes in a shell are also accepted: ``Q Z R C GF9 F9 ZZ6 Z6 QI Qsqrt2 Qsqrt-7 Qx
GF2t``. White space is ignored. docs/reference/rings.md has the grammar.
"""

import re
from collections.abc import Iterable
from difflib import get_close_matches
from functools import lru_cache
from importlib import import_module
from typing import TypeAlias

from hfield.checker.glossary import GREEK
from hfield.errors import NotationError, RingError, shorten
from hfield.fields.base.printing import from_unicode
from hfield.fields.base.registry import REGISTRY
from hfield.fields.base.ring import Ring, shared
from hfield.fields.base.variables import names_in, variables
from hfield.fields.foreign_rings import name_of_foreign_ring
from hfield.fields.number_fields.texts import NUMBER
from hfield.syntax.brackets import last_group, outside, split

KNOWN = (
    "QQ", "ZZ", "RR", "CC", "RDF", "CDF", "ZZ/6", "GF(9)", "GF(2^8)", "GF(9, x^2+1)", "QQ(sqrt(2))",
    "QQ(I)", "QQ(zeta5)", "QQ[s]/(s^3-2)", "QQ(x)", "GF(4)(t)", "ZZ[a,b,c]", "QQ[x,y]", "Qp(5)", "GF(9)((t))",
)  # fmt: skip
_EXPECTED = "known rings: " + " ".join(name.replace(" ", "") for name in KNOWN)

_SYMBOLS = str.maketrans(
    dict(zip("αβγδεζηθικλμνξοπρστυφχψω", GREEK, strict=True))
    | {
        "ℚ": "QQ",
        "ℤ": "ZZ",
        "ℝ": "RR",
        "ℂ": "CC",
        "𝔽": "GF",
        "−": "-",
        "–": "-",
        "·": "*",
        "×": "*",
    }
)
_ALGEBRA = re.compile(r"(?:H|ℍ|\\mathbb\{?H\}?)(?:\(.*\))?|[(\[].*\|.*\)")
_BLACKBOARD = re.compile(r"\\mathbb\{?([QZRCF])\}?")
_BLACKBOARD_NAMES = {"Q": "QQ", "Z": "ZZ", "R": "RR", "C": "CC", "F": "GF"}
_ROOT = re.compile(r"\\sqrt\{([^{}]*)\}")
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_NAMED = {
    "QQ": "rationals.ring",
    "ZZ": "rationals.ring",
    "RR": "algebraic.ring",
    "CC": "algebraic.ring",
    "RDF": "floats",
    "CDF": "floats",
}
_LONG = {"Q": "QQ", "Z": "ZZ", "R": "RR", "C": "CC"}
_MAX_LENGTH = 10_000

RingName: TypeAlias = object  # a Ring, a text, a domain of sympy, a field class of galois
Groups = list[tuple[str, str]]  # the contents of each pair of brackets, with the opening bracket


def ring(spec: RingName, factors: Iterable[int] | None = None) -> Ring:
    """Return the ring that a text, a sympy domain or a galois field names; a ring is returned as it is.

    ``factors`` are primes of numbers in the text that are too large to be factored. Raises :class:`RingError`
    for anything else, and for domains of floats.

    >>> ring("GF(2^8)")
    GF(256)
    >>> import sympy
    >>> ring(sympy.QQ.frac_field(*sympy.symbols("a b"))), ring(sympy.QQ.algebraic_field(sympy.sqrt(2)))
    (QQ(a,b), QQ(sqrt(2)))
    """
    if factors is not None:
        from hfield.core.factorisation import known_primes

        with known_primes(factors, "factors"):
            return ring(spec)
    if isinstance(spec, Ring):
        return spec
    if not isinstance(spec, str):
        name = name_of_foreign_ring(spec)
        if name is None:
            raise RingError(
                f"{shorten(repr(spec))} is not the name of a ring; expected a text such as 'GF(9)'"
            )
        return _ring("".join(name.split()))
    if apart := re.search(r"\d\s+\d|[(\[].*[^\W\d_]\s+[^\W\d_]", spec):
        raise RingError(f"{shorten(apart[0])!r} has a blank inside a number or a word")
    return _ring("".join(spec.split()))


def ring_of_data(data: object) -> Ring:
    """Return the ring described by the data in a certificate, as ``ring.data`` returns them.

    Raises :class:`hfield.checker.rejection.Rejected` for data of no ring that the checker knows.
    """
    from hfield.checker.scalars.fields import read_ring

    return ring(read_ring(data).name)


@lru_cache(maxsize=1024)
def _ring(spec: str) -> Ring:
    made = build(spec)
    canonical = "".join(made.name.split())
    return made if canonical == spec else _ring(canonical)


def build(text: str) -> Ring:
    """Return the ring that ``text`` names. Raises :class:`RingError`: what was wrong, and how to mend it."""
    if len(text) > _MAX_LENGTH:
        raise RingError(f"the name of a ring has at most {_MAX_LENGTH} characters, not {len(text)}")
    s = _without_latex("".join(text.translate(_SYMBOLS).split()))
    s = from_unicode(s).replace("**", "^")
    s = re.sub(r"\^\((\d+)\)(?![\w(.])", r"^\1", s)  # from 2³³; 2³3 remains invalid
    s = re.sub(r"[₀-₉]+(?!\w)", lambda m: f"_{m[0].translate(_LOWERED)}", s)
    if not s:
        raise RingError(f"the name of the ring is empty: {_EXPECTED}")
    if _ALGEBRA.fullmatch(s):
        raise RingError(
            f"{shorten(s)!r} is a quaternion algebra; expected a ring, such as GF(7). On the command line "
            "--algebra takes an algebra"
        )
    if unknown := next((char for char in s if not (char.isascii() or char == "∞")), None):
        raise RingError(f"{shorten(s)!r}: {unknown!r} is not a sign that names of rings have")
    below, place = _completed(s)
    if place:
        base = build(below)
        bare = place.startswith("(") and place.endswith(")") and "," not in place
        # GF(3)(t)_(5) is at 5, but a variable in brackets is a variable, even if it is called inf
        bare = bare and place[1:-1] not in base.names()
        return shared(base.completion, place[1:-1] if bare else place)
    if re.match(r"QQ?[(\[]", s):
        above, opening, inner = last_group(s)
        constants = REGISTRY.read(above) if above else None
        if constants is not None:
            return (
                _polynomials(constants, inner) if opening == "[" else _extension(constants, inner)
            )
    found_field = REGISTRY.read(s)
    if found_field is not None:
        return found_field
    if m := re.fullmatch(r"(.+)\[([^\W\d_]\w*)\]/\((.+)\)", s):
        return _quotient(build(m[1]), m[2], m[3])
    head, groups = _split(s)
    if head == "Frac" and len(groups) == 1 and groups[0][0] == "(":
        return _fractions(groups[0][1])
    found = _base(head, groups)
    if found is None:
        raise _unknown(s)
    made, rest = found
    for opening, inner in rest:
        made = _polynomials(made, inner) if opening == "[" else _extension(made, inner)
    return made


def _without_latex(s: str) -> str:
    """Return a name without the commands of LaTeX.

    >>> _without_latex(r"\\mathbb{F}_{7}"), _without_latex(r"\\mathbb{Q}(\\sqrt{2})")
    ('GF_7', 'QQ(sqrt(2))')
    """
    if "\\" in s:
        s = _BLACKBOARD.sub(lambda found: _BLACKBOARD_NAMES[found[1]], s)
        s = _ROOT.sub(r"sqrt(\1)", s)
    return re.sub(r"_\{(\d+)\}", r"_\1", s)


def _completed(s: str) -> tuple[str, str]:
    """Split ``QQ_5`` or ``QQ(I)_(5,I-2)`` into a global field and the text of a place, if there is one."""
    try:
        for n, char in outside(s):
            if char == "_" and n and s[:n] not in ("F", "FF", "GF"):
                return s[:n], s[n + 1 :]
    except NotationError as error:
        raise RingError(str(error)) from None
    return s, ""


def _split(s: str) -> tuple[str, Groups]:
    """Split ``GF(4)(t)`` into ``GF`` and its groups ``4``, ``t``."""
    closing = {"(": ")", "[": "]"}
    head = re.split(r"[(\[]", s, maxsplit=1)[0]
    groups: Groups = []
    stack: list[str] = []
    start = len(head)
    for n, char in enumerate(s[len(head) :], len(head)):
        if not stack:
            if char not in closing:
                raise _unknown(s)
            start = n
        if char in closing:
            stack.append(closing[char])
        elif char in ")]" and (not stack or stack.pop() != char):
            raise RingError(f"the brackets of {shorten(s)!r} do not match")
        if not stack:
            groups.append((s[start], s[start + 1 : n]))
    if stack:
        raise RingError(f"{shorten(s)!r} lacks a closing {stack[-1]!r}")
    return head, groups


def _base(head: str, groups: Groups) -> tuple[Ring, Groups] | None:
    """Return the ring that the head names, and the remaining groups; None if there is none."""
    long = _LONG.get(head, head)
    if long in _NAMED:
        return getattr(import_module(f"hfield.fields.{_NAMED[long]}"), long), groups
    if head in ("GF", "F", "FF") and groups and groups[0][0] == "(":
        return _finite(groups[0][1]), groups[1:]
    if head in ("Qp", "QQp"):
        return _p_adic(groups), groups[1:]
    if head in ("Zmod", "ZZ/", "Z/") and groups and (made := _residues(groups[0][1])):
        return made, groups[1:]
    if (m := re.fullmatch(r"ZZ?/?(-?\d+(?:\^\d+)?)(ZZ?)?", head)) and (made := _residues(m[1])):
        return made, groups
    if m := re.fullmatch(r"(?:GF|F)_?(-?\d+(?:\^\d+)?)([a-z]?)", head):
        field = _finite(m[1])
        return (_extension(field, m[2]) if m[2] else field), groups
    if m := re.fullmatch(r"QQ?(sqrt-?\d+|I|[a-z])", head):
        return _extension(build("QQ"), m[1]), groups
    if head in ("Qsqrt", "QQsqrt") and groups:
        return _extension(build("QQ"), f"sqrt({groups[0][1]})"), groups[1:]
    return None


def _fractions(inner: str) -> Ring:
    """Return the rational functions in the variables of ``QQ[pi]``, whatever their names."""
    base, rest = _base(*_split(inner)) or (None, [])
    if base is None or [opening for opening, _ in rest] != ["["]:
        raise RingError(
            f"Frac({shorten(inner)}): expected a ring of polynomials, as in Frac(QQ[pi])"
        )
    from hfield.fields.function_fields.rational_functions import rational_functions

    names = variables(shorten(inner), rest[0][1], base)
    return rational_functions(base.fractions or base, names)


def _quotient(base: Ring, variable: str, polynomial: str) -> Ring:
    """Return ``base[u]/(f)``."""
    from hfield.fields.function_fields.extensions import build as build_extension
    from hfield.fields.quotient_rings import build as build_quotient

    (name,) = variables(f"{base}[{shorten(variable)}]", variable, base, adjoined=False)
    if base in (build("ZZ"), build("QQ")) or (base.is_field and base.order == base.characteristic):
        return build_quotient(base, name, polynomial)
    return build_extension(base, name, polynomial)


def _p_adic(groups: Groups) -> Ring:
    if not groups:
        raise RingError("Qp needs its prime: write Qp(5) for the 5-adic numbers")
    from hfield.fields.rationals.completions import p_adic_numbers
    from hfield.fields.rationals.ring import QQ

    return shared(QQ.completion, str(p_adic_numbers(QQ, groups[0][1]).place))


def _residues(text: str) -> Ring | None:
    """Return ``ZZ/n`` for an n such as ``6`` or ``2^33``; None for a text that is not an integer."""
    from hfield.fields.base.coercion import whole_number
    from hfield.fields.rationals.ring import Zmod

    longest = max(map(len, re.findall(r"\d+", text)), default=0)
    if longest > 1300:
        raise RingError(
            f"ZZ/n with n of {longest} digits is too large; at most 4096 bits are taken"
        )
    n = whole_number(text)
    return None if n is None else Zmod(n)


def _finite(inner: str) -> Ring:
    from hfield.fields.finite.names import GF

    q, comma, modulus = inner.partition(",")
    return GF(q, modulus if comma else None)


def _extension(base: Ring, inner: str) -> Ring:
    """Return ``base(inner)``: a quadratic number field or a field of rational functions."""
    m = re.fullmatch(r"sqrt\((.+)\)|sqrt(-?\d+)", inner)
    if m or inner == "I":
        if base.name != "QQ":
            raise RingError(
                f"{base}({shorten(inner)}): square roots are adjoined to QQ only; larger fields are written "
                "QQ(sqrt(2))_(5) over Qp(5), QQ(x)[u]/(u^2-x) over functions"
            )
        from hfield.fields.number_fields.quadratic.ring import build as build_quadratic

        return build_quadratic((m[1] or m[2]) if m else "-1")
    from hfield.fields.function_fields.rational_functions import rational_functions

    if re.search(r"(?:^|,)(?:cos|sin)\(", inner):
        from hfield.fields.circles.names import read_circles

        return read_circles(base, split(inner, ","))
    if inner.startswith("(") and inner.endswith(")"):  # Laurent series
        names = variables(f"{base}({shorten(inner)})", inner[1:-1], base, adjoined=True)
        return shared(rational_functions(base, names).completion, names[0])
    names = variables(f"{base}({shorten(inner)})", inner, base, adjoined=True)
    return rational_functions(base, names)


def _polynomials(base: Ring, inner: str) -> Ring:
    from hfield.fields.adjoining import polynomials

    what = f"{base}[{shorten(inner)}]"
    if inner == "I" and base.name == "ZZ":
        from hfield.fields.quotient_rings import build as build_quotient

        return build_quotient(base, "I", "I^2+1")
    names = variables(what, inner, base, adjoined=False)
    number = next((name for name in names if re.fullmatch(NUMBER, name)), None)
    if number:
        raise RingError(
            f"{what}: {number} is a number, not the name of a variable such as x; the field that it "
            f"generates is QQ({number})"
        )
    return polynomials(base, names)


def _unknown(s: str) -> RingError:
    close = get_close_matches(s.upper(), [name.replace(" ", "") for name in KNOWN], 1, 0.6)
    did = f"did you mean {close[0]}? " if close else ""
    if (
        (letters := names_in(s))
        and len(letters) == len(min(letters)) == 1
        and re.search(r"\^[2-9]", s)
    ):
        did = f"the field of a root is QQ[{min(letters)}]/({shorten(s)}); "
    return RingError(f"there is no ring {shorten(s)!r}: {did}{_EXPECTED}")

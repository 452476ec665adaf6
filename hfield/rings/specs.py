"""From text to ring: ``QQ``, ``ZZ/6``, ``GF(9, x^2+1)``, ``QQ(sqrt(2))``, ``GF(4)(t)``, ``QQ[x,y]``.

Spellings that need no quotes in a shell are taken too: ``Q Z R C GF9 F9 ZZ6 Z6 QI Qsqrt2 Qsqrt-7 Qx
GF2t``. White space does not matter.
"""

import re
from difflib import get_close_matches
from importlib import import_module

from hfield.errors import RingError, shorten
from hfield.rings.base import Ring
from hfield.rings.printing import from_unicode

KNOWN = (
    "QQ", "ZZ", "RR", "CC", "RDF", "ZZ/6", "GF(9)", "GF(2^8)", "GF(9, x^2+1)", "QQ(sqrt(2))",
    "QQ(I)", "QQ(x)", "GF(4)(t)", "ZZ[a,b,c]", "QQ[x,y]",
)  # fmt: skip
_EXPECTED = "known are " + " ".join(name.replace(" ", "") for name in KNOWN)

BASIS = ("e", "i", "j", "k")
WORDS = {
    *("and", "or", "not", "exists", "conj", "norm", "trace", "inv", "scalar", "vector", "comm"),
    *("sqrt", "cbrt", "root"),
}

_SYMBOLS = str.maketrans(
    {"ζ": "zeta", "ℚ": "QQ", "ℤ": "ZZ", "ℝ": "RR", "ℂ": "CC", "𝔽": "GF", "−": "-"}
)
_NAMED = {
    "QQ": "integers", "ZZ": "integers", "RR": "algebraic", "CC": "algebraic", "RDF": "floats"
}  # fmt: skip
_LONG = {"Q": "QQ", "Z": "ZZ", "R": "RR", "C": "CC"}
_MAX_LENGTH = 10_000

Groups = list[tuple[str, str]]  # what stands in each pair of brackets, with the bracket that opens


def build(text: str) -> Ring:
    """Return the ring that ``text`` names. Raises :class:`RingError`: what was wrong, how to mend it."""
    if len(text) > _MAX_LENGTH:
        raise RingError(f"the name of a ring has at most {_MAX_LENGTH} characters, not {len(text)}")
    s = from_unicode("".join(text.translate(_SYMBOLS).split())).replace("**", "^")
    if not s:
        raise RingError(f"the name of the ring is empty: {_EXPECTED}")
    if s.startswith("Q"):
        from hfield.rings.number_field_specs import build as build_number_field

        number_field = build_number_field(s)
        if number_field is not None:
            return number_field
    head, groups = _split(s)
    found = _base(head, groups)
    if found is None:
        raise _unknown(s)
    made, rest = found
    for opening, inner in rest:
        made = _polynomials(made, inner) if opening == "[" else _extension(made, inner)
    return made


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
    """Return the ring that the head names, and the groups that remain; None if there is none."""
    long = _LONG.get(head, head)
    if long in _NAMED:
        return getattr(import_module(f"hfield.rings.{_NAMED[long]}"), long), groups
    if head in ("GF", "F", "FF") and groups and groups[0][0] == "(":
        return _finite(groups[0][1]), groups[1:]
    if head in ("Zmod", "ZZ/", "Z/") and groups and re.fullmatch(r"-?\d+", groups[0][1]):
        return _residues(groups[0][1]), groups[1:]
    if m := re.fullmatch(r"ZZ?/?(-?\d+)(ZZ?)?", head):
        return _residues(m[1]), groups
    if m := re.fullmatch(r"(?:GF|F_?)(-?\d+(?:\^\d+)?)([a-z]?)", head):
        field = _finite(m[1])
        return (_extension(field, m[2]) if m[2] else field), groups
    if m := re.fullmatch(r"QQ?(sqrt-?\d+|I|[a-z])", head):
        return _extension(build("QQ"), m[1]), groups
    if head in ("Qsqrt", "QQsqrt") and groups:
        return _extension(build("QQ"), f"sqrt({groups[0][1]})"), groups[1:]
    return None


def _residues(n: str) -> Ring:
    from hfield.rings.integers import Zmod

    if len(n) > 1300:
        raise RingError(f"ZZ/n with n of {len(n)} digits is too large; at most 4096 bits are taken")
    return Zmod(int(n))


def _finite(inner: str) -> Ring:
    from hfield.rings.field_specs import build as build_field

    q, comma, modulus = inner.partition(",")
    return build_field(q, modulus if comma else None)


def _extension(base: Ring, inner: str) -> Ring:
    """Return ``base(inner)``: a quadratic number field or a field of rational functions."""
    m = re.fullmatch(r"sqrt\((.+)\)|sqrt(-?\d+)", inner)
    if m or inner == "I":
        if base.name != "QQ":
            raise RingError(f"{base}({shorten(inner)}): square roots are adjoined to QQ only")
        from hfield.rings.quadratic import build as build_quadratic

        return build_quadratic((m[1] or m[2]) if m else "-1")
    from hfield.rings.functions import build as build_functions

    return build_functions(base, variables(f"{base}({shorten(inner)})", inner, base))


def _polynomials(base: Ring, inner: str) -> Ring:
    from hfield.rings.polynomials import build as build_polynomials

    return build_polynomials(base, variables(f"{base}[{shorten(inner)}]", inner, base))


def variables(what: str, inner: str, base: Ring | None = None) -> tuple[str, ...]:
    """Read names of variables, none of which means anything else. Raises :class:`RingError`."""
    names = tuple(inner.split(","))
    for name in names:
        if not re.fullmatch(r"[^\W\d_]\w*", name):
            raise RingError(f"{what}: {shorten(name)!r} is not the name of a variable such as x")
        if name in BASIS:
            unit = "; the imaginary unit is QQ(I)" if name == "i" else ""
            raise RingError(
                f"{what}: the variable {name!r} would clash with the basis e, i, j, k of the "
                f"quaternions; choose another letter{unit}"
            )
        if name in WORDS:
            raise RingError(f"{what}: {name!r} is a word of the language; choose another name")
        if name == "I":
            raise RingError(f"{what}: I is the imaginary unit, in QQ(I); choose another name")
        if base is not None and name in base.names():
            free = next(x for x in "tsuvxyz" if x not in base.names())
            raise RingError(
                f"{what}: {name!r} already names the generator of {base}; choose another letter, "
                f"such as {free}"
            )
    if len(set(names)) < len(names):
        raise RingError(f"{what}: a variable occurs twice; expected different names")
    return names


def _unknown(s: str) -> RingError:
    close = get_close_matches(s.upper(), [name.replace(" ", "") for name in KNOWN], 1, 0.6)
    did = f"did you mean {close[0]}? " if close else ""
    return RingError(f"there is no ring {shorten(s)!r}: {did}{_EXPECTED}")

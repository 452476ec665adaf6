"""Names of rings, read by the grammar of docs/reference/rings.md ("Names, and what they mean"), as data.

Written from that page, without a look at the code that reads names. ``Refused`` says that the page allows
no such name, ``Unsure`` that it takes more than is here to tell what it means.
"""

import re
from collections.abc import Callable
from functools import cache

from galois._databases import ConwayPolyDatabase

from tests.adversary.names.arithmetic import Galois, irreducible, monic, prime_power
from tests.adversary.names.expressions import (
    NAME,
    Refused,
    Unsure,
    parsed,
    parts,
    refuse,
    whole_number,
    worked_out,
)
from tests.adversary.names.numbers import Data, matched, number_field, numbers, real_cyclotomic
from tests.adversary.names.places import completion, p_adic

__all__ = ["Refused", "Unsure", "read"]

LARGEST = 10**12  # of orders that are judged
BASIS = ("e", "i", "j", "k", "I")
WORDS = (
    *("and", "or", "not", "exists", "conj", "norm", "trace", "inv", "scalar", "vector", "comm"),
    *("dot", "cross", "abs"),
    *("sqrt", "cbrt", "root"),
)
LETTERS = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa"),
    *("lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi"),
    *("psi", "omega"),
)
CONSTANTS = (
    *(*LETTERS, "varphi", "vartheta", "varepsilon"),
    *("root", "cos", "sin", "tan", "exp", "log", "cis", "golden", "euler"),
)
SIGNS = {
    **dict(zip("αβγδεζηθικλμνξοπρστυφχψω", LETTERS, strict=True)),
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
HIGH, LOW = (
    dict(zip(signs, "0123456789-", strict=False)) for signs in ("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "₀₁₂₃₄₅₆₇₈₉")
)


def read(text: str) -> Data:
    """Return what a name means."""
    return _ring(plain(text))


def plain(text: str) -> str:
    """Spell out signs, and leave out blanks."""
    brackets = re.split(r"[(\[]", text, maxsplit=1)
    if re.search(r"[0-9]\s+[0-9]", text) or re.search(
        r"[^\W\d_]\s+[^\W\d_]", brackets[-1] * (len(brackets) - 1)
    ):
        refuse("a blank inside a number or a word")
    text = "".join(SIGNS.get(sign, sign) for sign in "".join(text.split()))
    text = re.sub("√(-?[0-9]+|(?=[(]))", lambda m: f"sqrt({m[1]})" if m[1] else "sqrt", text)
    text = re.sub("[⁰¹²³⁴-⁹⁻]+(?![0-9A-Za-z(.])", lambda m: "^" + _translated(m[0], HIGH), text)
    text = re.sub("[₀-₉]+(?![0-9A-Za-z_])", lambda m: "_" + _translated(m[0], LOW), text)
    return text.replace("**", "^") if re.fullmatch("[!-~∞]*", text) else refuse("unknown signs")


def _translated(text: str, signs: dict[str, str]) -> str:
    return "".join(signs[sign] for sign in text)


def _ring(text: str) -> Data:
    if re.match("Q(?!Q)|Z(?!Zm?|mod)|[RC]$", text):
        text = text[0] + text
    where = _place_begins(text)
    if where:
        return completion(_ring(text[:where]), text[where + 1 :])
    named = {
        "QQ": "rationals",
        "ZZ": "integers",
        "RR": "reals",
        "CC": "complexes",
        "RDF": "floats",
        "CDF": "complex floats",
    }
    if text in named:
        return {"kind": named[text]}
    for shape, reader in SHAPES:
        found = re.fullmatch(shape, text)
        if found and all(matched(part or "") for part in found.groups()):
            return reader(*found.groups())
    refuse("no such shape")


def _place_begins(text: str) -> int:
    """Return where the first _ outside brackets is, that of F_9 and GF_9 apart; 0 for none."""
    depth = 0
    for n, sign in enumerate(text):
        depth += (sign in "([") - (sign in ")]")
        if sign == "_" and depth == 0 and text[:n] not in ("F", "GF"):
            return n
    return 0


def _split(text: str) -> list[str]:
    """Part a text at the commas outside brackets."""
    out = [""]
    for part in text.split(","):
        out[-1] += part
        if matched(out[-1]):
            out.append("")
        else:
            out[-1] += ","
    return out[:-1] if matched(text) else refuse("brackets that do not match")


def _residues(count: str) -> Data:
    n = whole_number(count)
    if n.bit_length() > 4096:
        raise Unsure("a large modulus")
    return {"kind": "residues", "modulus": n} if n >= 2 else refuse("a modulus is 2 or more")


def _finite(inside: str) -> Data:
    count, *moduli = _split(inside)
    q = whole_number(count)
    if q > LARGEST:
        raise Unsure("a large field")
    p, n = prime_power(q) or refuse("no prime power")
    field: Data = {"kind": "finite field", "characteristic": p, "degree": n, "modulus": None}
    if n == 1:
        return field if not moduli else refuse("a prime field takes no modulus")
    conway = _conway(p, n)
    modulus = _modulus(",".join(moduli), p, n) if moduli else conway
    if q <= 4096 or modulus != conway:
        field["modulus"] = modulus
    return field


@cache
def _conway(p: int, n: int) -> list[int]:
    try:
        powers, coefficients = ConwayPolyDatabase().fetch(p, n)
    except LookupError:
        raise Unsure("a field without a Conway polynomial in the database") from None
    terms = dict(zip(powers, coefficients, strict=True))
    return [int(terms.get(k, 0)) for k in range(n + 1)]


def _modulus(text: str, p: int, n: int) -> list[int]:
    tree = parsed(text)
    if any(x[0] in ("/", "decimal") for x in parts(tree)):
        refuse("whole coefficients")
    K = Galois(p)
    f = worked_out(tree, {"x": (K.zero, K.one)}, K)
    if len(f) != n + 1 or not irreducible(K, f):
        refuse("irreducible, of the degree of the field")
    return [c[0] for c in monic(K, f)]


def _variables(text: str, base: Data, *, cautious: bool = False) -> list[str]:
    names = text.split(",")
    for name in names:
        if not re.fullmatch(NAME, name) or name in BASIS or name in WORDS:
            refuse(f"{name} names no variable")
        if name == "x" and base.get("degree", 1) > 1:
            refuse("x is the generator")
        if cautious and reads_like_a_constant(name):
            refuse(f"{name} reads like a constant")
    return names if len(set(names)) == len(names) <= 64 else refuse("twice, or too many")


def reads_like_a_constant(name: str) -> bool:
    """Tell whether a variable is refused in round brackets."""
    stem = name.rstrip("_0123456789")
    rings = "(Q|QQ|Z|ZZ|R|RR|C|CC|RDF|CDF|GF|NN|Zmod)_?([0-9]*|[pqI]|bar)|FF?_?[0-9]+"
    return (
        stem.lower() in (*CONSTANTS, "sqrt", "cbrt")
        or stem in ("e", "i", "j", "k", "E", "I")
        or name.startswith(("sqrt", "cbrt", "zeta"))
        or name.lower() in ("inf", "infinity", "infty", "oo")
        or re.fullmatch(rings, name) is not None
    )


def _polynomials(base: str, text: str) -> Data:
    over = _ring(base)
    variables = _variables(text, over)
    if over["kind"] == "finite field" and over["degree"] > 1:
        refuse("polynomials are over ZZ, QQ, GF(p) and number fields")
    if any(re.fullmatch("zeta_?[0-9]+", name) for name in variables):
        refuse("the field is what one would read")
    return {"kind": "polynomials", "base": over, "variables": variables}


def _fractions(base: str, text: str) -> Data:
    over = _ring(base)
    over = {"kind": "rationals"} if over["kind"] == "integers" else over
    return _functions(over, _variables(text, over))


def _functions(base: Data, variables: list[str]) -> Data:
    if base["kind"] not in ("rationals", "finite field"):
        if "field" in base["kind"]:
            raise Unsure("functions over a number field")
        refuse("functions are over QQ, a number field or a finite field")
    if len(variables) > 1 and base.get("degree", 1) > 1:
        raise Unsure("an extension of the functions over the prime field")
    return {"kind": "rational functions", "base": base, "variables": variables}


def _round(base: str, inside: str) -> Data:
    """Read numbers or variables in round brackets."""
    over = _ring(base)
    found = numbers(_split(inside)) if over["kind"] == "rationals" else None
    return found or _functions(over, _variables(inside, over, cautious=True))


def _laurent(base: str, name: str) -> Data:
    field = _functions(_ring(base), _variables(name, _ring(base), cautious=True))
    return completion(field, f"({name})")


def _number_field(variable: str, text: str) -> Data:
    _variables(variable, {})
    return number_field(variable, text)


def _extension(base: str, variable: str, text: str) -> Data:
    over = _ring(base)
    if over["kind"] in ("integers", "rationals") or over.get("degree") == 1:
        raise Unsure("a quotient of a polynomial ring, without data")
    if over["kind"] != "rational functions":
        refuse("extensions are of fields of functions")
    _variables(variable, over["base"])
    raise Unsure("whether a polynomial over functions is irreducible")


POWER = r"[0-9]+(?:\^(?:[0-9]+|\([0-9]+\)))?"
FINITE = rf"(?:GF|FF?)\(.*\)|(?:GF_?|F_?){POWER}"
SHAPES: list[tuple[str, Callable[..., Data]]] = [
    (rf"ZZ/?({POWER})(?:ZZ?)?", _residues),
    (r"(?:ZZ/|Zmod)\((.*)\)", _residues),
    (r"QQp\((.*)\)", p_adic),
    (r"(?:GF|FF?)\((.*)\)", _finite),
    (rf"(?:GF_?|F_?)({POWER})", _finite),
    (rf"Frac\((ZZ?|QQ?|{FINITE})\[(.*)\]\)", _fractions),
    (rf"QQ\[({NAME})\]/\((.*)\)", _number_field),
    (rf"(.*)\[({NAME})\]/\((.*)\)", _extension),
    (rf"(ZZ|QQ|{FINITE})\[(.*)\]", _polynomials),
    (r"QQ\(zeta(?:_?([0-9]+)|\(([0-9]+)\))\)\+", lambda n, called: real_cyclotomic(n or called)),
    (rf"({FINITE})\(\((.*)\)\)", _laurent),
    (r"QQ(I|sqrt-?[0-9]+|sqrt\(.*\))", lambda short: numbers([short]) or refuse("no number")),
    (r"(QQ)([a-oq-z])", _round),
    (rf"((?:GF_?|F_?){POWER})([a-z])", _round),
    (rf"(QQ|{FINITE})\((.*)\)", _round),
]

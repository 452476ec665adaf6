"""Fields of numbers in names of rings: ``sqrt(2),I``, ``zeta5``, ``(1+sqrt(5))/2``; and their polynomials."""

import re
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from math import prod
from typing import Any

import sympy

from tests.adversary.names.arithmetic import (
    QQ,
    Poly,
    cyclotomic,
    dense,
    irreducible_over_rationals,
    monic,
    rational,
    remainder,
    squarefree_kernel,
    times,
    twice_cosine,
)
from tests.adversary.names.expressions import (
    NAME,
    Unsure,
    names_in,
    parsed,
    rational_number,
    refuse,
    worked_out,
)

Data = dict[str, Any]
Number = tuple[str, Any, int]  # ("root", a, n), ("zeta", None, N); I is ("root", −1, 2)
FORMS = (
    r"(?P<I>I)",
    r"sqrt\((?P<square>.+)\)",
    r"cbrt\((?P<cube>.+)\)",
    r"root\((?P<any>.+),(?P<order>[0-9]+)\)",
    r"zeta(?:_?(?P<zeta>[0-9]+)|\((?P<called>[0-9]+)\))",
)
X: Poly = (Fraction(0), Fraction(1))


def matched(text: str) -> bool:
    """Tell whether every bracket is closed that is opened, and no other."""
    depth = 0
    for sign in text:
        depth += (sign in "([") - (sign in ")]")
        if depth < 0:
            return False
    return depth == 0


def numbers(texts: Sequence[str]) -> Data | None:
    """Return the field of some numbers; None where none of the texts is of numbers."""
    if len(texts) == 1 and (short := re.fullmatch("sqrt(-?[0-9]+)", texts[0])):
        return field_of([_root(Fraction(int(short[1])), 2)])
    found = [_number(text) for text in texts]
    if all(found):
        return field_of([x for x in found if x])
    if any(found):
        refuse("numbers and others")
    return _generated_by(texts[0]) if len(texts) == 1 and _mentioned(texts[0]) else None


def _number(text: str) -> Number | None:
    found = next((m for form in FORMS if (m := re.fullmatch(form, text))), None)
    if found is None:
        return None
    given = {key: x for key, x in found.groupdict().items() if x}
    if "I" in given:
        return ("root", Fraction(-1), 2)
    if "zeta" in given or "called" in given:
        n = int(given.get("zeta") or given["called"])
        fits = 3 <= n <= 1000 and sympy.totient(n) <= 128
        return ("zeta", None, n) if fits else refuse("an order from 3 to 1000")
    under = given.get("square") or given.get("cube") or given["any"]
    if not matched(under):
        return None
    n = int(given["order"]) if "order" in given else 2 + ("cube" in given)
    return _root(rational_number(under), n)


def _root(a: Fraction, n: int) -> Number:
    if a == 0 or not 2 <= n <= 64:
        refuse("a root of 0, or of no order")
    parts = (abs(a.numerator), a.denominator)
    if (a > 0 or n % 2) and all(sympy.integer_nthroot(m, n)[1] for m in parts):
        refuse("a rational root")
    return ("root", a, n)


def _spelled(x: Number) -> str:
    kind, a, n = x
    if kind == "zeta":
        return f"zeta{n}"
    return f"root({a},{n})" if n > 2 else "I" if a == -1 else f"sqrt({a})"


def field_of(found: Sequence[Number]) -> Data:
    """Return the field of some numbers, which stand once each, roots in front."""
    by_name = {_spelled(x): x for x in found}
    order = sorted(by_name, key=lambda name: not name.endswith(")"))
    chosen = [by_name[name] for name in order]
    if len(chosen) == 1:
        kind, a, n = chosen[0]
        if kind == "zeta":
            return {"kind": "cyclotomic field", "order": n}
        if n > 2:
            return {"kind": "root field", "radicand": number_data(a), "order": n}
        return {"kind": "quadratic field", "d": squarefree_kernel(a.numerator * a.denominator)}
    if all(kind == "root" and n == 2 and a.denominator == 1 for kind, a, n in chosen):
        return {"kind": "multiquadratic field", "d": [int(a) for _, a, _ in chosen]}
    if prod(int(sympy.totient(n)) if kind == "zeta" else n for kind, _, n in chosen) > 64:
        raise Unsure("a field of a degree above 64, perhaps")
    return {"kind": "field of numbers", "numbers": order}


def number_data(c: Fraction) -> int | str:
    """Write a rational number as data."""
    return int(c) if c.denominator == 1 else str(c)


def _mentioned(text: str) -> list[str]:
    """Return the numbers that an expression mentions."""
    found, n = [], 0
    while n < len(text):
        m = re.match(rf"(?:sqrt|cbrt|root)\(|{NAME}|[^A-Za-z]", text[n:])
        assert m is not None
        start, n = n, n + m.end()
        if m[0].endswith("(") and len(m[0]) > 1:
            while n < len(text) and not matched(text[start:n]):
                n += 1
            if "(" in text[start + len(m[0]) : n]:
                refuse("brackets under a root in an expression")
            found.append(text[start:n])
        elif re.fullmatch("I|zeta[0-9]+", m[0]):
            found.append(m[0])
    return list(dict.fromkeys(found))


def _generated_by(text: str) -> Data:
    """Return the field of the numbers in an expression, if this generates it."""
    spelled = _mentioned(text)
    found = [_number(x) or refuse("a number that is none") for x in spelled]
    if text.strip("()") in (x.rstrip(")") for x in spelled) or re.search(r"root\([^(]*,2\)", text):
        raise Unsure("brackets around a number, or a square root in other words")
    field = field_of(found)
    for n, part in enumerate(spelled):
        text = text.replace(part, f"y{n}")
    tree = parsed(text)
    if not names_in(tree) <= {f"y{n}" for n in range(len(spelled))}:
        refuse("another name")
    if len({_spelled(x) for x in found}) > 1:
        raise Unsure("whether an expression generates all of a larger field")
    f = modulus_of(field)
    names = {f"y{n}": _inside(x, field) for n, x in enumerate(found)}
    power: Poly = (QQ.one,)
    rows = []
    value = worked_out(tree, names, QQ, f)
    for _ in f[1:]:
        rows.append([*power, *[Fraction(0)] * (len(f) - 1 - len(power))])
        power = remainder(QQ, times(QQ, power, value), f)
    if sympy.Matrix(rows).rank() < len(rows):
        refuse("it generates a smaller field")
    return field


def _inside(x: Number, field: Data) -> Poly:
    """Return a number as a multiple of the generator: √8 = 2√2."""
    if field["kind"] != "quadratic field":
        return X
    ratio = x[1] / field["d"]
    top, below = (int(sympy.integer_nthroot(m, 2)[0]) for m in (ratio.numerator, ratio.denominator))
    return (Fraction(0), Fraction(top, below))


def real_cyclotomic(order: str) -> Data:
    """Return the real subfield of ℚ(ζₙ)."""
    n = int(order)
    if not 3 <= n <= 1000 or not 4 <= sympy.totient(n) <= 256:
        refuse("QQ itself, or too large")
    return {"kind": "real cyclotomic field", "order": n}


def number_field(variable: str, text: str) -> Data:
    """Return ℚ[s]/(f), the variable being one already; f in it, or in any other one."""
    tree = parsed(text)
    names = names_in(tree)
    f = worked_out(tree, dict.fromkeys(names, X), QQ)
    if names & {"and", "or", "not", "exists"}:
        refuse("a word of the language")
    if names == {variable} and 3 <= len(f) <= 21 and not irreducible_over_rationals(monic(QQ, f)):
        raise Unsure("a quotient of a polynomial ring, without data")
    if len(names) > 1 or not 2 <= len(f) <= 65 or not irreducible_over_rationals(monic(QQ, f)):
        refuse("irreducible, of degree 1 to 64, in one variable")
    modulus = [number_data(c) for c in monic(QQ, f)]
    return {"kind": "number field", "modulus": modulus, "variable": variable}


def modulus_of(field: Data) -> Poly:
    """Return the minimal polynomial of the generator of a number field."""
    kind = field["kind"]
    if kind == "quadratic field":
        return (Fraction(-field["d"]), Fraction(0), Fraction(1))
    if kind == "cyclotomic field":
        return cyclotomic(field["order"])
    if kind == "real cyclotomic field":
        return twice_cosine(field["order"])
    if kind == "root field":
        return principal(Fraction(field["radicand"]), field["order"])
    if kind == "number field":
        return tuple(Fraction(c) for c in field["modulus"])
    raise Unsure(f"the polynomial of a {kind}")


@cache
def principal(a: Fraction, n: int) -> Poly:
    """Return the minimal polynomial of the n-th root of a, real where there is one, else the principal.

    It is the factor of Xⁿ − a with this root.
    """
    whole: Poly = (-a, *[Fraction(0)] * (n - 1), Fraction(1))
    z = -(complex(-a) ** (1 / n)) if a < 0 and n % 2 else complex(a) ** (1 / n)

    def size(f: Poly) -> float:
        terms = [complex(c) * z**k for k, c in enumerate(f)]
        return abs(sum(terms)) / sum(map(abs, terms))

    return min((dense(g.monic()) for g, _ in rational(whole).factor_list()[1]), key=size)


def generator(field: Data) -> str:
    """Return what the generator of a number field is called."""
    kind = field["kind"]
    if kind == "number field":
        return str(field["variable"])
    if kind == "quadratic field":
        return _spelled(("root", field["d"], 2))
    if kind == "root field":
        return _spelled(("root", field["radicand"], field["order"]))
    return f"{'c' if kind.startswith('real') else 'zeta'}{field['order']}"

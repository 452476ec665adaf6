"""Read algebras as Magma, Sage and PARI write them."""

from __future__ import annotations

import re
from math import lcm
from typing import Any

from hfield.core.product import Constants
from hfield.errors import RingError, shorten

RATIONALS = ("Rationals()", "RationalField()", "QQ", "y")
WRITTEN = {  # over ℚ or GF(q); over ℚ[s]/(f), with the letter that stands for s
    "magma": (
        "QuaternionAlgebra<{F} | {a}, {b}>",
        "QuaternionAlgebra<K | {a}, {b}> where K is NumberField(Polynomial([{c}]))",
        "K.1",
    ),
    "sage": (
        "QuaternionAlgebra({F}, {a}, {b})",
        "K.<s> = NumberField(QQ['s']([{c}])); QuaternionAlgebra(K, {a}, {b})",
        "s",
    ),
    "pari": ("alginit(nfinit({F}), [{a}, {b}])", "alginit(nfinit({f}), [{a}, {b}])", "y"),
}
_READ = (
    re.compile(
        r"QuaternionAlgebra<(?P<F>[^|]*)\|(?P<a>[^,]*),(?P<b>[^>]*)>"
        r"(?:whereKisNumberField\(Polynomial\(\[(?P<c>[^]]*)\]\)\))?"
    ),
    re.compile(
        r"(?:K\.<(?P<s>\w+)>=NumberField\((?:QQ\['\w+'\]\(\[(?P<c>[^]]*)\]\)|(?P<f>[^;]*))\);)?"
        r"QuaternionAlgebra\((?P<F>\w+(?:\(\w*\))?),(?P<a>.*),(?P<b>[^,]*)\)"
    ),
    re.compile(r"alginit\(nfinit\((?P<f>[^,]*)\),\[(?P<a>.*),(?P<b>.*)\]\)"),
)


def written(F: Any, c: Constants, system: str) -> str:
    """Write an algebra as a system reads it.

    Raises :class:`RingError` for algebras with t ≠ 0, and over other fields.
    """
    name = system.lower()
    if name not in WRITTEN:
        raise RingError(f"expected one of {', '.join(WRITTEN)}, not {shorten(system)}")
    whole, extended, letter = WRITTEN[name]
    kind, a, b = (
        F.data["kind"],
        *(F.text(x if name != "pari" else _whole(F, x)) for x in (c.a, c.b)),
    )
    if F.is_zero(c.t) and kind == "rationals":
        return whole.format(F={"magma": "Rationals()", "sage": "QQ", "pari": "y"}[name], a=a, b=b)
    if F.is_zero(c.t) and F.order is not None and F.order == F.characteristic and name != "pari":
        return whole.format(F=f"GF({F.order})", a=a, b=b)
    if not F.is_zero(c.t) or kind not in ("number field", "quadratic field", "cyclotomic field"):
        raise RingError(f"an algebra with t ≠ 0, or over {F.name}, is not written for {system}")
    modulus = F.polynomial.coeffs()
    a, b = (x.replace(F.gen_name, letter) for x in (a, b))
    f = "+".join(f"({x})*{letter}^{n}" for n, x in enumerate(modulus) if x)
    return extended.format(a=a, b=b, f=f, c=", ".join(map(str, modulus)))


def _whole(F: Any, x: Any) -> Any:
    """Return an element times a square, without denominators, which PARI asks for."""
    scale = lcm(*map(int, re.findall(r"/(\d+)", F.text(x))))
    return x * F(scale * scale)


def read(text: str) -> str | None:
    """Return the text here of an algebra that Magma, Sage or PARI wrote, or None if it is no such text.

    >>> read("QuaternionAlgebra< RationalField() | -1, -3 >"), read("alginit(nfinit(y^2-5), [-1, y])")
    ('(-1,-3|QQ)', '(-1,s|QQ[s]/(s^2-5))')
    """
    for pattern in _READ:
        found = pattern.fullmatch("".join(text.split()))
        if found is not None:
            break
    else:
        return None
    parts = {"s": None, "c": None, "f": None, "F": None, **found.groupdict()}
    letter = parts["s"] or ("K.1" if "<" in text else "y")
    field, f = parts["F"], parts["f"]
    if parts["c"]:
        f = "+".join(f"({x})*s^{n}" for n, x in enumerate(parts["c"].split(",")))
    if f is None or f in RATIONALS:
        field = "QQ" if field is None or field in RATIONALS else field.replace("FiniteField", "GF")
        return f"({parts['a']},{parts['b']}|{field})"
    a, b, f = (
        re.sub(rf"(?<!\w){re.escape(letter)}(?!\w)", "s", str(x))
        for x in (parts["a"], parts["b"], f)
    )
    f = re.sub(r"(?<!\w)x(?!\w)", "s", f)
    return f"({a},{b}|QQ[s]/({f}))"

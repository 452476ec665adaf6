"""Forgeries by meaning: the reader sees one field, and the certificate is about another that looks like it.

Genuine certificates about fields of a group are given the data, the names or the algebra of others in it.
What passes has to say of the field of its data what is so there, and to call it by its canonical name.
"""

import json
from collections.abc import Iterator
from functools import cache
from typing import Any

from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.prover.prove import prove
from tests.adversary.names.numbers import Data
from tests.adversary.names.reader import read

Certificate = dict[str, Any]
# What a reader may take for one another: canonical names, and other spellings of them.
GROUPS: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...] = (
    (
        ("QQ(zeta8)", "Frac(QQ[zeta8])", "QQ[zeta8]/(zeta8^2-3)", "QQ(zeta8)+", "QQ(zeta16)"),
        ("QQ(zeta_8)", "ℚ(ζ₈)", "QQ(zeta(8))", "QQ[zeta8]", "QQ( zeta8)"),
    ),
    (
        ("QQ(sqrt(2))", "Frac(QQ[sqrt2])", "QQ[sqrt2]/(sqrt2^2-3)", "QQ[s]/(s^2-2)", "QQ(sqrt(-2))"),
        ("QQ(sqrt2)", "Qsqrt2", "QQ(√2)", "QQ(sqrt(8))", "QQ(sqrt(2) )"),
    ),
    (("QQ(I)", "QQ(zeta4)", "QQ(zeta3)", "QQ(x)", "CC"), ("QI", "QQ(i)", "QQ(sqrt(-1))", "QQ(l)")),
    (("GF(7)", "ZZ/7", "Qp(7)", "GF(49)", "GF(7)(t)", "ZZ"), ("F7", "GF(7^1)", "Z7", "GF(07)")),
    (
        ("GF(9)", "GF(9, x^2+1)", "GF(9, x^2+x+2)", "ZZ/9", "GF(3)", "GF(9)((t))"),
        ("GF(3^2)", "F9", "GF(9, x^2+2*x+2)", "GF(9,x^2+1)", "GF(9, x^2 + 1)"),
    ),
    (("Qp(5)", "QQ(p)", "GF(5)", "ZZ/5", "QQ(sqrt(5))", "GF(5)((t))"), ("QQ_5", "Qp(05)", "Q_5", "Qp")),
    (
        ("GF(3)((t))", "GF(3)(t)", "GF(3)(t)_inf", "GF(3)(t)_(t+1)", "GF(3)(t)_(t^2+1)", "GF(3)[t]"),
        ("GF(3)(t)_t", "GF(3)(t)_(t)", "GF(3)(( t ))", "F3((t))"),
    ),
    (
        ("Frac(GF(5)[inf])_inf", "Frac(GF(5)[inf])_(inf)", "Frac(GF(5)[inf])", "GF(5)(t)_inf"),
        ("GF(5)((inf))", "GF(5)(inf)_inf", "GF(5)(inf)", "Frac(GF(5)[inf])_oo"),
    ),
    (
        ("QQ(I)_(5, I-2)", "QQ(I)_(5, I-3)", "Qp(5)", "QQ(I)", "QQ(I)_(13, I-5)"),
        ("QQ(I)_(5,I-2)", "QQ(I)_(5, I+3)", "QI_(5, I-2)", "QQ(I)_(5, I−2)"),
    ),
    (
        ("QQ(sqrt(2))_inf-", "RR", "QQ(sqrt(2))_(7, sqrt(2)-3)", "QQ(sqrt(2))_(7, sqrt(2)-4)"),
        ("QQ(sqrt(2))_inf+", "QQ(sqrt(2))_inf", "QQ(sqrt(2))_inf−", "QQ(√2)_inf-"),
    ),
    (
        tuple(f"QQ[s]/(s^3-3*s-1)_inf{n}" for n in range(3)),
        ("QQ[s]/(s^3-3*s-1)_inf", "QQ[s]/(s^3-3*s-1)_inf00", "QQ[s]/(s^3 - 3*s - 1)_inf0"),
    ),
    (
        ("QQ(root(2,3))", "QQ[s]/(s^3-2)", "QQ(root(-2,3))", "QQ(root(2,6))", "QQ[s]/(s^3-3)"),
        ("QQ(cbrt(2))", "QQ[s]/(x^3-2)", "QQ(root(2, 3))", "QQ[s]/(-2+s^3)"),
    ),
    (
        ("QQ[s]/(s^3-2)_(5, 2+s)", "QQ[s]/(s^3-2)_(5, 4+3*s+s^2)", "QQ[s]/(s^3-2)_(2, s)"),
        ("QQ[s]/(s^3-2)_5", "QQ[s]/(s^3-2)_(5, s+2)", "QQ[s]/(s^3-2)_(5,2+s)"),
    ),
    (("QQ(zeta5)", "QQ(zeta10)", "Frac(QQ[zeta5])", "QQ(zeta5)+"), ("QQ[zeta5]", "QQ(zeta_5)", "QQ(ζ5)")),
    (("QQ", "ZZ", "RR", "CC", "QQ(x)", "QQ[x]"), ("Q", "ℚ", "R", " QQ", "QQ ", "qq")),
    (("QQ(sqrt(2),sqrt(3))", "QQ(sqrt(6))", "QQ(sqrt(2),sqrt(5))"), ("QQ(√2,√3)", "QQ(sqrt(2), sqrt(3))")),
    (("Frac(QQ[pi])", "QQ[pi]", "QQ[pi]/(pi^2-2)", "RR"), ("QQ(pi)", "ℚ(π)", "Frac(ZZ[pi])")),
)  # fmt: skip
# Claims without unknowns that a field gives another meaning, by the group; y is an unknown.
OWN: dict[int, tuple[str, ...]] = {
    0: ("zeta8**8 == 1", "zeta8**2 == 3"),
    1: ("sqrt(2)**2 == 2", "sqrt2**2 == 3", "s**2 == 2"),
    2: ("I**2 == -1", "zeta4**2 == -1"),
    3: ("7 == 0", "49 == 0"),
    4: ("x**2 == -1", "x**2 == x + 1", "3 == 0"),
    5: ("5 == 0",),
    6: ("t == 0", "y**2 != t", "y**2 != t + 1"),
    7: ("y**2 != inf", "y**2 != inf + 1"),
    8: ("y**2 != I - 2", "y**2 != I"),
    9: ("y**2 != sqrt(2)", "y**2 != sqrt(2) - 3"),
    10: ("y**2 != s", "y**2 != s - 1", "y**2 != 1 + s"),
    11: ("s**3 == 2", "root(2,3)**3 == 2"),
    12: ("y**2 != s", "y**2 != 2 + s"),
    13: ("zeta5**5 == 1", "zeta5**4 == 1"),
    16: ("pi**2 == 2",),
}
ALWAYS = ("y**2 != -1", "y**2 != 2", "y**2 != 3")


@cache
def data_of(name: str) -> str:
    """Return the data of a canonical name, as text."""
    return json.dumps(read(name))


@cache
def certificate(claim: str, name: str) -> Certificate | None:
    """Return the prover's certificate of a claim, or of its denial, where it has one."""
    try:
        return prove(claim, ring(name), timeout=2.0).certificate
    except HFieldError:
        return None


@cache
def verdict(claim: str, name: str) -> str:
    """Return what the prover decides of a claim, '' where nothing."""
    try:
        return prove(claim, ring(name), timeout=2.0).verdict
    except HFieldError:
        return ""


def genuine(group: int) -> Iterator[tuple[str, str, Certificate]]:
    """Yield fields, claims and certificates."""
    for name in GROUPS[group][0]:
        for claim in (*OWN.get(group, ()), *ALWAYS):
            found = certificate(claim, name)
            if found is not None:
                yield name, claim, found


def forged(group: int) -> Iterator[tuple[str, Certificate]]:
    """Yield certificates in which something is another field's, and how it was done."""
    names, spellings = GROUPS[group]
    for name, _, true in genuine(group):
        for spelled in spellings:
            yield "another spelling", renamed(true, spelled)
            yield "another spelling of the field alone", {**true, "field": spelled}
        for other in (x for x in names if x != name):
            data: Data = json.loads(data_of(other))
            yield "the other's data", {**true, "ring": data}
            yield "the other's data throughout", moved(true, data)
            yield "the other's name", renamed(true, other)
            yield "the other's algebra", {**true, "algebra": f"(-1,-1|{other})"}
            yield "the other's field", renamed(moved(true, data), other)
            yield (
                "the other's field, the evidence as it was",
                renamed({**true, "ring": data}, other),
            )
            denied = {"proved": "refuted", "refuted": "proved"}.get(true["verdict"], "proved")
            yield (
                "the other's field, denied",
                renamed(moved(true, data), other) | {"verdict": denied},
            )
            yield "over the other", over(true, name, data)
            yield "over the other by name", over(true, other, true["ring"])


def renamed(true: Certificate, name: str) -> Certificate:
    """Return a certificate that calls its field so."""
    return {**true, "field": name, "algebra": f"(-1,-1|{name})"}


def moved(value: Any, data: Data) -> Any:
    """Put data in the place of all data of rings."""
    if isinstance(value, list):
        return [moved(x, data) for x in value]
    if not isinstance(value, dict):
        return value
    return {key: data if key == "ring" else moved(x, data) for key, x in value.items()}


def over(true: Certificate, name: str, data: Data) -> Certificate:
    """Say it with ``over``: the ring is named in the statement, its data stand in the evidence."""
    evidence = {"kind": "rings", "rings": [data], "evidence": true["evidence"]}
    statement = f"over{{{name}; {true['statement']}}}"
    return {**true, "statement": statement, "evidence": evidence, **_over_rationals()}


def _over_rationals() -> Certificate:
    return {"field": "QQ", "algebra": "(-1,-1|QQ)", "ring": {"kind": "rationals"}}


def wrong_in(data: Certificate) -> str | None:
    """Return what is wrong with a forgery that passes, '' where it may pass, None where it is rejected."""
    try:
        established = check(data)
    except Rejected:
        return None
    claim, name = data["statement"], data["field"]
    about = data["ring"]
    if claim.startswith("over{"):
        name, _, claim = claim[5:-1].partition(";")
        about, claim = data["evidence"]["rings"][0], claim.strip()
    canonical = read_ring(about).name
    if name != canonical:
        return f"{name} passes as the name of {canonical}"
    truth = verdict(claim, canonical)
    if truth != established.verdict:
        return (
            f"{claim} passes as {established.verdict} over {canonical}, but is {truth or 'nothing'}"
        )
    return ""

"""Statements whose certificates are checked, and the fields they are decided over."""

from typing import Any

from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.vocabulary.logic import names_of_rings
from hfield.prover.prove import prove
from tests.checker.ring_data import Data, data_of

FIELDS = (
    *(None, "QQ", "GF(2)", "GF(3)", "GF(4)", "GF(9)", "QQ(sqrt(-7))", "QQ(sqrt(2))", "QQ(I)"),
    *("QQ(x)", "GF(2)(t)", "GF(5)", "RR", "CC", "ZZ", "ZZ/4", "GF(9, x^2+1)"),
)
STATEMENTS = (
    "(p*q)*r == p*(q*r)",
    "p*q == q*p",
    "norm(p*q) == norm(p)*norm(q)",
    "comm(comm(p,q)*comm(p,q), r) == 0",
    "q**2 - trace(q)*q + norm(q) == 0",
    "trace(p*q) == trace(q*p)",
    "p*q*p*r == p*(q*(p*r))",
    "conj(p*q) == conj(q)*conj(p)",
    "conj(q) == q[0] - q[1]*i - q[2]*j - q[3]*k",
    "2*p*q == 2*q*p",
    "q**4 == q**2",
    "(q + conj(q))**2 == 0",
    "i*j == k and j*k == i",
    "i*j == j*i",
    "not (p == q) <=> p != q",
    "norm(q) != 0 => q*inv(q) == e",
    "norm(p) != 0 and norm(q) != 0 => inv(p*q) == inv(q)*inv(p)",
    "inv(p*q) == inv(q)*inv(p)",
    "q*inv(q) == e",
    "q[0] != 0 => (q[0]*q[0])/q[0] == q[0]",
    "p*q == 0 => p == 0 or q == 0",
    "norm(q) == 0 => q == 0",
    "norm(p) == 0 => norm(p*q) == 0",
    "p*q == e => q*p == e",
    "s*s == norm(p) and y*y == norm(q) => (s*y)*(s*y) == norm(p*q)",
    "2 == 0 => p*q == q*p",
    "q**2 == e => q == e or q == -e",
    "q**2 == q => q == 0 or q == e",
    "q**2 == 0 => q == 0",
    "q*q == -1 => trace(q) == 0",
    "s*p == 0 => s == 0 or p == 0",
    "norm(q) == 3 => q != 0",
    "norm(q) == 1 and norm(q) == 2 => p == q",
    "s**2 == 3 => s == 0",
    "exists q: q != 0 and norm(q) == 0",
    "exists q: q*q == -e",
    "exists s: s*s == 2",
    "exists p, q: p*q != q*p",
    "exists q: p*q == e",
    "norm(p) != 0 => (exists q: p*q == e)",
)
ALGEBRAS = (
    ("p*q == q*p", "(a,b|F)"),
    ("norm(p*q) == norm(p)*norm(q)", "(a,b|F)"),
    ("i*i == a", "(a,b|F)"),
    ("norm(p*q) == norm(p)*norm(q)", "[a,b|F)"),
    ("q**2 - trace(q)*q + norm(q) == 0", "[a,b,t|F)"),
    ("norm(q) == 0 => q == 0", "(-1,-3|QQ)"),
    ("p*q == 0 => p == 0 or q == 0", "(-1/2,-3|QQ)"),
    ("p*q == 0 => p == 0 or q == 0", "(2,3|QQ)"),
    ("p*q == 0 => p == 0 or q == 0", "(2,3|QQ(sqrt(-7)))"),
    ("norm(q) == 0 => q == 0", "(-1,sqrt(2)|QQ(sqrt(2)))"),
    ("norm(q) == 0 => q == 0", "(x,-1|QQ(x))"),
    ("norm(q) == 0 => q == 0", "(t,2|GF(5)(t))"),
    ("norm(q) == 0 => q == 0", "[1,t|GF(2)(t))"),
    ("norm(q) == 0 => q == 0", "(6,10|QQ)"),
)

Certificate = dict[str, Any]
Field = str | Data | None


def certificates() -> list[Certificate]:
    """Return the certificates of everything above that is decided."""
    pairs = [(statement, field, None) for statement in STATEMENTS for field in FIELDS]
    pairs += [(statement, None, algebra) for statement, algebra in ALGEBRAS]
    found = [prove(s, f, algebra=a, timeout=5.0).certificate for s, f, a in pairs]
    return [c for c in found if c is not None]


def decided(statement: str, field: str | None = "QQ", algebra: str | None = None) -> Certificate:
    """Return the certificate of a statement that is decided."""
    found = prove(statement, field, algebra=algebra).certificate
    assert found is not None
    return found


def certified(
    statement: str, field: Field, method: str, evidence: Any, algebra: str | None = None
) -> Certificate:
    """Return a certificate that a hand wrote: proved, citing nothing."""
    data = {
        "schema": "hfield-cert/2",
        "statement": statement,
        "verdict": "proved",
        "method": method,
        "assumes": [],
        "evidence": with_rings(statement, evidence),
    }
    return about_field(data, field) | ({} if algebra is None else {"algebra": algebra})


def with_rings(statement: str, evidence: Any) -> Any:
    """Return the evidence, with the data of the rings that the statement names, if any."""
    names = names_of_rings(statement)
    if not names:
        return evidence
    return {"kind": "rings", "rings": [data_of(name) for name in names], "evidence": evidence}


def about_field(data: Certificate, field: Field) -> Certificate:
    """Return the certificate said of H(F) over a field: of a canonical name, of these data, or over all."""
    ring = data_of(field) if isinstance(field, str) else field
    try:
        name = None if ring is None else read_ring(ring).name
    except Rejected:  # as the test expects it to be, for it is no ring
        name = field if isinstance(field, str) else "F"
    assert not isinstance(field, str) or field == name
    return {**data, "field": name, "ring": ring, "algebra": f"(-1,-1|{name or 'F'})"}

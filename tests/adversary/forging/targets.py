"""False claims to forge certificates for. That they are false is tested, not trusted (test_targets.py)."""

from dataclasses import dataclass, replace
from typing import Any

from hfield.checker.rejection import Rejected
from hfield.errors import RingError
from tests.checker.cases import with_rings
from tests.checker.ring_data import (
    QQ,
    Data,
    completion,
    data_of,
    finite,
    functions,
    generated,
    number,
    polynomials,
    quadratic,
    residues,
)

Certificate = dict[str, Any]


@dataclass(frozen=True)
class Target:
    """A false claim. ``zeros`` and ``goals`` are the polynomials of its clause, where it has one.

    ``variables`` are the coordinates in the order in which they occur, ``constants`` the field's.
    """

    statement: str
    field: str | None = "QQ"
    verdict: str = "proved"
    algebra: str | None = None
    zeros: tuple[str, ...] = ()
    goals: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()
    constants: tuple[str, ...] = ()

    @property
    def algebra_text(self) -> str:
        """The algebra as a certificate has it."""
        return self.algebra or f"(-1,-1|{self.field or 'F'})"

    def certificate(
        self, evidence: Any, method: str = "implication", **changes: Any
    ) -> Certificate:
        """Return a certificate of the claim, which says the rings that its words name."""
        statement = changes.get("statement", self.statement)
        return {
            "schema": "hfield-cert/2",
            "statement": statement,
            "algebra": self.algebra_text,
            "field": self.field,
            "ring": None if self.field is None else any_data(self.field),
            "verdict": self.verdict,
            "method": method,
            "assumes": [],
            "evidence": _with_rings(statement, evidence),
        } | changes

    def over(self, field: str | None) -> "Target":
        """Return the same over another field."""
        return replace(self, field=field)


def any_data(name: str) -> Data:
    """Return the data of a ring of that name, or some if there is none."""
    try:
        return data_of(name)
    except RingError:
        return {"kind": name}


def _with_rings(statement: str, evidence: Any) -> Any:
    try:
        return with_rings(statement, evidence)
    except Rejected:  # the statement nests too deeply
        return evidence


Q = tuple(f"q[{n}]" for n in range(4))
P = tuple(f"p[{n}]" for n in range(4))
NORM = "q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2"
PQ = (
    "p[0]*q[0] - p[1]*q[1] - p[2]*q[2] - p[3]*q[3]",
    "p[0]*q[1] + p[1]*q[0] + p[2]*q[3] - p[3]*q[2]",
    "p[0]*q[2] - p[1]*q[3] + p[2]*q[0] + p[3]*q[1]",
    "p[0]*q[3] + p[1]*q[2] - p[2]*q[1] + p[3]*q[0]",
)
COMMUTATOR = (
    "2*p[2]*q[3] - 2*p[3]*q[2]",
    "-2*p[1]*q[3] + 2*p[3]*q[1]",
    "2*p[1]*q[2] - 2*p[2]*q[1]",
)


def _over(target: Target, *fields: str | None) -> list[Target]:
    return [target.over(field) for field in fields]


CLAUSES = [
    *_over(Target("s == s + 1", goals=("1",), variables=("s",)), "ZZ", "QQ", "GF(3)", "ZZ/6", None),
    *_over(Target("s == 0", goals=("s",), variables=("s",)), "QQ", "GF(2)", "GF(3)", "ZZ/4", None),
    *_over(Target("q == 0", goals=Q, variables=Q), "GF(3)", "QQ", "ZZ", "ZZ/6", None),
    *_over(Target("p*q == q*p", goals=COMMUTATOR, variables=(*P, *Q)), "QQ", "GF(3)", "ZZ", None),
    *_over(
        Target("s*y == 0 => s == 0", zeros=("s*y",), goals=("s",), variables=("s", "y")),
        *("QQ", "GF(2)", "ZZ/6", None),
    ),
    *_over(
        Target("2*s == 0 => s == 0", zeros=("2*s",), goals=("s",), variables=("s",)),
        *("GF(2)", "ZZ/4", "ZZ/6", "GF(4)", None),
    ),
    *_over(
        Target("s**2 == 0 => s == 0", zeros=("s**2",), goals=("s",), variables=("s",)),
        *("ZZ/4", "ZZ/8", "ZZ/9", "ZZ/12"),
    ),
    *_over(
        Target("s**2 == 2 => s == 0", zeros=("s**2 - 2",), goals=("s",), variables=("s",)),
        *("RR", "CC", "QQ(sqrt(2))", "GF(7)", None),
    ),
    *_over(
        Target("s**2 != 2", zeros=("s**2 - 2",), variables=("s",)),
        *("RR", "QQ(sqrt(2))", "GF(7)", "GF(9)"),
    ),
    *_over(
        Target(
            "s**2 + y**2 == 0 => s == 0", zeros=("s**2 + y**2",), goals=("s",), variables=("s", "y")
        ),
        *("GF(5)", "QQ(I)", "CC", "GF(2)(t)", None),
    ),
    *_over(
        Target("norm(q) == 0 => q == 0", zeros=(NORM,), goals=Q, variables=Q),
        *(
            "GF(2)",
            "GF(3)",
            "GF(5)",
            "QQ(I)",
            "CC",
            "QQ(sqrt(-2))",
            "QQ(sqrt(-3))",
            "GF(3)(t)",
            None,
        ),
    ),
    *_over(
        Target("p*q == 0 => p == 0", zeros=PQ, goals=P, variables=(*P, *Q)),
        *("QQ", "GF(3)", "ZZ", "QQ(sqrt(-3))", None),
    ),
    *_over(
        Target("s**2 == s", goals=("s**2 - s",), variables=("s",)), "GF(3)", "GF(4)", "ZZ/6", "QQ"
    ),
    *_over(Target("x**2 == x", goals=("x**2 - x",), constants=("x",)), "GF(4)", "GF(9)", "QQ(x)"),
    Target("sqrt(2)**2 == 3", "QQ(sqrt(2))", goals=("sqrt(2)**2 - 3",), constants=("sqrt(2)",)),
    Target("sqrt(2) == 1", "RR", goals=("sqrt(2) - 1",), constants=("sqrt(2)",)),
    Target("I == 1", "QQ(I)", goals=("I - 1",), constants=("I",)),
    Target("s != 0 => s/s + 2*s == 1", None, zeros=(), goals=("2*s**2", "s"), variables=("s",)),
    Target("inv(q)*q == e", "QQ", goals=(NORM,), variables=Q),
    Target("a != 0 => b == 0", "QQ", algebra="(a,b|QQ)", goals=("a", "b"), variables=("a", "b")),
    Target("b == 1", "GF(3)", algebra="(1/a,b|GF(3))", goals=("b - 1",), variables=("a", "b")),
    Target("1 == 2", "QQ", goals=("1",)),
    Target("2 == 0", None, goals=("2",)),
]
OTHERS = [
    Target("exists s: s**2 == -1"),
    Target("exists s: s**2 == 2", "GF(3)"),
    Target("exists q: q != 0 and norm(q) == 0"),
    Target("exists q: p*q == e", "GF(3)"),
    Target("exists q: p*q == e", None),
    Target("exists y: s*y == 1", "GF(5)"),
    Target("exists y: 0*y == 1", "ZZ/6"),
    Target("exists y: not (y == y)", "QQ"),
    Target("exists y: not (s*y == 1) and s*y == 1", "QQ"),
    Target("(p*q)*r == p*(q*r)", "QQ", "refuted"),
    Target("(p*q)*r == p*(q*r)", None, "refuted"),
    Target("norm(p*q) == norm(p)*norm(q)", "GF(3)", "refuted"),
    Target("norm(p*q) == norm(p)*norm(q)", "QQ(x)", "refuted", algebra="(x,-1|QQ(x))"),
    Target("s == s", "ZZ", "refuted"),
    Target("s**3 == s", "GF(3)", "refuted"),
    Target("s*y == y*s", None, "refuted", algebra="(a,b|F)"),
    Target("s == s", "QQ", "refuted", algebra="(1/a,b|QQ)"),
    Target("exists x: x == 0", None, "refuted"),
    Target("exists s: i*i == x", None, "refuted", algebra="(x,-1|F)"),
    Target("exists y: a*y == 1", "GF(3)", "refuted", algebra="(1/a,1|GF(3))"),
    Target("exists y: a*y == 1", "QQ", "refuted", algebra="(1/a,1|QQ)"),
    Target("exists t: t*t == t", None, "refuted"),
    Target("exists q: q*q == -1", "QQ", "refuted"),
    Target("exists s: s**2 == 2", "RR", "refuted"),
    Target("exists s: s**2 == 2", "GF(7)", "refuted"),
    Target("exists z: z + s == 0", None, "refuted"),
    Target("norm(q) != 0 => (exists p: p*q == e)", "GF(3)", "refuted"),
    Target("norm(q) == 0 => norm(p*q) == 0", "QQ", "vacuous"),
    Target("s == 1 => s == 2", "GF(3)", "vacuous"),
    Target("a == 0 => a == 1", "GF(3)", "vacuous", algebra="(a,1|GF(3))"),
    Target("s*s == 4 => s == 2", "ZZ", "vacuous"),
    Target("s == s", "QQ", "vacuous"),
    Target("2 == 0 => p*q == q*p", None, "vacuous"),
]
# What no ring is, or what is not a field: a claim over it is not a theorem at all.
NO_FIELDS = (
    *("GF(6)", "GF(1)", "GF(0)", "GF(15)", "GF(561)", "GF(1729)", "GF(3215031751)", "ZZ/1", "ZZ/0"),
    *("GF(3317044064679887385961981)", "GF(318665857834031151167461)", "GF(4, x^2+1)", "GF(4,x^2)"),
    *("GF(8, x^3+1)", "GF(9, x^2-1)", "GF(9,x^2+2*x+1)", "GF(16,x^4+x^2+1)", "GF(16,(x^2+x+1)^2)"),
    *(
        "GF(4, 2*x^2+x+1)",
        "GF(4,x^3+x+1)",
        "GF(25,x^2+1)",
        "GF(7,x^2+1)",
        "QQ(sqrt(8))",
        "QQ(sqrt(1))",
    ),
    *(
        "QQ(sqrt(0))",
        "QQ(sqrt(4))",
        "QQ(sqrt(-1))",
        "QQ(sqrt(12))",
        "QQ(e)",
        "QQ(i)",
        "RR(x)",
    ),
    *(
        "QQ(x)(x)",
        "ZZ(x)",
        "ZZ/4(x)",
        "GF(4)(x)",
        "GF(9)[x]",
        "QQ[x,x]",
        "GF(٣)",
        "GF(3.0)",
        "GF(+3)",
    ),
    *("GF(1_1)", "GF(１１)", "ZZ/٦", "F", "", " ", "GF()", "QQ(sqrt(2)", "QQ(sqrt(2.0))", "GF(-3)"),
)
# And what the data of none are, each with a name that it might have.
X, QQX = "x", functions(QQ, "x")
NO_RINGS: tuple[tuple[str, Data], ...] = (
    *(
        (f"GF({p})", finite(p))
        for p in (6, 1, 0, 15, 561, 1729, 3215031751, 4, 9, 318665857834031151167461)
    ),
    *((f"ZZ/{n}", residues(n)) for n in (1, 0, -3)),
    *(
        ("GF(4)", finite(2, 2, f))
        for f in ([1, 0, 1], [0, 0, 1], [1, 1, 0, 1], [1, 1, 2], [3, 1, 1], None)
    ),
    *(
        ("GF(9)", finite(3, 2, f))
        for f in ([2, 0, 1], [1, 2, 1], [2, 2, 4], [2, 2, -2], [2, 2], [5, 2, 1])
    ),
    *(("GF(16)", finite(2, 4, f)) for f in ([1, 0, 1, 0, 1], [1, 1, 0, 0, 0, 1], [1, 0, 0, 0, 1])),
    ("GF(8, x^3+1)", finite(2, 3, [1, 0, 0, 1])),
    ("GF(25, x^2+1)", finite(5, 2, [1, 0, 1])),
    ("GF(49, x^2-1)", finite(7, 2, [6, 0, 1])),
    ("GF(7)", finite(7, 1, [1, 1])),
    ("GF(3)", finite(3, 1, [1, 0, 1])),
    ("GF(6)", finite(6, 2, [1, 1, 1])),
    *((f"QQ(sqrt({d}))", quadratic(d)) for d in (8, 1, 0, 4, 12, -4, "2", 2.0, True)),
    ("QQ(I)", quadratic(-9)),
    *((f"QQ({name})", functions(QQ, name)) for name in ("e", "i", "I", "not", "x,y", "x)(", "")),
    ("QQ(I)(I)", functions(quadratic(-1), "I")),
    ("RR(x)", functions({"kind": "reals"}, X)),
    ("QQ(x)(x)", functions(QQX, X)),
    ("ZZ(x)", functions({"kind": "integers"}, X)),
    ("ZZ/4(x)", functions(residues(4), X)),
    ("GF(4)(x)", functions(finite(2, 2, [1, 1, 1]), X)),
    ("GF(9)[x]", polynomials(finite(3, 2, [2, 2, 1]), X)),
    ("QQ[x,x]", polynomials(QQ, X, X)),
    ("QQ", {**QQ, "modulus": 1}),
    ("QQ", {"kind": "QQ"}),
    ("Qp(4)", completion(QQ, number(4))),
    ("Qp(2)", completion(QQ, {"kind": "infinity"})),
    ("QQ[s]/(s^2-4)", generated([-4, 0, 1])),
    ("QQ[s]/(s^4+4)", generated([4, 0, 0, 0, 1])),
)
TRUE_THERE = ("s == s", "p*(q + r) == p*q + p*r", "s**2 == 0 => s**3 == 0")

TARGETS = [*CLAUSES, *OTHERS]

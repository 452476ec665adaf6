"""The table of the first page, who can do what: every tick is tried, a peer's where the peer is installed."""

import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from hfield import GF, H, QuaternionAlgebra, check, prove
from tests.patience import PATIENCE
from tests.subcases import subcases

PAGE = Path(__file__).parents[2] / "docs" / "index.md"
SYSTEMS = ("hfield", "Sage", "PARI", "GAP", "Magma")


def table() -> dict[str, dict[str, str]]:
    """The marks of each row, by system."""
    text = PAGE.read_text(encoding="utf-8")
    head = "| " + " | ".join(["", *SYSTEMS]).strip() + " |"
    rows = text[text.index(head) :].split("\n\n")[0].splitlines()[2:]
    cells = [[cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]] for row in rows]
    return {label: dict(zip(SYSTEMS, marks, strict=True)) for label, *marks in cells}


def a_million_products() -> bool:
    A = H(GF(7))
    digits = np.random.default_rng(0).integers(0, 7, (2, 4, 10**6))
    p, q = (A.from_array(x) for x in digits)
    return bool(((p * q).norm() == p.norm() * q.norm()).all())


def a_certified_theorem() -> bool:
    found = prove("norm(p*q) == norm(p)*norm(q)")
    return found.verdict == check(found.certificate).verdict == "proved"


def division_over_many_fields() -> bool:
    algebras = [("QQ(x)", -1, -1), ("GF(5)(t)", 2, "t"), ("Qp(5)", 2, 5), ("RR", 1, 1)]
    return [QuaternionAlgebra(*A).is_division_algebra() for A in algebras] == [True] * 3 + [False]


def an_inverse() -> bool:
    A = H("GF(5)(t)")
    _, i, j, _ = A.basis
    M = A.matrix([[1, i], [j, 1]])
    return M @ M.inverse() == A.matrix([[1, 0], [0, 1]])


def all_roots() -> bool:
    P = H("RR").polynomials("x")
    return len(P([1, 0, 1]).roots().spheres) == 1


def classes_over_a_number_field() -> bool:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    P = A.ring.primes_above(31)[0]
    return A.eichler_order(P).class_set().hecke_polynomial(A.ring.gen) == [-12, -4, 1]


def hilbert_newforms() -> bool:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    C = A.eichler_order(A.ring.primes_above(61)[0]).class_set()
    return [f.degree for f in C.newforms()] == [2]


def certified_embeddings() -> bool:
    claim = QuaternionAlgebra(6).maximal_order().embeddings(-24).claim_of_orbits()
    return check(claim.certificate).verdict == "proved"


def classes_over_polynomials() -> bool:
    A = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t^3+2*t+1", "inf"])
    return len(A.maximal_order().class_set()) == 4


def a_proved_domain() -> bool:
    G = QuaternionAlgebra(6).maximal_order().norm_one_group()
    return (G.signature.genus, G.signature.orders) == (0, (2, 2, 3, 3))


OURS: dict[str, Callable[[], bool]] = {
    "decides statements about all quaternions": lambda: (
        prove("p*q == q*p", "QQ").verdict == "refuted"
    ),
    "gives certificates that an independent program checks": a_certified_theorem,
    "division algebra or not, over a number field": lambda: (
        H("QQ(sqrt(-7))").is_division_algebra() and not H("QQ(I)").is_division_algebra()
    ),
    "the same over ℚ(x), GF(5)(t), ℚ₅, ℝ": division_over_many_fields,
    "characteristic 2": lambda: H(GF(4)).is_commutative(),
    "multiplies a million pairs in one call": a_million_products,
    "ideal classes over ℤ, Brandt matrices": lambda: (
        QuaternionAlgebra(11).maximal_order().class_set().brandt_matrix(2) == [[1, 2], [3, 0]]
    ),
    "ideal classes over the integers of number fields": classes_over_a_number_field,
    "Hilbert newforms with irrational eigenvalues": hilbert_newforms,
    "all optimal embeddings in indefinite orders, with a certificate": certified_embeddings,
    "orders over 𝔽_q[t] and their ideal classes": classes_over_polynomials,
    "unit groups of indefinite orders, with a proved fundamental domain": a_proved_domain,
    "inverts matrices over H(F)": an_inverse,
    "finds all roots of polynomials over H(F)": all_roots,
}


def test_every_row_is_ours_and_tried() -> None:
    assert list(table()) == list(OURS)
    assert {marks["hfield"] for marks in table().values()} == {"✓"}
    assert {mark for marks in table().values() for mark in marks.values()} <= {
        "✓",
        "–",
        "in part",
        "?",
    }


@subcases("row", OURS)
def test_ours(row: str) -> None:
    assert OURS[row]()


def sages(sage, algebra) -> dict[str, Callable[[], object]]:
    QQ, x = sage.QQ, sage.polygen(sage.QQ)
    matrix = lambda A: sage.matrix(A, [[A.gen(0), 1], [1, A.gen(1)]])  # noqa: E731
    return {
        "division algebra or not, over a number field": lambda: algebra(
            sage.NumberField(x**2 + 7, "s"), -1, -1
        ).is_division_algebra(),
        "the same over ℚ(x), GF(5)(t), ℚ₅, ℝ": lambda: algebra(
            sage.FractionField(QQ["x"]), -1, -1
        ).is_division_algebra(),
        "characteristic 2": lambda: algebra(sage.GF(4, "a"), 1, 1),
        "ideal classes over ℤ, Brandt matrices": lambda: (
            sage.BrandtModule(11).hecke_matrix(2).list() == [1, 2, 3, 0]
        ),
        "ideal classes over the integers of number fields": lambda: (
            algebra(sage.QuadraticField(5), -1, -1).maximal_order().class_set()
        ),
        "inverts matrices over H(F)": lambda: matrix(algebra(QQ, -1, -1)).inverse(),
        "finds all roots of polynomials over H(F)": lambda: algebra(QQ, -1, -1)["x"](
            [1, 0, 1]
        ).roots(),
    }


def test_sage() -> None:
    sage = pytest.importorskip("sage.all__sagemath_schemes", reason="Sage is not installed")
    from sage.algebras.quatalg.quaternion_algebra import QuaternionAlgebra as Sages

    for row, call in sages(sage, Sages).items():
        assert works(call) == (table()[row]["Sage"] == "✓"), row


PARIS = {
    "division algebra or not, over a number field": (
        "algisdivision(alginit(nfinit(y^2+7),[-1,-1]))"
    ),
    "the same over ℚ(x), GF(5)(t), ℚ₅, ℝ": "algisdivision(alginit(ffgen(5),[2,3]))",
    "characteristic 2": "alginit(Mod(1,2),[1,1])",
    "inverts matrices over H(F)": (
        "A=alginit(nfinit(y),[-1,-1]);alginv(A,[[1,0,0,0]~,[0,1,0,0]~;[0,0,1,0]~,[1,0,0,0]~])"
    ),
}


def test_pari() -> None:
    pari = pytest.importorskip("cypari", reason="PARI is not installed").pari
    for row, text in PARIS.items():
        assert works(lambda text=text: pari(text)) == (table()[row]["PARI"] == "✓"), row


GAPS = {  # what it prints, where it is right
    "division algebra or not, over a number field": "IsDivisionRing(QuaternionAlgebra(Rationals,2,3))",
    "characteristic 2": "IsCommutative(QuaternionAlgebra(GF(4),One(GF(4)),One(GF(4))))",
    "inverts matrices over H(F)": (
        "(function() local b,M; b:=Basis(QuaternionAlgebra(Rationals));"
        " M:=[[b[1],b[2]],[b[3],b[1]]]; return IsOne(M*Inverse(M)); end)()"
    ),
}


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("gap") is None, reason="GAP is not installed")
def test_gap() -> None:
    program = "".join(f'Print({text},"\\n");\n' for text in GAPS.values())
    done = subprocess.run(
        ["gap", "-q"], input=program, capture_output=True, text=True, timeout=PATIENCE
    )
    for row, printed in zip(GAPS, done.stdout.split(), strict=True):
        assert (printed == "true") == (table()[row]["GAP"] == "✓"), row


def works(call: Callable[[], object]) -> bool:
    """Whether a peer answers, and not with no."""
    try:
        return bool(call())
    except Exception:
        return False

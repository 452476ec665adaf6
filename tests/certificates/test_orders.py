"""Certificates about lattices: what is true is accepted, what is forged is rejected, and both sides agree."""

import json
import random
import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import pytest
from flint import fmpz_mat

from hfield import QuaternionAlgebra
from hfield.certificates import work
from hfield.certificates.check import Established, Pin, check_text
from hfield.certificates.orders import local_types
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.orders.enumeration import short_vectors
from hfield.certificates.orders.lattice import Lattice, hermite, inverse, rational_rows
from hfield.certificates.rejection import Rejected
from hfield.certificates.statement import read_setting
from hfield.certificates.work import MAX_WORK, bounded
from tests.certificates.cases import Certificate

ALGEBRAS = ((-1, -11, 0), (-1, -1, 0), ("-1/2", "-5/3", 0), (-1, -3, 1), (2, 3, 0), (-7, -1, 0))


def established(data: Certificate, pin: Pin | None = None) -> Established:
    return check_text(json.dumps(data), pin)


def rejects(data: Certificate, why: str = ".") -> None:
    with pytest.raises(Rejected, match=why):
        established(data)


@cache
def true_ones() -> list[Certificate]:
    """One certificate of every kind, verdict and method, and of different algebras."""
    found: list[Certificate | None] = []
    for a, b, t in ALGEBRAS:
        A = QuaternionAlgebra("QQ", a, b, t)
        O = A.maximal_order()
        x = A(1, 2, 0, 1)
        p = next(p for p in (5, 7, 13) if O.discriminant() % p)
        I, J = O.ideals_of_norm(p)[:2]
        E = A.eichler_order(p)
        found += [O.certificate, E.certificate, I.certificate, J.conjugate().certificate]
        found += [I.equivalence(I * x).certificate, O.isomorphism(x * O * x.inverse()).certificate]
        found += [O.isomorphism(E).certificate]
        R = I.conjugate()
        found.append(R.equivalence(x * R).certificate)
        if "inf" in A.ramified_places():
            found += [E.class_set().certificate, O.class_set().certificate]
            found += [E.embeddings(d).certificate for d in (-3, -4, -7, -8, -15)]
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    I, J = O.ideals_of_norm(2)[:2]
    for side in (I, I.conjugate()):
        found += [side.is_principal().certificate, (2 * side).is_principal().certificate]
    found.append(O.isomorphism(I.right_order()).certificate)
    found.append(O.left_ideal([3, "1 + j"]).equivalence(O.left_ideal([9])).certificate)
    assert None not in found
    return [data for data in found if data is not None]


def test_the_true_ones_are_accepted() -> None:
    seen = set()
    for data in true_ones():
        found = established(data)
        assert (found.statement, found.verdict, found.field) == (
            data["statement"],
            data["verdict"],
            "QQ",
        )
        assert not found.assumptions
        seen.add((data["evidence"]["kind"], data["verdict"], data["method"]))
        assert established(data, Pin((data["statement"],), "QQ", data["algebra"]))
    kinds = ("equivalent", "isomorphic-orders", "embedding")
    assert seen >= {(kind, verdict, how) for kind in kinds for verdict, how in BOTH}
    assert {kind for kind, _, _ in seen} == {"order", "ideal", "class-set", *kinds}


BOTH = (("proved", "element"), ("refuted", "enumeration"))


def test_only_the_mass_is_cited() -> None:
    for data in true_ones():
        cited = established(data).theorems
        assert bool(cited) == (data["evidence"]["kind"] == "class-set")


# --- forged ---------------------------------------------------------------------------------------


def changed(value: Any) -> Iterator[Any]:
    """Yield copies of JSON data with one number changed, in texts too."""
    if isinstance(value, int):
        yield from (value + 1, -value)
    elif isinstance(value, str):
        for m in re.finditer(r"\d+", value):
            for other in (int(m[0]) + 1, 2 * int(m[0]) + 3, 0):
                yield value[: m.start()] + str(other) + value[m.end() :]
        yield value.replace("left", "right") if "left" in value else value.replace("right", "left")
    elif isinstance(value, list):
        for n, item in enumerate(value):
            yield from ([*value[:n], new, *value[n + 1 :]] for new in changed(item))
        if value:
            yield from (value[1:], [*value, value[0]])
    elif isinstance(value, dict):
        for key, item in value.items():
            if key != "kind":
                yield from ({**value, key: new} for new in changed(item))
            yield {k: v for k, v in value.items() if k != key}


def read(A: QuaternionAlgebra, text: str) -> Any:
    return A.lattice([[Fraction(x) for x in row.split(",")] for row in text.split("|")])


def is_true(data: Certificate) -> bool:
    """Decide the statement of a certificate with the lattices of the package."""
    A = QuaternionAlgebra.from_text(data["algebra"])
    m = re.fullmatch(r"([a-z-]+)\{(.*)\}", data["statement"])
    assert m is not None
    parts = [part.strip() for part in m[2].split(";")]
    lattices = [read(A, part) for part in parts if "|" in part]
    proved = data["verdict"] == "proved"
    if m[1] == "equivalent":
        first, second = lattices
        c = second.colon(first, "right" if parts[0] == "left" else "left")
        sizes = [
            q
            for q in c.reduced_basis()
            if (first * q if parts[0] == "left" else q * first) == second
        ]
        return bool(sizes) == proved
    orders = [L.left_order() for L in (lattices if m[1] != "ideal" else lattices[1:])]
    if orders != (lattices if m[1] != "ideal" else lattices[1:]):
        return False
    O = orders[0]
    if m[1] == "order":
        return O.discriminant() == int(parts[1]) and (len(parts) == 2 or O.is_maximal())
    if m[1] == "ideal":
        I = lattices[0]
        same = (I.left_order() if parts[1] == "left" else I.right_order()) == O
        return bool(same and I.is_invertible() and str(I.norm()) == str(Fraction(parts[3])))
    if m[1] == "isomorphic-orders":
        return bool(O.isomorphism(orders[1])) == proved
    if m[1] == "embedding":
        return bool(O.embeddings(int(parts[1]))) == proved
    return len(O.class_set()) == int(parts[1])


def test_no_number_can_be_changed() -> None:
    """Whatever statement is accepted after a change is true; other keys are given away by any change."""
    rng, tried, accepted = random.Random(4), 0, []
    for data in true_ones():
        for key in ("statement", "algebra", "method", "verdict", "assumes", "evidence"):
            every = [new for new in changed(data[key]) if new != data[key]]
            for new in rng.sample(every, min(len(every), 25)):
                forged, tried = {**data, key: new}, tried + 1
                try:
                    established(forged)
                except Rejected:
                    continue
                accepted.append((key, forged))
    assert tried > 2000
    for key, forged in accepted:
        assert key in ("statement", "algebra", "evidence")
        assert key == "evidence" or is_true(forged), forged
    assert sum(key != "evidence" for key, _ in accepted) < tried / 10


def class_set() -> Certificate:
    A = QuaternionAlgebra.from_ramification("QQ", [2, 3, 5])
    data = A.eichler_order(7).class_set().certificate
    assert data is not None
    return data


def restated(data: Certificate, number: int, classes: list[Any]) -> Certificate:
    statement = re.sub(r"; \d+\}$", f"; {number}}}", data["statement"])
    evidence = {"kind": "class-set", "classes": classes}
    return {**data, "statement": statement, "evidence": evidence}


def test_forged_class_sets() -> None:
    data = class_set()
    classes = data["evidence"]["classes"]
    assert established(restated(data, 8, classes[::-1]))
    rejects(restated(data, 8, classes[1:]), "which is not the number")
    rejects(restated(data, 7, classes[1:]), "do not have the mass")
    rejects(restated(data, 9, [*classes, classes[0]]), "in one class")
    rejects(restated(data, 8, [*classes[1:], classes[1]]), "in one class")
    doubled = {
        "den": classes[0]["den"],
        "rows": [[2 * x for x in row] for row in classes[0]["rows"]],
    }
    rejects(restated(data, 9, [*classes, doubled]), "in one class")
    # an ideal of another order, and one that is not locally principal
    A = QuaternionAlgebra.from_text(data["algebra"])
    O = A.eichler_order(7)
    foreign = O.ideals_of_norm(11)[0].hnf
    fat = (O.maximal_overorder() * 1).hnf
    for (den, rows), why in ((foreign, "no right ideal"), (fat, "not locally principal")):
        other = {"den": den, "rows": [list(row) for row in rows]}
        rejects(restated(data, 8, [other, *classes[1:]]), why)
    rejects({**data, "algebra": "(-3,-10|QQ)"})
    rejects({**data, "algebra": "(3,30|QQ)"}, ".")
    rejects({**data, "assumes": []}, "assumes")


def test_too_large_an_ideal_is_not_locally_principal() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).order(["2*i", "2*j"])
    I = O.right_ideal([2, "i + j"])  # an ideal, but of no class
    if I.is_invertible():
        pytest.skip("this ideal is invertible")
    assert I.certificate is None
    assert "not locally principal" in str(I.claim.why_no_certificate)


def order(rows: str, n: int | str, algebra: str = "(-1,-1|QQ)", more: str = "") -> Certificate:
    return {
        "schema": "hfield-cert/1",
        "statement": f"order{{{rows}; {n}{more}}}",
        "algebra": algebra,
        "field": "QQ",
        "verdict": "proved",
        "method": "order",
        "assumes": [],
        "evidence": {"kind": "order"},
    }


LIPSCHITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"
HURWITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2"


def test_orders() -> None:
    assert established(order(LIPSCHITZ, 4))
    assert established(order(HURWITZ, 2, more="; maximal"))
    rejects(order(LIPSCHITZ, 4, more="; maximal"), "not shown that this order is maximal at 2")
    rejects(order(HURWITZ, 4), "another reduced discriminant")
    rejects(order(HURWITZ, 2, more="; minimal"), "nothing more")
    rejects(order(HURWITZ, 2, more="; maximal; maximal"), "parts")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1/2", 2), "a product of two rows")
    rejects(order("2,0,0,0 | 0,2,0,0 | 0,0,2,0 | 0,0,0,2", 64), "1 is not in it")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,1,1,0", 4), "rank below 4")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0", 4), "four rows")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1/0", 4), "divides by 0")
    rejects(order("1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,e", 4), "no rational number")
    rejects(order(LIPSCHITZ, 4, "(-1,0|QQ)"), "degenerate")
    rejects(order(LIPSCHITZ, 4, "(-1,a|QQ)"), "numbers for constants")
    rejects({**order(LIPSCHITZ, 4, "(-1,-1|F)"), "field": None}, "over QQ alone")
    rejects({**order(LIPSCHITZ, 4, "(-1,-1|GF(5))"), "field": "GF(5)"}, "over QQ alone")
    rejects({**order(LIPSCHITZ, 4), "verdict": "refuted"}, "does not show")
    rejects({**order(LIPSCHITZ, 4), "evidence": {"kind": "order", "n": 4}}, "unknown key")
    huge = "9" * 4001
    rejects(order(f"1,0,0,0 | 0,{huge},0,0 | 0,0,1,0 | 0,0,0,1", 4), "no rational number")
    big = f"1,0,0,0 | 0,1{'0' * 3000},0,0 | 0,0,1{'0' * 3000},0 | 0,0,0,1{'0' * 3900}"
    rejects(order(big, 4, more="; maximal"))


def test_an_eichler_order_is_not_maximal() -> None:
    """At a prime that divides the discriminant once the Eichler symbol decides."""
    A = QuaternionAlgebra("QQ", -1, -11)
    data = A.eichler_order(3).certificate
    assert data is not None
    assert data["statement"].endswith("; 33}")
    rejects({**data, "statement": data["statement"][:-1] + "; maximal}"}, "maximal at 3")
    # ℤ[i] + 3·O has the symbol −1 at 3, as a maximal order of a division algebra has
    O = A.maximal_order()
    smaller = A.order(["i", *(3 * q for q in O.basis)])
    assert smaller.eichler_symbol(3) == -1
    data = smaller.certificate
    assert data is not None
    rejects({**data, "statement": data["statement"][:-1] + "; maximal}"}, "maximal at 3")


def test_what_both_orders_have_tells_nothing() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    data = O.isomorphism(O.ideals_of_norm(2)[0].right_order()).certificate
    assert data is not None
    for changes in ({"norm": 10**3, "trace": 7}, {"norm": -1}):
        rejects(
            {**data, "evidence": {**data["evidence"], **changes}}, "both orders have 0 elements"
        )


def test_optimal_embeddings() -> None:
    """2·i has the discriminant −16, but i is in the order."""
    data = QuaternionAlgebra("QQ", -1, -11).maximal_order().embeddings(-4).certificate
    assert data is not None
    assert established(data)
    twice = {"kind": "embedding", "element": ["0", "2", "0", "0"]}
    forged = {**data, "statement": data["statement"].replace("; -4}", "; -16}"), "evidence": twice}
    rejects(forged, "does not generate all integral elements")


def test_enumerations_that_are_not_exhausted() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    I = O.ideals_of_norm(2)[0]
    data = I.is_principal().certificate
    assert data is not None
    rows = data["evidence"]["between"]
    thinner = {"den": rows["den"], "rows": [[3 * x for x in rows["rows"][0]], *rows["rows"][1:]]}
    rejects({**data, "evidence": {"kind": "equivalent", "between": thinner}}, "no basis of the")
    rejects({**data, "evidence": {"kind": "equivalent"}}, "need a basis")
    true = I.equivalence(I * O.algebra(1, 1, 0, 0)).certificate
    assert true is not None
    c = true["statement"]
    rejects({**data, "statement": c}, ".")
    between = I.inverse() * (I * O.algebra(1, 1, 0, 0))
    rows = {"den": between.hnf[0], "rows": [list(row) for row in between.hnf[1]]}
    forged = {**data, "statement": c, "evidence": {"kind": "equivalent", "between": rows}}
    rejects(forged, "an element carries")
    # in an indefinite algebra nothing is exhausted
    M = QuaternionAlgebra("QQ", 1, 5).maximal_order()
    N = M.ideals_of_norm(7)[0]
    told = N.is_principal().certificate
    assert told is not None
    for evidence in ({"kind": "equivalent"}, {"kind": "equivalent", "between": rows}):
        rejects({**told, "verdict": "refuted", "evidence": evidence, "method": "enumeration"})


def test_a_bad_basis_costs_work_and_not_truth() -> None:
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    data = O.ideals_of_norm(2)[0].is_principal().certificate
    assert data is not None
    rows = data["evidence"]["between"]["rows"]
    skew = [
        rows[0],
        *([x + 10**9 * y for x, y in zip(row, rows[0], strict=True)] for row in rows[1:]),
    ]
    between = {"den": data["evidence"]["between"]["den"], "rows": skew}
    try:
        established({**data, "evidence": {"kind": "equivalent", "between": between}})
    except Rejected as error:
        assert "more work" in str(error)  # noqa: PT017


def test_large_numbers() -> None:
    p = 5 * 2**248 - 1
    A = QuaternionAlgebra("QQ", -1, -p)
    O = A.extremal_order()
    I = O.random_ideal(2**127 - 1, seed=1)
    P = I.right_order()
    answers = (I.is_principal(), I.equivalence(I.equivalent_of_prime_norm()[0]), O.isomorphism(P))
    for source in (O, I, *answers):
        assert source.certificate is not None
        established(source.certificate)
    assert "maximal" not in O.certificate["statement"]  # the checker proves no such prime


# --- two systems that share nothing agree -----------------------------------------------------------


def mirrored(L: Any) -> Lattice:
    """Return a lattice of the package as one of the checker."""
    algebra = Algebra(read_setting(str(L.algebra), "QQ"))
    den, rows = L.hnf
    return Lattice(algebra, den, rows)


def test_arithmetic_agrees() -> None:
    rng = random.Random(1)
    for a, b, t in ALGEBRAS:
        A = QuaternionAlgebra("QQ", a, b, t)
        for _ in range(6):
            rows = [
                [Fraction(rng.randint(-9, 9), rng.randint(1, 4)) for _ in range(4)]
                for _ in range(9)
            ]
            L, M = A.lattice(rows[:4]), A.lattice(rows[4:8])
            own, other = mirrored(L), mirrored(M)
            assert own.key == L.hnf
            assert own.norm == Fraction(str(L.norm()))
            assert other.volume / own.volume == Fraction(L.index(M))
            for side in ("left", "right"):
                found = own.into(other, side)
                assert found.key == M.colon(L, "right" if side == "left" else "left").hnf
            O = L.left_order()
            assert local_types.discriminant(mirrored(O)) == O.discriminant()
            for p in local_types.factored(O.discriminant()):
                assert local_types.eichler_symbol(mirrored(O), p) == O.eichler_symbol(p)
            if "inf" in A.ramified_places():
                assert local_types.mass(mirrored(O)) == O.mass()


def test_hermite_forms_and_inverses() -> None:
    rng = random.Random(2)
    for size in (3, 10**3, 10**80):
        for _ in range(20):
            rows = [[rng.randint(-size, size) for _ in range(4)] for _ in range(rng.randint(4, 9))]
            if fmpz_mat(rows).rank() < 4:
                continue
            expected = fmpz_mat(rows).hnf().tolist()[:4]
            assert [list(row) for row in hermite(rows)] == [
                [int(x) for x in row] for row in expected
            ]
            square = fmpz_mat(rows[:4])
            if square.det():
                back, d = inverse(tuple(map(tuple, rows[:4])))
                assert abs(d) == abs(int(square.det()))
                assert square * fmpz_mat([list(row) for row in back]) == d * fmpz_mat(
                    [[int(m == n) for n in range(4)] for m in range(4)]
                )


def test_enumeration_is_complete() -> None:
    rng = random.Random(3)
    for _ in range(20):
        m = fmpz_mat([[rng.randint(-2, 2) for _ in range(4)] for _ in range(4)])
        gram = (
            m * m.transpose() * 2
            + 2 * fmpz_mat([[int(i == j) for j in range(4)] for i in range(4)])
        ).tolist()
        rows = tuple(tuple(int(x) for x in row) for row in gram)
        bound = 14
        # 2·|x|² ≤ x·G·xᵀ, so that coordinates beyond 2 are too long
        brute = {}
        for x in product(range(-2, 3), repeat=4):
            value = sum(x[i] * x[j] * rows[i][j] for i in range(4) for j in range(4))
            if 0 < value <= bound:
                brute[x] = value
        found = dict(short_vectors(rows, bound))
        both = found | {tuple(-c for c in x): v for x, v in found.items()}
        assert len(both) == 2 * len(found)
        assert both == brute


def test_masses_of_small_discriminants() -> None:
    """The mass counted by Eichler's formula for Eichler orders: φ(D)·ψ(N)/12."""
    for primes, level, expected in (((11,), 1, "5/6"), ((11,), 3, "10/3"), ((2, 3, 5), 7, "16/3")):
        O = QuaternionAlgebra.from_ramification("QQ", primes).eichler_order(level)
        assert local_types.mass(mirrored(O)) == Fraction(expected)


def test_what_is_too_large_to_factor_is_rejected() -> None:
    with bounded():
        assert local_types.factored(2**5 * 3 * 1000003) == {2: 5, 3: 1, 1000003: 1}
        assert local_types.factored(10**12 + 39) == {10**12 + 39: 1}
        for n in (2**5000, (10**9 + 7) * (10**9 + 9), 5 * 2**248 - 1):
            with pytest.raises(Rejected):
                local_types.factored(n)


def test_rows_of_fractions() -> None:
    assert rational_rows([[Fraction(1, 2), Fraction(2, 3)]]) == (6, ((3, 4),))


LIPSCHITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"
TWICE = "2,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"


def about(statement: str, evidence: Any, **changes: Any) -> Certificate:
    kind = statement.partition("{")[0]
    data = {
        "schema": "hfield-cert/1",
        "statement": statement,
        "algebra": "(-1,-1|QQ)",
        "field": "QQ",
    }
    data |= {"verdict": "proved", "method": kind, "assumes": []}  # type: ignore[dict-item]
    return {**data, "evidence": {"kind": kind, **evidence}, **changes}


def test_lattices_whose_volumes_are_not_like_those_of_ideals() -> None:
    refuted = {"verdict": "refuted", "method": "norm"}
    for side in ("left", "right"):
        statement = f"equivalent{{{side}; {LIPSCHITZ}; {TWICE}}}"
        assert established(about(statement, {}, **refuted)).scope == "field"
        basis = {
            "between": {"den": 1, "rows": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]]}
        }
        rejects(about(statement, basis, **refuted), "there is nothing to run through")
    rejects(
        about(f"equivalent{{up; {LIPSCHITZ}; {TWICE}}}", {}, **refuted), "must be left or right"
    )
    same = f"equivalent{{left; {LIPSCHITZ}; {LIPSCHITZ}}}"
    rejects(about(same, {}, **refuted), "need a basis")


def test_statements_that_are_not_well_made() -> None:
    assert established(about(f"order{{{LIPSCHITZ}; 4}}", {}))
    for statement, said in (
        (f"order{{{LIPSCHITZ}; 4; maximal}}", "not shown that this order is maximal at 2"),
        (f"order{{{LIPSCHITZ}; 4; best}}", "maximal, or nothing more"),
        (f"order{{{LIPSCHITZ}; 9/2}}", "a discriminant must be an integer"),
        (f"order{{{LIPSCHITZ}; 2}}", "another reduced discriminant"),
        (f"order{{{LIPSCHITZ}; -4}}", "another reduced discriminant"),
        (f"order{{{TWICE}; 8}}", "1 is not in it"),
        (f"order{{{LIPSCHITZ.replace('1', '1/2', 1)}; 2}}", "a product of two rows is not in it"),
        (f"order{{{LIPSCHITZ.replace('1', '0', 1)}; 4}}", "of rank below 4"),
        (f"order{{{LIPSCHITZ[:-2]}; 4}}", "is no rational number|four rows"),
        (f"order{{{LIPSCHITZ}}}", "has not 1 parts"),
        (f"order{{{LIPSCHITZ.replace('1', '1/0', 1)}; 4}}", "divides by 0"),
    ):
        rejects(about(statement, {}), said)


def test_long_numbers_are_paid_for() -> None:
    """Running through vectors costs as much more as the numbers are longer."""

    def spent(scale: int) -> int:
        gram = tuple(tuple(scale * (m == n) for n in range(4)) for m in range(4))
        with bounded():
            assert len(list(short_vectors(gram, 4 * scale))) == 44
            return MAX_WORK - work._current.get().left

    assert spent(10**4000) > 50 * spent(1)

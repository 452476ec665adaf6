"""The two spellings are one theory: that of number fields says over the field of degree 1 what ℚ says."""

import random
from fractions import Fraction
from typing import Any

from flint import fmpz_mat

from hfield import QuaternionAlgebra
from hfield.checker.number_fields.integers import RATIONAL_INTEGERS
from hfield.checker.number_fields.matrices import hermite, rational_rows, times, times_any
from hfield.checker.orders.words import establish_order
from hfield.checker.scalars.number_fields import NumberField
from hfield.checker.statement import Setting, read_setting
from tests.checker.cases import Certificate
from tests.checker.order_certificates import rejects, true_ones
from tests.checker.test_answers_over_integers import genuine
from tests.checker.test_norm_one_groups import both

FIELD = NumberField("QQ[s]/(s-1)", [Fraction(-1), Fraction(1)], ("name", "s"), "s")
TORSION = {"order": 2, "generator": [-1], "residues": []}
S_UNITS = {
    "kind": "S-units", "basis": [[1]], "torsion": TORSION,
    "primes": [], "S": [], "reductions": [], "generators": [], "saturated": [],
}  # fmt: skip
UNITS = {"units": S_UNITS, "fundamental": []}
PRIMES = [[p, [[0]]] for p in (2, 3, 5, 7, 11, 13)]
OTHER = {
    "order": "order-over-integers", "ideal": "ideal-over-integers", "equivalent": "equivalent-over-integers",
    "isomorphic-orders": "isomorphic-over-integers", "class-set": "ideal-classes",
    "dirichlet-domain": "dirichlet-domain-over-integers", "norm-one-group": "norm-one-group-over-integers",
}  # fmt: skip
Statement = tuple[str, tuple[str, ...], Setting, str, Any]


def respelt(data: Certificate) -> Statement | None:
    """Return a statement over ℚ and its evidence as over the field of degree 1; None where there is none."""
    word, _, inside = data["statement"][:-1].partition("{")
    parts = tuple(part.strip() for part in inside.split(";"))
    evidence = dict(data["evidence"])
    lattice = QuaternionAlgebra.from_text(data["algebra"]).lattice
    if word == "embedding" or "bases" in evidence:
        return None
    if word == "equivalent" and data["verdict"] == "refuted":
        if "between" not in evidence:
            return None
        first, second = (lattice([row.split(",") for row in part.split("|")]) for part in parts[1:])
        evidence |= {**UNITS, "norm": [number(second.norm() / first.norm())]}
        if parts[0] == "right":
            den, basis = lattice(rows_of(evidence["between"])).conjugate().hnf
            evidence["between"] = {"den": den, "rows": [list(row) for row in basis]}
    elif word == "class-set":
        classes = [{**x, "norm": [number(lattice(rows_of(x)).norm())]} for x in evidence["classes"]]
        evidence |= {**UNITS, "primes": PRIMES, "classes": classes}
    else:
        evidence["basis"] = [[1]]
        evidence |= {"primes": PRIMES} if word in ("dirichlet-domain", "norm-one-group") else {}
        evidence |= {
            key: element(evidence[key]) for key in ("element", "center") if key in evidence
        }
        if "units" in evidence:
            evidence["units"] = [element(x) for x in evidence["units"]]
    setting = read_setting(data["algebra"].replace("|QQ)", f"|{FIELD.name})"), FIELD)
    said = parts[:2] if word == "order" else parts  # that an order is maximal is said over ℚ alone
    return OTHER[word], said, setting, data["verdict"], {**evidence, "kind": OTHER[word]}


def rows_of(value: dict[str, Any]) -> list[list[Fraction]]:
    return [[Fraction(c, value["den"]) for c in row] for row in value["rows"]]


def number(x: Any) -> int | str:
    return int(str(x)) if "/" not in str(x) else str(x)


def element(values: list[str]) -> dict[str, Any]:
    den, (row,) = rational_rows([[Fraction(x) for x in values]])
    return {"den": den, "row": list(row)}


def test_the_spelling_of_number_fields_says_the_same_in_degree_one() -> None:
    seen = set()
    for data in (*true_ones(), *both(3, -1, 1), *both(1, 1, 6)):
        other = respelt(data)
        if other is not None:
            assert establish_order(*other).method == data["method"]
            seen.add((other[0], other[3]))
    refuted = {("equivalent-over-integers", "refuted"), ("isomorphic-over-integers", "refuted")}
    assert seen == {(word, "proved") for word in OTHER.values()} | refuted


def test_a_degenerate_algebra_has_no_orders_over_any_base() -> None:
    for data in genuine("QQ(sqrt(5))"):
        for algebra in ("(0,-1|QQ(sqrt(5)))", "(-1,0|QQ(sqrt(5)))", "[-1,-1,2|QQ(sqrt(5)))"):
            rejects({**data, "algebra": algebra}, "degenerate")


def test_rows_of_four_are_multiplied_as_others_are() -> None:
    rng = random.Random(5)
    for width in (1, 4, 16):
        matrix = [[rng.randint(-(10**9), 10**9) for _ in range(width)] for _ in range(4)]
        rows = [[rng.randint(-9, 9) for _ in range(4)] for _ in range(3)]
        assert times(rows, matrix) == times_any(rows, matrix)
        assert fmpz_mat(rows) * fmpz_mat(matrix) == fmpz_mat([list(x) for x in times(rows, matrix)])


def test_matrices_of_one_column() -> None:
    assert hermite([[12], [-18], [0]]) == ((6,),)


def test_powers_modulo_a_prime_in_degree_one() -> None:
    for x in (-3, 0, 2, 10):
        power = (1,)
        for e in range(12):
            assert RATIONAL_INTEGERS.power_modulo((x,), e, 7) == (power[0] % 7,)
            power = RATIONAL_INTEGERS.mul(power, (x,))

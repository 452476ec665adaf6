"""Certificates of newforms: true ones are accepted, and forged forms, ideals and fields are not."""

import copy
import random
import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.checker.check import Budget, check
from hfield.checker.glossary import MASS, NEW_FUNCTIONS, NEW_FUNCTIONS_OF_WEIGHT, SIGNS
from hfield.checker.rejection import Rejected
from hfield.orders import newform_certificates
from tests.checker.cases import Certificate
from tests.checker.order_certificates import established, rejects
from tests.orders.hilbert_traces import published
from tests.subcases import first_quick, subcases

GOLDEN = "QQ(sqrt(5))"
CLASS_NUMBER_2 = "(-1,-1|QQ(sqrt(10)))"


@cache
def _certificate(
    algebra: int | str, level: int | str, norm: int, weight: int, signs: bool
) -> Certificate:
    A = QuaternionAlgebra(algebra)
    found = A.eichler_order(level).class_set().claim_of_newforms(weight, norm, signs).certificate
    assert found is not None
    return found


def certificate(
    algebra: int | str, level: int | str = 1, norm: int = 5, weight: int = 2, signs: bool = False
) -> Certificate:
    """A copy of a certificate, which may be forged."""
    return copy.deepcopy(_certificate(algebra, level, norm, weight, signs))


def orbits_of(data: Certificate) -> str:
    return str(data["statement"]).split(";")[3].strip(" }")


def restated(data: Certificate, text: str, place: int = 3) -> Certificate:
    """The same evidence for other orbits, or another part of the statement."""
    parts = data["statement"].rstrip("}").split("; ")
    parts[place] = text
    return {**data, "statement": "; ".join(parts) + "}"}


@pytest.mark.parametrize(
    ("algebra", "level", "norm", "orbits"),
    first_quick(
        [
            (11, 1, 7, "QQ: -2,-1,1,-2"),
            (2, 1, 3, "none"),
            (43, 1, 5, "QQ: -2,-2,-4 | QQ[s]/(s^2-2): s,-s,2-s"),
            (11, 3, 7, "QQ: 1,-2,4"),  # with oldforms of level 11
            (3, 16, 11, "QQ: -2,0,-4"),  # at a level with squares
            (
                2,
                45,
                11,
                "QQ: 2,6,-4,-6 | QQ: 2,-6,-4,6 | QQ: -4,0,2,-6",
            ),  # a combination tells them apart
            (f"(-1,-1|{GOLDEN})", "6 + sqrt(5)", 9, "QQ: -3,-2,2"),  # of norm 31
            ("(-1,-1|QQ(sqrt(3)))", "5", 3, "QQ[s]/(s^4-5*s^2+2): 4*s-s^3,-5*s+s^3"),
        ],
        7,
    ),
)
def test_true_ones(algebra: int | str, level: int | str, norm: int, orbits: str) -> None:
    data = certificate(algebra, level, norm)
    found = established(data)
    assert orbits_of(data) == orbits
    assert found.verdict == "proved"
    assert not found.assumptions
    assert NEW_FUNCTIONS in found.theorems


def test_orbits_of_level_389() -> None:
    """The polynomial of degree 20 is irreducible modulo none of the first primes."""
    data = certificate(389, norm=2)
    assert ["s^20" in field for field in orbits_of(data).split("|")] == [False] * 4 + [True]
    assert established(data).theorems == (MASS, NEW_FUNCTIONS)


def test_where_there_is_none() -> None:
    for field in (GOLDEN, "QQ[s]/(s-1)"):  # a field of degree 1 is not QQ by its data
        C = QuaternionAlgebra(field, -1, -1).maximal_order().class_set()
        reason = C.claim_of_newforms(weight=6, norm=5).why_no_certificate
        assert reason == "the checker knows newforms of weights above 2 over QQ only"
    P = QuaternionAlgebra.from_text("[1,t^3+t+1|GF(2)(t))").eichler_order("t").class_set()
    assert "over number fields" in str(P.claim_of_newforms(norm=5).why_no_certificate)


def test_orbits_of_large_degree_have_no_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(newform_certificates, "MAX_DEGREE", 1)
    C = QuaternionAlgebra(23).maximal_order().class_set()
    claim = C.claim_of_newforms(norm=5)
    assert "an orbit has 2 newforms" in str(claim.why_no_certificate)


# --- weights above 2 ------------------------------------------------------------------------------------


def eta_product(exponents: dict[int, int], size: int) -> list[int]:
    """The coefficients of q, q², … in ∏ η(d·z)^r, where Σ d·r = 24."""
    found = [1] + [0] * size
    for d, r in exponents.items():
        for n in range(d, size + 1, d):
            for _ in range(r):
                for k in range(size, n - 1, -1):
                    found[k] -= found[k - n]
    return found[:size]


@pytest.mark.parametrize(
    ("discriminant", "level", "weight", "exponents"),
    [
        (5, 1, 4, {1: 4, 5: 4}),
        (2, 3, 4, {1: 2, 2: 2, 3: 2, 6: 2}),
        (3, 1, 6, {1: 6, 3: 6}),
        (2, 1, 8, {1: 8, 2: 8}),
    ],
)
def test_products_of_eta_functions(
    discriminant: int, level: int, weight: int, exponents: dict[int, int]
) -> None:
    """Each is the only newform of its level and weight."""
    data = certificate(discriminant, level, 13, weight)
    expected = eta_product(exponents, 13)
    primes = [p for p in (2, 3, 5, 7, 11, 13) if discriminant * level % p]
    assert orbits_of(data) == "QQ: " + ",".join(str(expected[p - 1]) for p in primes)
    assert established(data).theorems == (MASS, NEW_FUNCTIONS_OF_WEIGHT)


@subcases(
    "algebra, level, weight, orbits",
    [
        (11, 1, 4, "QQ[s]/(s^2-3): 1+s,-1-4*s,1+8*s"),  # 11.4.a.a, where s is √3
        (2, 9, 4, "QQ: -6"),  # where T_5 has this eigenvalue once
        (13, 1, 4, "QQ: -5,-7,-7 | QQ[s]/(s^2-s-4): 1-s,1+3*s,-1-s"),
        ("[-3,-2/5|QQ)", 1, 8, "QQ: 12,-210"),  # where i² = −3 + i
    ],
)
def test_other_weights(algebra: int | str, level: int, weight: int, orbits: str) -> None:
    data = certificate(algebra, level, 5, weight)
    assert orbits_of(data) == orbits
    assert established(data).verdict == "proved"


def test_forged_values() -> None:
    """Values that units change, that are not new, and those of other weights."""
    data = certificate(2, 3, 7, 4)  # one class, with twelve units modulo ±1
    data["evidence"]["orbits"][0]["vector"][0][0] += 1
    rejects(data, "unit of a left order changes")
    data = certificate(7, 3, 5, 4)
    data["evidence"]["orbits"].pop()
    rejects(restated(data, orbits_of(data).rpartition(" | ")[0]), "add up")
    data = certificate(11, weight=4)
    for text in ("6", "2", "5", "0", "102"):
        rejects({**data, "statement": data["statement"].replace("; 4; 2,", f"; {text}; 2,")})
    rejects({**data, "assumes": [MASS, NEW_FUNCTIONS]}, "assumes")
    vector = data["evidence"]["orbits"][0]["vector"]
    for change in ([[0] * 6] * 2, [*vector, vector[0]], [row[:5] for row in vector]):
        data["evidence"]["orbits"][0]["vector"] = change
        rejects(data)


# --- fields of class number 2 -----------------------------------------------------------------------------


def test_a_field_of_class_number_2() -> None:
    """The traces are published ones (tests/orders/hilbert_traces.py): of T at (2), (3) and (5)."""
    data = certificate(CLASS_NUMBER_2)
    assert orbits_of(data) == "QQ[s]/(s^2-2): s,-s,-s,2*s"  # at P², P·P′, P², where s is √2
    traces = [2 * (2 - 2), 2 * 2, 2 * (8 - 5)]
    assert [published()[40][1, 2][n - 1] for n in (2, 3, 5)] == traces
    assert established(data).verdict == "proved"


def test_functions_with_another_character() -> None:
    """Without ideals of the field there are more functions, and eigenvectors that these ideals change."""
    data = certificate(CLASS_NUMBER_2)
    (table,) = data["evidence"]["central"]
    classes = len(table)
    for change in (
        [],
        [table[:-1]],
        [[table[1], table[0], *table[2:]]],
        [[[i, {"den": 1, "row": [1] + [0] * 7}] for i in range(classes)]],
    ):
        data["evidence"]["central"] = change
        rejects(data)
    del data["evidence"]["central"]
    rejects(data, "class group")
    data = certificate(f"(-1,-1|{GOLDEN})", "6 + sqrt(5)", 5)
    data["evidence"]["central"] = [data["evidence"]["neighbours"][0][0][1]]
    rejects(data, "class group")


# --- signs ----------------------------------------------------------------------------------------------


@subcases(
    "algebra, level, weight, signs",
    [
        # of PARI's mfatkineigenvalues, also at squares
        (2, 27, 6, "2,3; 1,-1 | 1,1 | 1,-1 | -1,-1 | -1,1 | -1,1"),
        (2, 1, 2, "2; none"),
        # a_P = −w at a prime of the level
        (f"(-1,-1|{GOLDEN})", "6 + sqrt(5)", 2, "(31, sqrt(5)-25); 1"),
    ],
)
def test_signs(algebra: int | str, level: int | str, weight: int, signs: str) -> None:
    data = certificate(algebra, level, 5, weight, signs=True)
    assert data["statement"].endswith(f"; {signs}}}")
    assert SIGNS in established(data).theorems


def test_forged_signs() -> None:
    data = certificate(2, 9, 5, 4, signs=True)
    assert data["statement"].endswith("; QQ: -6; 2,3; -1,-1}")
    for signs in ("1,-1", "-1,1", "-1", "-1,-1,-1", "-1,0", "-1,-1 | -1,-1", "none"):
        rejects(restated(data, signs, 5))
    for primes in ("3,2,5", "2,5", "2", "none"):
        rejects(restated(data, primes, 4))
    whole = data["statement"].split("; ")
    rejects({**data, "statement": "; ".join(whole[:4]) + "}"}, "together")
    rejects({**data, "statement": "; ".join(whole[:5]) + "}"}, "5 parts")
    rejects({**data, "assumes": data["assumes"][:-1]}, "assumes")
    two, three = data["evidence"]["signs"]
    for change in (
        [two],
        [three, two],
        [two, {**three, "images": []}],
        [two, {**three, "images": three["images"] * 2}],
        [two, {**three, "images": two["images"]}],
        [two, {**three, "ideal": two["ideal"]}],
    ):
        data["evidence"]["signs"] = change
        rejects(data)


def test_the_multiple_of_a_prime_is_not_its_two_sided_ideal() -> None:
    """3·O has the norm of the two-sided ideal at 3 of level 9; with it the sign there would be 1."""
    data = certificate(2, 9, 5, 4, signs=True)
    rows = data["statement"].partition("{")[2].partition(";")[0].split(" | ")
    ideal = {"den": 4, "rows": [[int(12 * Fraction(x)) for x in row.split(",")] for row in rows]}
    images = [[i, [i, ["3", "0", "0", "0"]]] for i, _ in data["evidence"]["signs"][1]["images"]]
    data["evidence"]["signs"][1] = {"ideal": ideal, "images": images}
    rejects(restated(data, "-1,1", 5), "multiple of the prime")


# --- a change at any place -------------------------------------------------------------------------------


def places(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """The paths to all numbers of some evidence."""
    entries = value.items() if isinstance(value, dict) else enumerate(value)
    for key, entry in entries:
        if isinstance(entry, dict | list):
            yield from places(entry, (*path, key))
        elif isinstance(entry, int) or entry.lstrip("-").replace("/", "").isdigit():
            yield (*path, key)


def with_another_number(data: Certificate, path: tuple[str | int, ...]) -> Certificate:
    """A copy in which the number at a place is larger by 1."""
    forged = copy.deepcopy(data)
    inner: Any = forged["evidence"]
    for key in path[:-1]:
        inner = inner[key]
    x = inner[path[-1]]
    inner[path[-1]] = x + 1 if isinstance(x, int) else str(Fraction(x) + 1)
    return forged


Kind = tuple[int | str, int | str, int, int, bool]
CERTIFIED: Kind = (7, 3, 5, 4, True)


def check_changes(kind: Kind, each: int) -> None:
    """Change so many numbers of each field of a certificate, one at a time."""
    data = certificate(*kind)
    fields: dict[tuple[str, ...], list[tuple[str | int, ...]]] = {}
    for path in places(data["evidence"]):
        if path[0] != "operator":  # another combination is as good
            fields.setdefault(tuple(k for k in path if isinstance(k, str)), []).append(path)
    assert len(fields) > 6
    rng = random.Random(1)
    for paths in fields.values():
        for path in rng.sample(paths, min(each, len(paths))):
            with pytest.raises(Rejected):
                check(with_another_number(data, path))
    orbits = orbits_of(data)
    for m in list(re.finditer(r"\d+", orbits))[:each]:
        rejects(restated(data, orbits[: m.start()] + str(int(m[0]) + 1) + orbits[m.end() :]))


def test_some_numbers_changed() -> None:
    check_changes(CERTIFIED, 2)


@pytest.mark.slow
def test_each_number_changed() -> None:
    check_changes(CERTIFIED, 10**6)


@pytest.mark.slow
def test_some_numbers_changed_over_a_field() -> None:
    check_changes((CLASS_NUMBER_2, 1, 3, 2, False), 2)


# --- eigenvectors and orbits --------------------------------------------------------------------------


def test_another_vector() -> None:
    for number, j, k in ((0, 0, 0), (1, 2, 1), (1, 3, 0)):
        data = certificate(43)
        data["evidence"]["orbits"][number]["vector"][j][k] += 1
        rejects(data, "no eigenvector|no new function")
    data = certificate(43)
    data["evidence"]["orbits"][0]["vector"] = [[0]] * 4
    rejects(data, "not seen")
    for change in ([[1]] * 3, [[1, 0]] * 4, [["1"]] * 4, [[0.5]] * 4):
        data = certificate(43)
        data["evidence"]["orbits"][0]["vector"] = change
        rejects(data)


def test_the_constant_function_is_no_newform() -> None:
    data = certificate(11)
    data["evidence"]["orbits"][0]["vector"] = [[1], [1]]
    rejects(restated(data, "QQ: 3,4,6"), "no new function")


def test_an_orbit_that_comes_often_costs_work_each_time() -> None:
    """Some microseconds for each class in an equation or a row, so four units at least."""
    data = certificate(11, 3, 2)
    evidence, text = data["evidence"], orbits_of(data)
    (orbit,) = evidence["orbits"]
    rows = [row for _, row in evidence["neighbours"][0]]
    rows += [ideals for above in evidence["above"] for ideals in above["ideals"]]
    steps = len(evidence["classes"]) + sum(len({j for j, _ in row}) for row in rows)
    spent = []
    for number in (2, 12):
        evidence["orbits"] = [orbit] * number
        budget = Budget()
        with pytest.raises(Rejected, match="add up"):
            check(restated(data, " | ".join([text] * number)), None, budget)
        spent.append(budget.spent)
    assert spent[1] - spent[0] >= 10 * 4 * steps


def test_two_rational_forms_are_no_orbit_over_a_product_of_fields() -> None:
    """Over ℚ[s]/(s² − s) the vector s·v + (1 − s)·w has the eigenvalues s·a + (1 − s)·b."""
    data = certificate(2, 45, 11)
    first, second, third = data["evidence"]["orbits"]
    both = [[y[0], x[0] - y[0]] for x, y in zip(first["vector"], second["vector"], strict=True)]
    for modulus, name in (([0, -1, 1], "s^2-s"), ([-1, 0, 1], "s^2-1")):
        ring = {"kind": "number field", "modulus": modulus, "variable": "s"}
        data["evidence"]["orbits"] = [{"ring": ring, "vector": both}, third]
        rejects(restated(data, f"QQ[s]/({name}): 2,-6+12*s,-4,6-12*s | QQ: -4,0,2,-6"), "reducible")
    ring = {"kind": "quotient ring", "base": {"kind": "rationals"}, "variable": "s"}
    data["evidence"]["orbits"][0]["ring"] = {**ring, "modulus": ["0", "-1", "1"]}
    rejects(restated(data, "QQ[x]/(x^2-x): 2,-6+12*x,-4,6-12*x | QQ: -4,0,2,-6"))


def test_an_orbit_left_out_and_one_that_comes_twice() -> None:
    data = certificate(43)
    rational, other = data["evidence"]["orbits"]
    first, second = orbits_of(data).split(" | ")
    for orbits, text in (
        ([rational], first),
        ([other], second),
        ([rational] * 3, " | ".join([first] * 3)),
        ([], "none"),
    ):
        data["evidence"]["orbits"] = orbits
        rejects(restated(data, text), "add up|twice")
    rejects(restated(data, first), "for each orbit")


def test_an_orbit_in_the_field_of_another() -> None:
    """The same eigenvector with rational eigenvalues, written over a larger field: a subspace too large."""
    data = certificate(43)
    rational = data["evidence"]["orbits"][0]
    larger = {"kind": "number field", "modulus": [-2, 0, 1], "variable": "s"}
    for a, b in ((1, 0), (0, 1), (1, 1)):
        vector = [[a * x[0], b * x[0]] for x in rational["vector"]]
        data["evidence"]["orbits"] = [{"ring": larger, "vector": vector}, rational]
        rejects(restated(data, "QQ[s]/(s^2-2): -2,-2,-4 | QQ: -2,-2,-4"), "twice")


def test_other_eigenvalues_and_fields() -> None:
    data = certificate(43)
    orbits = orbits_of(data)
    for m in re.finditer(r"\d+", orbits):
        rejects(restated(data, orbits[: m.start()] + str(int(m[0]) + 1) + orbits[m.end() :]))
    for other in (
        orbits.replace("-s", "s"),
        orbits.replace("QQ:", "ZZ:"),
        orbits.replace("s", "t"),
        orbits.replace(":", ""),
        orbits.replace("-4", "-4,1"),
        orbits.replace("QQ: -2", "QQ: s"),
        " | ".join(reversed(orbits.split(" | "))),
    ):
        rejects(restated(data, other))
    front = data["statement"]
    for weight in ("4", "0", "2.0", ""):
        rejects({**data, "statement": front.replace("; 2; 2,3,5;", f"; {weight}; 2,3,5;")})
    for primes in ("2,3,7", "2,3", "2,3,5,7", "2,3,9", "43,3,5", "none", "3,2,5"):
        rejects({**data, "statement": front.replace("; 2; 2,3,5;", f"; 2; {primes};")})


# --- operators ----------------------------------------------------------------------------------------


def test_ideals_that_are_not_all_neighbours() -> None:
    def forged(change: Any) -> None:
        data = certificate(43)
        change(data["evidence"]["neighbours"][0][1][1])  # those of norm 2 in class 1
        rejects(data)

    forged(lambda ideals: ideals.pop())
    forged(lambda ideals: ideals.append(ideals[0]))
    forged(lambda ideals: ideals.__setitem__(0, ideals[1]))
    forged(lambda ideals: ideals[0].__setitem__(0, (ideals[0][0] + 1) % 4))  # in another class
    forged(lambda ideals: ideals[0].__setitem__(0, -1))
    forged(lambda ideals: ideals[0].__setitem__(1, ["0", "0", "0", "0"]))
    forged(lambda ideals: ideals[0].__setitem__(1, [f"2*{x}" for x in ideals[0][1]]))
    forged(lambda ideals: ideals[0].__setitem__(1, ideals[1][1]))
    forged(lambda ideals: ideals[0].append(1))


def test_negative_elements_give_the_same_ideals_and_count_once() -> None:
    data = certificate(43)
    ideals = data["evidence"]["neighbours"][0][0][1]
    j, c = ideals[0]
    negative = [x.removeprefix("-") if x.startswith("-") or x == "0" else f"-{x}" for x in c]
    ideals[0] = [j, negative]
    assert established(data).verdict == "proved"
    ideals[1] = [j, c]
    rejects(data, "different ideals")


def test_rows_of_operators() -> None:
    for change in (
        lambda e: e["neighbours"][0].pop(),  # T_2, which tells the forms apart
        lambda e: e["neighbours"].pop(),
        lambda e: e["neighbours"][1].clear(),
        lambda e: e["neighbours"][0].append(e["neighbours"][0][0]),
        lambda e: e["neighbours"][0][0].__setitem__(0, 1),
        lambda e: e.update(operator=[0, 0, 0]),
        lambda e: e.update(operator=[0, 1, 0]),
        lambda e: e.update(operator=[1, 0]),
        lambda e: e.update(modulus=10**9),
        lambda e: e.update(modulus=2**127 - 1),
        lambda e: e.update(modulus=2),
    ):
        data = certificate(43)
        change(data["evidence"])
        rejects(data)


def test_an_operator_with_an_eigenvalue_twice() -> None:
    data = certificate(2, 45, 11)
    data["evidence"]["operator"] = [1, 0, 0, 0]
    rejects(data, "twice")


def test_a_prime_ideal_is_not_its_conjugate() -> None:
    data = certificate("(-1,-1|QQ(sqrt(5)))", "6 + sqrt(5)", 11)
    one, other = re.findall(r"\(11, [^|;]*\)", data["statement"])
    swapped = data["statement"].replace(one, "@").replace(other, one).replace("@", other)
    rejects({**data, "statement": swapped}, "another norm|does not lie")
    for text in (
        "(11, 2)",
        "11",
        "(11, 0)",
        "(0, sqrt(5))",
        "(4, sqrt(5))",
        "(7, sqrt(5))",
        "(31, sqrt(5)-25)",
    ):
        rejects({**data, "statement": data["statement"].replace(one, text)})


# --- oldforms -----------------------------------------------------------------------------------------


def test_an_oldform_is_not_called_new() -> None:
    """Level 33 has two old functions with the eigenvalues of level 11."""
    from flint import fmpz_mat

    data = certificate(11, 3)
    C = QuaternionAlgebra(11).eichler_order(3).class_set()
    T = fmpz_mat(C.brandt_matrix(2))
    shifted = T + 2 * fmpz_mat([[int(i == j) for j in range(4)] for i in range(4)])
    kernel, rank = shifted.nullspace()
    assert rank == 2
    old = [[int(kernel[i, 0])] for i in range(4)]
    evidence, new = data["evidence"], data["evidence"]["orbits"][0]
    ring = {"kind": "rationals"}
    stated = restated(data, "QQ: -2,1 | QQ: 1,-2")
    evidence["orbits"] = [{"ring": ring, "vector": old}, new]
    rejects(stated, "no new function|no eigenvector")
    for above in ([], evidence["above"][:1], [evidence["above"][0]] * 2):
        evidence["above"] = above
        rejects(stated)
        evidence["orbits"] = [new]
        rejects(data, "two orders above")
        evidence["orbits"] = [{"ring": ring, "vector": old}, new]


def test_orders_above_and_their_ideals() -> None:
    for change in (
        lambda e: e["above"].append(e["above"][0]),
        lambda e: e["above"][0].update(order=e["above"][1]["order"]),
        lambda e: e["above"][0]["order"]["rows"][0].__setitem__(0, 7),
        lambda e: e["above"][0]["order"].update(den=e["above"][0]["order"]["den"] * 3),
        lambda e: e["above"][0]["ideals"].pop(),
        lambda e: e["above"][0]["ideals"][0].pop(),
        lambda e: e["above"][0]["ideals"][0].__setitem__(0, e["above"][0]["ideals"][0][1]),
        lambda e: e["above"][0]["ideals"].clear(),
        lambda e: e["above"][0].update(ideals=e["above"][1]["ideals"]),
        lambda e: e["above"].append({"order": e["classes"][0], "ideals": []}),
    ):
        data = certificate(11, 3)
        change(data["evidence"])
        rejects(data)


def test_an_order_that_is_no_eichler_order() -> None:
    """ℤ + 2·O has class sets, and no newforms."""
    A = QuaternionAlgebra(3)
    order = A.order([A(1), *(2 * x for x in A.maximal_order().basis[1:])])
    classes = order.class_set().claim
    data = certificate(3, norm=5)
    evidence = {**data["evidence"], "classes": classes.evidence["classes"]}
    whole = classes.statement.partition("{")[2].rpartition(";")[0]
    rejects(
        {**data, "statement": f"newforms{{{whole}; 2; 5; none}}", "evidence": evidence},
        "Eichler order",
    )


def test_theorems_and_verdicts() -> None:
    data = certificate(11)
    for assumes in ([], [MASS], [NEW_FUNCTIONS]):
        rejects({**data, "assumes": assumes}, "assumes")
    rejects({**data, "verdict": "refuted"})
    rejects({**data, "method": "mass"})
    for key in data["evidence"]:
        rejects({**data, "evidence": {k: v for k, v in data["evidence"].items() if k != key}})

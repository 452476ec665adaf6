"""Groups of units, classes and automorphisms: by brute force, and by GAP where it is installed."""

import json
import shutil
import subprocess
from collections import Counter
from itertools import product
from math import lcm

import numpy as np
import pytest

from hfield import GF, QQ, H, QuaternionAlgebra
from hfield.algebra.structure.counting.tally import MIN_COMPILED
from hfield.errors import NotFiniteError, RingError, TooLargeError
from hfield.exploring.finite_groups import FiniteGroup
from hfield.exploring.group_names import MAX_ORDER, group_invariants, joined
from hfield.exploring.labels import labelled
from hfield.exploring.unit_groups import LinearGroup, ListedUnitGroup
from tests.exploring.brute_force import CASES, BruteForce, Case, cases_of
from tests.patience import PATIENCE
from tests.subcases import slow
from tests.thorough import part


def order_in(brute: BruteForce, x: int) -> int:
    n, power = 1, x
    while power != brute.one:
        n, power = n + 1, int(brute.table[power, x])
    return n


def closure(brute: BruteForce, generators: list[int]) -> set[int]:
    found, queue = {brute.one}, [brute.one]
    while queue:
        x = queue.pop()
        for g in generators:
            y = int(brute.table[x, g])
            if y not in found:
                found.add(y)
                queue.append(y)
    return found


@pytest.mark.parametrize("case", cases_of(CASES), ids=str)
def test_groups_by_brute_force(case: Case) -> None:
    A, brute = case.algebra, BruteForce(case)
    everything = list(A.elements())
    number = {q: n for n, q in enumerate(everything)}
    units = sorted(brute.inverses)
    special = [x for x in units if everything[x].norm() == 1]
    for G, members in ((A.unit_group(), units), (A.special_unit_group(), special)):
        assert G.order == len(G) == len(members)
        assert sorted(number[q] for q in G) == members
        assert all((q in G) == (n in set(members)) for n, q in enumerate(everything))
        orders = Counter(order_in(brute, x) for x in members)
        assert G.element_orders == dict(sorted(orders.items()))
        assert G.exponent == lcm(*orders)
        table = brute.table[np.ix_(members, members)]
        central = {
            x
            for x, left, right in zip(members, table, table.T, strict=True)
            if (left == right).all()
        }
        assert {number[q] for q in G.center} == central
        assert G.center.order == len(central)
        assert closure(brute, [number[q] for q in G.generators]) == set(members)
        assert G.is_abelian() == (len(central) == len(members))
        check_classes(G.conjugacy_classes, brute.conjugate_classes(members, members), number)
    check_classes(
        A.conjugacy_classes(), brute.conjugate_classes(units, range(len(everything))), number
    )


def check_classes(found, expected: set[frozenset[int]], number: dict) -> None:
    assert {frozenset(number[q] for q in c) for c in found} == expected
    assert sum(map(len, found)) == sum(map(len, expected))
    for c in found:
        assert c.representative in c
        assert c.minimal_polynomial == c.representative.minimal_polynomial()
        assert len(c) == len(list(c))


SMALL = [
    c for c in CASES if c.ring == "GF(2)" or (c.ring == "GF(3)" and (c.a, c.t, c.b) != (0, 0, 0))
]


@pytest.mark.parametrize("case", [*SMALL[:6], *map(slow, SMALL[6:])], ids=str)
def test_automorphisms_by_brute_force(case: Case) -> None:
    A = case.algebra
    everything = list(A.elements())
    a, t, b = A.constants.a, A.constants.t, A.constants.b
    found = set()
    first = [x for x in everything if x * x == x * t + a]
    second = [y for y in everything if y * y == b]
    for x, y in product(first, second):
        if y * x == y * t - x * y:
            images = [A.one, x, y, x * y]
            spanned = {
                sum((q * s for q, s in zip(images, scalars, strict=True)), A.zero)
                for scalars in product(A.ring.elements(), repeat=4)
            }
            if len(spanned) == len(everything):
                found.add((x, y))
    G = A.automorphism_group()
    assert G.order == len(G) == len(found)
    if not A.is_central_simple():
        assert {f.images[1:3] for f in G} == found
    reached = {A.basis[1:3]}
    queue = list(reached)
    while queue:
        x, y = queue.pop()
        for f in G.generators:
            if (image := (f(x), f(y))) not in reached:
                reached.add(image)
                queue.append(image)
    assert reached == found


@pytest.mark.parametrize("ring", ["GF(7)", "GF(8)", "GF(9)"])
def test_linear_groups_against_listing(ring: str) -> None:
    A = H(ring) if ring != "GF(8)" else QuaternionAlgebra(ring, 1, 1, 1)
    G = A.special_unit_group()
    assert isinstance(G, LinearGroup)
    listed = ListedUnitGroup(A, "listed", G.elements)
    assert G.element_orders == listed.element_orders
    assert sorted(map(len, G.conjugacy_classes)) == sorted(map(len, listed.conjugacy_classes))
    for c in G.conjugacy_classes:
        same = next(other for other in listed.conjugacy_classes if c.representative in other)
        assert all(q in same for q in list(same)[:20])
        assert all((q in c) == (q in same) for q in list(listed)[:300])
    generated = listed._group.generated(
        [
            int(np.searchsorted(listed._group.members, listed._labels.number(q)))
            for q in G.generators
        ]
    )
    assert generated.all()


@pytest.mark.parametrize(
    ("algebra", "units", "special", "automorphisms"),
    [
        (H(GF(3)), "GL(2,3)", "SL(2,3)", "PGL(2,3)"),
        (H("ZZ/9"), "GL(2,Z/9)", "SL(2,Z/9)", "PGL(2,Z/9)"),
        slow(H("ZZ/15"), "GL(2,3) x GL(2,5)", "SL(2,3) x SL(2,5)", "PGL(2,3) x PGL(2,5)"),
        (H("ZZ/6"), "C2 x C2 x C2 x GL(2,3)", "C2 x C2 x C2 x SL(2,3)", "S4 x PGL(2,3)"),
        (
            QuaternionAlgebra("GF(3)", -1, 0),
            "(C3 x C3) : C8",
            "(C3 x C3) : C4",
            "((C3 x C3) : C8) : C2",
        ),
    ],
    ids=str,
)
def test_names(algebra, units: str, special: str, automorphisms: str) -> None:
    assert algebra.unit_group().structure == units
    assert algebra.special_unit_group().structure == special
    assert algebra.automorphism_group().structure == automorphisms


@pytest.mark.slow
def test_groups_without_a_name_have_invariants() -> None:
    H16 = H("ZZ/16").special_unit_group()
    assert H16.order > MAX_ORDER
    assert H16.structure == str(H16.invariants)
    assert H16.structure.startswith(f"order {H16.order}, exponent {H16.exponent}, centre C")


@pytest.mark.parametrize(
    "algebra",
    [
        H("GF(3)"),
        H("GF(5)"),
        QuaternionAlgebra("GF(2)", 1, 1, 1),
        QuaternionAlgebra("GF(4)", 1, 1, 1),
    ],
    ids=str,
)
def test_invariants_of_linear_groups_against_listing(algebra) -> None:
    for G in (algebra.unit_group(), algebra.special_unit_group()):
        assert (
            group_invariants(ListedUnitGroup(algebra, "listed", G.elements)._group) == G.invariants
        )


@pytest.mark.slow
def test_invariants_of_products() -> None:
    G = H("ZZ/6").unit_group()
    listed = FiniteGroup(G._group.members, G._labels.products, G._labels.number(G.algebra.one))
    assert G.invariants == group_invariants(listed)
    automorphisms = H("ZZ/6").automorphism_group().invariants
    assert automorphisms.derived_series == (576, 144, 16, 1)


@pytest.mark.slow
def test_invariants_against_gap() -> None:
    groups = [H("ZZ/4").unit_group(), QuaternionAlgebra("GF(3)", -1, 0).unit_group()]
    groups += [QuaternionAlgebra("GF(3)", 0, 0).unit_group(), H("GF(4)").unit_group()]
    numbers = (
        "(g -> [[Order(g), Exponent(g)], AbelianInvariants(Centre(g)), AbelianInvariants(g), "
        "List(DerivedSeriesOfGroup(g), Order)])"
    )
    answers = gap(*(f"{numbers}(Image(IsomorphismPermGroup({G.text_for('gap')})))" for G in groups))
    for G, answer in zip(groups, answers, strict=True):
        numbers, center, quotient, series = json.loads(answer)
        found = G.invariants
        assert [found.order, found.exponent] == numbers
        assert found.center == joined([f"C{n}" for n in center])
        assert found.abelian_quotient == joined([f"C{n}" for n in quotient])
        assert list(found.derived_series) == series


def test_large_linear_groups_are_known_by_formulas() -> None:
    G = H(GF(31)).unit_group()
    assert sum(G.element_orders.values()) == G.order == 892_800
    assert len(G.conjugacy_classes) == 31**2 - 1
    assert sum(map(len, G.conjugacy_classes)) == G.order
    assert sum(map(len, H(GF(31)).conjugacy_classes())) == 31**4


@pytest.mark.slow
def test_large_groups_that_are_listed() -> None:
    # of more elements than make compiled loops pay
    A = QuaternionAlgebra("GF(19)", 2, 0)  # modulo its radical the field of 361 elements
    labels = labelled(A)
    assert labels.size >= MIN_COMPILED
    everything = np.arange(labels.size)
    elements = [A.random_element(n) for n in range(40)]
    units = [q for q in elements if q.is_unit()]
    for u in units:
        one = np.array([labels.number(u)])
        left, right = labels.products(one, everything), labels.products(everything, one)
        permutation = labels.conjugation(u)
        for q in elements:
            n = labels.number(q)
            assert labels.element(left[n]) == u * q
            assert labels.element(right[n]) == q * u
            assert labels.element(permutation[n]) == u * q * u.inverse()
    G = A.unit_group()
    assert G is A.unit_group()
    assert G.order == 360 * 361
    assert sum(G.element_orders.values()) == G.order == sum(map(len, G.conjugacy_classes))
    assert G._group.generated(G._group.generators).all()
    for u in units:
        order = int(G._group.orders[np.searchsorted(G._group.members, labels.number(u))])
        assert u**order == 1
        assert all(u ** (order // p) != 1 for p in (2, 3, 5, 19) if order % p == 0)


def test_what_is_refused() -> None:
    for name in ("unit_group", "special_unit_group", "conjugacy_classes", "automorphism_group"):
        with pytest.raises(NotFiniteError):
            getattr(H(QQ), name)()
    with pytest.raises(TooLargeError):
        _ = H("ZZ/64").unit_group().structure
    with pytest.raises(TooLargeError):
        H("ZZ/60").conjugacy_classes()
    assert H("ZZ/60").unit_group().order == H("ZZ/60").count("units")
    with pytest.raises(RingError, match="'gap'"):
        H(GF(3)).unit_group().text_for("magma")
    with pytest.raises(RingError, match="Conway"):
        H("GF(9, x^2+1)").unit_group().text_for("gap")


def gap(*lines: str) -> list[str]:
    if shutil.which("gap") is None:
        pytest.skip("GAP is not installed")
    program = "SizeScreen([4000, 100]);;\n" + "\n".join(f'Print({line}, "\\n");' for line in lines)
    done = subprocess.run(
        ["gap", "-q"], input=program, capture_output=True, text=True, timeout=PATIENCE, check=True
    )
    return done.stdout.split("\n")[: len(lines)]


# H over GF(q), q ≤ 5, and degenerate algebras. Of order 64 and above, 2-groups may be written in another way.
OF_GAP = [H(GF(q)) for q in (2, 3, 4, 5)]
OF_GAP += [QuaternionAlgebra("GF(3)", *ab) for ab in ((0, 0), (-1, 0), (1, 0))]
OF_GAP += [
    QuaternionAlgebra("GF(2)", 1, 1, 1),
    QuaternionAlgebra("GF(4)", 1, 0, 1),
]


@pytest.mark.slow
def test_groups_against_gap() -> None:
    groups = [G for A in part(OF_GAP, 2) for G in (A.unit_group(), A.special_unit_group())]
    numbers = "(g -> [Order(g), NrConjugacyClasses(g), Exponent(g), Order(Centre(g))])"
    answers = gap(*(f"{numbers}(Image(IsomorphismPermGroup({G.text_for('gap')})))" for G in groups))
    for G, answer in zip(groups, answers, strict=True):
        assert [G.order, len(G.conjugacy_classes), G.exponent, G.center.order] == json.loads(
            answer
        ), G


@pytest.mark.slow
def test_structures_against_gap() -> None:
    groups = [
        G for A in OF_GAP if A.ring.is_field for G in (A.unit_group(), A.special_unit_group())
    ]
    structures = gap(*(f"StructureDescription({G.text_for('gap')})" for G in groups))
    if any("Error" in line or not line for line in structures):
        pytest.skip("GAP has no library of small groups")
    equal = {"GL(2,2)": "S3", "SL(2,2)": "S3"}  # GAP prefers these names
    assert [equal.get(G.structure, G.structure) for G in groups] == structures

"""Units of norm 1 of indefinite orders: known curves, words against products, domains against brute force."""

import cmath
import json
import math
import random
from fractions import Fraction
from itertools import product

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.core.factorisation import factorise
from hfield.errors import IndefiniteError, LatticeError, TooLargeError
from hfield.fuchsian import area, dirichlet, group, normaliser, presentation
from hfield.fuchsian.polygon import Polygon
from hfield.orders.lattice import Order
from tests.subcases import first_quick, share_quick, subcases
from tests.thorough import quick_part

# D, N: the area in units of π/3, elliptic points of order 2 and 3, the genus (tables of Shimura curves)
KNOWN = {
    (6, 1): (2, 2, 2, 0), (10, 1): (4, 0, 4, 0), (22, 1): (10, 2, 4, 0), (14, 1): (6, 2, 0, 1),
    (15, 1): (8, 0, 2, 1), (21, 1): (12, 4, 0, 1), (26, 1): (12, 0, 0, 2), (33, 1): (20, 4, 2, 1),
    (34, 1): (16, 0, 4, 1), (35, 1): (24, 0, 0, 3), (39, 1): (24, 0, 0, 3), (46, 1): (22, 2, 4, 1),
}  # fmt: skip
GENUS_ONE = [(6, 5), (6, 7), (6, 13), (10, 3), (10, 7)]
# N: elliptic points of order 2 and 3, cusps, genus of X₀(N) (Diamond and Shurman, chapter 3)
MODULAR = {1: (1, 1, 1, 0), 2: (1, 0, 2, 0), 3: (0, 1, 2, 0), 4: (0, 0, 3, 0), 5: (2, 0, 2, 0),
           7: (0, 2, 2, 0), 9: (0, 0, 4, 0),
           11: (0, 0, 2, 1), 12: (0, 0, 6, 0), 13: (2, 2, 2, 0)}  # fmt: skip


def order(D: int, N: int = 1) -> Order:
    if D == 1:
        return QuaternionAlgebra("QQ", 1, 1).eichler_order(N)
    return QuaternionAlgebra.from_ramification("QQ", list(factorise(D))).eichler_order(N)


def checked(O: Order) -> None:
    """The presentation and the domain hold what they say, multiplied out."""
    G = O.norm_one_group()
    genus, orders, cusps = G.signature
    assert G.area == 2 * genus - 2 + sum(1 - Fraction(1, m) for m in orders) + cusps
    assert all(g in O and g.norm() == 1 for g in G.generators)
    assert all(G.evaluate(r) in (1, -1) for r in G.relations)
    # the abelian quotient of 2g + … generators with the one long relation, written down from the signature
    k, e = 2 * genus, len(orders)
    n = k + e + cusps
    rows = [tuple([k + m + 1] * orders[m]) for m in range(e)] + [tuple(range(k + 1, n + 1))]
    assert G.abelian_invariants == presentation.abelian_invariants(n, rows)
    D = G.domain()
    for n, side in enumerate(D.sides):
        other = D.sides[side.partner]
        assert other.partner == n
        assert side.element * other.element in (1, -1)
        # numerically: the ends go to the ends of the partner, the other way round
        mapped = [image(D, side.element, D.vertices[(n + m) % len(D.sides)]) for m in (1, 0)]
        there = [D.vertices[(side.partner + m) % len(D.sides)] for m in (0, 1)]
        assert mapped == pytest.approx(there, abs=1e-6)
    angles = sum(interior(D, n) for n in range(len(D.sides)))
    assert (len(D.sides) - 2) * math.pi - angles == pytest.approx(2 * math.pi * float(G.area))


def image(D, g, z: complex) -> complex:
    """Where an element maps a point of the disc, by its matrix in floats."""
    plane = D.polygon.plane
    m = [list(map(plane.order.real, row)) for row in plane.motion(g)]
    a, b = plane.stretch
    w = 2 * z / (1 + abs(z) ** 2)
    v = (1.0, w.real / a, w.imag / b)
    x, y, t = (sum(p * q for p, q in zip(row, v, strict=True)) for row in m)
    k = complex(y * a / x, t * b / x)
    return k / (1 + math.sqrt(max(0.0, 1 - abs(k) ** 2)))


def interior(D, n: int) -> float:
    """The angle at a vertex, between the directions to its neighbours."""
    z = D.vertices[n]
    if abs(z) > 1 - 1e-9:
        return 0.0
    before, after = D.vertices[n - 1], D.vertices[(n + 1) % len(D.vertices)]

    def seen(w: complex) -> complex:
        return (w - z) / (1 - z.conjugate() * w)

    return cmath.phase(seen(before) / seen(after)) % (2 * math.pi)


@pytest.mark.slow
@subcases(("D", "N"), KNOWN)
def test_shimura_curves(D: int, N: int) -> None:
    size, two, three, genus = KNOWN[D, N]
    G = order(D, N).norm_one_group()
    assert G.area == Fraction(size, 6)
    assert G.signature == (genus, (2,) * two + (3,) * three, 0)
    checked(order(D, N))


# a field, the places that ramify (real ones by number, finite ones by primes), the area, elliptic points:
# triangle groups of K. Takeuchi's list (*J. Fac. Sci. Tokyo* 24, 1977), and others
OVER_FIELDS = [
    ("QQ[s]/(s^3+s^2-2*s-1)", [0, 1], None, "1/42", (2, 3, 7)),
    ("QQ[s]/(s^3-3*s-1)", [1, 2], None, "1/18", (2, 3, 9)),
    ("QQ(sqrt(5))", [0], 2, "1/10", (2, 5, 5)),
    ("QQ(sqrt(2))", [1], 2, "1/12", (3, 3, 4)),
    ("QQ(sqrt(3))", [0], 2, "1/6", (3, 3, 6)),
    ("QQ[s]/(s^2-s-3)", [0], 3, "1/3", (2, 2, 3, 3)),
]


def over_field(field: str, real: list[int], *primes: int | None):
    K = ring(field)
    places = [K.real_places()[n] for n in real] + [K.primes_above(p)[0] for p in primes if p]
    return QuaternionAlgebra.from_ramification(K, places)


@pytest.mark.parametrize(("field", "real", "p", "area", "orders"), OVER_FIELDS)
def test_groups_over_totally_real_fields(field, real, p, area, orders) -> None:
    O = over_field(field, real, p).maximal_order()
    G = O.norm_one_group()
    assert G.area == Fraction(area)
    assert G.signature == (0, orders, 0)
    checked(O)
    x = G.evaluate((1, 2, -1, 2, 1, 1))
    assert G.evaluate(G.word(x)) in (x, -x)
    assert G.word(-1) == ()
    with pytest.raises(LatticeError, match="not a unit of norm 1"):
        G.word(2)


def test_eichler_orders_over_a_field() -> None:
    A = over_field("QQ(sqrt(5))", [0], 2)
    for p, q in ((11, 11), (5, 5), (3, 9)):
        O = A.eichler_order(A.ring.primes_above(p)[0])
        assert O.norm_one_group().area == Fraction(q + 1, 10)
        checked(O)


# the plane modulo the whole normaliser (Takeuchi; Elkies, ANTS III, 1998; X₀(11)⁺, X₀(37)⁺)
STARS = {
    (6, 1): (0, (2, 4, 6), 0), (10, 1): (0, (2, 2, 2, 3), 0), (14, 1): (0, (2, 2, 2, 4), 0),
    (15, 1): (0, (2, 2, 2, 6), 0), (1, 11): (0, (2, 2, 2, 2), 1), (1, 37): (1, (2, 2, 2, 3), 1),
}  # fmt: skip


@pytest.mark.parametrize(("D", "N"), STARS)
def test_modulo_the_normaliser(D: int, N: int) -> None:
    O = order(D, N)
    star = O.norm_one_group().quotient()
    assert star.signature == STARS[D, N]
    for m, w in star.elements.items():
        assert w.norm() == m
        assert O.left_ideal([w]) == O.right_ideal([w])


def test_some_involutions(monkeypatch: pytest.MonkeyPatch) -> None:
    G = order(6).norm_one_group()
    found = {m: G.quotient(m).signature.orders for m in (2, 3, 6)}
    assert found == {2: (3, 4, 4), 3: (2, 6, 6), 6: (2, 2, 2, 3)}  # of index 2 in (2, 4, 6)
    assert len(G.quotient(2, 3).elements) == len(G.quotient(2, 3, 6).elements) == 4
    for m in (4, 5, 0):
        with pytest.raises(LatticeError, match=r"exact divisor|not a positive integer"):
            G.quotient(m)
    monkeypatch.setattr(normaliser, "MAX_COORDINATES", 8)
    assert len(G.quotient(2).elements) == 2
    with pytest.raises(TooLargeError, match="up to 2 are within reach"):
        G.quotient()


# the same over fields: maximal groups in the commensurability classes of Takeuchi's triangle groups, and two
# fields with ideals that are not principal, where the index was counted by hand
STARS_OVER_FIELDS = [
    ("QQ[s]/(s^4-4*s^2+2)", [0, 1, 2], [2], 2, (2, 3, 16)),
    ("QQ[s]/(s^3-3*s-1)", [0, 1], [2, 3], 4, (2, 4, 18)),
    ("QQ(sqrt(5))", [0], [2], 2, (2, 4, 5)),
    ("QQ(sqrt(5))", [0], [5], 2, (2, 3, 10)),
    ("QQ(sqrt(5))", [0], [3], 2, (2, 5, 6)),
    ("QQ(sqrt(2))", [0], [2], 2, (2, 3, 8)),
    ("QQ(sqrt(3))", [0], [2], 2, (2, 3, 12)),
    ("QQ(sqrt(3))", [0], [3], 2, (2, 4, 12)),
    ("QQ(sqrt(6))", [0], [2], 2, (3, 4, 6)),
    ("QQ(sqrt(10))", [0], [3], 2, (2, 2, 3, 4, 4)),  # P₃ is in no square class; P₂² = (2)
    ("QQ(sqrt(15))", [0], [2], 4, (2, 2, 3, 6)),  # 4 + √15 is not a square, P₂² = (2)
]  # fmt: skip


@pytest.mark.slow
@subcases(("field", "real", "primes", "index", "orders"), STARS_OVER_FIELDS)
def test_modulo_the_normaliser_over_a_field(field, real, primes, index, orders) -> None:
    O = over_field(field, real, *primes).maximal_order()
    G = O.norm_one_group()
    star = G.quotient()
    assert star.signature == (0, orders, 0)
    assert len(star.elements) == index
    assert star.area == G.area / index == sum(1 - Fraction(1, m) for m in orders) - 2
    for n, w in star.elements.items():
        assert w.norm() == n
        assert all(v.sign(n) > 0 for v in O.algebra.ring.real_places())
        assert O.left_ideal([w]) == O.right_ideal([w])


@pytest.mark.slow
def test_modulo_the_normaliser_of_eichler_orders_over_a_field() -> None:
    """Triangle groups commensurable to (2, 3, 7) and (2, 3, 9), by their areas of level P₂, P₇ and P₃."""
    for field, p, orders in [
        ("QQ[s]/(s^3+s^2-2*s-1)", None, (2, 3, 7)),
        ("QQ[s]/(s^3+s^2-2*s-1)", 2, (2, 4, 7)),
        ("QQ[s]/(s^3+s^2-2*s-1)", 7, (2, 3, 14)),
        ("QQ[s]/(s^3-3*s-1)", 3, (2, 3, 18)),
    ]:
        A = over_field(field, [0, 1])
        O = A.eichler_order(A.ring.primes_above(p)[0] if p else 1)
        assert O.norm_one_group().quotient().signature == (0, orders, 0)


@pytest.mark.slow
def test_the_index_in_the_normaliser_against_pari() -> None:
    """[U⁺ : U²] times the pairs (class of 𝔞, S) with 𝔞²·∏Pᵉ narrowly principal, with PARI's class groups."""
    pari = pytest.importorskip("cypari", reason="cypari, an oracle, is not installed").pari
    for d, p, level in quick_part([(10, 3, 2), (15, 2, 7), (34, 2, 3), (30, 2, 1), (5, 2, 11)]):
        K = ring(f"QQ(sqrt({d}))")
        P = K.primes_above(level)[0] if level > 1 else None
        A = over_field(K.name, [0], p)
        O = A.eichler_order(P or 1)
        bnf = pari.bnfinit(pari.polredbest(f"x^2-{d}"), 1)
        narrow = pari.bnrinit(bnf, pari("[1,[1,1]]"), 1)
        signs = pari.matconcat([pari.bnfsignunit(bnf), pari("[-1;-1]")])
        rank = int(pari.matrank(pari("m->(matrix(#m~,#m,i,j,Mod(m[i,j]<0,2)))")(signs)))
        cyc = [int(c) for c in bnf.bnf_get_cyc()]
        primes = [pari.idealprimedec(bnf, q)[0] for q in (p, level) if q > 1]
        pairs = 0
        for e in product(*map(range, cyc), *[range(2)] * len(primes)):
            ideal = pari(1)
            for a, k in zip(bnf.bnf_get_gen(), e, strict=False):
                ideal = pari.idealmul(bnf, ideal, pari.idealpow(bnf, a, 2 * k))
            for Q, k in zip(primes, e[len(cyc) :], strict=True):
                ideal = pari.idealmul(bnf, ideal, pari.idealpow(bnf, Q, k))
            pairs += not any(pari.bnrisprincipal(narrow, ideal, 0))
        G = O.norm_one_group()
        assert len(normaliser.Cosets(G.domain().polygon, ()).elements) == 2 ** (2 - rank) * pairs


def test_products_and_inverses_of_cosets() -> None:
    """In coordinates of cosets they are those of the elements, up to numbers."""
    for O in (order(6), over_field("QQ(sqrt(15))", [0], 2).maximal_order()):
        G = O.norm_one_group()
        cosets = normaliser.Cosets(G.domain().polygon, ())
        units = G.order.rows([G.evaluate((1, 2, -1)), G.evaluate((2, 2, 1))])
        rows = [row for n in range(4) for row in cosets.block(n, units)]
        elements = list(map(cosets.element, rows))
        for x, row in zip(elements, rows, strict=True):
            inverse = cosets.element(row @ cosets.bar)
            assert (x * inverse).conjugate() == x * inverse
            for y, other in zip(elements, rows, strict=True):
                z = x * y / cosets.element(row @ (other @ cosets.products))
                assert z.conjugate() == z


def test_products_of_a_basis_stay_small_over_a_field() -> None:
    """The Hermite basis of this order has products with six digits; those of units overflowed with it."""
    A = over_field("QQ[s]/(s^3-7*s-5)", [1, 2])
    order = A.eichler_order(3).norm_one_group().order
    assert max(abs(c) for row in order.products for c in row) < 50
    assert order.order == A.order(order.basis).value


def test_some_involutions_over_a_field() -> None:
    A = over_field("QQ(sqrt(3))", [0], 2)
    K = A.ring
    (P, Q), R = (K.ideal(K.primes_above(p)[0]) for p in (2, 3)), K.ideal(K.primes_above(11)[0])
    G = A.eichler_order(Q).norm_one_group()
    # 1 + √3 has norm −2 and √3 has −3: neither has a totally positive generator, their product has
    assert len(G.quotient(1).elements) == 2
    assert len(G.quotient(P * Q).elements) == len(G.quotient().elements) == 4
    for norm in (P, Q):
        with pytest.raises(LatticeError, match="no element of totally positive norm"):
            G.quotient(norm)
    for norm in (2, 3, R, P * Q * Q):
        with pytest.raises(LatticeError, match="exact divisor"):
            G.quotient(norm)
    with pytest.raises(LatticeError, match="Eichler orders"):
        QuaternionAlgebra(K, -1, K.gen).order(["i", "j"]).norm_one_group().quotient()


def test_principal_ideals_over_fields() -> None:
    """Generators are multiplied out; where the narrow class group forbids one, the answer is no."""
    for field, real, p, expected in [
        ("QQ(sqrt(5))", [0], 2, True),
        ("QQ[s]/(s^3+s^2-2*s-1)", [0, 1], None, True),
        ("QQ[s]/(s^2-10)", [0], 3, False),
    ]:
        O = over_field(field, real, p).maximal_order()
        P = O.algebra.ring.primes_above(13)[0]
        for I in O.ideals_of_norm(P, side="right")[:2]:
            answer = I.is_principal()
            assert bool(answer) == expected
            assert not answer or O.right_ideal([answer.element]) == I
            left = I.conjugate().is_principal()
            assert not left or O.left_ideal([left.element]) == I.conjugate()
    assert not answer
    assert "has none" in answer.reason


def test_units_of_norms() -> None:
    for D, N in ((6, 1), (46, 1), (1, 11), (10, 7)):
        O = order(D, N)
        x = O.norm_one_group().unit_of_norm(-1)
        assert x.norm() == -1
        assert x in O
        for u in (0, 2):
            with pytest.raises(LatticeError, match="not a unit"):
                O.norm_one_group().unit_of_norm(u)
    G = over_field("QQ(sqrt(5))", [0], 2).maximal_order().norm_one_group()
    golden = ring("QQ(sqrt(5))")("1/2+1/2*sqrt(5)")
    signs = [v.sign(golden) for v in ring("QQ(sqrt(5))").real_places()]
    assert signs == [-1, 1]  # negative at the place that ramifies
    assert G.unit_of_norm(golden) is None
    assert G.unit_of_norm(-golden).norm() == -golden
    assert G.unit_of_norm(-1) is None


@pytest.mark.parametrize(("D", "N"), first_quick([(10, 1), (6, 5), (1, 8), (10, 9), (22, 3)], 3))
def test_traces_of_words(D: int, N: int) -> None:
    """Those of products of units are those that embeddings allow, each of them up to 20."""
    G = order(D, N).norm_one_group()
    rng = random.Random(1)
    units = [side.element for side in G.domain().sides]
    found = set()
    for _ in range(6000):
        word = rng.choices(units, k=rng.randrange(1, 6))
        found.add(abs(int(math.prod(word, start=G.order.algebra(1)).trace())))
    assert tuple(sorted(t for t in found if 2 < t <= 20)) == G.traces(20)
    assert G.systole == 2 * math.acosh(G.traces(20)[0] / 2)


def test_other_places_split() -> None:
    for field, b in (("QQ(sqrt(5))", 3), ("QQ(sqrt(5))", -1), ("QQ[s]/(s^3-2)", 3)):
        with pytest.raises(IndefiniteError, match="exactly one"):
            QuaternionAlgebra(field, -1, b).maximal_order().norm_one_group()


@pytest.mark.parametrize(("D", "N"), GENUS_ONE)
def test_curves_of_genus_one(D: int, N: int) -> None:
    assert order(D, N).norm_one_group().signature.genus == 1


@subcases("N", MODULAR)
def test_modular_curves(N: int) -> None:
    two, three, cusps, genus = MODULAR[N]
    assert order(1, N).norm_one_group().signature == (genus, (2,) * two + (3,) * three, cusps)
    checked(order(1, N))


@pytest.mark.parametrize(
    ("a", "b", "texts"),
    [
        (3, -1, "1 i j k"),
        (3, -1, "1 2*i j"),
        (1, 1, "1 i j k"),
        (1, 1, "1 2*i j"),
        (2, -3, "1 i j k"),
    ],
)
def test_orders_of_every_kind(a: int, b: int, texts: str) -> None:
    """Those that are not Eichler orders too: the domain has the area of the local formula."""
    checked(QuaternionAlgebra("QQ", a, b).order(texts.split()))


@pytest.mark.parametrize(("D", "N"), [(6, 1), (14, 1), (1, 11), (1, 4)])
def test_words(D: int, N: int) -> None:
    O = order(D, N)
    G = O.norm_one_group()
    rng = random.Random(D * N)
    letters = [n for m in range(1, len(G.generators) + 1) for n in (m, -m)]
    assert G.word(1) == G.word(-1) == ()
    for _ in range(20):
        x = G.evaluate(tuple(rng.choice(letters) for _ in range(rng.randrange(30))))
        assert G.evaluate(G.word(x)) in (x, -x)
        assert G.word(-x) == G.word(x)
    # the same element by another word: a relation put in the middle
    for r in G.relations:
        assert G.word(G.evaluate(r)) == ()
    i = O.algebra("i")
    for wrong in (i, i / 7, 2, 0, O.algebra("1/3")):
        if O.algebra(wrong).norm() != 1 or wrong not in O:
            with pytest.raises(LatticeError):
                G.word(wrong)


def test_words_of_enumerated_units() -> None:
    """Every unit in a box, not found by the search, is a product of the generators."""
    O = order(6)
    G = O.norm_one_group()
    units = [
        x
        for row in product(range(-4, 5), repeat=4)
        if (x := sum((c * b for c, b in zip(row, O.basis, strict=True)), O.algebra(0))).norm() == 1
    ]
    assert len(units) > 50
    assert all(G.evaluate(G.word(x)) in (x, -x) for x in units)


def test_centers() -> None:
    G = order(1).norm_one_group()
    D = G.domain(0.1 + 2j)
    assert abs(D.center - (0.1 + 2j)) < 0.3
    c = D.center_element
    assert c.trace() == 0
    assert c.norm() > 0
    assert all(s.element * c != c * s.element for s in D.sides)
    # i is an elliptic point of SL₂(ℤ), and another point takes its place
    assert abs(G.domain(1j).center - 1j) < 0.2
    for z in (0.5, -1j, complex("nan+infj"), 1e300j, "x", [1j]):
        with pytest.raises(LatticeError, match="positive imaginary part"):
            G.domain(z)


@pytest.mark.parametrize("constants", [(39, -8, -3), (2, 3, 1), (-3, 7, 1)])
def test_algebras_with_a_trace(constants: tuple[int, int, int]) -> None:
    """In [a, b), and with any t: what is real in an element is half its trace, not its first coordinate."""
    checked(QuaternionAlgebra("QQ", constants[0], constants[1], constants[2]).maximal_order())


def test_signatures_without_a_domain(monkeypatch) -> None:
    """By formulas alone where the area is large; here for all areas, against the domains."""
    orders = [order(D, N) for D, N in ((6, 1), (14, 1), (10, 9), (1, 36), (1, 13), (1, 1), (6, 7))]
    known = [O.norm_one_group().signature for O in orders]
    monkeypatch.setattr(group, "MAX_AREA_OF_CENTERS", 0)
    assert [O.norm_one_group().signature for O in orders] == known
    assert order(1, 10**9 + 7).norm_one_group().signature == (83_333_334, (), 2)


@pytest.mark.parametrize(
    ("field", "below", "level"),
    share_quick(
    [("QQ(sqrt(5))", 5, 1), ("QQ(sqrt(5))", 5, 4), ("QQ(sqrt(2))", 2, 9), ("QQ(sqrt(3))", 3, 1),
     ("QQ(sqrt(13))", 3, 4), ("QQ(sqrt(10))", 3, 2), ("QQ(sqrt(17))", 17, 1), ("QQ[s]/(s^3-3*s-1)", 0, 3),
     # orders that are not maximal at the level
     ("QQ(sqrt(3))", 3, "1+sqrt(3)"), ("QQ(sqrt(3))", 3, 2)], 2),
)  # fmt: skip
def test_signatures_over_number_fields_without_a_domain(
    field: str, below: int, level: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Embedding numbers give the elliptic points that a domain has, of the orders 2 to 9."""
    K = ring(field)
    places = K.real_places()
    ramified = K.primes_above(below)[:1] if below else places[1:2]
    A = QuaternionAlgebra.from_ramification(K, [places[0], *ramified])
    O = A.maximal_order() if level == 1 else A.eichler_order(level)
    with monkeypatch.context() as patch:
        patch.setattr(group.NormOneGroup, "_signature_by_formulas", lambda self: None)
        known = O.norm_one_group().signature
    monkeypatch.setattr(group, "MAX_AREA_OF_CENTERS", 0)
    monkeypatch.delattr(group.NormOneGroup, "_domain")
    assert O.norm_one_group().signature == known


def test_signature_of_a_group_that_is_too_large_for_a_domain() -> None:
    K = ring("QQ(sqrt(1298))")
    places = [K.primes_above(3)[0], K.real_places()[0]]
    G = QuaternionAlgebra.from_ramification(K, places).maximal_order().norm_one_group()
    assert G.area == 10608
    assert G.signature == (5297, (3,) * 24, 0)


def test_what_is_too_large_is_refused_at_once() -> None:
    for b, level, size in ((3, 100_003, "100004/3"), (1_000_003, 1, "166667")):
        G = QuaternionAlgebra("QQ", -1, b).eichler_order(level).norm_one_group()
        for center in (None, 1 + 1j):
            with pytest.raises(TooLargeError, match=f"of area 2π·{size}, is too large"):
                G.domain(center)


def test_definite_orders_are_refused() -> None:
    with pytest.raises(IndefiniteError, match="definite"):
        QuaternionAlgebra("QQ", -1, -11).maximal_order().norm_one_group()


def test_local_index_against_counting() -> None:
    """The index of Γ₀(N)-like orders in the maximal one, by counting units modulo their conductor."""
    A = QuaternionAlgebra("QQ", 1, 1)
    M = A.maximal_order()
    for p in (2, 3, 5):
        O = A.order([p * b for b in M.basis])  # ℤ + p·M: modulo p the matrices ±1 among SL₂(𝔽ₚ)
        index = p * (p * p - 1) // (1 if p == 2 else 2)
        assert area.area(O.value) == index * area.area(M.value)


def test_orders_of_large_index() -> None:
    """Their domains come from that of a maximal order; the narrow cusps are all there."""
    G = QuaternionAlgebra("QQ", 1, 1).order(["3*i", "5*j"]).norm_one_group()
    assert G.area == 180
    assert G.domain().area == 180
    assert len(G.generators) == 2 * G.signature.genus + G.signature.cusps - 1  # a free group
    assert G.relations == ()
    rows = dirichlet.generators_by_cosets(G.order, dirichlet.order_above(G.order)).tolist()
    assert all((x := G.order.element(row)) in G.order and x.norm() == 1 for row in rows)
    with pytest.raises(TooLargeError, match="of index 5040"):
        QuaternionAlgebra("QQ", 1, 1).order(["5*i", "7*j"]).norm_one_group().domain()


def test_an_incomplete_domain_is_seen() -> None:
    """Half of the generators bound a larger polygon, whose area is not that of the group."""
    whole = order(14).norm_one_group().domain()
    P, area = whole.polygon, whole.area
    assert dirichlet.proof(Polygon(P.plane, P.units), area) is not None
    assert dirichlet.proof(Polygon(P.plane, P.units), area / 2) is None
    assert not Polygon(P.plane, P.units * 2).is_closed()  # twice around
    assert not Polygon(P.plane, P.units[::-1]).is_closed()
    for units in (
        P.units[1:],
        P.units[::-1],
        [*P.units[2:], P.units[0], P.units[1]][1:],
        P.units * 2,
    ):
        assert dirichlet.proof(Polygon(P.plane, units), area) is None


def test_pictures(tmp_path) -> None:
    D = order(6).norm_one_group().domain()
    D.draw(tmp_path / "c.html")
    text = (tmp_path / "c.html").read_text(encoding="utf-8")
    assert "{{" not in text
    assert "://" not in text  # it asks nobody for anything
    data = json.loads(text.split("const GROUP = ")[1].split(";\n")[0])
    assert len(data["units"]) == len(D.sides)
    assert all(abs(p * p + q * q - r * r - s * s - 1) < 1e-9 for p, q, r, s in data["units"])
    for name in ("a.svg", "b.png"):
        D.draw(tmp_path / name, dark=name == "b.png", depth=2)
        assert (tmp_path / name).stat().st_size > 5000
    assert "</svg>" in D._repr_svg_()
    assert "5 sides" in repr(D)
    with pytest.raises(LatticeError, match=r"ends in \.svg"):
        D.draw(tmp_path / "nowhere" / "a.svg")


def test_far_units_end_no_search() -> None:
    """With eight cusps some units are so far away that rounding turned them around for ever."""
    assert len(order(1, 248).norm_one_group().domain().sides) > 64


@pytest.mark.parametrize(
    ("algebra", "index", "orders"),
    [
        ("(-1,sqrt(5)|QQ(sqrt(5)))", 30, (2,) * 10),  # 2 is inert there
        ("(-1,1+sqrt(2)|QQ(sqrt(2)))", 12, (2,) * 6),  # and ramifies here
    ],
)
def test_orders_over_fields_that_are_not_eichler(
    algebra: str, index: int, orders: tuple[int, ...]
) -> None:
    """Gauss and Bonnet agree with the local indices of units and of their norms, or there is no domain."""
    A = QuaternionAlgebra.from_text(algebra)
    O, M = A.order(["i", "j"]), A.maximal_order()
    G = O.norm_one_group()
    assert not O.is_eichler()
    assert G.area / M.norm_one_group().area == index
    assert (G.signature.orders, G.domain().area) == (orders, G.area)
    assert "above 2" in str(G.claim.why_no_certificate)


def test_units_that_are_1_modulo_an_odd_prime() -> None:
    """Their index is the order of PSL₂(𝔽₅), and a certificate says so."""
    A = QuaternionAlgebra.from_text("(-1,sqrt(5)|QQ(sqrt(5)))")
    M = A.maximal_order()
    G = A.order([A("sqrt(5)") * x for x in M.basis]).norm_one_group()
    assert G.area / M.norm_one_group().area == 60
    assert G.signature == (4, (), 0)
    assert G.certificate is not None

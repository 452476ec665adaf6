"""Prime ideals and places by their definition, and of quadratic fields by two ways that share nothing."""

import pickle
from fractions import Fraction
from itertools import islice, product
from math import isqrt, prod
from random import Random

import flint
import pytest

from hfield.errors import HFieldError, RingError
from hfield.fields.base.residue_polynomials import (
    coefficients,
    idempotent,
    residues,
    sorted_factors,
)
from hfield.fields.function_fields.places import FunctionPlace, place_of_functions
from hfield.fields.names import ring
from hfield.fields.number_fields.integers import LocalOrder, dedekind, integral_generator
from hfield.fields.number_fields.places import place_of_number_field
from hfield.fields.number_fields.prime_ideals import by_other_generators
from hfield.fields.number_fields.quadratic.places import QuadraticPrime, integer_coordinates
from hfield.fields.number_fields.quadratic.ring import QuadraticField, common_quadratic_field
from hfield.fields.number_fields.sums import (
    _newton_sums,
    common_root,
    evaluate,
    factor_at,
    roots_in,
    sums_of_roots,
)
from hfield.fields.rationals.places import place_of_q
from hfield.fields.rationals.whole_numbers import fraction
from tests.fields.general_fields import general, moved, place_of
from tests.subcases import share_quick, subcases

PRIMES = (2, 3, 5, 7, 11, 13)
QUADRATIC = (-1, -2, -3, -5, -6, -7, -11, -15, -23, 2, 3, 5, 6, 7, 10, 13, 17, 21, 33)


def order_at(n: int, p: int) -> int:
    """Return how often p divides n ≠ 0."""
    count = 0
    while n % p == 0:
        n, count = n // p, count + 1
    return count


def order_of(x: Fraction, p: int) -> int:
    return order_at(x.numerator, p) - order_at(x.denominator, p)


@pytest.mark.parametrize("d", share_quick(QUADRATIC, 5))
def test_places_of_quadratic_fields_are_those_of_the_number_field(d: int) -> None:
    F = QuadraticField(d)
    K = general(F)
    assert F.discriminant() == K.discriminant()
    one, omega = F.integral_basis()
    assert one == 1
    # the discriminant is that of the form tr(x·y) on the basis
    traces = [[moved(K, x * y).trace() for y in (one, omega)] for x in (one, omega)]
    assert traces[0][0] * traces[1][1] - traces[0][1] * traces[1][0] == F.discriminant()
    assert K.is_integral(moved(K, omega))
    rng = Random(d)
    drawn = [F.random(rng) for _ in range(5)]
    drawn += [F(12), F.gen, F(Fraction(1, 30)), omega, omega + 1]
    drawn = [x for x in drawn if not F.is_zero(x)]
    for x in drawn:
        assert moved(F, moved(K, x)) == x
        u, v = integer_coordinates(d, x)
        assert one * u + omega * v == x
    for p in PRIMES:
        above = F.primes_above(p)
        others = K.primes_above(p)
        assert sorted((P.e, P.f) for P in above) == sorted((P.e, P.f) for P in others)
        assert sum(P.e * P.f for P in above) == 2
        images = [place_of(K, P) for P in above]
        assert len(set(images)) == len(above)
        for P, image in zip(above, images, strict=True):
            assert (P.p, P.is_finite) == (p, True)
            assert [P.valuation(x) for x in drawn] == [image.valuation(moved(K, x)) for x in drawn]
            assert all(g in P for g in P.generators)
            assert min(map(P.valuation, P.generators)) == 1
            assert [x in P for x in (*drawn, F.zero)] == [
                moved(K, x) in image for x in (*drawn, F.zero)
            ]
            assert [min(map(Q.valuation, P.generators)) > 0 for Q in above] == [
                Q == P for Q in above
            ]
            assert place_of_number_field(F, str(P)) == P == place_of_number_field(F, P)
            assert P.field == F
            with pytest.raises(HFieldError, match="0 has no valuation: it lies in every power"):
                P.valuation(0)
            assert pickle.loads(pickle.dumps(P)) == P
            for x in drawn:  # residues are those of the general prime ideal
                if P.valuation(x) >= 0:
                    rest = P.lift(P.residue_of(x)) - x
                    assert F.is_zero(rest) or image.valuation(moved(K, rest)) > 0
        for x in drawn:
            norm = fraction(moved(K, x).norm())
            assert sum(P.f * P.valuation(x) for P in above) == order_of(norm, p)
        for x, y in product(drawn, drawn):
            for P in above:
                assert P.valuation(x * y) == P.valuation(x) + P.valuation(y)
                if not F.is_zero(x + y):
                    assert P.valuation(x + y) >= min(P.valuation(x), P.valuation(y))
        if len(above) == 1:
            assert place_of_number_field(F, p) == above[0]
        else:
            with pytest.raises(HFieldError, match="is not a single place of"):
                place_of_number_field(F, p)


@pytest.mark.parametrize("d", [-7, -1, 2, 13])
def test_infinite_places_of_quadratic_fields(d: int) -> None:
    F = QuadraticField(d)
    K = general(F)
    above = F.infinite_places()
    assert [str(v) for v in above] == (["inf-", "inf+"] if d > 0 else ["inf"])
    assert [str(v) for v in K.infinite_places()] == (["inf0", "inf1"] if d > 0 else ["inf"])
    assert F.real_places() == (above if d > 0 else ())
    assert [v.index for v in F.real_places()] == [0, 1][: len(F.real_places())]
    for v in above:
        assert not v.is_finite
        assert place_of_number_field(F, f" {v} ") == v
        image = place_of(K, v)
        assert image.index == v.index
        if d > 0:
            for x in (F.gen, F(1), F(-1), 1 + F.gen, 2 - F.gen, F.gen - 1):
                assert v.sign(x) == image.sign(moved(K, x))
    listed = list(islice(F.places(), 12))
    assert listed[: len(above)] == list(above)[::-1]
    finite = [v.p for v in listed[len(above) :]]
    assert finite == sorted(finite)
    wanted = [p for p in PRIMES for _ in F.primes_above(p)]
    assert finite[: len(wanted)] == wanted[: len(finite)]
    for text in ("4", "x", "(4, 1)", "-3", "1", "(3", ""):
        with pytest.raises(HFieldError):
            place_of_number_field(F, text)
    with pytest.raises(HFieldError) as caught:
        place_of_number_field(QuadraticField(-7), "2")
    assert str(caught.value) == (
        "'2' is not a single place of QQ(sqrt(-7)): the places above it are "
        '"(2, -1/2+1/2*sqrt(-7))", "(2, -3/2+1/2*sqrt(-7))"'
    )
    with pytest.raises(HFieldError) as caught:
        place_of_number_field(QuadraticField(2), "4")
    assert str(caught.value) == (
        "'4' is not a place of QQ(sqrt(2)): expected a prime ideal, such as "
        '"(2, sqrt(2))", or an infinite place, such as "inf-"'
    )
    for p in ("4", Fraction(1, 2), 6, 1):
        with pytest.raises(HFieldError, match="is not a prime number; expected one, such as 5"):
            F.primes_above(p)


def test_common_quadratic_fields() -> None:
    R = ring("RR")
    assert common_quadratic_field(R("1+sqrt(2)"), R("sqrt(8)"), 3, R(1)) == QuadraticField(2)
    assert common_quadratic_field(R(1), 2, "text") is None
    assert common_quadratic_field() is None
    with pytest.raises(
        HFieldError, match=r"sqrt\(2\) and sqrt\(3\) lie in no common quadratic field"
    ):
        common_quadratic_field(R("sqrt(2)"), R("sqrt(3)"))
    with pytest.raises(HFieldError, match="lie in no common"):
        common_quadratic_field(R("sqrt(2)+sqrt(3)"))
    assert ring("QQ(sqrt(5))").integral_basis()[1] == ring("QQ(sqrt(5))")("1/2+1/2*sqrt(5)")
    assert ring("QQ(I)").integral_basis()[1] == ring("QQ(I)").gen
    assert QuadraticPrime(QuadraticField(5), 7) == QuadraticField(5).primes_above(7)[0]


def test_places_of_rational_numbers() -> None:
    for place in ("inf", "oo", "∞", " Infinity ", float("inf"), -1):
        assert place_of_q(place) == "inf"
    for place in (2, "2", " 2 ", flint.fmpz(2)):
        assert place_of_q(place) == 2
    for place in (4, "4", 1, 0, -2, "x", True, 2.0, None, "-3", ""):
        with pytest.raises(HFieldError, match='is not a place of QQ: expected a prime or "inf"'):
            place_of_q(place)


def test_data_of_places() -> None:
    F = ring("QQ(sqrt(2))")
    assert [F.place_data(v) for v in islice(F.places(), 3)] == [
        {"kind": "real", "number": 1},
        {"kind": "real", "number": 0},
        {"kind": "number", "n": 2},
    ]
    with pytest.raises(RingError, match=r"7 is not a place of QQ\(sqrt\(2\)\)"):
        F.place_data(7)


@pytest.mark.parametrize("q", [2, 3, 4, 5])
def test_places_of_functions(q: int) -> None:
    F = ring(f"GF({q})(t)")
    assert isinstance(next(F.places()), FunctionPlace)
    # as many irreducible monic polynomials of each degree as Gauss counted
    counts = {1: q, 2: (q * q - q) // 2, 3: (q**3 - q) // 3}
    listed = list(islice(F.places(), 1 + sum(counts.values())))
    assert str(listed[0]) == "inf"
    assert listed[0].degree == 1
    degrees = [v.degree for v in listed[1:]]
    assert degrees == [n for n, count in counts.items() for _ in range(count)]
    assert len({str(v) for v in listed}) == len(listed) == len(set(listed))
    for v in listed[1:]:
        x = F(str(v))
        assert x.den == 1
        assert (
            v
            == place_of_functions(F, str(v))
            == place_of_functions(F, x)
            == place_of_functions(F, v)
        )
        assert place_of_functions(F, x * (q - 1)) == v
        assert repr(v) == str(v)
    for text in ("inf", " oo ", "∞"):
        assert place_of_functions(F, text) == listed[0]
    for text in ("t^2", "1", "1/t", "0", "t*(t+1)", "t+", "(t+1)^2*t", ring("QQ")(1)):
        with pytest.raises(HFieldError, match=r'expected an irreducible polynomial or "inf"'):
            place_of_functions(F, text)
    with pytest.raises(
        HFieldError, match=r"the places of QQ\(x\) are not listed; its elements name"
    ):
        next(ring("QQ(x)").places())


# --- number fields ----------------------------------------------------------------------------------

POLYNOMIALS = (
    "x^3-x^2-2*x-8", "x^4+7*x^2+4*x+2", "x^2-5", "x^3-10", "x^3-2", "x^4-x^3+2*x^2+x+9", "2*x^3+3*x+1/5",
    "x^4-5", "x^3-49", "x^3+x^2-2*x+8", "x^5-x-1", "x^2+x+1/4+3/4", "x^4+3*x^2+27",
    "x^2-1/121*x+7", "2*x^3-3*x+1/2",
)  # fmt: skip


@pytest.mark.slow
@subcases("polynomial", POLYNOMIALS)
def test_prime_ideals_by_definition(polynomial: str) -> None:
    K = ring(f"QQ[x]/({polynomial})")
    rng = Random(2)
    drawn = [x for x in (K.random(rng) for _ in range(4)) if x] + [K.gen, K(6), K.gen + 1]
    basis = K.integral_basis()
    assert K.discriminant() == matrix([[(x * y).trace() for x in basis] for y in basis]).det()
    for p in (2, 3, 5, 7):
        above = K.primes_above(p)
        assert sum(P.e * P.f for P in above) == K.degree
        assert len(set(above)) == len(above)
        for P in above:
            assert (P.p, P.norm(), P.is_finite) == (p, p**P.f, True)
            assert [Q.valuation(P.uniformiser) for Q in above] == [int(Q is P) for Q in above]
            assert [Q.valuation(K(p)) for Q in above] == [Q.e for Q in above]
            assert [min(map(Q.valuation, P.generators)) for Q in above] == [
                int(Q is P) for Q in above
            ]
            # and they generate P, not only at p
            assert K.ideal(P.generators) == K.ideal(P)
            assert place_of_number_field(K, str(P)) == P
            # β/p has a pole of order 1 here, and none elsewhere
            assert P.valuation(P.inverse_uniformiser) == -1
            assert all(Q.valuation(P.inverse_uniformiser) >= 0 for Q in above if Q is not P)
            # ε is 1 here and 0 elsewhere
            eps = P.idempotent
            assert not eps - 1 or P.valuation(eps - 1) > 0
            assert all(not eps or Q.valuation(eps) > 0 for Q in above if Q is not P)
            residue = P.residue_field
            assert residue.order == P.norm()
            root = P.reduce(P.residue_gen)
            assert residue.is_zero(
                sum((root**n * c for n, c in enumerate(coefficients(P.residue))), residue.zero)
            )
            assert P.f == 1 or root == residue.gen
            whole = [P.integral(x) for x in drawn if P.valuation(x) >= 0]
            assert all(P.order.content(x) >= 0 for x in whole if x)
            for x, y in product(whole, whole):
                assert P.reduce(x * y) == P.reduce(x) * P.reduce(y)
                assert P.reduce(x + y) == P.reduce(x) + P.reduce(y)
                assert (x in P) == residue.is_zero(P.reduce(x)) or not K.is_integral(x)
            images = {P.reduce(K(P.lift(P.residue_of(x)))) == P.reduce(x) for x in whole}
            assert images == {True}
            assert P.reduce(K.zero) == 0
            for x in drawn:
                v, unit = P.unit_part(x)
                assert v == P.valuation(x)
                assert P.valuation(unit) == 0
                if v < 0:
                    with pytest.raises(
                        HFieldError, match=r"has no residue at .*: its valuation is negative"
                    ):
                        P.reduce(x)
                t = P.order.truncated(P.integral(x), p**3) if v >= 0 else None
                if t is not None:
                    rest = P.integral(x) - t
                    assert not rest or P.order.content(rest) >= 3
                    assert all(0 <= c < p**3 for c in P.order.coordinates(t)[0])
            assert (K.zero in P, K.one in P, K(p) in P, K(Fraction(1, p)) in P) == (
                True,
                False,
                True,
                False,
            )
            with pytest.raises(HFieldError, match="0 has no valuation: it lies in every power"):
                P.valuation(0)
            for other in by_other_generators(P, 4):
                g = other["polynomial"]
                assert (other["kind"], other["p"], len(g)) == ("other generator", p, P.f + 1)
                powers = (K.gen**n * K(c) for n, c in enumerate(other["generator"]))
                value = sum(powers, K.zero)
                total = sum((value**n * c for n, c in enumerate(g)), K.zero)
                assert not total or P.valuation(total) > 0
                modulo = residues(p, g)
                assert len(sorted_factors(modulo)) == 1
        for x in drawn:
            assert sum(P.f * P.valuation(x) for P in above) == order_of(fraction(x.norm()), p)


def matrix(rows):
    return flint.fmpq_mat(len(rows), len(rows), [c for row in rows for c in row])


def test_generators_that_are_integral() -> None:
    for f, scale in (("x^3-2", 1), ("x^2-1/4*x+1/2", 4), ("x^2-3/4", 2), ("x^3+1/8*x+1/9", 12),
                     ("x^3-3/8", 2), ("x^4-x/27-1", 3)):  # fmt: skip
        K = ring(f"QQ[x]/({f})")
        found, whole = integral_generator(K)
        assert found == scale
        assert whole.degree() == K.degree
        y = K.gen * found
        assert not sum((y**n * int(c) for n, c in enumerate(whole.coeffs())), K.zero)
        assert all(not K.is_integral(K.gen * Fraction(found, p)) for p in (2, 3) if found % p == 0)


def test_where_the_generator_tells_all() -> None:
    for f, p, wanted in (
        ([-5, 0, 1], 2, False), ([-5, 0, 1], 3, True), ([-5, 0, 1], 5, True), ([-2, 0, 0, 1], 3, True),
        ([-10, 0, 0, 1], 3, False), ([-8, -2, -1, 1], 2, False), ([-12, 0, 1], 2, False),
        ([-45, 0, 1], 3, False), ([1, 0, 1], 2, True), ([3, 0, 1], 2, False), ([-4, 0, 0, 1], 2, False),
    ):  # fmt: skip
        assert dedekind(flint.fmpz_poly(f), p) == wanted, (f, p)
    order = LocalOrder(ring("QQ[x]/(x^2-5)"), 2)
    assert not order.plain
    assert len(order.basis) == 2
    assert order.content(order.field("(1+x)/2")) == 0
    assert order.content(order.field("1+x")) == 1
    assert order.content(order.field("(1+x)/8")) == -2
    assert order.element(order.coordinates(order.field("3+5*x"))[0]) == order.field("3+5*x")


def test_polynomials_over_prime_fields() -> None:
    for p in (2, 3, 5, 2**89 - 1):
        rng = Random(p)
        f = residues(p, [1])
        for n in (1, 1, 2):
            g = residues(p, [rng.randrange(p) for _ in range(n)] + [1])
            f = f * g
        factors = sorted_factors(f)
        assert prod((g**e for g, e in factors), start=residues(p, [1])) == f
        assert [g.degree() for g, _ in factors] == sorted(g.degree() for g, _ in factors)
        for g, e in factors:
            part = g**e
            x = idempotent(f, part)
            assert (x - 1) % part == 0
            assert len(factors) == 1 or x % (f // part) == 0
            assert len(coefficients(x)) <= f.degree()
        assert coefficients(residues(p, [-1, p, 2 * p + 1])) == [p - 1, 0, 1]


def test_sums_of_roots() -> None:
    f, g = flint.fmpq_poly([-2, 0, 1]), flint.fmpq_poly([flint.fmpq(1, 3), -3, 0, 1])
    for scale in (1, -1, 2, 3):
        whole = sums_of_roots(f, g, scale)
        assert whole.degree() == 6
        assert whole[6] == 1
        roots = [[complex(z) for z, _ in h.numer().complex_roots()] for h in (f, g)]
        for x, y in product(*roots):
            z = x + scale * y
            assert (
                abs(
                    sum(
                        complex(float(c.p) / float(c.q)) * z**n
                        for n, c in enumerate(whole.coeffs())
                    )
                )
                < 1e-6
            )
    powers = _newton_sums(g, 7)
    for k, total in enumerate(powers):
        assert abs(sum(z**k for z in roots[1]) - float(total.p) / float(total.q)) < 1e-6
    both = f * g
    assert factor_at(both, lambda bits: flint.acb(flint.arb(2).sqrt())) == f
    assert factor_at(both * 3, lambda bits: flint.acb(g.numer().complex_roots()[0][0])) == g


@subcases(
    ("name", "polynomial", "count"),
    [
        ("QQ[s]/(s^3-2)", [-2, 0, 0, 1], 1),
        ("QQ[s]/(s^3-2)", [-16, 0, 0, 3], 0),
        ("QQ[s]/(s^3-2)", [-3, 0, 1], 0),
        ("QQ[s]/(s^3-2)", [-4, 0, 0, 1], 1),
        ("QQ(zeta5)", [-1, -1, 1], 2),
        ("QQ(zeta5)", [1, 1, 1, 1, 1], 4),
        ("QQ(zeta8)", [-2, 0, 1], 2),
        ("QQ(zeta8)", [1, 0, 1], 2),
        ("QQ(zeta8)", [-3, 0, 1], 0),
        ("QQ(zeta7)+", [-1, -2, 1, 1], 3),
        ("QQ[s]/(s^3-s+2/7)", [flint.fmpq(2, 7), -1, 0, 1], None),
        ("QQ(sqrt(2),sqrt(3))", [-6, 0, 1], 2),
        ("QQ(sqrt(2),sqrt(3))", [1, 0, -10, 0, 1], 4),
    ],
)
def test_roots_in_a_number_field(name: str, polynomial: list, count: int | None) -> None:
    K = ring(name)
    f = flint.fmpq_poly(polynomial)
    roots = roots_in(K, f)
    assert all(not evaluate(K, f, x) for x in roots)
    assert len(set(roots)) == len(roots)
    assert len(roots) == count if count is not None else len(roots) >= 1
    for x in roots:
        assert (
            common_root(K, f / f.leading_coefficient(), shifted(K, x), flint.fmpq(1)) == x
            or x == K.gen
        )


def shifted(K, x):
    """Return the polynomial of s − x, so that x is the common root of f(y) and g(s − y)."""
    return flint.fmpq_poly((K.gen - x).minimal_polynomial())


@pytest.mark.parametrize("name", ["QQ[s]/(s^2-2)", "QQ[s]/(s^2+1)", "QQ[s]/(s^2+3)"])
def test_square_roots_in_number_fields_are_those_of_quadratic_fields(name: str) -> None:
    K = ring(name)
    d = -int(K.polynomial[0].p)
    F = QuadraticField(d)
    for a, b in product(range(-5, 6), range(-5, 6)):
        x = K(a) + K.gen * b
        root, other = K.sqrt(x), F.sqrt(F(a) + F.gen * b)
        assert (root is None) == (other is None)
        if root is not None:
            assert root * root == x
            # principal in both: of two roots the one with positive real part (or on the upper axis)
            assert moved(F, root) == other
        if d > 0:
            for n in (0, 1):
                assert K.sign(x, n) == F.sign(F(a) + F.gen * b, 1 - n)


def test_embeddings() -> None:
    K = ring("QQ[s]/(s^4-2*s-1)")
    e = K.embeddings
    assert K.signature == (2, 1)
    roots = [complex(z) for z in e.at(64)]
    assert [abs(z.imag) < 1e-12 for z in roots] == [True, True, False]
    assert roots[0].real < roots[1].real
    assert roots[2].imag > 0
    for bits in (128, 500):
        finer = e.at(bits)
        assert all(z.overlaps(w) for z, w in zip(finer, e.at(64), strict=True))
        assert all(z.real.rad() < 2.0 ** (10 - bits) for z in finer)
    x = K("s^3-1/3*s+2")
    for n, z in enumerate(roots):
        assert abs(complex(e.value(x.poly, n, 64)) - (z**3 - z / 3 + 2)) < 1e-9
        for digits in (5, 40, 200):
            assert e.close(x.poly, n, digits).rel_accuracy_bits() >= 3.32 * digits
    assert [K.sign(x, n) for n in (0, 1)] == [
        1 if (z**3 - z / 3 + 2).real > 0 else -1 for z in roots[:2]
    ]
    near = isqrt(2 * 10**80)
    Q = ring("QQ[s]/(s^2-2)")
    tiny = Q.gen - Fraction(near, 10**40)
    assert (Q.sign(tiny, 1), Q.sign(-tiny, 1), Q.sign(tiny, 0)) == (1, -1, -1)
    assert e.close(K.zero.poly, 0, 10) == 0

"""Number fields: names, elements, embeddings, integers, prime ideals; by definition and against PARI."""

import pickle
from fractions import Fraction
from math import prod
from random import Random

import pytest
from flint import arb

from hfield import NumberField, QuaternionAlgebra, ring
from hfield.algebra.embedding import embedding
from hfield.errors import CoercionError, NotInvertibleError, RingError
from hfield.fields.base.printing import from_unicode
from hfield.fields.number_fields.places import place_of_number_field
from tests.fields.quadratic_forms.number_field_cases import cases, field, prime
from tests.subcases import subcases

FIELDS = cases("number_fields")
SPELLED = {
    "QQ(root(2,3))": 3, "QQ(root(2,4))": 4, "QQ(sqrt(2),sqrt(3))": 4, "QQ(sqrt(2),I)": 4, "QQ(zeta5)": 4,
    "QQ(zeta7)+": 3, "QQ(root(2,3),zeta3)": 6, "QQ(sqrt(2),sqrt(3),sqrt(6))": 4, "QQ(zeta12)": 4,
    "QQ(sqrt(1/2),root(3/4,3))": 6, "QQ(zeta9)+": 3, "QQ(root(-2,3))": 3,
}  # fmt: skip


@subcases(
    ("text", "name"),
    [
        ("QQ[s]/(s^3-2)", "QQ[s]/(s^3-2)"),
        ("Q[s] / (1*s^3 + 0*s^2 + 0*s - 2*s^0)", "QQ[s]/(s^3-2)"),
        ("QQ[x]/(2*x**2-3)", "QQ[x]/(x^2-3/2)"),
        ("ℚ[s]/(s³−2)", "QQ[s]/(s^3-2)"),
        ("QQ(cbrt(2))", "QQ(root(2,3))"),
        ("QQ( sqrt(2) , sqrt(3) )", "QQ(sqrt(2),sqrt(3))"),
        ("QQ(I,sqrt(2))", "QQ(sqrt(2),I)"),
        ("QQ(zeta_5)", "QQ(zeta5)"),
        ("QQ(ζ5)", "QQ(zeta5)"),
        ("QQ(sqrt(8))", "QQ(sqrt(2))"),
        ("QQ(I)", "QQ(I)"),
    ],
)
def test_names(text: str, name: str) -> None:
    K = ring(text)
    assert K.name == name
    assert ring(K.name) is K


def test_number_field_from_a_polynomial_in_any_letter() -> None:
    K = NumberField("x^4-x-1", "s")
    assert (K.name, K.degree, K.gen**4) == ("QQ[s]/(s^4-s-1)", 4, K.gen + 1)
    assert ring("QQ[s]/(s^4-s-1)") == K
    assert K.gen * ring("QQ[s]/(s^4-s-1)").gen == K.gen**2


@subcases(
    ("text", "why"),
    [
        ("QQ[s]/(x^3-8)", r"reducible, \(s-2\)\*\(s\^2\+2\*s\+4\)"),
        ("QQ[s]/((x^2+1)^2)", "reducible"),
        ("QQ[s]/(7)", "constant"),
        ("QQ[s]/(s^3+t)", "'t' means nothing"),
        ("QQ[s]/(1/s)", "cannot be read"),
        ("QQ[i]/(i^2+1)", "clash with the basis"),
        ("QQ[s]/(s^65-2)", "at most 64"),
        ("QQ(zeta2)", "rational"),
        ("QQ(zeta4)+", "QQ itself"),
        ("QQ(sqrt(2),x)", "write its polynomial"),
        ("QQ(sqrt(2),root(8,3))", "rational"),
        ("QQ(root(2,3),root(0,3))", "other than 0"),
        ("QQ(root(2,1))", "order 2 to 64"),
        ("QQ(zeta5000)", "order 3 to 1000"),
    ],
)
def test_what_makes_no_field_is_refused_in_words(text: str, why: str) -> None:
    with pytest.raises(RingError, match=why):
        ring(text)


@subcases("name", SPELLED)
def test_numbers_in_names_have_their_values(name: str) -> None:
    K = ring(name)
    assert K.degree == SPELLED[name]
    for text, x in K.parts.items():
        assert K(text) == x
        assert K(K.text(x)) == x
        number = next(n for n in K._numbers if n.text == text)
        assert (
            abs(K.embed(x) - number.value(64)).abs_lower() < 1e-12 or K.principal >= K.signature[0]
        )
    theta = K.gen
    assert not sum((theta**n * c for n, c in enumerate(K.polynomial.coeffs())), K.zero)


def test_both_roots_of_a_field_with_several_are_read_and_printed() -> None:
    K = ring("QQ(sqrt(2),sqrt(3))")
    x = K("(sqrt(2)+sqrt(3))^3")
    assert str(x) == "11*sqrt(2)+9*sqrt(3)"
    assert K("sqrt(6)") == K("sqrt(2)") * K("sqrt(3)")
    assert K.sqrt(K("5+2*sqrt(6)")) == K("sqrt(2)+sqrt(3)")
    assert x.minimal_polynomial() == [1, 0, -970, 0, 1]
    assert QuaternionAlgebra.from_text("(sqrt(2),sqrt(3)|QQ(sqrt(2),sqrt(3)))").constants.a == K(
        "sqrt(2)"
    )


@subcases("name", [*SPELLED, "QQ[s]/(s^3-2)", "QQ[s]/(s^5-s+1)", "QQ[s]/(2*s^3+s-1/3)"])
def test_norm_trace_and_values_are_those_of_the_conjugates(name: str) -> None:
    K, rng = ring(name), Random(name)
    real = K.signature[0]
    for _ in range(5):
        x, y = K.random(rng), K.random(rng)
        values = [K.embed(x, n, 30) for n in range(sum(K.signature))]
        conjugates = [*values, *(z.conjugate() for z in values[real:])]
        norm, trace = prod(conjugates[1:], start=conjugates[0]), sum(conjugates)
        assert norm.real.overlaps(arb(x.norm()))
        assert trace.real.overlaps(arb(x.trace()))
        assert (x * y).norm() == x.norm() * y.norm()
        assert [x.sign(n) for n in range(real)] == [
            int(float(z.real.mid()) > 0) * 2 - 1 for z in values[:real]
        ]
        f = x.minimal_polynomial()
        assert not sum((x**n * c for n, c in enumerate(f)), K.zero)
        assert K.degree % (len(f) - 1) == 0


@subcases("name", [*SPELLED, "QQ[s]/(s^3-2)", "QQ[s]/(s^4-s-1)", "QQ[s]/(s^6+3*s+3)"])
def test_square_roots_are_found_and_distinguished(name: str) -> None:
    K, rng = ring(name), Random(1)
    for _ in range(6):
        x = K.random(rng)
        assert K.sqrt(x * x) in (x, -x)
        if x:
            for p in (2, 3, 5, 7):
                P = K.primes_above(p)[0]
                if P.valuation(x) % 2:
                    assert K.sqrt(x) is None
                assert K.sqrt(x * x * P.uniformiser) is None or P.valuation(P.uniformiser) % 2 == 0
    assert K.sqrt(K.zero) == 0
    assert K.sqrt(K(Fraction(4, 9))) == Fraction(2, 3)


def test_elements_are_values() -> None:
    K = ring("QQ[s]/(s^3-2)")
    s = K.gen
    assert {1 + s: 1}[K("s+1")] == 1
    assert hash(K(3)) == hash(K(6) / 2) == hash(3)
    assert pickle.loads(pickle.dumps(s)) == s
    assert (s / 2 + Fraction(1, 3), 1 / s, 2 - s, s**-2) == (
        K("1/3+s/2"), K("s^2/2"), K("2-s"), K("1/2*s")
    )  # fmt: skip
    assert s != ring("QQ(root(2,3))").gen
    with pytest.raises(TypeError):
        s + ring("QQ(root(2,3))").gen
    with pytest.raises(CoercionError, match="no square root"):
        K("sqrt(s)")
    with pytest.raises(NotInvertibleError):
        K.inverse(K.zero)
    with pytest.raises(RingError, match="no real place number 1"):
        K.sign(s, 1)
    with pytest.raises(RingError, match="no embedding number 2"):
        K.embed(s, 2)
    assert float(s.complex(digits=40).real.rad()) < 1e-39


@pytest.mark.slow
@subcases("case", FIELDS)
def test_integers_and_prime_ideals_are_those_of_pari(case: dict) -> None:
    K = field(case["polynomial"])
    assert K.discriminant() == case["discriminant"]
    assert list(K.signature) == case["signature"]
    basis = K.integral_basis()
    assert basis[0] == 1
    assert all(map(K.is_integral, basis))
    elements = [K(x) for x in case["elements"]]
    for found in case["primes"]:
        p, above = found["p"], K.primes_above(found["p"])
        assert len(above) == len(found["above"])
        for data in found["above"]:
            P = prime(K, p, data["gen"])
            assert (P.p, P.e, P.f) == (p, data["e"], data["f"])
            assert [P.valuation(x) for x in elements] == data["valuations"]
            assert (
                K.residue_size(P)
                if hasattr(K, "residue_size")
                else P.residue_field.order == P.norm()
            )
            assert all(g in P for g in P.generators)
            assert [Q.valuation(P.uniformiser) for Q in above] == [int(Q == P) for Q in above]
            assert place_of_number_field(K, str(P)) == P
            assert pickle.loads(pickle.dumps(P)) == P


@pytest.mark.parametrize(
    "polynomial", ["x^3-x^2-2*x-8", "x^4-10*x^2+1", "x^6-2*x^3+2", "x^4+7*x^2+4*x+2"]
)
def test_residues_are_a_ring_homomorphism(polynomial: str) -> None:
    K, rng = field(polynomial), Random(2)
    for p in (2, 3, 5):
        for P in K.primes_above(p):
            F, seen = P.residue_field, set()
            for _ in range(60):
                x, y = K.random(rng), K.random(rng)
                if not (x and y) or P.valuation(x) < 0 or P.valuation(y) < 0:
                    continue
                assert P.reduce(x) + P.reduce(y) == P.reduce(x + y)
                assert P.reduce(x) * P.reduce(y) == P.reduce(x * y)
                assert F.is_zero(P.reduce(x)) == (P.valuation(x) > 0)
                assert P.reduce(P.lift(P.residue_of(x))) == P.reduce(x)
                seen.add(F.key(P.reduce(x)))
            assert len(seen) > 1
            with pytest.raises(RingError, match="no residue"):
                P.reduce(P.inverse_uniformiser)


def test_places() -> None:
    K = ring("QQ[s]/(s^3-3*s-1)")
    real = K.real_places()
    assert [v.index for v in real] == [0, 1, 2]
    assert [float(v.value(K.gen).real.mid()) for v in real] == sorted(
        float(v.value(K.gen).real.mid()) for v in real
    )
    assert [v.sign(K.gen) for v in real] == [-1, -1, 1]
    assert [str(v) for v in ring("QQ[s]/(s^4-2)").infinite_places()] == ["inf0", "inf1", "inf2"]
    (P,) = K.primes_above(2)
    assert str(P) == "2"
    assert P.generators == (2, 2)
    for wrong in ("4", "(5, s+1)", "inf3", "(2, 1)", "s"):
        with pytest.raises(RingError):
            place_of_number_field(K, wrong)
    with pytest.raises(RingError, match="is a place of QQ"):
        place_of_number_field(K, ring("QQ[s]/(s^3-2)").primes_above(2)[0])
    with pytest.raises(RingError, match="not a prime number"):
        K.primes_above(6)
    with pytest.raises(RingError, match="0 has no valuation"):
        P.valuation(0)


@subcases("d", [-1, 2, 3, 5, -3, -7, -2, 13, 17, -15, 6, 33])
def test_quadratic_fields_have_the_same_methods(d: int) -> None:
    K, L = ring(f"QQ(sqrt({d}))"), NumberField(f"x^2-({d})", "s")
    assert K.degree == 2
    assert K.discriminant() == L.discriminant()
    assert K.integral_basis()[0] == 1
    for p in (2, 3, 5, 7, 11, 13, 17):
        ours, theirs = K.primes_above(p), L.primes_above(p)
        assert sorted((P.e, P.f) for P in ours) == sorted((P.e, P.f) for P in theirs)
        for P in ours:
            assert all(g in P for g in P.generators)
            assert [min(Q.valuation(g) for g in P.generators) > 0 for Q in ours] == [
                Q == P for Q in ours
            ]
        rng = Random(d)
        for _ in range(8):
            u, v, w = rng.randint(1, 60), rng.randint(-60, 60), rng.randint(1, 30)
            x, y = (F(Fraction(u, w)) + F.gen * F(Fraction(v, w)) for F in (K, L))
            assert sorted(P.valuation(x) for P in ours) == sorted(P.valuation(y) for P in theirs)
    signs = [v.sign(K.gen) for v in K.real_places()]
    assert signs == [v.sign(L.gen) for v in L.real_places()] == ([-1, 1] if d > 0 else [])
    assert [v.index for v in K.real_places()] == [*range(len(signs))]


@pytest.mark.parametrize(
    ("name", "level"),
    [("QQ(zeta5)", 2), ("QQ(zeta7)", 4), ("QQ(zeta8)", 1), ("QQ(zeta11)", 2), ("QQ(zeta7)+", float("inf")),
     ("QQ[s]/(s^4+7*s^2+4*s+2)", 2), ("QQ(sqrt(-7),root(2,3))", 4)],
)  # fmt: skip
def test_levels(name: str, level: float) -> None:
    K = ring(name)
    assert K.level.value == level
    squares = K.minus_one_as_squares()
    assert len(squares) == (0 if level == float("inf") else level)
    assert not squares or sum((x * x for x in squares), K.one) == 0


@pytest.mark.parametrize(
    ("source", "target"),
    [
        ("QQ(zeta5)", "QQ(zeta15)"), ("QQ(zeta7)+", "QQ(zeta7)"), ("QQ[s]/(s^3-2)", "QQ(root(2,3),zeta3)"),
        ("QQ(sqrt(2),sqrt(3))", "QQ(sqrt(2),sqrt(3),I)"), ("QQ(root(2,3))", "QQ[s]/(s^3-2)"),
        ("QQ[s]/(s^2-5)", "QQ(zeta5)"), ("QQ(sqrt(5))", "QQ(zeta5)"), ("QQ(I)", "QQ(zeta12)"),
        ("QQ", "QQ(zeta5)"),
    ],
)  # fmt: skip
def test_fields_map_into_larger_ones(source: str, target: str) -> None:
    F, rng = embedding(ring(source), ring(target)), Random(1)
    K, L = ring(source), ring(target)
    for _ in range(5):
        x, y = K.random(rng), K.random(rng)
        assert F(x * y) == F(x) * F(y)
        assert F(x + y) == F(x) + F(y)
        assert L(F(x)) == F(x)
        if hasattr(K, "embeddings"):
            assert (L.embed(F(x)) - K.embed(x)).contains(0)


def test_fields_that_do_not_map_say_so() -> None:
    with pytest.raises(CoercionError, match="contains no root"):
        embedding(ring("QQ(zeta5)"), ring("QQ(zeta7)"))
    for target in ("QQ(x)", "GF(7)"):
        with pytest.raises(CoercionError, match="has no image"):
            embedding(ring("QQ[s]/(s^3-2)"), ring(target))(ring("QQ[s]/(s^3-2)").gen)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("QQ(sqrt(2)+sqrt(3))", "QQ(sqrt(2),sqrt(3))"),
        ("QQ(√2 - √3/2)", "QQ(sqrt(2),sqrt(3))"),
        ("QQ((1+sqrt(5))/2)", "QQ(sqrt(5))"),
        ("QQ(1+root(2,3))", "QQ(root(2,3))"),
        ("QQ(zeta5^2)", "QQ(zeta5)"),
        ("QQ(-I)", "QQ(I)"),
        ("QQ(I+sqrt(2))", "QQ(sqrt(2),I)"),
    ],
)
def test_a_sum_of_roots_generates_their_field(text, name):
    K = ring(text)
    assert K.name == name
    if isinstance(K, NumberField):
        x = K(from_unicode("".join(text.split()))[3:-1])
        assert len(x.minimal_polynomial()) == K.degree + 1


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("QQ(sqrt(2)*sqrt(3))", r"smaller than .*: write QQ\[s\]/\(s\^2-6\)"),
        ("QQ(zeta5+1/zeta5)", r"smaller than .*: write QQ\[s\]/\(s\^2\+s-1\)"),
        ("QQ(sqrt(2)^2)", "is QQ itself"),
        ("QQ(root(2,3)^3)", "write QQ$"),
        ("QQ(x+sqrt(2))", "'x' means nothing.*write its polynomial"),
        ("QQ(1/0+sqrt(2))", "cannot divide by 0"),
        ("QQ(sqrt(2)+)", "write its polynomial"),
    ],
)
def test_a_sum_that_generates_less_or_is_not_read(text, why):
    with pytest.raises(RingError, match=why):
        ring(text)


def test_embeddings_and_digits_that_there_are_not():
    x = ring("QQ[s]/(s^4-s-1)").gen
    for digits in (0, -3, 1.5, "5", 10**9):
        with pytest.raises(CoercionError, match="number of digits from 1"):
            x.complex(0, digits=digits)
    for place in (3, -1, "a", 2.0):
        with pytest.raises(RingError, match="has no embedding number"):
            x.complex(place)
    for place in (2, -1):
        with pytest.raises(RingError, match="no real place number"):
            x.sign(place)
    with pytest.raises(RingError, match=r"QQ\(zeta5\) QQ\[s\]/\(s\^3-2\)"):
        ring("foo")

"""ℚ[s]/(f) in the checker: no reducible modulus, all real places, prime ideals and nothing like them."""

import random
from collections.abc import Sequence
from fractions import Fraction
from math import prod

import pytest
from flint import fmpz_poly, nmod_poly

from hfield.checker.anisotropy import is_certified
from hfield.checker.budget import bounded
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import (
    BITS,
    check_irreducible,
    cyclotomic,
    factor_degrees,
    root_discs,
    twice_cosine,
)
from hfield.checker.scalars.real_roots import real_roots
from tests.checker import ring_data
from tests.checker.ring_data import (
    INFINITY,
    QQ,
    Data,
    completion,
    generated,
    ideal,
    multiquadratic,
    number,
    other,
    prime,
    quadratic,
    read_field,
    root_field,
)
from tests.steps import steps
from tests.subcases import subcases
from tests.thorough import cases


def refused(data: Data) -> str:
    try:
        with bounded():
            read_ring(data)
    except Rejected as error:
        return str(error)
    pytest.fail(f"{data} is read")


def is_irreducible(f: Sequence[int]) -> bool:
    _, factors = fmpz_poly(list(f)).factor()
    return len(factors) == 1 and factors[0][1] == 1


@pytest.mark.slow
def test_what_is_reducible_is_no_field() -> None:
    """Small polynomials of degree 2 to 6, and products that no prime tells from irreducible ones."""
    rng = random.Random(5)
    both = {True: 0, False: 0}
    for _ in range(cases(400)):
        f = [rng.randint(-3, 3) for _ in range(rng.randint(2, 6))] + [1]
        if rng.random() < 0.3:
            f = [
                int(c)
                for c in fmpz_poly(f) * fmpz_poly([rng.randint(-3, 3), rng.randint(-2, 2), 1])
            ]
        right = is_irreducible(f)
        both[right] += 1
        try:
            check_irreducible(f, "it")
        except Rejected:
            assert not right, f
        else:
            assert right, f
    assert min(both.values()) > 10


@pytest.mark.parametrize(
    ("f", "right"),
    [
        ([1, 0, 0, 0, 1], True),  # modulo every prime it is a product of two
        ([1, 0, -10, 0, 1], True),
        ([576, 0, -960, 0, 352, 0, -40, 0, 1], True),  # √2 + √3 + √5
        ([4, 0, 0, 0, 1], False),
        ([-4, 0, 0, 0, 1], False),
        ([1, 0, 0, 0, 0, 0, 1], False),
        ([1, 0, 1, 0, 1], False),
    ],
)
def test_where_no_prime_helps(f: list[int], right: bool) -> None:
    assert is_irreducible(f) == right
    if right:
        check_irreducible(f, "it")
    else:
        with pytest.raises(Rejected, match="may be reducible"):
            check_irreducible(f, "it")


def test_degrees_of_factors_modulo_primes() -> None:
    rng, seen = random.Random(2), 0
    for _ in range(cases(200)):
        p = rng.choice([2, 3, 5, 31])
        f = [rng.randint(-9, 9) for _ in range(rng.randint(1, 12))] + [1]
        factors = nmod_poly(f, p).factor()[1]
        expected = sorted(g.degree() for g, _ in factors)
        found = factor_degrees(f, p)
        if found is None:
            assert any(e > 1 for _, e in factors), f
        else:
            assert sorted(found) == expected, f
            seen += 1
    assert seen > 20


@pytest.mark.parametrize("n", [16, 20, 33, 40])
def test_irreducible_polynomials_of_large_degree(n: int) -> None:
    """Xⁿ − X − 1 is irreducible (Selmer), and its group is that of all permutations."""
    check_irreducible([-1, -1, *[0] * (n - 2), 1], "it")


LONG, CUBE = 4**1000, generated([-2, 0, 0, 1])


@subcases(
    ("data", "why"),
    [
        (generated([4, 0, 0, 0, 1]), "may be reducible"),
        (generated(["-1/4", 0, 1]), "may be reducible"),
        (generated([1, -2, 1]), "are not parted here"),
        (generated([0, 0, 0, 0, 1]), "are not parted here"),
        (root_field(4, 4), "may be reducible"),
        (root_field(-4, 4), "may be reducible"),
        (root_field(8, 3), "may be reducible"),
        (root_field(2, 2), "expected a root of order 3 to 40"),
        (root_field(2, 41), "expected a root of order 3 to 40"),
        (root_field("1/0", 3), "a radicand must be an integer or a text such as '-1/2'"),
        (root_field("4/2", 3), "a radicand must be an integer or a text such as '-1/2'"),
        (root_field(2.0, 3), "a radicand must be an integer"),
        (root_field(2, "3"), "an order must be an integer"),
        (ring_data.cyclotomic(401), "of too large an order"),
        *((ring_data.cyclotomic(n, real), "at least 3") for n in (0, 1, 2, -5) for real in (False, True)),
        *((ring_data.cyclotomic(n, True), "the degree is from 2") for n in (3, 4, 6)),
        (ring_data.cyclotomic(43), "the degree is from 1 to 40"),
        (ring_data.cyclotomic("5"), "an order must be an integer"),
        (generated([0]), "has 1 entries; expected 2"),
        (generated([7]), "has 1 entries; expected 2"),
        (generated([-1, 0, 2]), "is not monic"),
        (generated([-1, 0, 1, 0]), "is not monic"),
        (generated([-1, 0, "1/2"]), "is not monic"),
        (generated([1, "2/4", 1]), "a coefficient must be an integer or a text such as '-1/2'"),
        (generated([1, "2", 1]), "a coefficient must be an integer or a text such as '-1/2'"),
        (generated([1, 2.0, 1]), "a coefficient must be an integer"),
        (generated([1, [1], 1]), "a coefficient must be an integer"),
        (generated([1, 0, 1], "e"), "cannot name a variable"),
        (generated([1, 0, 1], "I"), "cannot name a variable"),
        (generated([1, 0, 1], ""), "cannot name a variable"),
        (generated([1, 0, 1], None), "a variable must be a text"),
        (generated([-LONG, 0, 1]), "are too large"),
        (generated([-(4**90), 0, 1]), "may be reducible"),
        (generated([1, *[0] * 15, 1]), "is irreducible is shown up to the degree 14"),
        # Completions at what is not a place.
        *((completion(base, INFINITY), "a prime number must be an integer") for base in (QQ, quadratic(-1))),
        *((completion(base, prime(0, 1)), "must be an integer") for base in (QQ, quadratic(-1))),
        (completion(CUBE, INFINITY), "no place of the kind 'infinity'"),
    ],
)  # fmt: skip
def test_data_of_no_field(data: Data, why: str) -> None:
    said = refused(data)
    assert why in said


def test_roots_lie_in_their_discs() -> None:
    for f in ([-2, 0, 0, 1], [1, 0, 0, 0, 1], [-6, 11, -6, 1], [5, -3, 0, 0, 0, 1]):
        roots = [(float(z.real), float(z.imag)) for z, _ in fmpz_poly(f).complex_roots()]
        discs = [tuple(x / 2**BITS for x in disc) for disc in root_discs(f)]
        for x, y in roots:
            near = [d for d in discs if abs(d[0] - x) + abs(d[1] - y) < 1e-9 + d[2]]
            assert len(near) == 1
            assert near[0][2] < 1e-30
    for f, said in (
        ([0, 0, 1], "not parted"),
        ([1, 2, 1], "not parted|not found"),
        ([2**201, 0, 1], "too large"),
    ):
        with pytest.raises(Rejected) as caught:
            root_discs(f)
        assert any(part in str(caught.value) for part in said.split("|"))


def test_real_roots_are_those_of_flint() -> None:
    rng, seen = random.Random(3), 0
    while seen < 60:
        f = [rng.randint(-9, 9) for _ in range(rng.randint(2, 8))] + [1]
        scale = rng.choice((1, 2, 3))
        monic = [Fraction(c, scale ** (len(f) - 1 - n)) for n, c in enumerate(f)]
        if not is_irreducible(f):
            continue
        seen += 1
        right = sorted(
            float(z.real) for z, _ in fmpz_poly(f).complex_roots() if abs(float(z.imag)) < 1e-12
        )
        found = real_roots(monic)
        assert len(found) == len(right)
        for root, x in zip(found, right, strict=True):
            for y in (-1, 2):
                q = Fraction(int(x / scale * 1000) + y, 1000)
                assert root.sign([-q, Fraction(1)]) == (1 if x / scale > q else -1)
            assert root.sign([Fraction(0)] * 2) == 0
            assert root.sign([Fraction(-3)]) == -1
            assert root.sign(monic[:-1]) == (-1 if (x / scale) ** (len(f) - 1) > 0 else 1)
    with pytest.raises(Rejected, match="double root"):
        real_roots([Fraction(1), Fraction(2), Fraction(1)])


def test_signs_that_are_too_close_are_given_up() -> None:
    root = real_roots([Fraction(-2), Fraction(0), Fraction(0), Fraction(1)])[0]
    close = Fraction(2)
    for _ in range(13):  # Newton's steps: 2^13 bits are right
        close = (2 * close + 2 / close**2) / 3
        close = Fraction(int(close * 2**9000), 2**9000)
    with pytest.raises(Rejected, match=r"more work|too many halvings"), bounded():
        root.sign([-close, Fraction(1)])


def test_sturms_sequence_stays_small() -> None:
    """Of degree 40, coefficients of eight digits: where contents stay in, it did not end in a minute."""
    rng = random.Random(5)
    f = [2 * rng.randrange(-(10**8), 10**8) + (n in (0, 3, 4, 5)) for n in range(40)] + [1]
    data = generated(f)
    assert steps(lambda: read_ring(data)) < 10**6
    name = read_ring(data).name
    count = steps(lambda: real_roots([Fraction(c) for c in f]))
    assert count < 10**6
    with bounded():
        assert is_certified(f"(-1,-1|{name})", data, {"by": "ordering"})


@subcases("n", [3, 4, 5, 7, 8, 9, 12, 15, 16, 20, 21, 30, 60, 105])
def test_roots_of_unity(n: int) -> None:
    assert cyclotomic(n) == [int(c) for c in fmpz_poly.cyclotomic(n)]
    # with z + 1/z for s, times z^half, it is the cyclotomic polynomial
    f = twice_cosine(n)
    half, z = len(f) - 1, fmpz_poly([0, 1])
    total = sum((c * (z * z + 1) ** k * z ** (half - k) for k, c in enumerate(f)), fmpz_poly())
    assert total == fmpz_poly.cyclotomic(n)


def test_arithmetic() -> None:
    field, rng = read_field("QQ[s]/(s^4-s/3+5/2)"), random.Random(1)
    s = field.read("s")
    assert field.read("s^4") == field.read("s/3 - 5/2")
    assert field.inverse(field.zero) is None
    for _ in range(20):
        x = tuple(Fraction(rng.randint(-5, 5), rng.randint(1, 4)) for _ in range(4))
        y = tuple(Fraction(rng.randint(-5, 5)) for _ in range(4))
        assert field.mul(x, field.add(y, s)) == field.add(field.mul(x, y), field.mul(s, x))
        if any(x):
            assert field.mul(x, field.inverse(x)) == field.one
    assert field.constant(("name", "t")) is None
    assert field.signs(s) == (None,)  # there is no real root
    assert not field.is_ordered


def test_squares_and_levels() -> None:
    field = read_field("QQ[s]/(s^3-2)")
    for text, right in (("4", True), ("9/4", True), ("0", True), ("-1", False), ("s - 2", False)):
        assert field.is_square(field.read(text)) == right
    for text in ("5", "3", "s"):  # by a residue
        assert not field.is_square(field.read(text))
    with pytest.raises(Rejected, match="is not decided here"):
        field.is_square(field.read("(s + 3)^2"))
    for name, levels in (
        ("QQ[s]/(s^3-2)", (1, 2, 3, 100)),  # it is real
        ("QQ(zeta5)", (1,)),  # 2 has the even degree 4
        ("QQ(zeta7)", (1, 2, 3)),  # 2 has the degree 3
        ("QQ(zeta8)", ()),
        ("QQ[s]/(s^2+s+2)", (1, 2, 3)),  # 2 splits
        ("QQ[s]/(s^2+7)", (1,)),  # the same field, but 2 divides the index of ℤ[s]
        ("QQ[s]/(s^2+1/4)", ()),
        ("QQ[s]/(s^4+s^2+2)", (1,)),
    ):
        found = tuple(n for n in (1, 2, 3, 100) if read_field(name).level_above(n))
        assert found == levels, name


@subcases(
    ("field", "place", "why"),
    [
        (CUBE, ideal(2, 0, 1, 0), ""),
        (CUBE, ideal(5, -3, 1, 0), ""),
        (CUBE, ideal(5, 4, 3, 1), ""),
        (CUBE, ideal(7), ""),
        (CUBE, ideal(3, 1, 1, 0), ""),
        (generated([-1, "-1/3", 1]), ideal(2), ""),
        (CUBE, ideal(5), "reducible"),
        (CUBE, ideal(2), "reducible"),
        (CUBE, ideal(5, -2, 1, 0), "is not a prime ideal"),
        (CUBE, ideal(5, 1, 0, 1), "reducible"),
        (CUBE, ideal(5, 2, 0, 1), "is not a prime ideal"),
        (CUBE, ideal(5, 3, 0, 0), "a prime ideal needs a polynomial"),
        (CUBE, ideal(5, 0, 5, 0), "a prime ideal needs a polynomial"),
        (CUBE, ideal(5, 0, "1/5", 0), "a number is not integral at 5"),
        (CUBE, ideal(5, 0, "5/5", 0), "a coefficient must be an integer or a text"),
        (CUBE, ideal(5, 0, 1.0, 0), "a coefficient must be an integer"),
        (CUBE, ideal(5, -3, 1), "has 3 coefficients"),
        (CUBE, ideal(5, -3, 1, 0, 0), "has 3 coefficients"),
        (CUBE, ideal(6, 0, 1, 0), "6 is not a prime"),
        (CUBE, ideal(6), "6 is not a prime"),
        (CUBE, ideal(0, 0, 1, 0), "must be at least 2"),
        (CUBE, ideal(1, 0, 1, 0), "must be at least 2"),
        (CUBE, ideal("5", -3, 1, 0), "a prime number must be an integer"),
        (CUBE, {**ideal(7), "element": []}, "has 3 coefficients"),
        (CUBE, {**ideal(7), "element": "s"}, "an element must be a list"),
        (CUBE, {**ideal(7), "more": 1}, "unknown key 'more'"),
        (CUBE, {"kind": "prime ideal", "p": 7}, "lacks the key 'element'"),
        (CUBE, number(7), "no place of the kind 'number'"),
        (generated([-1, "-1/3", 1]), ideal(3, 0, 1), "is not integral at 3"),
        (generated([-45, 0, 1]), ideal(3, 0, 1), "is not a valuation ring"),
        (generated([-5, 0, 1]), ideal(2, 1, 1), "is not a valuation ring"),
        (generated([-12, 0, 1]), ideal(2, 0, 1), "is not a valuation ring"),
        (CUBE, {**other(5, [2, 1], [0, 1, 0]), "element": None}, "unknown key 'element'"),
        (CUBE, other(5, [2, "1"], [0, 1, 0]), "a coefficient must be an integer"),
        (CUBE, other(5, 2, [0, 1, 0]), "a polynomial must be a list"),
        (CUBE, other(5, [2, 1], [0, 1]), "has 3 coefficients"),
        (CUBE, other(5, [2, 1], [0, "2/2", 0]), "a coefficient must be an integer or a text"),
    ],
)
def test_prime_ideals(field: Data, place: Data, why: str) -> None:
    ring = read_ring(field)
    if why:
        with pytest.raises(Rejected, match=why):
            ring.place(place)
        return
    found, p = ring.place(place), place["p"]
    assert found.residue(ring.number(p)) == found.residue(ring.zero)
    assert found.is_unit(found.residue(ring.one))
    assert not found.is_unit(found.residue(found.odd))
    assert found.residue(ring.inverse(found.odd)) is None
    assert found.residue(ring.mul(ring.inverse(found.odd), found.odd)) == found.residue(ring.one)


def test_residues_with_denominators() -> None:
    """s³ − 2 is 25 at 3, so that s − 3 has the valuation 2 at the one ideal above 5, and 0 at the other."""
    field = read_field("QQ[s]/(s^3-2)")
    first, second = field.place(ideal(5, -3, 1, 0)), field.place(ideal(5, 4, 3, 1))
    x = field.read("5/(s-3)")
    assert first.residue(x) is None
    assert second.residue(x) == second.residue(field.zero)
    y = field.read("(s-3)/5")
    assert first.residue(y) == first.residue(field.zero)
    assert second.residue(y) is None
    rng = random.Random(7)
    for place in (first, second):
        for _ in range(10):
            u, v = (
                tuple(Fraction(rng.randint(-9, 9), rng.choice((1, 2, 3, 5, 25))) for _ in range(3))
                for _ in "uv"
            )
            ru, rv = place.residue(u), place.residue(v)
            if ru is not None and rv is not None:
                k = place.residues  # type: ignore[attr-defined]
                assert place.residue(field.add(u, v)) == k.add(ru, rv)
                assert place.residue(field.mul(u, v)) == k.mul(ru, rv)
                if place.is_unit(ru):
                    assert place.residue(field.inverse(u)) == k.inverse(ru)
            elif ru is None and any(u):
                assert place.residue(field.inverse(u)) == place.residue(field.zero)


def test_several_square_roots() -> None:
    field = read_field("QQ(sqrt(2),sqrt(3))")
    assert field.signs(field.read("sqrt(2) - sqrt(3)")) == (-1, 1, -1, 1)
    assert sorted(field.signs(field.read("sqrt(6)"))) == [-1, -1, 1, 1]
    assert prod(s for s in field.signs(field.read("1 + sqrt(2) + sqrt(3)")) if s) in (1, -1)
    for text, right in (
        ("2", True),
        ("6", True),
        ("1/3", True),
        ("5", False),
        ("0", True),
        ("-2", False),
    ):
        assert field.is_square(field.read(text)) == right
    assert not field.is_square(field.read("1 - sqrt(2)"))
    with pytest.raises(Rejected, match="is not decided here"):
        field.is_square(field.read("5 + 2*sqrt(6)"))
    complex_one = read_ring(multiquadratic(2, -2, 8, -1))
    assert complex_one.signs(complex_one.one) == (None,)
    assert complex_one.is_square(complex_one.read("-2"))
    assert not complex_one.is_ordered
    assert "there are 6 square roots; at most 5" in refused(multiquadratic(2, 3, 5, 6, 7, 10))

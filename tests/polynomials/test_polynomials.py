"""Polynomials over quaternion algebras: division, and all roots against brute force and substitution."""

import json
from itertools import product
from random import Random

import numpy as np
import pytest

from hfield import (
    CoercionError,
    H,
    NotationError,
    NotInvertibleError,
    QuaternionAlgebra,
    TooLargeError,
    UndecidedError,
)
from hfield.polynomials.polynomial import Factoring
from tests.cli.running import run
from tests.subcases import first_quick, slow


def random_polynomial(P, degree, rng):
    A = P.algebra
    lower = [A(*(rng.choice((0, 0, 1, -1, 2)) for _ in range(4))) for _ in range(degree)]
    return P([*lower, 1])


@pytest.mark.parametrize("field", ["QQ", "GF(7)", "GF(9)", "QQ(x)", "GF(2)", "ZZ/6"])
def test_division(field):
    P, rng = H(field).polynomials("y"), Random(field)
    for _ in range(5):
        f, g = random_polynomial(P, 4, rng), random_polynomial(P, 2, rng)
        h, r = f.divmod_right(g)
        assert h * g + r == f
        assert r.degree < 2
        h, r = f.divmod_left(g)
        assert g * h + r == f
        q = P.algebra(1, 2, 0, 1)
        assert f.divmod_right(P([-q, 1]))[1] == P([f(q)])
        assert (f * g).norm() == f.norm() * g.norm()
        assert all(not c.vector_part for c in f.norm().coefficients)
    with pytest.raises(NotInvertibleError):
        f.divmod_right(P([1, 0]) - 1)


@pytest.mark.parametrize("text", ["(-1,-1|GF(3))", "[1,1|GF(2))", "(1,2|GF(3))"])
def test_all_roots_by_brute_force(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    P, everything = A.polynomials(), list(A.elements())
    for degree in (1, 2, 2, 2, 3, 3):
        for _ in range(6):
            f = random_polynomial(P, degree, rng)
            if not f.norm():
                continue
            roots = {q for q in everything if not f(q)}
            found = f.roots()
            spheres = {(A.ring.key(t), A.ring.key(n)) for t, n in found.spheres}

            def place(q):
                return A.ring.key(q.trace()), A.ring.key(q.norm())

            inside = {q for q in roots if place(q) in spheres and q.vector_part}
            assert all(not f(q) for q in everything if q.vector_part and place(q) in spheres)
            families = {q for q in everything if any(m.contains(q) for m in found.families)}
            assert all(m.contains(m.example) for m in found.families)
            isolated = set(found.isolated)
            assert len(isolated) == len(found.isolated)
            spherical = [P([n, -t, 1]) for t, n in found.spheres]
            scalars = {q for q in roots if not q.vector_part and any(not g(q) for g in spherical)}
            assert not isolated & scalars
            assert inside | families | isolated | scalars == roots
            assert not isolated & (inside | families)
            for q in isolated:
                assert [p for p in roots if place(p) == place(q)] == [q]


@pytest.mark.parametrize("text", ["(-1,-1|QQ)", "(2,3|QQ)", "(1,1|QQ)", "(-1,-3|QQ)"])
def test_products_of_linear_factors(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    P = A.polynomials()
    for _ in range(8):
        factors = [A(*(rng.randrange(-2, 3) for _ in range(4))) for _ in range(3)]
        f = P([2])
        for q in factors:
            f = f * P([-q, 1])
        found = f.roots()
        assert not f(factors[-1])
        last = factors[-1]
        assert (
            last in found.isolated
            or any(m.contains(last) for m in found.families)
            or any((last.trace(), last.norm()) == pair for pair in found.spheres)
        )
        assert all(not f(q) for q in (*found.isolated, *(m.example for m in found.families)))
        try:
            c, parts = f.linear_factors()
        except UndecidedError:
            assert not A.is_division_algebra()
            continue
        again = P([c])
        for q in parts:
            again = again * P([-q, 1])
        assert again == f


def test_over_the_reals_and_number_fields():
    for field in ("RR", "QQ(sqrt(5))"):
        A = H(field)
        i = A.basis[1]
        P = A.polynomials()
        f = P([1, i, 1])
        c, parts = f.linear_factors()
        assert (P([-parts[0], 1]) * P([-parts[1], 1])) * c == f
        assert len(f.roots().isolated) == 2
    f = H("QQ").polynomials()([1, "i", 1])
    assert f.roots().isolated == ()
    refused = f.linear_factors()
    assert not refused
    assert "no root" in refused.reason
    assert H("QQ").polynomials()([2, 0, 1]).roots().spheres == ((0, 2),)
    assert H("QQ").polynomials()([7, 0, 1]).roots().spheres == ()  # 7 is no sum of three squares
    assert H("RR").polynomials()([-2, 0, 1]).roots().isolated == (
        H("RR")("sqrt(2)"),
        H("RR")("-sqrt(2)"),
    )


@pytest.mark.parametrize(
    ("text", "isolated", "spheres"),
    [
        ("x^3 + (i+j)*x + 1", 3, 0),
        ("x^2 + (1+i)*x + j", 2, 0),
        slow("x^3 + i*x + j", 3, 0),
        slow("x^5 - x - 1", 1, 2),
        ("x^3 - x + 1", 1, 1),
    ],
)
def test_roots_over_the_reals_that_are_no_radicals(text, isolated, spheres):
    P = H("RR").polynomials()
    f = P.parse(text)
    found = f.roots()
    assert (len(found.isolated), len(found.spheres), found.families) == (isolated, spheres, ())
    norm = [complex(c.coordinates[0].ball(64).real.mid(), 0) for c in f.norm().coefficients]
    near = [complex(z) for z in np.roots(norm[::-1])]
    floating = [[float(c.ball(64).real.mid()) for c in q.coordinates] for q in found.isolated]
    for q in floating:  # x² − tx + n divides the norm: its roots are among those of numpy
        z = complex(q[0], sum(c * c for c in q[1:]) ** 0.5)
        assert min(abs(z - w) for w in near) < 1e-6
    for q in found.isolated:
        assert not f(q)
    for t, n in found.spheres:
        rest = f.divmod_right(P([n, -t, 1]))[1]
        assert not rest


def test_what_is_refused():
    P = H("QQ").polynomials()
    with pytest.raises(CoercionError, match="root of 0"):
        P([]).roots()
    with pytest.raises(UndecidedError, match="not factored"):
        H("RR").polynomials()(["sqrt(2)", "i+j", 0, 1]).roots()
    with pytest.raises(UndecidedError, match="over fields"):
        H("ZZ").polynomials()([1, 1]).roots()
    with pytest.raises(UndecidedError, match="a radical and zero divisors modulo it"):
        QuaternionAlgebra("QQ", 1, 0).polynomials()(["1+i", "1+i"]).roots()


def test_every_polynomial_of_degree_one_over_gf_3():
    A = H("GF(3)")
    P, some = A.polynomials(), list(A.elements())[::7]
    for a, b in product(some, some):
        f = P([a, b])
        if f and f.norm():
            found = f.roots()
            every = {q for q in A.elements() if not f(q)}
            counted = {
                q
                for q in every
                if q in found.isolated or any(m.contains(q) for m in found.families)
            }
            assert counted == every


def test_what_is_read(capsys):
    P = H("QQ").polynomials("x")
    assert P.parse("(x - i)*(x - j)/2 + x^3") == P(["k/2", "-(i+j)/2", "1/2", 1])
    for text in ("x +", "1/x", "x**-1", "y", "x**(10**9)"):
        with pytest.raises((NotationError, CoercionError, TooLargeError)):
            P.parse(text)
    status, out, _ = run(capsys, "roots", "x^2 + i*x + 1", "--field", "RR", "--format", "json")
    assert status == 0
    assert len(json.loads(out)["isolated"]) == 2
    status, out, _ = run(capsys, "roots", "x^2 + 1")
    assert (status, out) == (0, "all q of trace 0 and norm 1\n")


def test_every_root_is_printed(capsys) -> None:
    def printed(*args):
        status, out, _ = run(capsys, "roots", *args)
        assert status == 0
        return out.splitlines()

    field = ("--field", "GF7")
    assert printed("x^2-1", *field) == ["1", "6", "all q of trace 0 and norm 6"]
    assert printed("(1+2i+3j)*x", *field) == ["0", "49, such as 0"]
    assert printed("x^2-x", "--algebra", "(1,1|QQ)") == [
        "0", "1", "all q of trace 1 and norm 0",
    ]  # fmt: skip
    assert printed("(1+i)*x", "--algebra", "(1,1|QQ)") == ["0", "several, such as 0"]
    assert len(printed("x^2-1", *field, "--list")) == 58
    data = json.loads("".join(printed("(1+2i+3j)*x", *field, "--format", "json")))
    assert (data["scalars"], data["count"]) == (["0"], 49)
    family = {"trace": None, "norm": None, "example": "0", "count": 49}
    assert data["families"] == [family]
    status, _, err = run(capsys, "roots", "x^2+1", "--list")
    assert status == 2
    assert "infinitely many roots" in err


def test_isolated_roots_lie_in_no_sphere() -> None:
    # Every f of degree 2 with leading coefficient 1 over the matrices over GF(2), by substitution.
    A = QuaternionAlgebra("GF(2)", 1, 1, 1)
    P, elements = A.polynomials("x"), list(A.elements())
    for a, b in product(elements, repeat=2):
        f = P([a, b, 1])
        if not f.norm():
            continue
        found = f.roots()
        spheres = [P([n, -t, 1]) for t, n in found.spheres]
        for q in elements:
            in_sphere = any(not g(q) for g in spheres)
            in_family = any(family.contains(q) for family in found.families)
            assert (not f(q)) == (in_sphere or in_family or q in found.isolated)
            assert not (in_sphere and q in found.isolated)


def test_an_element_minus_or_times_a_polynomial() -> None:
    A = QuaternionAlgebra("QQ", -1, -1)
    x = A.polynomials("x")([0, 1])
    assert (1 - x).coefficients == (A.one, -A.one)
    i = A.basis[1]
    assert (i * x).coefficients == (A.zero, i)


@pytest.mark.parametrize("text", ["(1,1|GF(3))", "[1,1|GF(2))", "(1,2|GF(3))"])
def test_roots_of_polynomials_of_norm_0_by_brute_force(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    P, everything = A.polynomials(), list(A.elements())
    divisors = [q for q in everything if q and not q.norm()]
    tried = 0
    for _ in range(60):
        factors = [
            P([rng.choice(everything) for _ in range(rng.choice((1, 2, 3)))]) for _ in range(2)
        ]
        f = factors[0] * P([rng.choice(divisors)]) * factors[1]
        if not f:
            continue
        assert not f.norm()
        tried += 1
        roots = {q for q in everything if not f(q)}
        found = f.roots()
        assert found.isolated == ()
        spheres = {(t, n) for t, n in found.spheres}
        on_spheres = {q for q in everything if q.vector_part and (q.trace(), q.norm()) in spheres}
        assert on_spheres <= roots
        others = {q for family in found.families for q in everything if family.contains(q)}
        assert all(family.example in others for family in found.families)
        assert roots <= on_spheres | others | {
            q for q in everything if (q.trace(), q.norm()) in spheres
        }
        assert others <= roots
    assert tried > 20


def test_roots_of_norm_0_over_infinite_fields():
    for field in ("QQ", "GF(5)(t)", "QQ(sqrt(2))"):
        A = QuaternionAlgebra(field, 1, 1)
        i, j = A.basis[1], A.basis[2]
        P = A.polynomials()
        for f in (
            P([1 + i]) * P([j, 1, 1]),
            P([1, 0, 1 + i]) * P([1 - i]),
            P([1 + i]) * P([i, 2, j, 1]),
        ):
            assert not f.norm()
            for family in f.roots().families:
                assert not f(family.example)
        assert P([1 + i]).roots().families == ()


def test_divisors_and_multiples():
    for field in ("QQ", "QQ(sqrt(-7))", "QQ(x)"):
        A = H(field)
        P, rng = A.polynomials(), Random(field)
        f, g, h = (random_polynomial(P, n, rng) for n in (2, 1, 2))
        d = (f * g).gcd_right(h * g)
        assert not (f * g).divmod_right(d)[1]
        assert not (h * g).divmod_right(d)[1]
        assert d.degree >= 1
        m = f.lcm_left(h)
        assert not m.divmod_right(f)[1]
        assert not m.divmod_right(h)[1]
        assert m.degree == f.degree + h.degree - f.gcd_right(h).degree
        assert (g * f).gcd_left(g * h).degree >= 1
        m = f.lcm_right(h)
        assert not m.divmod_left(f)[1]
        assert not m.divmod_left(h)[1]


def test_elements_and_scalars_on_the_left_and_equal():
    A = H("QQ")
    i, x = A.basis[1], A.polynomials()([0, 1])
    assert i + x == x + i
    assert i - x == -(x - i)
    assert (x - x + 3, x * 0 + i) == (3, i)
    assert i == x * 0 + i
    assert hash(x * 0 + i) == hash(i)
    assert x != i
    assert len({x, x + 0, i, x * 0 + i}) == 2


def test_roots_over_many_fields_by_substitution():
    for field in (
        "QQ(sqrt(2))",
        "QQ(sqrt(-7))",
        "QQ[s]/(s^3-2)",
        "QQ(x)",
        "GF(5)(t)",
        "QQ(x,y)",
        "RR",
    ):
        A, rng = H(field), Random(field)
        P = A.polynomials()
        for _ in range(4):
            roots = [A(*(rng.randint(-1, 1) for _ in range(4))) for _ in range(2)]
            f = P([-roots[0], 1]) * P([-roots[1], 1])
            found = f.roots()
            places = [*found.spheres, *((q.trace(), q.norm()) for q in found.isolated)]
            assert len(places) + len(found.families) <= 2 or not A.is_division_algebra()
            assert all(not f(q) for q in found.isolated)
            assert not f(roots[1])
            assert (
                roots[1] in found.isolated
                or any(family.contains(roots[1]) for family in found.families)
                or (roots[1].trace(), roots[1].norm()) in found.spheres
            )
            c, factors = f.linear_factors()
            again = P([c])
            for q in factors:
                again = again * P([-q, 1])
            assert again == f


def test_a_product_of_choices_over_a_split_algebra():
    A = QuaternionAlgebra("GF(3)", 1, 1)
    P, rng, everything = A.polynomials(), Random(5), list(A.elements())
    for _ in range(20):
        roots = [rng.choice(everything) for _ in range(3)]
        f = P([1])
        for q in roots:
            f = f * P([-q, 1])
        try:
            found = f.linear_factors()
        except UndecidedError:
            continue
        assert found


def test_every_product_of_two_over_a_split_algebra_and_no_other():
    A = QuaternionAlgebra.from_text("[1,1|GF(2))")
    P, elements = A.polynomials(), list(A.elements())
    products = {P([-p, 1]) * P([-q, 1]) for p in elements for q in elements}
    assert len(products) < 256
    for a, b in product(elements, elements):
        f = P([a, b, 1])
        found = f.linear_factors()
        assert bool(found) == (f in products)
        if found:
            c, (p, q) = found
            assert c == 1
            assert P([-p, 1]) * P([-q, 1]) == f


@pytest.mark.parametrize("text", ["(-1,-1|GF(3))", "(1,2|GF(5))"])
def test_products_over_finite_fields_are_factored(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    P = A.polynomials()
    for degree in (2, 3, 4, 5):
        f = P([1])
        for _ in range(degree):
            f = f * P([A.random_element(rng.randrange(10**6)), 1])
        c, parts = f.linear_factors()
        again = P([c])
        for q in parts:
            again = again * P([-q, 1])
        assert again == f


def test_products_of_three_and_no_others():
    A, rng = QuaternionAlgebra.from_text("[1,1|GF(2))"), Random(8)
    P, elements = A.polynomials(), list(A.elements())
    two = {P([-p, 1]) * P([-q, 1]) for p in elements for q in elements}
    products = {f * P([-q, 1]) for f in two for q in elements}
    centre = [P([n, -t, 1]) * P([q, 1]) for t in (0, 1) for n in (0, 1) for q in elements]
    drawn = [P([*rng.sample(elements, 3), 1]) for _ in range(150)]
    found = [bool(f.linear_factors()) for f in (*centre, *drawn)]
    assert found == [f in products for f in (*centre, *drawn)]
    assert set(found) == {True, False}


@pytest.mark.parametrize("text", ["[1,1|GF(2))", "(-1,-1|GF(3))"])
def test_all_roots_are_tried_over_a_finite_field(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(4)
    P, kinds = A.polynomials(), set()
    nilpotent = next(q for q in A.elements() if q and not q * q)
    for f in (
        P([1, 0, 1]) * random_polynomial(P, 1, rng),
        P([1, 1, 1]) * random_polynomial(P, 1, rng),
        P([0, nilpotent, 1]),
        P([0, 0, 1, 1]),
        P([nilpotent]) * P([1, 1]),
        *(random_polynomial(P, 3, rng) for _ in range(20)),
    ):
        found = f.roots()
        kinds |= {n for n, some in enumerate((found.spheres, found.families)) if some}
        tried = set(Factoring(A, False).roots(f, found))
        assert tried == {q for q in A.elements() if not f(q)}
    assert kinds == {0, 1}


@pytest.mark.parametrize("degree", first_quick([1, 4, 2, 3, 5], 2))
def test_exact_roots_over_the_reals_are_short_and_near_floats(degree):
    """Against eigenvalues of the companion matrix; a root has the degree n·(2n − 1), and a text to suit."""
    A, rng = H("RR"), Random(degree)
    P = A.polynomials()
    for _ in range(4 if degree < 4 else 1):
        f = P([A(*(rng.randint(-3, 3) for _ in range(4))) for _ in range(degree)] + [A(1, 2, 0, 1)])
        roots = f.roots()
        assert len(roots.isolated) == degree
        top = f.coefficients[-1].inverse()
        companion = np.zeros((4 * degree, 4 * degree))  # of left products, on rows of coefficients
        for n in range(degree - 1):
            companion[4 * n : 4 * n + 4, 4 * n + 4 : 4 * n + 8] = np.eye(4)
        for n, c in enumerate(f.coefficients[:-1]):
            left = [[float(x.ball(64).real.mid()) for x in row] for row in (-(top * c)).matrix()]
            companion[4 * degree - 4 :, 4 * n : 4 * n + 4] = left
        near = np.linalg.eigvals(companion)
        for q in roots.isolated:
            assert f(q) == 0
            half = float(q.scalar_part.ball(64).real.mid()) if q.scalar_part else 0.0
            norm = float(q.norm().ball(64).real.mid())
            assert np.abs(near - complex(half, max(norm - half**2, 0) ** 0.5)).min() < 1e-6
            assert len(str(q)) <= (60, 400, 2000, 6000, 16000)[degree - 1]
            if degree < 4:
                assert A(str(q)) == q

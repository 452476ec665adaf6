"""Roots in every quaternion algebra over small fields, degenerate and commutative too, by brute force."""

from itertools import product
from random import Random

import pytest

from hfield import NotFiniteError, QuaternionAlgebra, TooLargeError, UndecidedError, ring
from tests.subcases import first_quick, subcases


class Everything:
    """All elements of a finite algebra, sorted by the definitions of ``Roots``."""

    def __init__(self, A):
        self.P, self.F, self.elements = A.polynomials(), A.ring, list(A.elements())
        self.own = {q: (self.F.key(q.trace()), self.F.key(q.norm())) for q in self.elements}
        self.squares = {}
        for t, n in product(self.F.elements(), repeat=2):
            g = self.P([n, -t, 1])
            within = {q for q in self.elements if not g(q)}
            self.squares[self.F.key(t), self.F.key(n)] = g, within

    def check(self, f):
        """Compare ``f.roots()`` with the definitions; return what kinds of roots there are."""
        roots = {q for q in self.elements if not f(q)}
        spheres = {
            place
            for place, (g, within) in self.squares.items()
            if any(self.own[q] == place and q.vector_part for q in within)
            and not f.divmod_right(g)[1]
        }
        on_spheres = {q for place in spheres for q in self.squares[place][1]}
        assert on_spheres <= roots
        groups = {}
        for q in roots:
            groups.setdefault(self.own[q], set()).add(q)
        single = {q for q in roots - on_spheres if len(groups[self.own[q]]) == 1}
        several = {p: g for p, g in groups.items() if len(g) > 1 and p not in spheres}
        found = f.roots()
        assert [(self.F.key(t), self.F.key(n)) for t, n in found.spheres] == list(
            dict.fromkeys((self.F.key(t), self.F.key(n)) for t, n in found.spheres)
        )
        assert {(self.F.key(t), self.F.key(n)) for t, n in found.spheres} == spheres
        members = [{q for q in self.elements if m.contains(q)} for m in found.families]
        assert all(m.example in those for m, those in zip(found.families, members, strict=True))
        assert set(found.scalars) == {q for q in roots if not q.vector_part}
        listed = list(found.elements())
        assert found.count() == len(listed) == len(roots)
        assert set(listed) == roots
        for m, those in zip(found.families, members, strict=True):
            assert m.count() == len(those)
            assert set(m.elements()) == those
        if any(m.t is None for m in found.families):
            assert not f.norm()
            assert len(members[0]) > 1
            assert members == [{q for q in roots if self.own[q] not in spheres}]
            assert not found.isolated
            return "whole"
        assert len(found.isolated) == len(single)
        assert set(found.isolated) == single
        assert dict(zip(map(self._place, found.families), members, strict=True)) == several
        return "sphere" * bool(spheres) + "family" * bool(several) + "single" * bool(single)

    def _place(self, family):
        return self.F.key(family.t), self.F.key(family.n)


CONSTANTS = {  # a, t, b
    2: list(product((0, 1), repeat=3)),
    3: [(0, 0, 0), (1, 0, 0), (0, 0, 2), (2, 0, 0), (2, 1, 0), (2, 2, 1), (0, 1, 1)],
    4: [(0, 0, 0), ("x", 0, "x+1"), (1, 1, 0), ("x", 1, 0), (0, 1, "x")],
}


@pytest.mark.parametrize("q", CONSTANTS)
def test_roots_are_those_among_all_elements(q):
    F, rng, kinds = ring(f"GF({q})"), Random(q), set()
    for a, t, b in CONSTANTS[q]:
        A = QuaternionAlgebra(F, F(a), F(b), F(t))
        everything = Everything(A)
        P, elements = everything.P, everything.elements
        lazy = [x for x in elements if x and not x.is_unit()] or elements
        for n in range({2: 30, 3: 12, 4: 4}[q]):
            pool = elements if n % 2 else lazy
            f = P([rng.choice(pool) for _ in range(rng.randint(1, 4))]) * P(
                [-rng.choice(elements), rng.choice(pool)] if n % 3 else [1]
            )
            if f:
                kinds.add(everything.check(f))
    assert {"whole", "family", "single"} <= kinds


@subcases(
    "text",
    [
        "(0,0|QQ)", "(-1,0|QQ)", "(1,0|QQ)", "(0,3|QQ)", "(0,0|GF(5)(t))", "(-1,0|QQ(sqrt(2)))",
        "(1,1|GF(2)(t))", "(t,t+1|GF(2)(t))", "(t,0|GF(2)(t))", "[t,0|GF(2)(t))",
    ],
)  # fmt: skip
def test_planted_roots_over_infinite_fields(text):
    A, rng = QuaternionAlgebra.from_text(text), Random(text)
    P, F = A.polynomials(), A.ring
    few = [F(0), F(1), F(-1), F.gen if F.characteristic else F(2)]
    nilpotent = [r for r in A.radical() if not r.norm()]

    def element():
        return A(*(rng.choice(few) for _ in range(4)))

    for n in range(12):
        q = element()
        f = P([element() for _ in range(1 + n % 3)]) * P([-q, 1])
        if n % 4 == 3 and nilpotent:
            f = P([rng.choice(nilpotent)]) * f
        if not f:
            continue
        try:
            found = f.roots()
        except UndecidedError:
            assert text in ("(1,0|QQ)", "[t,0|GF(2)(t))")  # zero divisors modulo the radical
            assert not f.norm()
            continue
        on_spheres = any(not P([n, -t, 1])(q) for t, n in found.spheres)
        assert on_spheres or q in found.isolated or any(m.contains(q) for m in found.families)
        assert not any(f(r) for r in (*found.isolated, *(m.example for m in found.families)))
        assert not any(f.divmod_right(P([n, -t, 1]))[1] for t, n in found.spheres)


@pytest.mark.parametrize(
    "text", first_quick(["(1,1|GF(2))", "[1,0|GF(2))", "(0,0|GF(2))", "[0,0|GF(2))"], 2)
)
def test_every_product_of_two_and_no_other(text):
    A = QuaternionAlgebra.from_text(text)
    P, elements = A.polynomials(), list(A.elements())
    products = {P([-p, 1]) * P([-q, 1]) for p in elements for q in elements}
    for a, b in product(elements, elements):
        f = P([a, b, 1])
        found = f.linear_factors()
        assert bool(found) == (f in products)
        if found:
            c, (p, q) = found
            assert P([c]) * P([-p, 1]) * P([-q, 1]) == f


@pytest.mark.parametrize("degenerate", [False, True])
def test_a_sample_of_all_polynomials_of_degree_two_over_gf_3(degenerate):
    F, rng = ring("GF(3)"), Random(11)
    for a, t, b in product(range(3), repeat=3):
        A = QuaternionAlgebra(F, a, b, t)
        if A.is_central_simple() == degenerate or rng.random() < 0.5:
            continue
        everything = Everything(A)
        for _ in range(3):
            f = everything.P([rng.choice(everything.elements) for _ in range(3)])
            if f:
                everything.check(f)


def test_counts_over_larger_fields_by_listing():
    for text in ("(1,1|GF(11))", "(2,0|GF(7))", "[x,1|GF(8))", "[1,0|GF(8))", "(x,1|GF(8))"):
        A = QuaternionAlgebra.from_text(text)
        P, (_, i, j, _) = A.polynomials(), A.basis
        zero_norm = A.zero_norm_element()
        for f in (
            P([-1, 0, 1]), P([0, -1, 1]), P([1, 1, 1]), P([j, 1 + i]),
            P([zero_norm]) * P([-1, 0, 1]), P([zero_norm]) * P([i, j, 1]),
        ):  # fmt: skip
            try:
                found = f.roots()
            except UndecidedError:
                continue
            listed = list(found.elements())
            assert len(set(listed)) == len(listed) == found.count()
            assert not any(map(f, listed))
            assert set(found.scalars) == {q for q in listed if not q.vector_part}


def test_what_is_infinite_is_not_counted():
    P = QuaternionAlgebra("QQ", 1, 1).polynomials()
    for text in ("x^2 - x", "(1+i)*x"):
        found = P(text).roots()
        with pytest.raises(NotFiniteError, match="infinitely many roots"):
            found.count()
    assert P("x^2 - x").roots().scalars == (0, 1)
    assert (P("x - 2").roots().count(), [*P("x - 2").roots().elements()]) == (1, [2])
    P = QuaternionAlgebra("GF(1000003)", 1, 1).polynomials()
    assert P("x^2 - 1").roots().count() == 1000003**2 + 1000003 + 2
    with pytest.raises(TooLargeError, match="too many to be listed"):
        P("x^2 - 1").roots().elements()

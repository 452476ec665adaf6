"""The engine for ideals, against sympy's Gröbner bases."""

import random

import pytest
import sympy
from flint import Ordering, fmpz_mpoly_ctx

from hfield.errors import TooLargeError
from hfield.prover.clock import Clock
from hfield.prover.polynomials.groebner import Monomials
from hfield.prover.polynomials.membership import PolynomialIdeal
from tests.subcases import subcases


def test_the_coding_of_monomials_is_an_order_and_a_product():
    mon, rng = Monomials(3), random.Random(1)
    vectors = [tuple(rng.randrange(5) for _ in range(3)) for _ in range(60)]
    order = sympy.polys.orderings.grevlex
    for a in vectors:
        assert mon.decode(mon.encode(a)) == a
        assert mon.degree(mon.encode(a)) == sum(a)
        for b in vectors:
            x, y = mon.encode(a), mon.encode(b)
            assert x + y == mon.encode(u + v for u, v in zip(a, b, strict=True))
            assert (x < y) == (order(a) < order(b))
            assert mon.divides(x, y) == all(u <= v for u, v in zip(a, b, strict=True))
            assert mon.decode(mon.lcm(x, y)) == tuple(map(max, a, b))
    with pytest.raises(TooLargeError):
        mon.encode((5000, 0, 0))


def random_polynomial(rng, gens, terms, degree):
    out = 0
    for _ in range(terms):
        term = rng.choice([1, -1, 2, 3])
        for _ in range(rng.randrange(degree + 1)):
            term = term * rng.choice(gens)
        out = out + term
    return out


@subcases("seed", range(12))
def test_membership_agrees_with_sympy(seed):
    rng = random.Random(seed)
    p = [0, 0, 2, 3, 7][seed % 5]
    context = fmpz_mpoly_ctx.get(["v0", "v1", "v2"], Ordering.degrevlex)
    gens, symbols = context.gens(), sympy.symbols("v0:3")
    generators = [random_polynomial(rng, gens, 3, 3) + 0 * gens[0] for _ in range(3)]
    targets = [random_polynomial(rng, gens, 2, 2) + 0 * gens[0] for _ in range(4)]
    targets += [sum(g * random_polynomial(rng, gens, 2, 1) for g in generators) for _ in range(3)]
    ideal = PolynomialIdeal(3, p, clock=Clock.of(20))
    ideal.extend(generators)
    assert ideal.run(10_000)

    def as_sympy(f):
        return sympy.Poly({m: int(c) for m, c in f.to_dict().items()} or 0, *symbols)

    options = {"modulus": p} if p else {"domain": "QQ"}
    basis = sympy.groebner(
        [as_sympy(g).as_expr() for g in generators], *symbols, order="grevlex", **options
    )
    for f in targets:
        found = ideal.cofactors(f)
        assert (found is not None) == basis.contains(as_sympy(f).as_expr())
        if found is not None:
            total = sum(c * g for c, g in zip(found.factors, generators, strict=True))
            rest = total - found.denominator * f
            assert rest == 0 or (p and int(rest.content()) % p == 0)

"""Number fields against PARI, live: seeded random algebras over random fields (cypari, extra ``oracles``)."""

from random import Random

import pytest

from hfield import NumberField, QuaternionAlgebra
from hfield.errors import RingError
from hfield.rings.number_primes import PrimeIdeal

cypari = pytest.importorskip("cypari", reason="cypari is not installed (extra 'oracles')")
pari = cypari.pari


@pytest.mark.parametrize("seed", range(12))
def test_random_algebras_over_random_fields(seed: int) -> None:
    rng = Random(f"live {seed}")
    K = _field(rng)
    polynomial = "+".join(f"({c})*x^{n}" for n, c in enumerate(K.polynomial.coeffs()))
    nf = pari(f"nfinit({polynomial})")
    assert K.discriminant() == int(nf[2])
    for _ in range(8):
        a, b = (K.random(rng) for _ in "ab")
        if not (a and b):
            continue
        ours = [
            P for P in QuaternionAlgebra(K, a, b).ramified_places() if isinstance(P, PrimeIdeal)
        ]
        first, second = pari(str(a)), pari(str(b))
        primes = {str(P): P for x in (pari(2), first, second) for P in nf.idealfactor(x)[0]}
        theirs = [P for P in primes.values() if int(nf.nfhilbert(first, second, P)) < 0]
        generators = [(int(P[0]), str(nf.nfbasistoalg(P[1]).lift())) for P in theirs]
        assert sorted((P.p, P.e, P.f) for P in ours) == sorted(
            (int(P[0]), int(P[2]), int(P[3])) for P in theirs
        )
        assert all(sum(K(g) in P for P in ours if P.p == p) == 1 for p, g in generators)


def _field(rng: Random) -> NumberField:
    while True:
        degree = rng.randint(3, 7)
        terms = [f"{rng.randint(-6, 6)}*x^{n}" for n in range(degree)]
        try:
            return NumberField(f"x^{degree}+{'+'.join(terms)}", "x")
        except RingError:
            continue

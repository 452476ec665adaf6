"""Make function_division.json: python scripts/vectors/make_functions.py

Needs the PyPI packages passagemath-schemes and passagemath-repl (Sage in wheels; 10.8.13 was used)
in an environment of its own. The algebra (a, b) over F(t) is a division algebra exactly where the
conic a·X² + b·Y² = Z² has no rational point; Sage's own solver for conics over F(t) (van Hoeij and
Cremona) decides. Every point it finds is put into the equation (over GF(9)(t) it cannot write points
down), and over GF(q)(t) the answer must be that of `ramified` below, which looks for square roots
among all residues. The script stops where the two differ. Where Sage breaks down, which it does for
some pairs over GF(9)(t), `ramified` decides.
"""

import re
from collections.abc import Callable
from functools import cache
from importlib.metadata import version
from itertools import product
from random import Random
from typing import Any

from common import write_cases
from sage.all__sagemath_schemes import GF, QQ, PolynomialRing
from sage.schemes.plane_conics.constructor import Conic

COUNTS = {"GF(3)(t)": 40, "GF(5)(t)": 40, "GF(7)(t)": 40, "GF(9)(t)": 40, "QQ(x)": 80}
KINDS = 8

Poly = tuple[int, ...]  # low degree first, without zeros at the end


class Small:
    """Polynomials over GF(q) written out; an element of GF(9) is c + 3d for c + d·x."""

    def __init__(self, q: int) -> None:
        self.q = q
        p = 3 if q == 9 else q
        self.p = p
        pairs = list(product(range(q), repeat=2))
        self.plus = {(u, v): (u + v) % p + p * ((u // p + v // p) % p) for u, v in pairs}
        self.times = {}
        for u, v in pairs:  # x² = x + 1 in GF(9), as x² + 2x + 2 = 0
            (d, c), (f, e) = divmod(u, p), divmod(v, p)
            self.times[u, v] = (c * e + d * f) % p + p * ((c * f + d * e + d * f) % p)
        self.minus = {u: next(v for v in range(q) if not self.plus[u, v]) for u in range(q)}
        self.squares = {self.times[u, u] for u in range(q)}
        self.roots = cache(self._squares)

    def mul(self, f: Poly, g: Poly) -> Poly:
        out = [0] * max(len(f) + len(g) - 1, 0)
        for (m, u), (n, v) in product(enumerate(f), enumerate(g)):
            out[m + n] = self.plus[out[m + n], self.times[u, v]]
        return tuple(out)

    def divmod(self, f: Poly, g: Poly) -> tuple[Poly, Poly]:
        """Divide by a monic polynomial."""
        rest, quotient = list(f), []
        while len(rest) >= len(g):
            top = rest[-1]
            quotient.append(top)
            for n, v in enumerate(g, len(rest) - len(g)):
                rest[n] = self.plus[rest[n], self.minus[self.times[top, v]]]
            rest.pop()
        while rest and not rest[-1]:
            rest.pop()
        return tuple(reversed(quotient)), tuple(rest)

    def primes(self, f: Poly) -> set[Poly]:
        """Return the monic irreducible factors, by trial division."""
        found, degree = set(), 1
        while 2 * degree < len(f):
            for low in product(range(self.q), repeat=degree):
                g = (*low, 1)
                while len(f) > degree and not self.divmod(f, g)[1]:
                    found.add(g)
                    f = self.divmod(f, g)[0]
            degree += 1
        if len(f) > 1:
            inverse = next(u for u in range(self.q) if self.times[u, f[-1]] == 1)
            found.add(self.mul(f, (inverse,)))
        return found

    def valuation(self, f: Poly, g: Poly) -> tuple[int, Poly]:
        quotient, rest = self.divmod(f, g)
        if rest:
            return 0, f
        n, unit = self.valuation(quotient, g)
        return n + 1, unit

    def _squares(self, g: Poly) -> set[Poly]:
        """Return the squares of all residues modulo g."""
        residues = product(range(self.q), repeat=len(g) - 1)
        return {self.divmod(self.mul(f, f), g)[1] for f in residues}

    def ramified(self, a: Poly, b: Poly) -> int:
        """Count the places, with that at infinity, without a local point."""
        count = 0
        for g in self.primes(a) | self.primes(b):
            (v, f), (w, h) = self.valuation(a, g), self.valuation(b, g)
            count += self.divmod(self._residue(v, f, w, h), g)[1] not in self.roots(g)
        infinite = self._residue(len(a) - 1, a[-1:], len(b) - 1, b[-1:])
        return count + (infinite[0] not in self.squares)

    def _residue(self, v: int, f: Poly, w: int, h: Poly) -> Poly:
        """Return (−1)^(vw) f^w h^v up to squares: the tame symbol of valuations v, w, units f, h."""
        out: Poly = (self.minus[1],) if v * w % 2 else (1,)
        if w % 2:
            out = self.mul(out, f)
        return self.mul(out, h) if v % 2 else out


def coefficients(f: Any, q: int) -> Poly:
    if q == 9:
        return tuple(sum(int(c) * 3**n for n, c in enumerate(e.polynomial())) for e in f)
    return tuple(map(int, f))


def draw(rng: Random, n: int, R: Any, scalar: Callable[[], Any]) -> tuple[Any, Any]:
    """Return nonzero a, b of degree at most 4, of the nth kind."""

    def poly(degree: int) -> Any:
        return R([scalar() for _ in range(rng.randint(0, degree) + 1)])

    def unit() -> Any:
        return R(next(c for c in iter(scalar, None) if c))

    def monic(degree: int) -> Any:
        return R([*(scalar() for _ in range(degree)), 1])

    def prime(degree: int) -> Any:
        return next(f for f in iter(lambda: monic(degree), None) if f.is_irreducible())

    match n % KINDS:
        case 0:
            return poly(4), poly(4)
        case 1:
            return unit(), poly(4)
        case 2:
            return unit() * prime(rng.randint(1, 2)) * prime(2), unit() * prime(rng.randint(1, 4))
        case 3:  # a square, or one up to a constant
            return rng.choice((R(1), unit())) * poly(2) ** 2, poly(4)
        case 4:  # split by design
            a, u, v = poly(2), poly(2), poly(1)
            return a, u**2 - a * v**2
        case 5:  # up to a constant algebra
            a, u, v = rng.choice((unit(), R(-1))), poly(2), poly(2)
            return a, rng.choice((unit(), R(-1))) * (u**2 - a * v**2)
        case 6:
            return R(-1), unit() * prime(rng.randint(1, 2)) * prime(rng.randint(1, 2))
        case _:  # a common factor
            f = prime(rng.randint(1, 2))
            return f * poly(2), f * poly(2)


def ask_sage(a: Any, b: Any, q: int) -> bool | None:
    """Tell whether the conic has a point; None where Sage 10.8.13 breaks down over GF(9)(t)."""
    K = a.parent().fraction_field()
    conic = Conic(K, [K(a), K(b), K(-1)])
    if q == 9:
        try:
            return bool(conic.has_rational_point())
        except TypeError:  # common factors come out wrong by a constant
            return None
    found, point = conic.has_rational_point(point=True)
    if found:
        X, Y, Z = point
        if not any((X, Y, Z)) or a * X**2 + b * Y**2 != Z**2:
            raise RuntimeError(f"({a}, {b}): {point} is no point")
    return bool(found)


def decide(a: Any, b: Any, q: int) -> tuple[bool, bool]:
    """Tell whether the algebra is a division algebra, and whether Sage says so."""
    found = ask_sage(a, b, q)
    if q:
        count = Small(q).ramified(coefficients(a, q), coefficients(b, q))
        if count % 2 or found == bool(count):
            raise RuntimeError(f"({a}, {b}): {count} ramified places, but has a point: {found}")
        return bool(count), found is not None
    return not found, True


def cases(name: str, count: int) -> list[dict[str, object]]:
    rng = Random(f"hfield functions {name}")
    q = int(size[1]) if (size := re.match(r"GF\((\d)\)", name)) else 0
    F: Any = GF(q, "x") if q else QQ
    if q == 9 and list(F.modulus()) != [2, 2, 1]:
        raise RuntimeError(f"GF(9) modulo {F.modulus()}")
    R = PolynomialRing(F, name[-2])

    def scalar() -> Any:
        if not q:
            return QQ(rng.randint(-4, 4)) / rng.choice((1, 1, 1, 1, 1, 2, 3))
        return F.gen() * rng.randrange(q) + rng.randrange(q) if q == 9 else F(rng.randrange(q))

    out: dict[tuple[str, str], dict[str, object]] = {}
    n = by_sage = 0
    while len(out) < count:
        a, b = draw(rng, n, R, scalar)
        if not a or not b:
            continue
        n += 1
        texts = str(a).replace(" ", ""), str(b).replace(" ", "")
        if texts not in out:
            division, here = decide(a, b, q)
            by_sage += here
            out[texts] = {"ring": name, "a": texts[0], "b": texts[1], "division": division}
    found = list(out.values())
    total = sum(bool(case["division"]) for case in found)
    print(f"{name}: {total} of {len(found)} are division algebras, {by_sage} decided by Sage")
    return found


if __name__ == "__main__":
    source = {
        "system": f"Sage {version('passagemath-schemes')} (passagemath)",
        "route": "Conic(F(t), [a, b, -1]).has_rational_point(); over GF(q)(t) agrees with local "
        "symbols by enumerating residues, which alone decide where Sage breaks down (9 pairs over "
        "GF(9)(t))",
        "script": "scripts/vectors/make_functions.py",
    }
    everything = [case for name, count in COUNTS.items() for case in cases(name, count)]
    write_cases("function_division.json", source, everything)

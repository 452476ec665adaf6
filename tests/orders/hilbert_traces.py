"""Traces of Hecke operators on Hilbert cusp forms from newforms, to be compared with published ones.

The published ones are those of the full cuspidal space of trivial character, level n and parallel weight k
over a real quadratic field, at the ideals m, for n and m from 1 to 5. They come from the trace formula (Magma
code of the project hilbertmodularforms, ``Tests/traces.m``, commit f5ce6582, BSD license).
"""

import json
from collections.abc import Iterator
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

from flint import fmpq, fmpq_poly

from hfield import QuaternionAlgebra, ring
from hfield.orders.newforms import Newform

FILE = Path(__file__).parents[1] / "vectors" / "hilbert_traces.json"
LEVELS = NORMS = range(1, 6)
WEIGHTS = range(2, 13, 2)
Level = tuple[tuple[Any, int], ...]


def published() -> dict[int, dict[tuple[int, int], list[int]]]:
    """By the discriminant, then by the level and the weight, the traces at 1, …, 5."""
    cases = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
    keys = list(product(LEVELS, WEIGHTS))
    return {case["discriminant"]: dict(zip(keys, case["traces"], strict=True)) for case in cases}


class Field:
    """The newforms over a real quadratic field, in the algebra that ramifies at its real places alone."""

    def __init__(self, discriminant: int) -> None:
        d = discriminant // 4 if discriminant % 4 == 0 else discriminant
        self.K = ring(f"QQ(sqrt({d}))")
        self.algebra = QuaternionAlgebra.from_ramification(self.K, self.K.real_places())
        self.newforms = cache(self._newforms)

    def exponents(self, n: int) -> dict[Any, int]:
        """The prime ideals of an integer, with their exponents."""
        return dict(self.K.ideal(n).factorisation())

    def _newforms(self, level: Level, k: int) -> list[Newform]:
        return self.algebra.eichler_order(list(level)).class_set().newforms(weight=k)

    def traces(self, n: int, k: int) -> list[int]:
        """The traces on the cusp forms of level n."""
        return [sum(self._parts(n, k, m)) for m in NORMS]

    def _parts(self, n: int, k: int, m: int) -> Iterator[int]:
        whole, norm = self.exponents(n), self.exponents(m)
        for drops in product(*(range(e + 1) for e in whole.values())):
            lower = {P: e - t for (P, e), t in zip(whole.items(), drops, strict=True)}
            for f in self.newforms(tuple((P, e) for P, e in lower.items() if e), k):
                value = fmpq_poly([1])
                for P in {**whole, **norm}:
                    value *= factor(f, P, norm.get(P, 0), lower.get(P, 0), whole.get(P, 0), k)
                yield trace(value, fmpq_poly(f.polynomial))


def trace(x: fmpq_poly, g: fmpq_poly) -> int:
    """The trace of x(α) for a root α of g: N_(d−1) for x = N/g′ modulo g, where d is the degree of g."""
    return int(fmpq((x * g.derivative() % g)[g.degree() - 1]).p)


def factor(f: Newform, P: Any, e: int, own: int, level: int, k: int) -> fmpq_poly:
    """The trace of T of Pᵉ on what the newform of level Pᵒʷⁿ gives in the level Pˡᵉᵛᵉˡ, at a root."""
    if not e:
        return fmpq_poly([level - own + 1])
    a = f.eigenvalue_polynomial(P)
    if own:
        return a**e
    before, now = fmpq_poly([2 if level else 1]), a  # power sums, or coefficients at powers of P
    for _ in range(1, e):
        before, now = now, a * now - before * P.norm() ** (k - 1)
    return now

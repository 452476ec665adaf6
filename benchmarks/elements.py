"""Single quaternions beside Sage's and PARI's in one process: products, sums, norms, inverses, ==.

    python benchmarks/elements.py [WORD…]

Needs Sage's wheels and cypari beside hfield (``pip install 'hfield[peers]'``); a peer that is not there is
left out. Both sides get the same elements, take turns, and are compared. Prints microseconds, the least of
many short runs, and our time over theirs with the bound that we hold ourselves to. Words pick lines. Where
Sage has no quaternions (characteristic 2), the formula is typed on Sage's elements of the field.
"""

import sys
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from timeit import Timer
from typing import Any

from hfield import QuaternionAlgebra, ring

OPERATIONS = {
    "product": "p*q", "sum": "p+q", "norm": "p.norm()", "inverse": "p.inverse()", "==": "p==q",
}  # fmt: skip
SAGES = OPERATIONS | {"norm": "p.reduced_norm()", "inverse": "~p"}
ROUNDS = 60


@dataclass(frozen=True)
class Case:
    """Two elements of one algebra, and the bounds of our time over Sage's for some operations.

    ``sage`` returns Sage's field for ``field``; ``texts`` are the coordinates of p and of q.
    """

    name: str
    field: str
    texts: list[str]
    bounds: dict[str, float]
    sage: Callable[[Any], Any]
    renamed: tuple[str, str] = ("s", "s")  # how we and how Sage write the generator


def random_texts(field: str) -> list[str]:
    """Return eight random elements of a field as texts."""
    F, rng = ring(field), Random(3)
    return [F.text(F.random(rng)) for _ in range(8)]


def fractions(bits: int) -> list[str]:
    """Return eight random fractions, numerators and denominators of so many bits."""
    rng = Random(bits)
    return [
        f"{rng.getrandbits(bits) - 2 ** (bits - 1)}/{rng.getrandbits(bits) | 1}" for _ in range(8)
    ]


def finite(q: int) -> Callable[[Any], Any]:
    """Return Sage's field with q elements, its modulus Conway's as ours is."""
    return lambda sage: sage.GF(q, "x")


def cases() -> list[Case]:
    """Return all lines."""
    every = {"product": 2.0, "sum": 2.0, "norm": 2.0, "inverse": 1.0, "==": 10.0}
    halves = ["1/3+1/2*s", "2/5+3*s", "-2-1/3*s", "3/4", "5", "1-1/2*s", "1/7*s", "3"]
    functions = [
        "(1/20*x^2-x-1)/x", "(-2/11*x^2-x+5)/(x^2+2)", "(3/7*x^2-1/4*x-1/2)/(x^2-x)",
        "(2*x^2-x+1)/(x^2+3*x-1)", "1/x", "(x+1)/(x^2+1)", "(x-1)/2", "3/(x+2)",
    ]  # fmt: skip
    small = ["1/3", "2/5", "-2", "3/4", "5/2", "1", "-1/7", "3"]
    return [
        Case("QQ, small fractions", "QQ", small, every, lambda sage: sage.QQ),
        Case("QQ, small integers", "QQ", list("12345678"), every, lambda sage: sage.QQ),
        Case("QQ, 1000 bits", "QQ", fractions(1000), {"product": 1.3}, lambda sage: sage.QQ),
        *(
            Case(name, name, random_texts(name), {"product": 1.0, "inverse": 3.0}, finite(p))
            for name, p in (("GF(7)", 7), ("GF(65537)", 65537))
        ),
        *(
            Case(f"GF({q})", f"GF({q})", random_texts(f"GF({q})"), {"product": bound}, finite(q))
            for q, bound in ((9, 1.5), (243, 1.5), (256, 1.5), (2**16, 4.0), (5**10, 4.0))
        ),
        Case("QQ(sqrt(-7))", "QQ(sqrt(-7))", [t.replace("s", "sqrt(-7)") for t in halves],
             {"product": 0.4}, lambda sage: sage.QuadraticField(-7, "s"), ("sqrt(-7)", "s")),
        Case("QQ[s]/(s^3-2)", "QQ[s]/(s^3-2)", halves, {"product": 2.0},
             lambda sage: sage.NumberField(sage.QQ["s"]("s^3-2"), "s")),
        Case("QQ(x)", "QQ(x)", functions, {"product": 0.3}, lambda sage: sage.QQ["x"].fraction_field()),
    ]  # fmt: skip


def least(*timers: Timer) -> list[float]:
    """Return the least microseconds of each, in turns."""
    numbers = []
    for timer in timers:
        timer.timeit(2)
        numbers.append(max(1, min(500, int(5e-4 / max(timer.timeit(3) / 3, 1e-7)))))
    best = [float("inf")] * len(timers)
    for _ in range(ROUNDS):
        for n, timer in enumerate(timers):
            best[n] = min(best[n], timer.timeit(numbers[n]) / numbers[n])
    return [1e6 * x for x in best]


class Typed(tuple):
    """Four elements of Sage's field and the formula for i² = j² = −1, where Sage has no quaternions."""

    def __mul__(self, other: Any) -> Any:
        (w1, x1, y1, z1), (w2, x2, y2, z2) = self, other
        return Typed((
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2, w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 + y1 * w2 + z1 * x2 - x1 * z2, w1 * z2 + z1 * w2 + x1 * y2 - y1 * x2,
        ))  # fmt: skip


def read(F: Any, sage: Any, text: str) -> Any:
    """Return the element of Sage's field for a text; its wheels cannot read texts everywhere."""
    if F.characteristic() or F is sage.QQ:
        return F(text)
    if not hasattr(F, "ring"):  # a number field
        return F(sage.QQ["s"](text))
    top, _, bottom = text.partition(")/") if text.startswith("(") else text.partition("/")
    polynomial = F.ring()
    return F(polynomial(top.strip("()"))) / F(polynomial(bottom.strip("()") or "1"))


def line(case: Case, sage: Any) -> None:
    """Time a case on both sides and print a line for each operation."""
    A = QuaternionAlgebra(case.field, -1, -1)
    ours = {"p": A(*case.texts[:4]), "q": A(*case.texts[4:])}
    if sage is None:
        for operation in case.bounds:
            (x,) = least(Timer(OPERATIONS[operation], globals=ours))
            print(f"{case.name:<22}{operation:<9}{x:>9.3f}")
        return
    F = case.sage(sage)
    values = [read(F, sage, text.replace(*case.renamed)) for text in case.texts]
    make: Any = Typed if F.characteristic() == 2 else sage.QuaternionAlgebra(F, -1, -1)
    theirs = {"p": make(values[:4]), "q": make(values[4:])}
    found = [str(c).replace(*reversed(case.renamed)) for c in theirs["p"] * theirs["q"]]
    assert A(*found) == ours["p"] * ours["q"], f"{case.name}: the products differ"
    for operation, bound in case.bounds.items():
        x, y = least(
            Timer(OPERATIONS[operation], globals=ours), Timer(SAGES[operation], globals=theirs)
        )
        flag = "" if x <= bound * y else "  above"
        print(
            f"{case.name:<22}{operation:<9}{x:>9.3f}{y:>9.3f}{x / y:>8.2f}  ≤ {bound}{flag}",
            flush=True,
        )


def beside_pari() -> None:
    """Time a product over ℚ beside PARI's algmul."""
    try:
        from cypari import pari
    except ImportError:
        print("PARI is not here: pip install cypari")
        return
    A = QuaternionAlgebra("QQ", -1, -3)
    ours = {"p": A("1/3", "2/5", -2, "3/4"), "q": A("5/2", 1, "-1/7", 3)}
    algebra = pari.alginit(pari.nfinit(pari("y")), pari("[-1,-3]"))
    theirs = {
        "algebra": algebra,
        "p": pari("[1/3,2/5,-2,3/4]~"),
        "q": pari("[5/2,1,-1/7,3]~"),
    }
    x, y = least(Timer("p*q", globals=ours), Timer("algebra.algmul(p, q)", globals=theirs))
    print(f"{'QQ, beside PARI':<22}{'product':<9}{x:>9.3f}{y:>9.3f}{x / y:>8.2f}  ≤ 0.7")


def main(words: list[str]) -> None:
    """Print the lines that have one of the words in their names, or all."""
    try:
        import sage.all__sagemath_schemes as sage
        from sage.algebras.quatalg.quaternion_algebra import QuaternionAlgebra as Sages

        sage.QuaternionAlgebra = Sages
    except ImportError:
        sage = None
        print("Sage is not here: pip install 'hfield[peers]'")
    print(f"{'':<22}{'':<9}{'ours, µs':>9}{'Sage, µs':>9}{'ratio':>8}")
    for case in cases():
        if not words or any(word in case.name for word in words):
            line(case, sage)
    if not words or "PARI" in words:
        beside_pari()


if __name__ == "__main__":
    main(sys.argv[1:])

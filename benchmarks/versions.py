"""Orders, ideals, class sets and groups of this tree beside those of another checkout, paired.

    python benchmarks/versions.py TREE [--over ZZ | K] [--only WORD] [--rounds N]

TREE is a folder with another version of the package (``git worktree add --detach TREE COMMIT``). A process of
each version makes the same objects anew, without anything that was computed before; then both take turns, and
each times itself with the processor's clock. What takes a short time is repeated. Prints the medians in
milliseconds, and the median of the ratios of the pairs: below 1 this tree is faster.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import pickle
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import islice, product
from pathlib import Path
from statistics import median, quantiles
from typing import Any

ROUNDS = 21
LEAST_SECONDS = 0.03
"""What takes a shorter time is repeated until it takes about this."""
MAX_REPEATED = 300
MAX_SECONDS_TO_MAKE = 0.2
"""Arguments are made for this time at most, so that fewer calls are repeated where they take long to make."""
HERE = Path(__file__).resolve().parent.parent

PRIMES = {10: (1019, 1013, 1021), 251: (5 * 2**248 - 1, 2**127 - 1, 2**128 + 51)}
"""Discriminants of algebras over QQ, and about what the norms of ideals are."""
FIELDS = {"QQ(sqrt(5))": 4999, "QQ[s]/(s^3-s^2-3*s+1)": 13}
"""Fields, and a prime below the level of orders whose class sets are computed."""

Case = tuple[Callable[[], Any], Callable[[Any], Any]]
"""A function that makes fresh arguments, and what is timed."""


# --- the cases ------------------------------------------------------------------------------------


def texts(lattice: Any) -> list[list[str]]:
    """Return a basis as texts."""
    return [[str(x) for x in q.coordinates] for q in lattice.basis]


def ideals_over_ZZ() -> dict[str, Any]:
    """Return bases of a maximal order, two left ideals, and one of the class of the first, by bits."""
    from hfield import QuaternionAlgebra
    from hfield.core.primality import is_prime

    found = {}
    for bits, (p, *norms) in PRIMES.items():
        A = QuaternionAlgebra("QQ", -1, -p)
        O = A.order(["1/2 + 1/2*j", "1/2*i + 1/2*k", "j", "k", "i"])
        q, r = (next(n for n in range(x, x + 4000) if is_prime(n)) for x in norms)
        O = O.random_ideal(q, seed=3).right_order()  # one maximal order among many
        I, J = O.random_ideal(q, seed=1), O.random_ideal(r, seed=2)
        lattices = {"O": O, "I": I, "J": J, "E": I.equivalent_of_prime_norm()[0]}
        found[str(bits)] = {name: texts(L) for name, L in lattices.items()}
    return found


def lattice_cases(name: str, O: Any, I: Any, J: Any, E: Any) -> dict[str, Case]:
    """Return what is timed of left ideals I, J and E of one order, I equivalent to E."""
    P, x = I.right_order(), I.algebra(1, 2, 3, 1)
    Q = I.algebra.order_from_basis((x * P * x.inverse()).basis)
    first, two, same, orders = map(pickle.dumps, (I, (I, J), (I, E), (P, Q)))

    works: dict[str, tuple[bytes, Callable[[Any], Any]]] = {
        "conj(I)·J": (two, lambda x: x[0].conjugate() * x[1]),
        "I + J": (two, lambda x: x[0] + x[1]),
        "I ∩ J": (two, lambda x: x[0] & x[1]),
        "norm": (first, lambda x: x.norm()),
        "inverse": (first, lambda x: x.inverse()),
        "conjugate": (first, lambda x: x.conjugate()),
        "right order": (first, lambda x: x.right_order()),
        "left order, as of a lattice": (first, lambda x: x.colon(x)),
        "I·x": (first, lambda x, q=x: x * q),
        "I·3": (first, lambda x: x * 3),
        "dual": (first, lambda x: x.dual()),
        "index": (two, lambda x: x[0].index(x[1])),
        "x in I": (first, lambda x, q=x: q in x),
        "I ≤ J": (two, lambda x: x[0] <= x[1]),
        "reduced basis": (first, lambda x: x.reduced_basis()),
        "equivalence": (same, lambda x: x[0].equivalence(x[1])),
        "isomorphism": (orders, lambda x: x[0].isomorphism(x[1])),
        "discriminant": (pickle.dumps(P), lambda x: x.discriminant()),
        "units": (pickle.dumps(P), lambda x: x.unit_group()),
    }
    return {
        f"{name}: {key}": (partial(pickle.loads, data), work) for key, (data, work) in works.items()
    }


def class_set_cases(name: str, O: Any, prime: Any) -> dict[str, Case]:
    """Return what is timed of the class set of an order, with a prime for a Brandt matrix."""
    data = pickle.dumps(O)

    def classes() -> Any:
        return pickle.loads(data).class_set()

    def classes_and_rows() -> Any:
        C = classes()
        C.neighbours(prime)
        return C

    return {
        f"{name}: class set": (partial(pickle.loads, data), lambda x: x.class_set()),
        f"{name}: class set, then a Brandt matrix": (
            partial(pickle.loads, data),
            lambda x: x.class_set().brandt_matrix(prime),
        ),
        f"{name}: Brandt matrix": (classes_and_rows, lambda x: x.brandt_matrix(prime)),
        f"{name}: types": (classes, lambda x: x.types),
    }


@cache
def cases_over_ZZ() -> dict[str, Case]:
    """Return what is timed over ℤ."""
    from hfield import QuaternionAlgebra

    found: dict[str, Case] = {}
    for bits, bases in json.loads(os.environ["IDEALS"]).items():
        A = QuaternionAlgebra("QQ", -1, -PRIMES[int(bits)][0])
        rows = {
            name: [A(*(A.ring(x) for x in row)) for row in basis] for name, basis in bases.items()
        }
        O = A.order_from_basis(rows["O"])
        found |= lattice_cases(f"{bits} bits", O, *(O.left_ideal(rows[x]) for x in "IJE"))
    for p in (101, 1009):
        O = QuaternionAlgebra.from_ramification("QQ", [p]).maximal_order()
        found |= class_set_cases(f"p = {p}", O, 2)
    O = QuaternionAlgebra.from_ramification("QQ", [11]).maximal_order()
    fresh = pickle.dumps(O)
    works: dict[str, Callable[[Any], Any]] = {
        "theta series": lambda x: x.theta_series(200),
        "ternary theta series": lambda x: x.ternary_theta_series(200),
        "ideals of norm 105": lambda x: x.ideals_of_norm(105),
        "random ideal": lambda x: x.random_ideal(1009, seed=1),
        "Eichler order of level 35": lambda x: x.algebra.eichler_order(35),
        "order of i and j": lambda x: x.algebra.order(["i", "j"]),
        "maximal overorder": lambda x: x.algebra.order(["3*i", "5*j"]).maximal_overorder(),
    }
    found |= {
        f"p = 11: {name}": (partial(pickle.loads, fresh), work) for name, work in works.items()
    }
    for a in (3, 7, 23):
        data = pickle.dumps(QuaternionAlgebra("QQ", a, -1).maximal_order())
        found[f"({a}, −1): Dirichlet domain"] = (
            partial(pickle.loads, data),
            lambda x: len(x.norm_one_group().domain().sides),
        )
    return found


@cache
def cases_over_K() -> dict[str, Case]:
    """Return what is timed over fields."""
    from hfield import QuaternionAlgebra, ring

    found: dict[str, Case] = {}
    for name, p in FIELDS.items():
        K: Any = ring(name)
        odd = K.primes_above(2)[:1] if K.degree % 2 else []
        A = QuaternionAlgebra.from_ramification(K, [*K.real_places(), *odd])
        O = A.maximal_order()
        I, J = (O.left_ideal(list(pair)) for pair in islice(elements_of_prime_norm(O, K), 2))
        y = A(1, 1, K.gen, 2)
        found |= lattice_cases(name, O, I, J, O.left_ideal([g * y for g in I.basis]))
        P = min(K.primes_above(p), key=lambda P: (P.f, str(P)))
        found |= class_set_cases(name, A.eichler_order([(P, 1)]), K.primes_above(2)[-1])
    return found


def elements_of_prime_norm(O: Any, K: Any) -> Iterator[tuple[int, Any]]:
    """Yield prime numbers p, and elements of O whose norms lie in a prime ideal of degree 1 above p."""
    for p in (11, 13, 17, 19, 23, 29, 31, 37, 41, 43):
        P = min(K.primes_above(p), key=lambda P: (P.f, str(P)))
        if P.f == 1:
            box = product(range(p), repeat=3)
            yield p, next(x for x in (O.algebra(1, *c) for c in box) if x.norm() in P)


# --- the two sides --------------------------------------------------------------------------------


def worker(over: str) -> None:
    """Time the cases named on the input, one a line; each version runs this in its own process."""
    cases = cases_over_ZZ() if over == "ZZ" else cases_over_K()
    print(json.dumps(list(cases)), flush=True)
    for line in sys.stdin:
        name, number = json.loads(line)
        make, work = cases[name]
        try:
            start = time.process_time()
            given = [make()]
            many = int(MAX_SECONDS_TO_MAKE / max(time.process_time() - start, 1e-6))
            given += [make() for _ in range(min(number, many) - 1)]
            gc.collect()
            start = time.process_time()
            for x in given:
                answer = work(x)
            took = (time.process_time() - start) / len(given)
        except Exception as error:  # a version that lacks it
            print(json.dumps([None, f"{type(error).__name__}: {error}"[:100]]), flush=True)
        else:
            shown = answer if isinstance(answer, (int, bool)) else ""
            print(json.dumps([took, str(shown)]), flush=True)


class Side:
    """A process of one version."""

    def __init__(self, tree: Path, over: str, ideals: str) -> None:
        variables = {**os.environ, "PYTHONPATH": str(tree), "IDEALS": ideals}
        self.process = subprocess.Popen(
            [sys.executable, __file__, str(tree), "--over", over, "--worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=variables,
        )
        self.names: list[str] = json.loads(self._read())

    def _read(self) -> str:
        assert self.process.stdout is not None
        return self.process.stdout.readline() or "[]"

    def time(self, name: str, number: int) -> tuple[float | None, str]:
        """Return the seconds that a case took, and its answer."""
        assert self.process.stdin is not None
        print(json.dumps([name, number]), file=self.process.stdin, flush=True)
        took, answer = json.loads(self._read())
        return took, answer

    def close(self) -> None:
        """End the process."""
        self.process.communicate()


def compare(own: Side, other: Side, name: str, rounds: int) -> str:
    """Return a line about one case."""
    (once, answer), (before, same) = own.time(name, 1), other.time(name, 1)  # imports
    if once is None or before is None:
        return f"{name:<48} {answer if once is None else same}"
    if answer != same:
        return f"{name:<48} the answers differ: {answer[:60]}, {same[:60]}"
    (once, _), (before, _) = own.time(name, 2), other.time(name, 2)
    assert once is not None
    number = max(1, min(MAX_REPEATED, int(LEAST_SECONDS / max(once, 1e-6))))
    pairs = []
    for n in range(rounds):
        order = (own, other) if n % 2 else (other, own)
        took = {id(side): side.time(name, number)[0] for side in order}
        pairs.append((took[id(own)] or 0.0, took[id(other)] or 1.0))
    ratios = [x / y for x, y in pairs]
    low, _, high = quantiles(ratios, n=4)
    mine, theirs = (median(pair[k] for pair in pairs) * 1000 for k in (0, 1))
    return f"{name:<48}{mine:10.4f}{theirs:10.4f}{median(ratios):8.3f}   ({low:.2f} to {high:.2f})"


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("tree", type=Path, help="a folder with another version")
    parser.add_argument("--over", choices=("ZZ", "K"), default="ZZ")
    parser.add_argument("--only", default="", help="cases whose name has this word")
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.worker:
        worker(args.over)
        return 0
    sys.path.insert(0, str(HERE))
    ideals = json.dumps(ideals_over_ZZ()) if args.over == "ZZ" else "{}"
    sides = [Side(tree, args.over, ideals) for tree in (HERE, args.tree.resolve())]
    print(f"{'ms':<48}{'this':>10}{'other':>10}{'ratio':>8}   (half of the ratios)")
    for name in sides[0].names:
        if args.only in name:
            print(compare(*sides, name, args.rounds), flush=True)
    for side in sides:
        side.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())

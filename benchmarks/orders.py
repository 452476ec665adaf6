"""Orders and ideals at 10, 251 and 505 bits, class sets and KLPT: hfield beside Sage in one run.

    python benchmarks/orders.py [--sage PYTHON] [--quick]

PYTHON is an interpreter that has Sage (passagemath-modules, passagemath-pari, passagemath-schemes);
without it, and where this one has none either, the column of Sage is left out. What Sage lacks, KLPT,
pairs of norms and representing integers, is a script on its objects (sage_klpt.py). Both sides get the same
ideals, make
each object anew before it is timed, so that nothing is cached, and time with the processor's clock: the
best of some rounds, or the mean over the same seeds where luck decides. The answers are compared. Prints
milliseconds and ratios.
"""

import argparse
import json
import random
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

PRIMES = {10: 1019, 251: 5 * 2**248 - 1, 505: 27 * 2**500 - 1}
NORMS = {10: (1013, 1021), 251: (2**127 - 1, 2**128 + 51), 505: (2**255 - 19, 2**256 + 297)}
OTHER = {10: 17, 251: 5, 505: 5}
"""The q of another extremal order."""
SETS = (1009, 10007)
ROUNDS = 9
SEEDS = range(1, 6)
INTEGER, KLPT = "represent an integer", "KLPT, to a power of 2"
DIVIDING, MODULO = "norm that divides 6^k", "O/qO → M₂(ℤ/q)"
GENERATORS, REDUCED, PAIR = "two generators", "reduced equivalent", "pair of norms (Qlapoti)"


def mean(make: Callable[[], Any], work: Callable[[Any, int], Any]) -> tuple[float, Any]:
    """Return the mean time in milliseconds of what depends on luck, over some seeds, and its last answer.

    The first call of all, which imports and compiles, is not counted.
    """
    work(make(), 0)
    found = [best(make, lambda x, seed=seed: work(x, seed), 1) for seed in SEEDS]
    return sum(time for time, _ in found) / len(found), found[-1][1]


def best(
    make: Callable[[], Any], work: Callable[[Any], Any], rounds: int = ROUNDS
) -> tuple[float, Any]:
    """Return the best time in milliseconds of ``work`` on fresh objects, and its answer."""
    times, answer = [], None
    for _ in range(rounds):
        fresh = make()
        start = time.process_time()
        answer = work(fresh)
        times.append(time.process_time() - start)
    return min(times) * 1000, answer


def rows(lattice: Any) -> Any:
    """Return a basis as texts."""
    return [[str(x) for x in q] for q in (b.coefficient_tuple() for b in lattice.basis())]


def peer(data: dict[str, Any]) -> None:
    """Time Sage on the ideals given, and print the results as JSON; runs in Sage's interpreter."""
    from sage.algebras.quatalg.quaternion_algebra import QuaternionAlgebra
    from sage.all__sagemath_schemes import QQ
    from sage.modular.quatalg.brandt import BrandtModule
    from sage_klpt import (  # beside this file
        equivalent_of_norm_dividing,
        equivalent_of_power_norm,
        equivalent_pair,
        modulo,
        reduced_equivalent,
        represent_integer,
        two_generators,
    )

    results: dict[str, Any] = {}
    for bits, case in data["cases"].items():
        B = QuaternionAlgebra(QQ, -1, -case["p"])

        def elements(name: str, B: Any = B, case: Any = case) -> list[Any]:
            return [B([QQ(x) for x in row]) for row in case[name]]

        def ideal(name: str, B: Any = B, case: Any = case) -> Any:
            return B.ideal(elements(name, B, case))

        def order(name: str, B: Any = B, case: Any = case) -> Any:
            return B.quaternion_order(elements(name, B, case))

        pairs = lambda: (ideal("I"), ideal("J"))  # noqa: E731
        found = {
            "conj(I)·J": best(pairs, lambda x: rows(x[0].conjugate() * x[1])),
            "norm": best(lambda: ideal("I"), lambda x: str(x.norm())),
            "left order": best(lambda: ideal("I"), lambda x: rows(x.left_order())),
            "right order": best(lambda: ideal("I"), lambda x: rows(x.right_order())),
            "equivalence": best(
                lambda: (ideal("I"), ideal("K")),
                lambda x: bool(x[0].is_left_equivalent(x[1], certificate=True)[0]),
                5,
            ),
            "isomorphism": best(
                lambda: (order("P"), order("Q")),
                lambda x: bool(x[0].isomorphism_to(x[1], conjugator=True)[1] is not None),
                5,
            ),
            INTEGER: mean(
                lambda B=B: B,
                lambda B, seed, n=case["p"] ** 2 + 2: str(
                    represent_integer(B, n, random.Random(seed)).reduced_norm()
                ),
            ),
            KLPT: mean(lambda: ideal("L"), lambda L, seed: equivalent_of_power_norm(L, 2, seed)[1]),
            DIVIDING: mean(
                lambda: ideal("L"),
                lambda L, seed, k=4 * int(bits): str(
                    equivalent_of_norm_dividing(L, k, seed).norm()
                ),
            ),
            MODULO: best(lambda: order("S"), lambda x, q=case["q"]: len(modulo(x, q)) == 4),
            GENERATORS: best(
                lambda: ideal("I"), lambda x: str(two_generators(x, random.Random(1))[0]), 3
            ),
            REDUCED: best(lambda: ideal("I"), lambda x: str(reduced_equivalent(x).norm()), 5),
            PAIR: mean(
                lambda: ideal("L"),
                lambda L, _, n=2 ** (int(bits) + 4): str(sum(equivalent_pair(L, n))),
            ),
        }
        results[bits] = {name: list(x) for name, x in found.items()}
    for p in data["sets"]:
        start = time.process_time()
        M = BrandtModule(p)
        number = len(M.right_ideals())
        middle = time.process_time()
        polynomial = str(M.hecke_matrix(2).trace())
        end = time.process_time()
        results[str(p)] = [(middle - start) * 1000, (end - middle) * 1000, number, polynomial]
    print(json.dumps(results))


def ours(sets: list[int]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return our times and answers, and the data for the peer."""
    from hfield import Ideal, Order, QuaternionAlgebra
    from hfield.core.primality import is_prime

    def texts(lattice: Any) -> list[list[str]]:
        return [[str(x) for x in q.coordinates] for q in lattice.basis]

    def fresh(L: Any) -> Any:
        value = type(L.value)(L.value.ambient, L.value.den, L.value.matrix)
        return Ideal(value, L.side, fresh(L.order)) if isinstance(L, Ideal) else Order(value)

    data: dict[str, Any] = {"cases": {}, "sets": sets}
    results: dict[str, Any] = {}
    for bits, p in PRIMES.items():
        A = QuaternionAlgebra("QQ", -1, -p)
        O = A.order(["1/2 + 1/2*j", "1/2*i + 1/2*k", "j", "k", "i"])
        q, r = (next(n for n in range(x, x + 4000) if is_prime(n)) for x in NORMS[bits])
        standard, O = O, O.random_ideal(q, seed=3).right_order()  # one maximal order among many
        I, J = O.random_ideal(q, seed=1), O.random_ideal(r, seed=2)
        L = standard.random_ideal(q, seed=4)
        K = I.equivalent_of_prime_norm()[0]
        P = I.right_order()
        x = A(1, 2, 3, 1)
        Q = Order.from_lattice(x * P * x.inverse())
        names = {"O": O, "S": standard, "I": I, "J": J, "K": K, "L": L, "P": P, "Q": Q}
        data["cases"][str(bits)] = {"p": p, "q": q} | {name: texts(L) for name, L in names.items()}

        def copies(*names: Any) -> Callable[[], list[Any]]:
            return lambda: [fresh(L) for L in names]

        rounds = 40
        results[str(bits)] = {
            "conj(I)·J": best(copies(I, J), lambda x: x[0].conjugate() * x[1], rounds),
            "norm": best(copies(I), lambda x: x[0].norm(), rounds),
            "left order": best(copies(I), lambda x: x[0].colon_order("left"), rounds),
            "right order": best(copies(I), lambda x: x[0].right_order(), rounds),
            "equivalence": best(copies(I, K), lambda x: x[0].equivalence(x[1]), rounds),
            "isomorphism": best(copies(P, Q), lambda x: x[0].isomorphism(x[1]), rounds),
            INTEGER: mean(
                copies(standard),
                lambda x, seed, n=p * p + 2: x[0].represent_integer(n, seed).norm(),
            ),
            KLPT: mean(copies(L), lambda x, seed: x[0].equivalent_of_power_norm(2, seed)[2]),
            GENERATORS: best(copies(I), lambda x: x[0].generators[0], rounds),
            REDUCED: best(copies(I), lambda x: x[0].reduced_equivalent().norm(), rounds),
            PAIR: mean(
                copies(L),
                lambda x, seed, n=2 ** (bits + 4): sum(
                    J.norm() for J, _ in x[0].equivalent_pair(n, seed)
                ),
            ),
            DIVIDING: mean(
                copies(L),
                lambda x, seed, n=6 ** (4 * bits): x[0].equivalent_of_norm_dividing(n, seed)[2],
            ),
            MODULO: best(copies(standard), lambda x, q=q: x[0].modulo(q), rounds),
            "extremal order of another q": best(
                lambda A=A: A, lambda A, q=OTHER[bits]: A.extremal_order(q), 5
            ),
        }
    for p in sets:
        O = QuaternionAlgebra.from_ramification("QQ", [p]).maximal_order()
        start = time.process_time()
        C = O.class_set()
        middle = time.process_time()
        matrix = C.brandt_matrix(2)
        end = time.process_time()
        trace = str(sum(matrix[n][n] for n in range(len(C))))
        results[str(p)] = [(middle - start) * 1000, (end - middle) * 1000, len(C), trace]
    return results, data


def ask(python: str, data: dict[str, Any]) -> dict[str, Any] | None:
    """Return what Sage finds in another interpreter, or None where there is none."""
    probe = [python, "-c", "import sage.algebras.quatalg.quaternion_algebra"]
    if subprocess.run(probe, capture_output=True, check=False).returncode:
        return None
    done = subprocess.run(
        [python, __file__, "--peer"],
        input=json.dumps(data),
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def compare(mine: dict[str, Any], theirs: dict[str, Any]) -> None:
    """Stop where an answer differs."""
    for bits in map(str, PRIMES):
        for name, (_, answer) in theirs[bits].items():
            own = mine[bits][name][1]
            if name == DIVIDING:
                print(
                    f"{name}, {bits} bits: to {own.bit_length()} bits, Sage {int(answer).bit_length()}"
                )
            elif name == KLPT:
                print(f"KLPT, {bits} bits: to 2^{own}, Sage to 2^{answer}")
            elif isinstance(answer, list):
                assert (
                    own.algebra.lattice([[own.algebra.ring(x) for x in row] for row in answer])
                    == own
                )
            else:
                assert (str(own) if isinstance(answer, str) else bool(own)) == answer, (bits, name)


def main(words: list[str]) -> None:
    """Time both, compare, and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--sage", default=sys.executable, help="an interpreter that has Sage")
    parser.add_argument("--quick", action="store_true", help="the class set of 1009 only")
    parser.add_argument("--peer", action="store_true", help=argparse.SUPPRESS)
    args = parser.parse_args(words)
    if args.peer:
        peer(json.load(sys.stdin))
        return
    sets = list(SETS[:1] if args.quick else SETS)
    mine, data = ours(sets)
    theirs = ask(args.sage, data)
    if theirs is None:
        print(
            f"{args.sage} has no Sage (pip install passagemath-schemes …): its column is left out"
        )
    else:
        compare(mine, theirs)
    print(f"{'ms':<26}{'hfield':>10}{'Sage':>12}{'ratio':>9}")
    for bits in map(str, PRIMES):
        for name, (own, _) in mine[bits].items():
            line(f"{name}, {bits} bits", own, theirs and theirs[bits].get(name, [None])[0])
    for p in map(str, sets):
        if theirs is not None:
            assert mine[p][2:] == theirs[p][2:]
        line(f"class set, p = {p}", mine[p][0], theirs and theirs[p][0])
        line(f"T2, p = {p}", mine[p][1], theirs and theirs[p][1])


def line(name: str, own: float, other: float | None) -> None:
    """Print a row."""
    end = "" if other is None else f"{other:12.3f}{other / own:9.0f}"
    print(f"{name:<32}{own:10.4f}{end}")


if __name__ == "__main__":
    main(sys.argv[1:])

"""Groups of units of Eichler orders over QQ with D·N ≤ 500, and over real fields, each proved and compared.

One line of JSON a group: area, signature, sides, relations, the systole over QQ, whether the abelian
quotient of the presentation is that of the signature, and seconds.
``--most 500 --seconds 150``, or ``--least 396``, then without those over fields; exit status 1 where
something failed.
"""

import argparse
import json
import signal
import sys
import time
from collections.abc import Iterator
from itertools import chain, islice
from typing import Any

from hfield import QuaternionAlgebra, ring
from hfield.core.factorisation import factorise
from hfield.fuchsian.presentation import abelian_invariants

FIELDS = [f"QQ[s]/(s^2-{d})" for d in (2, 3, 6, 7)] + [
    "QQ[s]/(s^2-s-1)", "QQ[s]/(s^2-s-3)", "QQ[s]/(s^2-s-4)", "QQ[s]/(s^3+s^2-2*s-1)",
    "QQ[s]/(s^3-3*s-1)", "QQ[s]/(s^3-s^2-3*s+1)", "QQ[s]/(s^3-s^2-4*s-1)"]  # fmt: skip
EACH = 30
"""Seconds of processor time for one group."""


def over_rationals(most: int, least: int = 1) -> Iterator[tuple[str, Any]]:
    for whole in range(least, most + 1):
        for D in (d for d in range(1, whole + 1) if whole % d == 0):
            N, primes = whole // D, factorise(D)
            if len(primes) % 2 or set(primes.values()) - {1} or any(N % p == 0 for p in primes):
                continue
            A = QuaternionAlgebra.from_ramification("QQ", list(primes)) if D > 1 else None
            yield f"({D}, {N})", (A or QuaternionAlgebra("QQ", 1, 1)).eichler_order(N)


def over_fields() -> Iterator[tuple[str, Any]]:
    for name in FIELDS:
        K = ring(name)
        real = list(K.real_places())
        primes = [P for p in (2, 3, 5, 7) for P in K.primes_above(p)]
        places = [[P] for P in primes[:3]] if len(real) == 2 else [[], primes[:2], primes[1:3]]
        for n, some in enumerate(places):
            chosen = [v for v in real if v.index != n % len(real)] + some
            yield (
                f"{name} ramified at {chosen}",
                QuaternionAlgebra.from_ramification(K, chosen).maximal_order(),
            )


def facts(order: Any) -> dict[str, Any]:
    group = order.norm_one_group()
    genus, orders, cusps = group.signature  # raises where formulas do not agree
    domain = group.domain()
    k, n = 2 * genus, 2 * genus + len(orders) + cusps
    rows = [(k + m,) * order for m, order in enumerate(orders, 1)] + [tuple(range(k + 1, n + 1))]
    return {
        "area": str(group.area),
        "signature": [genus, list(orders), cusps],
        "sides": len(domain.sides),
        "relations": [list(r) for r in group.relations],
        **({"systole": group.systole} if order.algebra.ring.name == "QQ" else {}),
        "agrees": domain.area == group.area
        and group.abelian_invariants == abelian_invariants(n, rows),
    }


def too_long(*_: object) -> None:
    raise TimeoutError(f"longer than {EACH} seconds")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--least", type=int, default=1, help="the smallest")
    parser.add_argument("--most", type=int, default=500, help="the largest D·N over QQ")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--step", type=int, default=1, help="every so manieth of those over QQ")
    args = parser.parse_args()
    signal.signal(signal.SIGVTALRM, too_long)
    start, bad = time.monotonic(), 0
    rational = islice(over_rationals(args.most, args.least), 0, None, args.step)
    for name, order in chain(over_fields() if args.least == 1 else (), rational):
        if time.monotonic() - start > args.seconds:
            print(json.dumps({"stopped": name}))
            break
        begun = time.process_time()
        signal.setitimer(signal.ITIMER_VIRTUAL, EACH)
        try:
            found = facts(order)
        except Exception as error:  # each failure is a line
            found = {"error": f"{type(error).__name__}: {error}", "agrees": False}
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        bad += not found["agrees"]
        print(
            json.dumps({"group": name, **found, "seconds": round(time.process_time() - begun, 3)}),
            flush=True,
        )
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())

"""Random right ideals of orders that split at one real place: a generator is found wherever there is one.

    python scripts/try_ideal_generators.py [--orders 200] [--ideals 100] [--seconds 150] [--seed 0]

An ideal is spanned by a random element and a random divisor of its norm, of norm up to 10⁴. The generator has
to span it again. Over QQ each ideal is principal; over a field, PARI (cypari, where it is installed) has to
agree that a norm has no generator that is positive at the real places that ramify. Rounds go once through all
orders, so that what --seconds leaves is even. Exit status 1 where something failed.
"""

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import QuaternionAlgebra, ring
from scripts.try_groups import over_fields, over_rationals
from tests.fuchsian.random_ideals import trial

WITH_CLASSES = [f"QQ[s]/(s^2-{d})" for d in (10, 15, 26, 34, 65, 82)] + ["QQ[s]/(s^3-4*s-1)"]
"""Fields with narrow classes that are not principal."""


def orders(count: int) -> Iterator[tuple[str, Any]]:
    """Yield about so many orders: a quarter at most over fields, the others Eichler orders over ℤ."""
    found = [*over_fields(), *over_fields_with_classes()][: count // 4 or 1]
    rational = list(over_rationals(400))
    yield from found
    yield from rational[:: max(1, len(rational) // (count - len(found) or 1))][: count - len(found)]


def over_fields_with_classes() -> Iterator[tuple[str, Any]]:
    for name in WITH_CLASSES:
        K = ring(name)
        real = list(K.real_places())
        some = [P for p in (2, 3, 5, 7) for P in K.primes_above(p)]
        for split in range(2):
            chosen = [v for v in real if v.index != split]
            chosen += some[split : split + 1] if len(chosen) % 2 else []
            A = QuaternionAlgebra.from_ramification(K, chosen)
            yield f"{name} ramified at {chosen}", A.maximal_order()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--orders", type=int, default=200)
    parser.add_argument("--ideals", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    rng, tally, slowest = random.Random(args.seed), Counter[str](), (0.0, "")
    end, every = time.monotonic() + args.seconds, []
    for entry in orders(args.orders):
        if time.monotonic() > end:
            break
        every.append(entry)
    for _ in range(args.ideals):
        for name, order in every:
            if time.monotonic() > end:
                break
            begun = time.process_time()
            said = trial(rng, order)
            slowest = max(slowest, (time.process_time() - begun, name))
            tally[said.partition(":")[0]] += 1
            if said.startswith("failed"):
                print(f"{name}: {said}", flush=True)
    for what, number in sorted(tally.items()):
        print(f"{number:8} {what}")
    print(f"{len(every):8} orders; the slowest {slowest[0]:.2f} s, {slowest[1]}")
    return int(tally["failed"] > 0)


if __name__ == "__main__":
    sys.exit(main())

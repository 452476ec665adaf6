"""Class groups of random number fields beside certified PARI (C, through cypari), in one process.

    python benchmarks/class_groups.py [COUNT [DEGREE…]]

For each degree (by default 2 to 6) COUNT fields (by default 100) of random monic polynomials with
coefficients from −5 to 5. Ours is without hypotheses; PARI's is ``bnfinit`` with ``bnfcertify``. Times are
milliseconds of processor time for a field never seen before, from its name to the group; groups are compared.
Quadratic fields are those of random discriminants up to 10⁶, half of them real. Fields whose group is refused
are counted and left out.
"""

import statistics
import sys
import time
from collections.abc import Callable, Iterator
from random import Random
from typing import TypeVar

from cypari import pari

from hfield import ring
from hfield.errors import TooLargeError

MAX_DISCRIMINANT = 10**6
SIZE = 5
T = TypeVar("T")


def fields(degree: int) -> Iterator[str]:
    """Yield polynomials in s, no two of the same text."""
    rng, seen = Random(degree), set()
    while True:
        if degree == 2:
            d = rng.choice((-1, 1)) * rng.randrange(2, MAX_DISCRIMINANT)
            if not pari(d).isfundamental():
                continue
            text = str(pari(f"quadpoly({d}, 's)"))
        else:
            c = [rng.randint(-SIZE, SIZE) for _ in range(degree)]
            f = pari(f"Pol({[1, *c]}, 's)")
            if not f.polisirreducible():
                continue
            text = str(f)
        text = text.replace(" ", "")
        if text not in seen:
            seen.add(text)
            yield text


def timed(function: Callable[[], T]) -> tuple[float, T]:
    """Return milliseconds of processor time, and the result."""
    begun = time.process_time()
    found = function()
    return 1000 * (time.process_time() - begun), found


def ours(text: str) -> list[int] | None:
    try:
        return list(ring(f"QQ[s]/({text})").class_group().invariants)
    except TooLargeError:
        return None


def theirs(text: str) -> list[int]:
    bnf = pari(f"bnfinit({text}, 1)")
    assert pari.bnfcertify(bnf) == 1
    return [int(d) for d in bnf.bnf_get_cyc()][::-1]


def main() -> None:
    count, *degrees = map(int, sys.argv[1:] or [100])
    pari.allocatemem(1 << 28, silent=True)
    ours("s^3-2")  # imports
    for degree in degrees or range(2, 7):
        pairs, refused = [], 0
        for text in fields(degree):
            ms, group = timed(lambda text=text: ours(text))
            if group is None:
                refused += 1
                continue
            other_ms, other = timed(lambda text=text: theirs(text))
            assert group == other, (text, group, other)
            pairs.append((ms, other_ms, text))
            if len(pairs) == count:
                break
        mine, his, _ = zip(*pairs, strict=True)
        ratios = sorted(a / b for a, b, _ in pairs)
        print(
            f"degree {degree}: {count} equal groups, {refused} refused; "
            f"ours median {statistics.median(mine):.1f} ms, worst {max(mine):.0f} ms ({max(pairs)[2]}); "
            f"PARI {statistics.median(his):.1f}, {max(his):.0f} ms; "
            f"ratio median {statistics.median(ratios):.1f}, worst {ratios[-1]:.1f}, "
            f"of all times together {sum(mine) / sum(his):.1f}",
            flush=True,
        )


if __name__ == "__main__":
    main()

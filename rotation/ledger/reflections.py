"""Section 2.1.2: orthogonal matrices of determinant −1, and the matrices in the thesis."""

from itertools import pairwise

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.real_geometry import Angles
from hfield.ledger.scopes import InField
from hfield.syntax import Node, both, either, implies, parse, unequal
from hfield.syntax import equal as same
from rotation.ledger.entries import (
    ONE,
    ZERO,
    det,
    equal,
    general,
    matrix,
    negative,
    orthogonal,
)

A = general("p")
MINUS = both(orthogonal(A), same(det(A), -1))

TURNING, MIRRORING = matrix("p[0], -p[2]; p[2], p[0]"), matrix("p[0], p[2]; p[2], -p[0]")
UNIT = "p[0]**2 + p[2]**2 == 1"

ANY_PRINTED = implies(orthogonal(A), equal(A, matrix("p[0], p[1]; p[1], p[0]")))
ANY = implies(orthogonal(A), both(either(equal(A, TURNING), equal(A, MIRRORING)), UNIT))
MINUS_PRINTED = implies(MINUS, equal(A, matrix("p[0], -p[2]; p[2], -p[0]")))
MINUS_MENDED = implies(MINUS, both(equal(A, MIRRORING), UNIT))


# cos(2πn/10), and sin(2πn/10) over sin(2π/10), for n = 0 … 10; GOLDEN is 2·cos(2π/10).
GOLDEN, SQUARE = parse("(1 + sqrt(5))/2"), parse("(5 - sqrt(5))/8")  # the latter is sin²(2π/10)
FIRST_HALF = (ONE, GOLDEN / 2, (GOLDEN - 1) / 2, (1 - GOLDEN) / 2, -GOLDEN / 2, -ONE)
COSINES = (*FIRST_HALF, *FIRST_HALF[-2::-1])
RISING = (ZERO, ONE, GOLDEN, GOLDEN, ONE)
SINES = (*RISING, *map(negative, RISING), ZERO)


def turns(full: int) -> Node:
    """Return the claim that tenths of a turn add up to a full turn after ``full`` steps, and not before."""
    (_, c, *_), pairs = COSINES, list(zip(COSINES, SINES, strict=True))
    steps = [
        both(same(x * c - y * SQUARE, u), same(x + y * c, v)) for (x, y), (u, v) in pairwise(pairs)
    ]
    before = [unequal(x, 1) for x in COSINES[1:full]]
    ends = [same(c**2 + SQUARE, 1), same(COSINES[full], 1), same(SINES[full], 0)]
    return both(*steps, *ends, *before)


def area_kept(steps: tuple[int, ...]) -> Node:
    """Return the claim for which n from 0 to 9 O(2πn/10), of determinant 2cos² − 1, preserves areas."""
    added = [same(COSINES[n + 1], GOLDEN * COSINES[n] - COSINES[n - 1]) for n in range(1, 10)]
    kept = [
        (same if n in steps else unequal)((2 * c**2 - 1) ** 2, 1)
        for n, c in enumerate(COSINES[:10])
    ]
    return both(*added, *kept)


COMPUTED = {
    "C2.1.2-a": Propositions(
        as_printed=Angles(Assertion.of(ANY_PRINTED, words="an orthogonal A is [[c, s], [s, c]]")),
        spoilt=Angles(Assertion.of(ANY)),
        corrected=Angles(
            Assertion.of(
                ANY,
                words="an orthogonal A is [[c, −s], [s, c]] or [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
    ),
    "C2.1.2-b": Propositions(
        as_printed=Angles(
            Assertion.of(
                MINUS_PRINTED, words="an orthogonal A with det A = −1 is [[c, −s], [s, −c]]"
            )
        ),
        spoilt=Angles(Assertion.of(MINUS_MENDED)),
        corrected=Angles(
            Assertion.of(
                MINUS_MENDED,
                words="an orthogonal A with det A = −1 is [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
    ),
    "C2.1.2-f": Propositions(
        as_printed=InField(
            "QQ(sqrt(5))",
            Assertion.of(turns(10), words="10 steps of 2π/10 make a full turn, and fewer do not"),
        ),
        spoilt=InField("QQ(sqrt(5))", Assertion.of(turns(9))),
    ),
    "C2.1.2-g": Propositions(
        as_printed=InField(
            "QQ(sqrt(5))",
            Assertion.of(
                area_kept((0, 5)),
                words="of the ten images by O(2πn/10), n from 0 to 9, those for n = 0 and 5 keep the "
                "area, and no others",
            ),
        ),
        spoilt=InField("QQ(sqrt(5))", Assertion.of(area_kept((0, 2, 5)))),
    ),
}

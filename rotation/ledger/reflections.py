"""Section 2.1.2: orthogonal matrices of determinant −1, and what the thesis takes for them."""

from itertools import pairwise

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Over, Statement
from hfield.ledger.real import Angles
from rotation.ledger.entries import (
    both,
    det,
    equal,
    general,
    matrix,
    orthogonal,
)

A = general("p")
MINUS = f"{orthogonal(A)} and {det(A)} == -1"

TURNING, MIRRORING = matrix("p[0], -p[2]; p[2], p[0]"), matrix("p[0], p[2]; p[2], -p[0]")
UNIT = "p[0]**2 + p[2]**2 == 1"

ANY_PRINTED = f"{orthogonal(A)} => {equal(A, matrix('p[0], p[1]; p[1], p[0]'))}"
ANY = f"{orthogonal(A)} => ({equal(A, TURNING)} or {equal(A, MIRRORING)}) and {UNIT}"
MINUS_PRINTED = f"{MINUS} => {equal(A, matrix('p[0], -p[2]; p[2], -p[0]'))}"
MINUS_MENDED = f"{MINUS} => {equal(A, MIRRORING)} and {UNIT}"


# cos(2πn/10), and sin(2πn/10) over sin(2π/10), for n = 0 … 10; GOLDEN is 2·cos(2π/10).
GOLDEN = "(1 + sqrt(5))/2"
COSINES = (
    *("1", f"{GOLDEN}/2", f"({GOLDEN} - 1)/2", f"(1 - {GOLDEN})/2", f"-{GOLDEN}/2", "-1"),
    *(f"-{GOLDEN}/2", f"(1 - {GOLDEN})/2", f"({GOLDEN} - 1)/2", f"{GOLDEN}/2", "1"),
)
SINES = ("0", "1", GOLDEN, GOLDEN, "1", "0", "-1", f"-{GOLDEN}", f"-{GOLDEN}", "-1", "0")
SQUARE = "(5 - sqrt(5))/8"  # sin²(2π/10)


def turns(full: int) -> str:
    """Say that tenths of a turn, added up, make a full turn after ``full`` steps, and not before."""
    (_, c, *_), pairs = COSINES, list(zip(COSINES, SINES, strict=True))
    steps = [
        f"({x})*{c} - ({y})*{SQUARE} == {u} and ({x}) + ({y})*{c} == {v}"
        for (x, y), (u, v) in pairwise(pairs)
    ]
    before = [f"{x} != 1" for x in COSINES[1:full]]
    ends = [f"({c})**2 + {SQUARE} == 1", f"{COSINES[full]} == 1", f"{SINES[full]} == 0"]
    return both(*steps, *ends, *before)


def area_kept(steps: tuple[int, ...]) -> str:
    """Say for which n from 0 to 9 the matrix O(2πn/10), of determinant 2cos² − 1, keeps areas."""
    added = [
        f"{COSINES[n + 1]} == {GOLDEN}*({COSINES[n]}) - ({COSINES[n - 1]})" for n in range(1, 10)
    ]
    kept = [
        f"(2*({c})**2 - 1)**2 {'==' if n in steps else '!='} 1" for n, c in enumerate(COSINES[:10])
    ]
    return both(*added, *kept)


COMPUTED = {
    "C2.1.2-a": Propositions(
        as_printed=Angles(Statement(ANY_PRINTED, words="an orthogonal A is [[c, s], [s, c]]")),
        spoilt=Angles(Statement(ANY)),
        corrected=Angles(
            Statement(
                ANY,
                words="an orthogonal A is [[c, −s], [s, c]] or [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
    ),
    "C2.1.2-b": Propositions(
        as_printed=Angles(
            Statement(MINUS_PRINTED, words="an orthogonal A with det A = −1 is [[c, −s], [s, −c]]")
        ),
        spoilt=Angles(Statement(MINUS_MENDED)),
        corrected=Angles(
            Statement(
                MINUS_MENDED,
                words="an orthogonal A with det A = −1 is [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
    ),
    "C2.1.2-f": Propositions(
        as_printed=Over(
            "QQ(sqrt(5))",
            Statement(turns(10), words="10 steps of 2π/10 make a full turn, and fewer do not"),
        ),
        spoilt=Over("QQ(sqrt(5))", Statement(turns(9))),
    ),
    "C2.1.2-g": Propositions(
        as_printed=Over(
            "QQ(sqrt(5))",
            Statement(
                area_kept((0, 5)),
                words="of the ten images by O(2πn/10), n from 0 to 9, those for n = 0 and 5 keep the "
                "area, and no others",
            ),
        ),
        spoilt=Over("QQ(sqrt(5))", Statement(area_kept((0, 2, 5)))),
    ),
}

"""Section 2.1.2: orthogonal matrices of determinant −1, and what the thesis takes for them."""

from itertools import pairwise

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Over, Statement
from hfield.ledger.real import Angles
from rotation.ledger.entries import (
    Matrix,
    Vector,
    apply,
    both,
    det,
    equal,
    general,
    identity,
    matrix,
    orthogonal,
    times,
    transpose,
)
from rotation.ledger.letter import LETTER, twice_area
from rotation.ledger.plane import ON_CIRCLE, POINT

A = general("p")
B = general("q")
MINUS = f"{orthogonal(A)} and {det(A)} == -1"
PRINTED_O = matrix("y, s; s, y")  # what is printed for any orthogonal matrix, and as O(θ)
PRINTED = matrix("y, -s; s, -y")  # what is printed for determinant −1
REFLECTION = matrix("y, s; s, -y")
MENDED_O = "[[cosθ, sinθ], [sinθ, −cosθ]]"
KEEPS_X, KEEPS_Y = matrix("1, 0; 0, -1"), matrix("-1, 0; 0, 1")

TURNING, MIRRORING = matrix("p[0], -p[2]; p[2], p[0]"), matrix("p[0], p[2]; p[2], -p[0]")
UNIT = "p[0]**2 + p[2]**2 == 1"

ANY_PRINTED = f"{orthogonal(A)} => {equal(A, matrix('p[0], p[1]; p[1], p[0]'))}"
ANY = f"{orthogonal(A)} => ({equal(A, TURNING)} or {equal(A, MIRRORING)}) and {UNIT}"
MINUS_PRINTED = f"{MINUS} => {equal(A, matrix('p[0], -p[2]; p[2], -p[0]'))}"
MINUS_MENDED = f"{MINUS} => {equal(A, MIRRORING)} and {UNIT}"
AREA = twice_area(tuple((x[0], x[1]) for x in (apply(A, (str(a), str(b))) for a, b in LETTER)))
AREA_CHANGES = (
    f"{MINUS} and not ({equal(A, KEEPS_X)}) and not ({equal(A, KEEPS_Y)}) => ({det(A)})**2 != 1"
)
AREA_KEPT = f"{MINUS} => {AREA} == -({twice_area(LETTER)})"
HALF_TURN = "(y == 1 or y == -1) and s == 0 => "


def of_determinant(m: Matrix, name: str) -> Statement:
    """Say that a matrix made of y and s is orthogonal with determinant −1 for every angle."""
    words = f"{name} is orthogonal and has the determinant −1"
    return Statement(f"{ON_CIRCLE} => {orthogonal(m)} and {det(m)} == -1", words=words)


def mirrored_in(axis: int, name: str) -> Statement:
    """Say that (x, −y) is the mirror image of (x, y) in an axis."""
    words = f"(x, −y) is the mirror image of (x, y) in the {name} axis"
    return Statement(mirrored(("p[0]", "-p[1]"), axis), words=words)


def respectively(first: int, second: int) -> Statement:
    """Say in which axes diag(1, −1) and diag(−1, 1) mirror."""
    images = (apply(KEEPS_X, POINT), apply(KEEPS_Y, POINT))
    words = f"diag(1, −1) mirrors in the {'xy'[first]} axis, diag(−1, 1) in the {'xy'[second]} axis"
    return Statement(both(mirrored(images[0], first), mirrored(images[1], second)), words=words)


def half_turns(m: Matrix, name: str) -> Statement:
    """Say that a matrix made of y and s is diag(1, −1) or diag(−1, 1) at the angles 0 and π."""
    words = f"at the angles 0 and π, {name} is diag(1, −1) or diag(−1, 1)"
    return Statement(f"{HALF_TURN}{equal(m, KEEPS_X)} or {equal(m, KEEPS_Y)}", words=words)


def mirrored(image: Vector, axis: int) -> str:
    """Say that ``image`` is the mirror image of the point p in the axis x (0) or y (1).

    The middle of the two points lies on the axis, and the line through them is perpendicular to it.
    """
    along, across = (0, 1) if axis == 0 else (1, 0)
    return f"({image[across]}) + {POINT[across]} == 0 and ({image[along]}) - {POINT[along]} == 0"


def at_zero(m: Matrix, y: str) -> str:
    """Say what a matrix made of y and s does at the angle 0."""
    return f"y == 1 and s == 0 => {equal(apply(m, POINT), ('p[0]', y))}"


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


CLAIMS = (
    Claim(
        "C2.1.2-a",
        "orthogonal-form",
        "claim",
        "Proof of Thm 4 shows that any orthogonal 2×2 matrix is [[cosθ,sinθ],[sinθ,cosθ]]",
        "[[cosθ, sinθ],[sinθ, cosθ]]",
        Angles(Statement(ANY_PRINTED, words="an orthogonal A is [[c, s], [s, c]]")),
        spoilt=Angles(Statement(ANY)),
        corrected=Angles(
            Statement(
                ANY,
                words="an orthogonal A is [[c, −s], [s, c]] or [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
        note="The rotation by a quarter turn has not that form. An orthogonal 2×2 matrix is "
        "[[cosθ,−sinθ],[sinθ,cosθ]] or [[cosθ,sinθ],[sinθ,−cosθ]]. Here A is [[p0, p1],[p2, p3]].",
    ),
    Claim(
        "C2.1.2-b",
        "reflection-form",
        "claim",
        "Any real orthogonal 2×2 with det −1 has form [[cosθ,−sinθ],[sinθ,−cosθ]]",
        "[[cosθ, −sinθ],[sinθ, −cosθ]]",
        Angles(
            Statement(MINUS_PRINTED, words="an orthogonal A with det A = −1 is [[c, −s], [s, −c]]")
        ),
        spoilt=Angles(Statement(MINUS_MENDED)),
        corrected=Angles(
            Statement(
                MINUS_MENDED,
                words="an orthogonal A with det A = −1 is [[c, s], [s, −c]] with c² + s² = 1",
            )
        ),
        note="The printed matrix has the determinant −cos²θ + sin²θ and is not even orthogonal; "
        "the form is [[cosθ,sinθ],[sinθ,−cosθ]]. Here A is [[p0, p1],[p2, p3]].",
    ),
    Claim(
        "C2.1.2-c",
        "reflection-at-zero",
        "formula",
        "Action at angle 0",
        "x_Δ=x cos0−y sin0=x; y_Δ=x sin0−y cos0=−y",
        Statement(at_zero(PRINTED, "-p[1]")),
        spoilt=Statement(at_zero(PRINTED, "p[1]")),
    ),
    Claim(
        "C2.1.2-d",
        "reflection-axis",
        "claim",
        "The effect (x,−y) is reflection in the y axis",
        "odbicie względem osi y",
        mirrored_in(1, "y"),
        spoilt=mirrored_in(0, "x"),
        corrected=mirrored_in(0, "x"),
        note="(x,−y) is the mirror image in the x axis, which it leaves fixed.",
    ),
    Claim(
        "C2.1.2-e",
        "example-3-matrix",
        "example 3",
        "O(θ)=[[cosθ_n,sinθ_n],[sinθ_n,cosθ_n]]",
        "O(θ)",
        of_determinant(PRINTED_O, "[[cosθ, sinθ], [sinθ, cosθ]]"),
        spoilt=of_determinant(REFLECTION, MENDED_O),
        corrected=of_determinant(REFLECTION, MENDED_O),
        note="Read as the orthogonal matrix of determinant −1 that the section speaks of (and with "
        "θ for θ_n); the last entry must be −cosθ.",
    ),
    Claim(
        "C2.1.2-f",
        "example-3-angles",
        "number",
        "angles {2πx/10: x∈N∪{0}, x≤10}",
        "x≤10",
        Over(
            "QQ(sqrt(5))",
            Statement(turns(10), words="10 steps of 2π/10 make a full turn, and fewer do not"),
        ),
        spoilt=Over("QQ(sqrt(5))", Statement(turns(9))),
        note="Eleven angles from 0 to a full turn; the last brings back the first, so there are ten "
        "directions. cos(2π/10) = (1+√5)/4, sin²(2π/10) = (5−√5)/8.",
        fieldless=True,
    ),
    Claim(
        "C2.1.2-g",
        "example-3-areas",
        "claim",
        "Only 2 of the images keep the area of the original",
        "tylko 2 obroty mają identyczne pola",
        Over(
            "QQ(sqrt(5))",
            Statement(
                area_kept((0, 5)),
                words="of the ten images by O(2πn/10), n from 0 to 9, those for n = 0 and 5 keep the "
                "area, and no others",
            ),
        ),
        spoilt=Over("QQ(sqrt(5))", Statement(area_kept((0, 2, 5)))),
        note="O(θ) multiplies areas by |cos²θ − sin²θ|, which is 1 for θ = 0, π and 2π alone: three "
        "of the eleven angles, but 0 and 2π give one and the same image. A correct reflection "
        "keeps every area.",
        fieldless=True,
    ),
    Claim(
        "C2.1.2-h",
        "areas-of-reflections",
        "claim",
        "orthogonal det −1 “do not satisfy the assumptions of rotation; most visible in comparing "
        "areas”",
        "porównaniu pól",
        Statement(
            AREA_CHANGES,
            words="an orthogonal A with det A = −1 changes areas, but for diag(1, −1) and diag(−1, 1)",
        ),
        spoilt=Statement(AREA_KEPT),
        corrected=Statement(
            AREA_KEPT,
            words="an orthogonal A with det A = −1 makes of the area of the letter T its opposite",
        ),
        note="Read with the two exceptions that the thesis names. An orthogonal matrix keeps every "
        "area; one of determinant −1 changes its sign, the orientation. Here A is [[p0, p1],[p2, p3]].",
    ),
    Claim(
        "C2.1.2-i",
        "area-preserving",
        "claim",
        "the two area-preserving ones are diag(1,−1) and diag(−1,1)",
        "[[1,0],[0,−1]],[[−1,0],[0,1]]",
        half_turns(PRINTED_O, "O(θ) as printed"),
        spoilt=half_turns(REFLECTION, MENDED_O),
        corrected=half_turns(REFLECTION, MENDED_O),
        note="O(θ) as printed is the identity for θ = 0 and −1 times it for θ = π; the two matrices "
        "belong to [[cosθ,sinθ],[sinθ,−cosθ]] (and to [[cosθ,−sinθ],[sinθ,−cosθ]]).",
    ),
    Claim(
        "C2.1.2-j",
        "axes-of-reflection",
        "claim",
        "multiplying by them gives respectively reflection in the y axis and in the x axis",
        "kolejno odbicie względem osi y oraz osi x",
        respectively(1, 0),
        spoilt=respectively(0, 1),
        corrected=respectively(0, 1),
        note="The axes are exchanged.",
    ),
    Claim(
        "C2.1.2-k",
        "reflection-matrix",
        "definition 6",
        "“reflection matrix” := orthogonal with det −1",
        "n",
        Statement(
            f"{MINUS} => {equal(times(A, A), identity(2))} and {equal(A, transpose(A))}",
            words="an orthogonal A with det A = −1 has A² = I and Aᵗ = A (n = 2)",
        ),
        spoilt=Statement(
            f"{orthogonal(A)} => {equal(times(A, A), identity(2))} and {equal(A, transpose(A))}"
        ),
        note="A definition. For n = 2 such a matrix deserves the name: it is symmetric and its own "
        "inverse. From n = 3 on the name is wider than usual, as −I_3 shows.",
    ),
    Claim(
        "C2.1.2-l",
        "orthogonal-group",
        "definition 7",
        "O(n) is the set of orthogonal matrices",
        "O(n)",
        Statement(
            f"{orthogonal(A)} and {orthogonal(B)} => {orthogonal(times(A, B))}"
            f" and {orthogonal(transpose(A))}",
            words="O(2) has the products of its elements and their inverses",
        ),
        spoilt=Statement(f"{orthogonal(A)} => {orthogonal(times(A, B))}"),
        note="A definition; that the set is a group, as its name says, is decided for n = 2.",
    ),
)

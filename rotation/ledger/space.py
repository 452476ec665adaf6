"""Sections 2.2.1 to 2.2.3: the three axes, their rotations, and that the order matters."""

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Statement
from rotation.ledger.entries import (
    Matrix,
    Vector,
    apply,
    both,
    coordinates,
    equal,
    matrix,
    negative,
    times,
    transpose,
    vector,
)
from rotation.ledger.plane import ON_CIRCLE

E1, E2, E3 = vector("1, 0, 0"), vector("0, 1, 0"), vector("0, 0, 1")
ONES = vector("1, 1, 1")
P, IMAGE = coordinates("v"), coordinates("u")


def about_x(c: str, s: str) -> Matrix:
    """Return R_x for the angle whose point is (c, s), as printed."""
    return (("1", "0", "0"), ("0", c, negative(s)), ("0", s, c))


def about_y(c: str, s: str) -> Matrix:
    """Return R_y for the angle whose point is (c, s), as printed."""
    return ((c, "0", s), ("0", "1", "0"), (negative(s), "0", c))


def about_z(c: str, s: str) -> Matrix:
    """Return R_z for the angle whose point is (c, s), as printed."""
    return ((c, negative(s), "0"), (s, c, "0"), ("0", "0", "1"))


X_QUARTER, Z_QUARTER = matrix("1, 0, 0; 0, 0, -1; 0, 1, 0"), matrix("0, -1, 0; 1, 0, 0; 0, 0, 1")


def right_hand(y: Matrix) -> str:
    """Say that quarter turns about z, x and y (the matrix given) take x to y, y to z and z to x."""
    return both(
        equal(apply(about_z("0", "1"), E1), E2),
        equal(apply(about_x("0", "1"), E2), E3),
        equal(apply(y, E3), E1),
    )


def turned(v: Vector) -> str:
    """Say that u is v turned about z: the three equations."""
    return f"u[1] == {v[0]}*y - {v[1]}*s and u[2] == {v[0]}*s + {v[1]}*y and u[3] == {v[2]}"


def system(v: Vector, name: str) -> Statement:
    """Say that the system with v on its right side is the matrix equation."""
    equation = equal(IMAGE, apply(about_z("y", "s"), P))
    return Statement(
        f"{ON_CIRCLE} => (({turned(v)}) <=> ({equation}))",
        words=f"the system with the coordinates of {name} on the right is p_Δ = R_z(ψ)·p",
    )


def cyclic(m: Matrix, order: tuple[int, int, int]) -> str:
    """Say that m leaves one coordinate of v and turns the two after it, in cyclic order, as R2 does.

    ``order`` is where the fixed coordinate and those two stand in v.
    """
    image = apply(m, P)
    fixed, first, second = order
    return both(
        f"{image[fixed]} == {P[fixed]}",
        f"{image[first]} == {P[first]}*y - {P[second]}*s",
        f"{image[second]} == {P[first]}*s + {P[second]}*y",
    )


def steps(first: Matrix, middle: Vector, second: Matrix, last: Vector) -> Statement:
    """Say where two matrices take the point (1, 1, 1), one after the other."""
    return Statement(both(equal(apply(first, ONES), middle), equal(apply(second, middle), last)))


X, Y, Z = about_x("y", "s"), about_y("y", "s"), about_z("y", "s")
QUARTERS = both(equal(about_z("0", "1"), Z_QUARTER), equal(about_x("0", "1"), X_QUARTER))
SPOILT_QUARTERS = both(
    equal(about_z("0", "1"), Z_QUARTER), equal(about_x("0", "1"), transpose(X_QUARTER))
)

CLAIMS = (
    Claim(
        "C2.2.1-a",
        "right-hand-rule",
        "convention",
        "right-hand rule",
        "reguła prawej dłoni",
        Statement(right_hand(about_y("0", "1"))),
        spoilt=Statement(right_hand(transpose(about_y("0", "1")))),
        note="A convention: a quarter turn about each axis takes the next axis to the one after it, "
        "as the matrices of 2.2.2 do.",
    ),
    Claim(
        "C2.2.2-a",
        "system-about-z",
        "formula",
        "rotation about z (system)",
        "x_pΔ = x_pΔ cosψ − y_pΔ sinψ …",
        system(IMAGE, "p_Δ"),
        spoilt=system(P, "p"),
        corrected=system(P, "p"),
        note="The coordinates of p_Δ stand on both sides; on the right those of p are meant, as in "
        "the matrix equation said to be equivalent.",
    ),
    Claim(
        "C2.2.2-b",
        "matrix-about-z",
        "matrix",
        "R_z(ψ)",
        "[[cos,−sin,0],[sin,cos,0],[0,0,1]]",
        Statement(cyclic(Z, (2, 0, 1))),
        spoilt=Statement(cyclic(transpose(Z), (2, 0, 1))),
    ),
    Claim(
        "C2.2.2-c",
        "matrix-about-x",
        "matrix",
        "R_x(ψ)",
        "[[1,0,0],[0,cos,−sin],[0,sin,cos]]",
        Statement(cyclic(X, (0, 1, 2))),
        spoilt=Statement(cyclic(transpose(X), (0, 1, 2))),
    ),
    Claim(
        "C2.2.2-d",
        "matrix-about-y",
        "matrix",
        "R_y(ψ)",
        "[[cos,0,sin],[0,1,0],[−sin,0,cos]]",
        Statement(cyclic(Y, (1, 2, 0))),
        spoilt=Statement(cyclic(transpose(Y), (1, 2, 0))),
        note="Its signs are those of the right-hand rule: it turns z to x as R_z turns x to y.",
    ),
    Claim(
        "C2.2.2-e",
        "coordinate-of-axis",
        "claim",
        "the z coordinate is unchanged by a rotation about z",
        "wartość współrzędnej z nie ulega zmianie",
        Statement(f"{apply(Z, P)[2]} == {P[2]}"),
        spoilt=Statement(f"{apply(Z, P)[1]} == {P[1]}"),
    ),
    Claim(
        "C2.2.3-a",
        "quarter-turns-in-space",
        "example 4",
        "R_z(π/2), R_x(π/2)",
        "[[0,−1,0],[1,0,0],[0,0,1]], [[1,0,0],[0,0,−1],[0,1,0]]",
        Statement(
            QUARTERS, words="R_z(ψ) and R_x(ψ) for the point (0, 1) are the matrices printed"
        ),
        spoilt=Statement(SPOILT_QUARTERS),
    ),
    Claim(
        "C2.2.3-b",
        "first-x-then-z",
        "example 4",
        "x then z on (1,1,1): (1,−1,1) then (1,1,1)",
        "(1,−1,1)→(1,1,1)",
        steps(X_QUARTER, vector("1, -1, 1"), Z_QUARTER, ONES),
        spoilt=steps(X_QUARTER, vector("1, -1, 1"), Z_QUARTER, vector("-1, 1, 1")),
    ),
    Claim(
        "C2.2.3-c",
        "first-z-then-x",
        "example 4",
        "z then x on (1,1,1): (−1,1,1) then (−1,−1,1)",
        "(−1,1,1)→(−1,−1,1)",
        steps(Z_QUARTER, vector("-1, 1, 1"), X_QUARTER, vector("-1, -1, 1")),
        spoilt=steps(Z_QUARTER, vector("-1, 1, 1"), X_QUARTER, ONES),
    ),
    Claim(
        "C2.2.3-d",
        "order-matters",
        "claim",
        "order matters",
        "ma znaczenie",
        Statement(f"not ({equal(times(Z_QUARTER, X_QUARTER), times(X_QUARTER, Z_QUARTER))})"),
        spoilt=Statement(
            f"not ({equal(times(X_QUARTER, X_QUARTER), times(X_QUARTER, X_QUARTER))})"
        ),
        note="The products of the two quarter turns differ over every field. The point (1,1,1) of "
        "the example shows it except in characteristic 2.",
    ),
)

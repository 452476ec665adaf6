"""Example 2 of section 2.1.1: the letter T and its quarter turns."""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Over, Statement
from rotation.ledger.entries import both

LETTER = ((10, 1), (11, 1), (11, 6), (13, 6), (13, 7), (8, 7), (8, 6), (10, 6))


def twice_area(points: tuple[tuple[object, object], ...]) -> str:
    """Return twice the signed area inside a closed line through the points."""
    pairs = zip(points, (*points[1:], points[0]), strict=True)
    return " + ".join(f"(({a})*({d}) - ({c})*({b}))" for (a, b), (c, d) in pairs)


def letter_t(points: tuple[tuple[int, int], ...]) -> str:
    """Say what makes eight points a letter T.

    The sides are parallel to the axes in turn, the mirror x ↦ 21 − x exchanges the two halves, and
    the area is that of a bar 5·1 upon a stem 1·5.
    """
    sides = zip(points, (*points[1:], points[0]), strict=True)
    parallel = [f"{a[1 - n % 2]} == {b[1 - n % 2]}" for n, (a, b) in enumerate(sides)]
    size = len(points)
    halves = [(points[n], points[(1 - n) % size]) for n in range(size)]
    mirror = [f"21 - {a[0]} == {b[0]} and {a[1]} == {b[1]}" for a, b in halves]
    return both(*parallel, *mirror, f"{twice_area(points)} == 2*(5*1 + 1*5)")


def joined(last: int) -> Over:
    """Say that for every i from 1 to ``last`` there is a point x_{i+1} among the eight."""
    some = " or ".join(f"s == {n}" for n in range(1, last + 1))
    points = " or ".join(f"s + 1 == {n}" for n in range(1, len(LETTER) + 1))
    words = f"for every i from 1 to {last} there is a point x_(i+1)"
    return Over("QQ", Statement(f"{some} => {points}", words=words))


COMPUTED = {
    "C2.1.1-h": Propositions(
        as_printed=Over(
            "QQ", Statement(letter_t(LETTER), words="the eight points are those of a letter T")
        ),
        spoilt=Over("QQ", Statement(letter_t((*LETTER[:5], (9, 7), *LETTER[6:])))),
    ),
    "C2.1.1-i": Propositions(as_printed=joined(8), spoilt=joined(7), corrected=joined(7)),
}

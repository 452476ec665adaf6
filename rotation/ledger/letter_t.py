"""Example 2 of section 2.1.1: the letter T and its quarter turns."""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.scopes import InField
from hfield.syntax import Node, both, either, equal, implies, names, number

LETTER = ((10, 1), (11, 1), (11, 6), (13, 6), (13, 7), (8, 7), (8, 6), (10, 6))


def twice_area(points: tuple[tuple[int, int], ...]) -> Node:
    """Return twice the signed area enclosed by a closed polygon through the points."""
    pairs = zip(points, (*points[1:], points[0]), strict=True)
    first, *rest = (number(a) * d - number(c) * b for (a, b), (c, d) in pairs)
    return sum(rest, first)


def letter_t(points: tuple[tuple[int, int], ...]) -> Node:
    """Return the claim that eight points form a letter T.

    The sides are alternately parallel to the axes, the reflection x ↦ 21 − x exchanges the two halves, and
    the area is that of a 5 × 1 bar on a 1 × 5 stem.
    """
    sides = zip(points, (*points[1:], points[0]), strict=True)
    parallel = [equal(a[1 - n % 2], b[1 - n % 2]) for n, (a, b) in enumerate(sides)]
    size = len(points)
    halves = [(points[n], points[(1 - n) % size]) for n in range(size)]
    mirror = [x for a, b in halves for x in (equal(21 - number(a[0]), b[0]), equal(a[1], b[1]))]
    bars = 2 * (number(5) * 1 + number(1) * 5)
    return both(*parallel, *mirror, equal(twice_area(points), bars))


def joined(last: int) -> InField:
    """Return the claim that for every i from 1 to ``last`` the point x_{i+1} is one of the eight."""
    (s,) = names("s")
    some = either(*(equal(s, n) for n in range(1, last + 1)))
    points = either(*(equal(s + 1, n) for n in range(1, len(LETTER) + 1)))
    words = f"for every i from 1 to {last} there is a point x_(i+1)"
    return InField("QQ", Assertion.of(implies(some, points), words=words))


COMPUTED = {
    "C2.1.1-h": Propositions(
        as_printed=InField(
            "QQ", Assertion.of(letter_t(LETTER), words="the eight points are those of a letter T")
        ),
        spoilt=InField("QQ", Assertion.of(letter_t((*LETTER[:5], (9, 7), *LETTER[6:])))),
    ),
    "C2.1.1-i": Propositions(as_printed=joined(8), spoilt=joined(7), corrected=joined(7)),
}

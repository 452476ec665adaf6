"""Section 2.2.4, Lemmas 2 and 3: the real eigenvalues of matrices with an odd number of rows."""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.real_geometry import Analysis
from hfield.syntax import Node, both, implies, names
from hfield.syntax import equal as same
from rotation.ledger.entries import (
    apply,
    coordinates,
    det,
    dot,
    equal,
    general,
    minor,
    orthogonal,
    scaled,
    shifted,
    total,
    trace,
    transpose,
)

A = general("pqr")
MINORS = total([det(minor(A, n, n)) for n in range(3)])
S, P = names("s p")


def cubic(x: Node, power: Node) -> Node:
    """Return x³ − (tr A)·x² + (sum of minors)·x − det A, with ``power`` in place of x³."""
    return power - trace(A) * x**2 + MINORS * x - det(A)


# det(λI − A) for n = 1 and n = 3, as −det(A − λI).
LINEAR = same(-det(shifted(((P[0],),), -S)), S - P[0])
CHARACTERISTIC = both(LINEAR, same(-det(shifted(A, -S)), cubic(S, S**3)))
OTHER_SIGN = both(LINEAR, same(-det(shifted(A, -S)), S**3 - trace(A) * S**2 - MINORS * S - det(A)))


def odd(power: Node) -> Node:
    """Return the same claim for λ and −λ; the cube of −λ is ``power``."""
    return both(CHARACTERISTIC, same(-det(shifted(A, S)), cubic(-S, power)))


V = coordinates("v")
IMAGE, MULTIPLE = apply(A, V), scaled(S, V)
EIGENVECTOR = both(orthogonal(transpose(A)), equal(IMAGE, MULTIPLE))
REST = both(same(dot(MULTIPLE, MULTIPLE), dot(IMAGE, IMAGE)), same(dot(IMAGE, IMAGE), dot(V, V)))
SQUARED = Assertion.of(
    implies(EIGENVECTOR, both(same(S**2 * dot(V, V), dot(MULTIPLE, MULTIPLE)), REST)),
    words="λ0²·vᵗv = (λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv for A ∈ O(3) and Av = λ0v",
)
# In the chain vᵗv is one number, y.
FIRST_LINK = Assertion("s**2*y == y => s*y == s**2*y")
ROOTS = Assertion("s**2*y == y and y != 0 => s == 1 or s == -1")
LEMMA_3 = "A ∈ O(3), Av = λ0·v and v∘v ≠ 0 make λ0 = ±1"

COMPUTED = {
    "C2.2.4-k": Propositions(
        as_printed=Analysis(
            "odd-degree",
            Assertion.of(
                CHARACTERISTIC, words="det(λI − A) is monic of degree n in λ (n = 1 and 3)"
            ),
        ),
        spoilt=Analysis("odd-degree", Assertion.of(OTHER_SIGN)),
    ),
    "C2.2.4-k2": Propositions(
        as_printed=Analysis(
            "limits",
            Assertion.of(
                odd((-S) ** 3),
                words="det(λI − A) has the leading term λⁿ, and det(−λI − A) has (−λ)ⁿ (n = 1 and 3)",
            ),
        ),
        spoilt=Analysis("limits", Assertion.of(odd(S**3))),
    ),
    "C2.2.4-l": Propositions(
        as_printed=Every((SQUARED, ROOTS), LEMMA_3),
        spoilt=Every(
            (SQUARED, Assertion("s**2*y == y and y != 0 => s == 1")),
            LEMMA_3.replace("±", ""),
        ),
    ),
    "C2.2.4-l2": Propositions(
        as_printed=Every(
            (
                Assertion.of(implies(EIGENVECTOR, REST), words="(λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv"),
                FIRST_LINK,
            ),
            "λ0·vᵗv = (λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv for A ∈ O(3) and Av = λ0v",
        ),
        corrected=Every((SQUARED,), SQUARED.text),
    ),
}

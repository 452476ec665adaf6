"""Section 2.2.4, Lemmas 2 and 3: the real eigenvalues of matrices with an odd number of rows."""

from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Every, Statement
from hfield.ledger.real import Analysis
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
MINORS = total([f"({det(minor(A, n, n))})" for n in range(3)])
CUBIC = f"s**3 - ({trace(A)})*s**2 + ({MINORS})*s - ({det(A)})"
# det(λI − A) for n = 1 and n = 3, as −det(A − λI).
CHARACTERISTIC = (
    f"-({det(shifted((('p[0]',),), '-s'))}) == s - p[0] and -({det(shifted(A, '-s'))}) == {CUBIC}"
)
ODD = f"{CHARACTERISTIC} and -({det(shifted(A, 's'))}) == {CUBIC.replace('s', '(-s)')}"

V = coordinates("v")
IMAGE, MULTIPLE = apply(A, V), scaled("s", V)
EIGENVECTOR = f"{orthogonal(transpose(A))} and {equal(IMAGE, MULTIPLE)}"
REST = f"{dot(MULTIPLE, MULTIPLE)} == {dot(IMAGE, IMAGE)} and {dot(IMAGE, IMAGE)} == {dot(V, V)}"
SQUARED = Statement(
    f"{EIGENVECTOR} => s**2*({dot(V, V)}) == {dot(MULTIPLE, MULTIPLE)} and {REST}",
    words="λ0²·vᵗv = (λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv for A ∈ O(3) and Av = λ0v",
)
# In the chain vᵗv is one number, y.
FIRST_LINK = Statement("s**2*y == y => s*y == s**2*y")
ROOTS = Statement("s**2*y == y and y != 0 => s == 1 or s == -1")
LEMMA_3 = "A ∈ O(3), Av = λ0·v and v∘v ≠ 0 make λ0 = ±1"

COMPUTED = {
    "C2.2.4-k": Propositions(
        as_printed=Analysis(
            "odd-degree",
            Statement(CHARACTERISTIC, words="det(λI − A) is monic of degree n in λ (n = 1 and 3)"),
        ),
        spoilt=Analysis("odd-degree", Statement(CHARACTERISTIC.replace("*s**2 + (", "*s**2 - ("))),
    ),
    "C2.2.4-k2": Propositions(
        as_printed=Analysis(
            "limits",
            Statement(
                ODD,
                words="det(λI − A) has the leading term λⁿ, and det(−λI − A) has (−λ)ⁿ (n = 1 and 3)",
            ),
        ),
        spoilt=Analysis("limits", Statement(ODD.replace("(-s)**3", "s**3"))),
    ),
    "C2.2.4-l": Propositions(
        as_printed=Every((SQUARED, ROOTS), LEMMA_3),
        spoilt=Every(
            (SQUARED, Statement("s**2*y == y and y != 0 => s == 1")),
            LEMMA_3.replace("±", ""),
        ),
    ),
    "C2.2.4-l2": Propositions(
        as_printed=Every(
            (
                Statement(f"{EIGENVECTOR} => {REST}", words="(λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv"),
                FIRST_LINK,
            ),
            "λ0·vᵗv = (λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv for A ∈ O(3) and Av = λ0v",
        ),
        corrected=Every((SQUARED,), SQUARED.text),
    ),
}

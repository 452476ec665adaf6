"""Section 2.2.4, Lemmas 2 and 3: the real eigenvalues of matrices with an odd number of rows."""

from hfield.ledger.claim import Claim
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

CLAIMS = (
    Claim(
        "C2.2.4-k",
        "lemma-2",
        "lemma 2",
        "A∈M_n(R), n odd ⇒ A has a real eigenvalue",
        "n nieparzysta",
        Analysis(
            "odd-degree",
            Statement(CHARACTERISTIC, words="det(λI − A) is monic of degree n in λ (n = 1 and 3)"),
        ),
        spoilt=Analysis("odd-degree", Statement(CHARACTERISTIC.replace("*s**2 + (", "*s**2 - ("))),
        note="Computed for n = 1 and 3: the characteristic polynomial is monic of degree n. That it "
        "has a root in R is cited.",
    ),
    Claim(
        "C2.2.4-k2",
        "lemma-2-limits",
        "lemma 2 proof",
        "p_A(λ)=det(λI−A)=λ^n+…, limits ∓∞ at ∓∞ (n odd)",
        "lim p_A(λ) = −∞ for λ → −∞, ∞ for λ → ∞",
        Analysis(
            "limits",
            Statement(
                ODD,
                words="det(λI − A) has the leading term λⁿ, and det(−λI − A) has (−λ)ⁿ (n = 1 and 3)",
            ),
        ),
        spoilt=Analysis("limits", Statement(ODD.replace("(-s)**3", "s**3"))),
        note="Computed for n = 1 and 3: p_A(λ) has the leading term λⁿ, and p_A(−λ) has (−λ)ⁿ.",
    ),
    Claim(
        "C2.2.4-l",
        "lemma-3",
        "lemma 3",
        "A∈O(n), n odd, λ0 real eigenvalue ⇒ λ0=±1",
        "λ0=±1",
        Every((SQUARED, ROOTS), LEMMA_3),
        spoilt=Every(
            (SQUARED, Statement("s**2*y == y and y != 0 => s == 1")),
            LEMMA_3.replace("±", ""),
        ),
        note="Decided for n = 3. An eigenvector v has v∘v ≠ 0 over the reals, and elsewhere this is a "
        "hypothesis. Nothing depends on n being odd but that there is an eigenvalue.",
    ),
    Claim(
        "C2.2.4-l2",
        "lemma-3-chain",
        "lemma 3 proof",
        "λ0 v^Tv=(λ0v)^Tλ0v=(Av)^TAv=v^TA^TAv=v^Tv",
        "λ0 v^T v = (λ0 v)^T λ0 v",
        Every(
            (
                Statement(f"{EIGENVECTOR} => {REST}", words="(λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv"),
                FIRST_LINK,
            ),
            "λ0·vᵗv = (λ0v)ᵗλ0v = (Av)ᵗAv = vᵗv for A ∈ O(3) and Av = λ0v",
        ),
        spoilt=SQUARED,
        corrected=Every((SQUARED,), SQUARED.text),
        note="The chain begins with λ0²vᵗv, as its consequence λ0²vᵗv = vᵗv has it. The first link is "
        "read given the rest, with y for vᵗv; where λ0 = −1 it says −y = y.",
    ),
)

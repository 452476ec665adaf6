"""The theorems that evidence may cite: everything else in ``assumes`` is an assumption.

A theorem here is general, proved in the literature, and says nothing about the algebra at hand. What the
checker uses in its own arithmetic is proved in docs/trust.md, or cited there.
"""

CIRCLE = "(cos θ, sin θ) runs once through the points of the circle c² + s² = 1 for θ in [0, 2π)"
KULIKOV = "a bounded pure subgroup of an abelian group is a direct summand (Kulikov)"
ODD_DEGREE = "a real polynomial of odd degree has a real root (intermediate value theorem)"
LIMITS = "a real polynomial with leading term λⁿ, n odd, tends to ±∞ as λ tends to ±∞"
INDUCTION = (
    "induction on k: what holds for one argument, and passes on to one more, holds for every k"
)
SIGN_CHANGE = (
    "a real polynomial with values of both signs has a root between (intermediate value theorem)"
)
COMPLEX_ROOT = "a complex polynomial of positive degree has a root (fundamental theorem of algebra)"
QUATERNION_ROOT = (
    "a polynomial over H(RR) with a single term of the highest degree has a root (Eilenberg, Niven)"
)
REAL_ROOTS = "every number that is not negative is a square in RR"
COMPLEX_ROOTS = "every number is a square in CC"
MASS = "the ideal classes of an order have the mass that its Eichler symbols give (Eichler's mass formula)"

# By the texts that stand in ``assumes``: where the theorem is proved.
THEOREMS = {
    CIRCLE: "Rudin, Principles of Mathematical Analysis, chapter 8",
    KULIKOV: "Fuchs, Infinite Abelian Groups I, theorem 27.5",
    ODD_DEGREE: "Rudin, Principles of Mathematical Analysis, theorem 4.23",
    LIMITS: "Rudin, Principles of Mathematical Analysis, chapter 4, exercise on polynomials",
    SIGN_CHANGE: "Rudin, Principles of Mathematical Analysis, theorem 4.23",
    COMPLEX_ROOT: "Rudin, Principles of Mathematical Analysis, theorem 8.8",
    QUATERNION_ROOT: "Eilenberg and Niven, Bulletin of the AMS 50 (1944), 246-248",
    INDUCTION: "Peano's axioms; the passage is that of an f with its last argument fixed",
    REAL_ROOTS: "Rudin, Principles of Mathematical Analysis, theorem 1.21",
    MASS: "Voight, Quaternion Algebras, theorem 26.1.5, for every order of a definite algebra over QQ",
    COMPLEX_ROOTS: "(a + b·i)² = c + d·i is solved by real square roots of (√(c² + d²) ± c)/2",
}
# Those that a statement may be read with (``citing{odd-degree; …}``), by the names it gives them.
CITED_BY_NAME = {"odd-degree": ODD_DEGREE, "limits": LIMITS, "induction": INDUCTION}


def is_theorem(text: str) -> bool:
    """Tell whether what evidence cites is one of the general theorems listed here."""
    return text in THEOREMS

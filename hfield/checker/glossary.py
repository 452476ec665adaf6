"""The words shared by prover, checker, ledger and documents: verdicts, scopes, methods, theorems.

This module has only plain data, and is the only module of this folder that a prover needs; nothing is derived
or checked here.
"""

import re

SCHEMA = "hfield-cert/2"
KEYS = (
    *("schema", "statement", "algebra", "field", "ring", "verdict", "method", "assumes"),
    "evidence",
)

PROVED, REFUTED, VACUOUS = "proved", "refuted", "vacuous"
CERTIFIED = (PROVED, REFUTED, VACUOUS)  # the verdicts that a certificate may state
UNDECIDED, NOT_APPLICABLE = "undecided", "not-applicable"
VERDICTS = (*CERTIFIED, UNDECIDED, NOT_APPLICABLE)

# Where a statement was shown: over the field named, or wider.
FIELD, FIELDS = "field", "fields"
ORDERED_FIELDS = "ordered fields"
REDUCED_RINGS, COMMUTATIVE_RINGS = "reduced rings", "commutative rings"

IDENTITY = "identity"
IMPLICATION = "implication"
EXHAUSTION = "exhaustion"
MULTILINEAR = "multilinear"
BASIS_TUPLES = "basis tuples"
COUNT = "count"
DETERMINANT = "determinant"
LINEAR_ALGEBRA = "linear algebra"
SMITH_FORM = "Smith form"
WITNESS = "witness"
COUNTEREXAMPLE = "counterexample"
FLOATS_EXACT = "floats, exact on small integers"
PRESENTATION = "presentation"
ALGEBRA = "algebra"
ANISOTROPIC_NORM = "anisotropic norm"
ZERO_NORM = "zero norm"
LEVEL = "level"
SUM_OF_SQUARES = "sum of squares"
ORDERING = "ordering"
CLOSED_FIELD = "closed field"
UNIQUE_ROOTS = "unique roots"
CHOICE_OF_ROOTS = "choice of roots"
ALL_CHOICES_OF_ROOTS = "all choices of roots"
ORDER, IDEAL, ELEMENT, NORM = "order", "ideal", "element", "norm"
ENUMERATION, DISCRIMINANT, BY_MASS = "enumeration", "discriminant", "mass"
BY_S_UNITS, BY_AREA = "S-units", "area"
BY_PRIME, BY_CLASS_NUMBER, BY_EIGENVECTORS = "prime", "class number", "eigenvectors"

# Names that a certificate may use for its method; several are joined by "; ".
METHODS = {
    IDENTITY: "both sides expand to the same polynomials, or differ at the witness",
    IMPLICATION: "each goal is a combination of the hypotheses with polynomial cofactors",
    EXHAUSTION: "all cases over a finite ring were tried",
    MULTILINEAR: "the statement is linear in each unknown, and all tuples of basis elements were tried",
    BASIS_TUPLES: "multilinear maps were compared at tuples of basis elements",
    COUNT: "the number of vectors, or their length, is not the dimension",
    DETERMINANT: "a determinant is a unit, or is not",
    LINEAR_ALGEBRA: "linear equations were solved",
    SMITH_FORM: "linear equations were solved over the integers and therefore over every field",
    WITNESS: "an element with the stated property, or one that refutes the statement",
    COUNTEREXAMPLE: "elements for which the statement is false",
    FLOATS_EXACT: "a counterexample in small integers, which floats compute exactly",
    PRESENTATION: "the goals follow from the relations in the free ring",
    ALGEBRA: "an algebra that satisfies the relations but not the goal",
    ANISOTROPIC_NORM: "the norm is 0 only at 0",
    ZERO_NORM: "a nonzero element has norm 0",
    LEVEL: "−1 is not a sum of that many squares",
    SUM_OF_SQUARES: "−1 is written as a sum of squares",
    ORDERING: "the field is ordered",
    CLOSED_FIELD: "every nonnegative number (over CC: every number) is a square",
    UNIQUE_ROOTS: "in characteristic 2 a square has exactly one root",
    CHOICE_OF_ROOTS: "the law holds for a choice of one root of each square",
    ALL_CHOICES_OF_ROOTS: "the law fails for every choice of roots",
    ORDER: "a lattice is a ring with 1 and has the stated discriminant",
    IDEAL: "a lattice is a locally principal ideal of an order and has the stated norm",
    ELEMENT: "an element carries one lattice to another, or has the stated discriminant",
    NORM: "no element has the quotient of the norms of two ideals as its norm",
    ENUMERATION: "all elements of a given norm, of a given trace and norm, or of least degree were listed",
    DISCRIMINANT: "two orders have different discriminants",
    BY_MASS: "the masses of pairwise different classes add up to the total mass",
    BY_AREA: "a polygon contains the Dirichlet domain and has the same area",
    BY_PRIME: "a quadratic order has no local embedding at a prime",
    BY_CLASS_NUMBER: "the number of pairwise inequivalent embeddings is that of the class number formula",
    BY_EIGENVECTORS: "the number of independent eigenvectors of Hecke operators is the dimension",
    BY_S_UNITS: "S-units for prime ideals that generate the class group give the classes and units",
}

NONE = "none"
NO_MEANING = "no meaning here"
NOT_CHECKABLE = "not checkable"
COMPUTATION = "computation"
FLOATS = "floats"
SEARCH = "search"
THE_PANEL = "panel"
NO_ORDER = "no order"
GAVE_UP = "gave up"

# What an answer without a certificate calls its method.
UNCERTIFIED = {
    NONE: "nothing decided it",
    NO_MEANING: "the terms of the claim have no meaning in the field",
    NOT_CHECKABLE: "no program can check the claim",
    COMPUTATION: "a program was run, or a quantity computed, as the steps say",
    FLOATS: "floats prove nothing",
    SEARCH: "what was searched for was not found",
    THE_PANEL: "each field of the panel was asked",
    NO_ORDER: "the field has no order that > could mean",
    GAVE_UP: "it took too long, or too much memory",
}

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
MASS = "the ideal classes of an order have the mass that its Eichler symbols give (Eichler's mass formula)"
MASS_OVER_FIELDS = (
    "the ideal classes of an order over ℤ_K have the mass of Eichler's formula, by ζ_K(−1)"
)
MASS_OVER_POLYNOMIALS = (
    "the ideal classes of a definite order over GF(q)[t] have the mass of Eichler's formula"
)
SIEGEL = "ζ_K(−1) is a sum of sums of divisors of totally positive numbers (Siegel's formula)"
SHIMIZU = "the units of norm 1 of an order have the area that its Eichler symbols give (Shimizu's formula)"
EMBEDDING_NUMBERS = (
    "the orbits of optimal embeddings are as many as class number and local numbers give (Eichler)"
)
NEW_FUNCTIONS = (
    "newforms of weight 2 are the new functions on ideal classes (Eichler, Jacquet and Langlands)"
)
NEW_FUNCTIONS_OF_WEIGHT = (
    "newforms of weight k are the new functions on ideals with values in polynomials of degree k/2 - 1 "
    "on the quaternions of trace and norm 0 (Eichler, Jacquet and Langlands)"
)
SIGNS = (
    "two-sided ideals act on new functions as the operators of Atkin and Lehner on newforms, up to the sign "
    "at primes where the algebra ramifies (Jacquet and Langlands)"
)
POINCARE = "what pairs the sides of a domain generates its group, its corners give all relations (Poincaré)"
COMPLEX_ROOTS = "every number is a square in CC"
MINKOWSKI = (
    "each class of a number field has an ideal of norm at most (4/π)^r₂·n!/nⁿ·√|D| (Minkowski)"
)
REDUCED_FORMS = (
    "each class of a quadratic field has an ideal of norm at most √(|D|/3), or √(D/5) for D > 0"
)
ZIMMERT = "prime ideals of norm at most c·√|D| generate the class group, c by degree and signature (Zimmert)"
FRIEDMAN = "the regulator of a number field of positive unit rank is at least 0.2052 (Friedman)"
ARTIN = "a unit ε > 1 of a cubic field with one real place has 4ε³ + 24 > |D| (Artin)"
CUSICK = "the regulator of a totally real cubic field is at least log²(D/4)/16 (Cusick)"
HERMITE = (
    "a lattice of rank r and determinant d has a vector of square at most γᵣ·d^(2/r) (Hermite)"
)

# Theorems that evidence may cite, by their text in ``assumes``, with a reference for the proof.
# They are general and state nothing about the particular algebra; everything else in ``assumes`` is
# an assumption.
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
    MASS_OVER_FIELDS: "Voight, Quaternion Algebras, theorem 26.1.5, for every totally definite order",
    MASS_OVER_POLYNOMIALS: "Denert and Van Geel, Math. Ann. 282 (1988), 379-393; by lemma 26.6.7 of Voight, "
    "Quaternion Algebras, for orders that are not maximal",
    SIEGEL: "Siegel, Nachrichten der Akademie Göttingen (1969), 87-102",
    SHIMIZU: "Voight, Quaternion Algebras, theorem 39.1.8 and lemma 26.6.7",
    EMBEDDING_NUMBERS: "Voight, Quaternion Algebras, theorem 30.7.3 and propositions 30.5.3 and 30.6.12",
    NEW_FUNCTIONS: "Dembélé and Voight, Explicit methods for Hilbert modular forms (2013); "
    "Jacquet and Langlands, Automorphic Forms on GL(2), Springer Lecture Notes in Mathematics 114 (1970)",
    NEW_FUNCTIONS_OF_WEIGHT: "Eichler, The basis problem for modular forms, Springer Lecture Notes in "
    "Mathematics 320 (1973), 75-151; Gross, Algebraic modular forms, Israel J. Math. 113 (1999)",
    SIGNS: "Dembélé and Voight, Explicit methods for Hilbert modular forms (2013); Jacquet and Langlands, "
    "Automorphic Forms on GL(2), Springer Lecture Notes in Mathematics 114 (1970)",
    POINCARE: "Voight, Quaternion Algebras, theorem 37.5.3; Maskit, Adv. Math. 7 (1971), 219-230",
    MINKOWSKI: "Neukirch, Algebraic Number Theory, chapter I, section 5 and exercise 3 of section 6",
    REDUCED_FORMS: "Cassels, An Introduction to the Geometry of Numbers, chapter II, theorems II and IV",
    ZIMMERT: "Zimmert, Inventiones mathematicae 62 (1981), 367-380, corollary 1; Hecke, on the different",
    FRIEDMAN: "Friedman, Inventiones mathematicae 98 (1989), 599-622",
    ARTIN: "Artin, Theory of Algebraic Numbers (1959), chapter 13",
    CUSICK: "Cusick, Lower bounds for regulators, Springer Lecture Notes in Mathematics 1068 (1984), 63-73",
    HERMITE: "Cassels, An Introduction to the Geometry of Numbers, chapters IX and X; Blichfeldt for r > 8",
    COMPLEX_ROOTS: "(a + b·i)² = c + d·i is solved by real square roots of (√(c² + d²) ± c)/2",
}
# Theorems with which a statement may be read (``citing{odd-degree; …}``), by their names there.
CITED_BY_NAME = {"odd-degree": ODD_DEGREE, "limits": LIMITS, "induction": INDUCTION}

# The basis, and the words of the language: these mean something in every statement.
BASIS = ("e", "i", "j", "k")
WORDS = (
    *("and", "or", "not", "exists", "conj", "norm", "trace", "inv", "scalar", "vector", "comm"),
    *("dot", "cross", "abs"),
    *("sqrt", "cbrt", "root", "I"),
)
GREEK = (
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "omicron", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
)  # fmt: skip
# Greek letters, functions, e and i with an index, roots, infinity, and names of rings such as Qp or GF9.
_CONSTANT = re.compile(
    rf"(?i:{'|'.join(GREEK)}|varphi|vartheta|varepsilon|root|cos|sin|tan|exp|log|cis|golden|euler)[_0-9]*"
    r"|[eijkEI][_0-9]*|(?:sqrt|cbrt|zeta)[a-zA-Z0-9_]*|(?i:inf|infinity|oo|infty|sqrt[_0-9]*|cbrt[_0-9]*)"
    r"|(?:QQ?|ZZ?|R|RR|C|CC|RDF|CDF|GF|NN|Zmod)_?(?:[pqI]|[0-9]+|bar)?|FF?_?[0-9]+"
)


def reads_like_a_constant(name: str) -> bool:
    """Return whether the name could be read as a number, a place or a ring, as ``zeta5`` or ``inf``.

    Rational functions in such a variable are written ``Frac(QQ[zeta5])``.
    """
    return _CONSTANT.fullmatch(name) is not None

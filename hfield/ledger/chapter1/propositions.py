"""Propositions of sections 1 to 1.4.4 that are not statements of the language and are decided in Python."""

from hfield.checker.glossary import INDUCTION
from hfield.fields.base.ring import INFINITY
from hfield.ledger.base_field import IsDivisionAlgebra, LevelAbove, PositiveNorm
from hfield.ledger.document import Propositions
from hfield.ledger.linear_algebra import Centre, IsBasis
from hfield.ledger.modulus import ModulusDefined, ModulusLaw
from hfield.ledger.multilinear import (
    CurriedIsLinear,
    DeterminedBy,
    LastArgument,
    all_tuples,
    constant_tuples,
    short_tuples,
    spoilt_tuples,
)
from hfield.ledger.propositions import Assertion, Equivalence, Every, Implication, Presented
from hfield.ledger.scopes import Negation, OnlyOver

# Sections 1, 1.1.1 and 1.1.2: the table, its extension to all of H(F), identity, commutativity
TABLE = (
    "e*e == e and e*i == i and e*j == j and e*k == k and "
    "i*e == i and i*i == -e and i*j == k and i*k == -j and "
    "j*e == j and j*i == -k and j*j == -e and j*k == i and "
    "k*e == k and k*i == j and k*j == -i and k*k == -e"
)


# Section 1.2: Theorem 1, that i² = j² = k² = ijk = −e gives the whole table
PRODUCTS = ("i*j == k", "j*i == -k", "j*k == i", "k*j == -i", "k*i == j", "i*k == -j")
UNITS = ("e*e == e", *(f"{x} == {y}" for y in "ijk" for x in (f"e*{y}", f"{y}*e")))
RELATIONS = "i*i == -e and j*j == -e and k*k == -e and (i*j)*k == -e"


# Section 1.3.1 from Definition 4 on: inverses, zero norms, formally real fields, Theorem 3. A
# nonzero q of norm 0 over a field F has a nonzero coordinate, and dividing by its square makes −1 a
# sum of three squares.
THREE_SQUARES = Every(
    tuple(
        Assertion(
            f"norm(q) == 0 and q[{n}] != 0 => "
            + " + ".join(f"(q[{m}]/q[{n}])**2" for m in range(4) if m != n)
            + " == -1"
        )
        for n in range(4)
    ),
    "a nonzero element of norm 0 makes −1 a sum of three squares in F",
)
TWO_SQUARES = Every(
    (
        Assertion("s**2 + y**2 == -1 => norm(e + s*i + y*j) == 0"),
        Assertion("s**2 == -1 => norm(e + s*i) == 0"),
        Assertion(
            "norm(q) == 0 and q[2]**2 + q[3]**2 != 0 => "
            "((q[0]*q[2] + q[1]*q[3])/(q[2]**2 + q[3]**2))**2"
            " + ((q[0]*q[3] - q[1]*q[2])/(q[2]**2 + q[3]**2))**2 == -1"
        ),
        Assertion("q[2]**2 + q[3]**2 == 0 and q[3] != 0 => (q[2]/q[3])**2 == -1"),
        Assertion("q[2]**2 + q[3]**2 == 0 and q[2] != 0 => (q[3]/q[2])**2 == -1"),
        Assertion("norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[1] != 0 => (q[0]/q[1])**2 == -1"),
        Assertion("norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[0] != 0 => (q[1]/q[0])**2 == -1"),
    ),
    "every nonzero element of H(F) has an inverse if and only if −1 is not a sum of two squares in F",
)


# Sections 1.4.1 and 1.4.2: the canonical and the Hamiltonian form
BASIS = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))


# Section 1.4.3: quaternions as 2 × 2 matrices over C.
Matrix = tuple[tuple[str, str], tuple[str, str]]

E: Matrix = (("e", "0*e"), ("0*e", "e"))
I: Matrix = (("i", "0*e"), ("0*e", "-i"))  # noqa: E741  the names of the thesis
J: Matrix = (("0*e", "e"), ("-e", "0*e"))
K: Matrix = (("0*e", "i"), ("i", "0*e"))
UNITS_TIMES_UNITS = {
    "EE": ("", E), "EI": ("", I), "EJ": ("", J), "EK": ("", K),
    "IE": ("", I), "II": ("-", E), "IJ": ("", K), "IK": ("-", J),
    "JE": ("", J), "JI": ("-", K), "JJ": ("-", E), "JK": ("", I),
    "KE": ("", K), "KI": ("", J), "KJ": ("-", I), "KK": ("-", E),
}  # fmt: skip


def times(m: Matrix, n: Matrix) -> Matrix:
    """Return the matrix product as text."""
    (a, b), (c, d) = m
    (s, t), (u, v) = n
    return (
        (f"({a})*({s}) + ({b})*({u})", f"({a})*({t}) + ({b})*({v})"),
        (f"({c})*({s}) + ({d})*({u})", f"({c})*({t}) + ({d})*({v})"),
    )


def table(sign_of_ji: str) -> str:
    """Return Table 1.1 for the four matrices."""
    letters = {"E": E, "I": I, "J": J, "K": K}
    parts = []
    for pair, (sign, result) in UNITS_TIMES_UNITS.items():
        s = sign_of_ji if pair == "JI" else sign
        product = times(letters[pair[0]], letters[pair[1]])
        parts += [f"{product[r][c]} == {s}1*({result[r][c]})" for r in (0, 1) for c in (0, 1)]
    return " and ".join(parts)


# Section 1.4.4: the trigonometric form.
CIRCLE = "(cos θ, sin θ) runs once through the points of the circle c² + s² = 1 for θ in [0, 2π)"
REAL = "Angles are real numbers."


def real(formula: str) -> OnlyOver:
    """Return a statement about angles, which has a meaning only over RR."""
    return OnlyOver(Assertion(formula), ("RR",), REAL, (CIRCLE,))


# q0 = y and ‖q⃗‖ = z; the required angle is that of (y, z) or of (−y, z), whichever is not (1, 0).
SQUARES = (
    "y**2 + z**2 == 1 => "
    "(y != 1 and y**2 + z**2 == 1) or (-y != 1 and (-y)**2 + z**2 == 1 and (-y)**2 == y**2)"
)
# (s, t) = (cos θ, sin θ) with θ in (0, 2π), so that it is not (1, 0).
ROOTS = (
    "s**2 + t**2 == 1 and s != 1 and y**2 + z**2 == 1 and y**2 == s**2 and z**2 == t**2"
    " => y == s and z == t"
)


COMPUTED = {
    # Sections 1, 1.1.1 and 1.1.2: the table, its extension to all of H(F), identity, commutativity
    "C1.1.2-b": Propositions(
        as_printed=Equivalence(
            Assertion("p*q == q*p"),
            Assertion("2 == 0"),
            Every((Assertion("2 == 0 => p*q == q*p"), Assertion("i*j == j*i => 2 == 0"))),
        ),
        spoilt=Equivalence(
            Assertion("p*q == q*p"),
            Assertion("3 == 0"),
            Every((Assertion("3 == 0 => p*q == q*p"), Assertion("i*j == j*i => 3 == 0"))),
        ),
    ),
    "C1.1.2-c": Propositions(as_printed=Centre(2), spoilt=Centre(3)),
    # Section 1.1.3: Lemma 1 on multilinear maps, and associativity through it, triple by triple
    "C1.1.3-a": Propositions(
        as_printed=DeterminedBy(
            all_tuples, (1, 2, 3), "all nᵏ tuples of basis vectors", (INDUCTION,)
        ),
        spoilt=DeterminedBy(spoilt_tuples, (1, 2, 3), "all tuples of basis vectors but one"),
    ),
    "C1.1.3-b": Propositions(
        as_printed=DeterminedBy(constant_tuples, (2, 3), "the sequences {e_{i_1}}_{i=1}^k"),
        spoilt=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k"),
        corrected=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k", (INDUCTION,)),
    ),
    "C1.1.3-c": Propositions(
        as_printed=LastArgument(arities=(1,)), spoilt=LastArgument(upper=3, arities=(1,))
    ),
    "C1.1.3-d": Propositions(as_printed=CurriedIsLinear(), spoilt=CurriedIsLinear(power=2)),
    "C1.1.3-e": Propositions(
        as_printed=LastArgument(upper=5), spoilt=LastArgument(), corrected=LastArgument()
    ),
    "C1.1.3-f": Propositions(
        as_printed=DeterminedBy(
            short_tuples, (2, 3), "sequences of m basis vectors, the last argument fixed"
        ),
        spoilt=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors"),
        corrected=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors", (INDUCTION,)),
    ),
    # Section 1.2: Theorem 1, that i² = j² = k² = ijk = −e gives the whole table
    "C1.2-a": Propositions(
        as_printed=Every(
            (Assertion(RELATIONS), Presented((*PRODUCTS, *UNITS), identity=False)),
            "in an associative algebra with basis (e,i,j,k), Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
        spoilt=Every(
            (Assertion(RELATIONS), Presented(PRODUCTS)),
            "in an associative algebra with identity e, Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
        corrected=Every(
            (Assertion(RELATIONS), Presented(PRODUCTS)),
            "in an associative algebra with identity e, Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
    ),
    "C1.2-c": Propositions(
        as_printed=Presented(
            goals=(
                "e*e == i*j*k*i*j*k",
                "i*j*k*i*j*k == e",
                "e*i == -i*j*k*j*k",
                "-i*j*k*j*k == i",
                "i == -j*k*i*j*k",
                "-j*k*i*j*k == i*e",
                "e*j == -i*j*k*k*i",
                "-i*j*k*k*i == j",
                "j == -k*i*i*j*k",
                "-k*i*i*j*k == j*e",
                "e*k == -i*j*k*i*j",
                "-i*j*k*i*j == k",
                "k == -i*j*i*j*k",
                "-i*j*i*j*k == k*e",
            ),
            identity=True,
        ),
        spoilt=Presented(goals=("e*e == i*j*k*i*j*k", "i*j*k*i*j*k == -e"), identity=True),
    ),
    "C1.2-d": Propositions(
        as_printed=Presented(goals=("i*i*j*k == -i", "j*k == i"), identity=True),
        spoilt=Presented(goals=("j*k == -i",), identity=True),
    ),
    "C1.2-e": Propositions(
        as_printed=Presented(goals=("i*j*k*k == -k", "i*j == k"), identity=True),
        spoilt=Presented(goals=("i*j == -k",), identity=True),
    ),
    "C1.2-f": Propositions(
        as_printed=Presented(goals=("i*i*j*k*k == -i*k", "-i*k == j"), identity=True),
        spoilt=Presented(goals=("i*k == j",), identity=True),
    ),
    "C1.2-g": Propositions(
        as_printed=Presented(
            goals=("j*j*i == -i", "j*j*i == -j*k", "j*i == -k", "k*i == j", "k*j == -i"),
            identity=True,
        ),
        spoilt=Presented(goals=("j*i == k",), identity=True),
    ),
    # Section 1.3 up to the norm's multiplicativity: norm, modulus, conjugate, Theorem 2
    "C1.3.1-a": Propositions(as_printed=ModulusDefined()),
    "C1.3.1-d": Propositions(
        as_printed=Negation(IsDivisionAlgebra("N(q) = 0 ⇒ q = 0")),
        spoilt=Negation(Assertion("q == 0 => norm(q) == 0")),
    ),
    "C1.3.1-n": Propositions(as_printed=ModulusLaw("*"), spoilt=ModulusLaw("+")),
    # Section 1.3.1 from Definition 4 on: inverses, zero norms, formally real fields, Theorem 3
    "C1.3.1-s": Propositions(as_printed=PositiveNorm(), spoilt=PositiveNorm(-1)),
    "C1.3.1-w": Propositions(
        as_printed=Implication(
            Assertion("2 == 0"),
            Assertion("exists q: q != 0 and norm(q) == 0"),
            Every((Assertion("2 == 0 => norm(e + i) == 0"), Assertion("e + i != 0"))),
        ),
        spoilt=Implication(
            Assertion("2 == 0"), Assertion("exists q: q != 0 and norm(q) == 1 and trace(q) == 1")
        ),
    ),
    "C1.3.1-x": Propositions(
        as_printed=Implication(LevelAbove(INFINITY), IsDivisionAlgebra(), THREE_SQUARES),
        spoilt=Implication(LevelAbove(1), IsDivisionAlgebra()),
    ),
    "C1.3.1-y": Propositions(
        as_printed=Implication(IsDivisionAlgebra(), LevelAbove(INFINITY)),
        spoilt=Implication(IsDivisionAlgebra(), LevelAbove(2), TWO_SQUARES),
        corrected=Equivalence(IsDivisionAlgebra(), LevelAbove(2), TWO_SQUARES),
    ),
    # Sections 1.4.1 and 1.4.2: the canonical and the Hamiltonian form
    "C1.4.1-a": Propositions(
        as_printed=Every(
            (IsBasis(BASIS, 4, "(1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,0,1)"), Assertion(TABLE))
        ),
        spoilt=IsBasis((*BASIS[:3], BASIS[2]), 4, "the list with its third vector twice"),
    ),
    "C1.4.2-a": Propositions(
        as_printed=IsBasis(((1, 0, 0), (0, 1, 0), (0, 0, 1)), 4, "{(1,(0,0)), (0,1,0), (0,0,1)}"),
        spoilt=IsBasis(BASIS, 4, "the list of four vectors"),
        corrected=IsBasis(BASIS, 4, "{(1,(0,0,0)), (0,(1,0,0)), (0,(0,1,0)), (0,(0,0,1))}"),
    ),
    # Section 1.4.3: quaternions as 2 × 2 matrices over C.
    "C1.4.3-c": Propositions(as_printed=Assertion(table("-")), spoilt=Assertion(table(""))),
    # Section 1.4.4: the trigonometric form.
    "C1.4.4-b": Propositions(
        as_printed=real(SQUARES), spoilt=real("y**2 + z**2 == 1 => y != 1 and y**2 + z**2 == 1")
    ),
    "C1.4.4-c": Propositions(
        as_printed=real(ROOTS),
        spoilt=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
        corrected=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
    ),
}

"""Section 1.3.1 from Definition 4 on: inverses, zero norms, formally real fields, Theorem 3."""

from hfield.ledger.base_field import Division, LevelAbove, PositiveNorm
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Equivalence, Every, Implication, Statement
from hfield.rings.base import INFINITY

# For a nonzero q of norm 0 in a field F, one of its coordinates is not 0, and dividing by its square
# makes −1 a sum of three squares.
THREE_SQUARES = Every(
    tuple(
        Statement(
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
        Statement("s**2 + y**2 == -1 => norm(e + s*i + y*j) == 0"),
        Statement("s**2 == -1 => norm(e + s*i) == 0"),
        Statement(
            "norm(q) == 0 and q[2]**2 + q[3]**2 != 0 => "
            "((q[0]*q[2] + q[1]*q[3])/(q[2]**2 + q[3]**2))**2"
            " + ((q[0]*q[3] - q[1]*q[2])/(q[2]**2 + q[3]**2))**2 == -1"
        ),
        Statement("q[2]**2 + q[3]**2 == 0 and q[3] != 0 => (q[2]/q[3])**2 == -1"),
        Statement("q[2]**2 + q[3]**2 == 0 and q[2] != 0 => (q[3]/q[2])**2 == -1"),
        Statement("norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[1] != 0 => (q[0]/q[1])**2 == -1"),
        Statement("norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[0] != 0 => (q[1]/q[0])**2 == -1"),
    ),
    "every nonzero element of H(F) has an inverse if and only if −1 is not a sum of two squares in F",
)

COMPUTED = {
    "C1.3.1-s": Propositions(as_printed=PositiveNorm(), spoilt=PositiveNorm(-1)),
    "C1.3.1-w": Propositions(
        as_printed=Implication(
            Statement("2 == 0"),
            Statement("exists q: q != 0 and norm(q) == 0"),
            Every((Statement("2 == 0 => norm(e + i) == 0"), Statement("e + i != 0"))),
        ),
        spoilt=Implication(
            Statement("2 == 0"), Statement("exists q: q != 0 and norm(q) == 1 and trace(q) == 1")
        ),
    ),
    "C1.3.1-x": Propositions(
        as_printed=Implication(LevelAbove(INFINITY), Division(), THREE_SQUARES),
        spoilt=Implication(LevelAbove(1), Division()),
    ),
    "C1.3.1-y": Propositions(
        as_printed=Implication(Division(), LevelAbove(INFINITY)),
        spoilt=Implication(Division(), LevelAbove(2), TWO_SQUARES),
        corrected=Equivalence(Division(), LevelAbove(2), TWO_SQUARES),
    ),
}

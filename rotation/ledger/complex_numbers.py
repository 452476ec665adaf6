"""Section 2.1.3: the rotation of the plane as a product of complex numbers.

The complex numbers are the elements a + b·i of H(F), as in section 1.4.3. So ``i`` is the i of the thesis,
and the algebraic core of every claim holds over every commutative ring.
"""

from hfield.checker.glossary import CIRCLE
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.real_geometry import REAL, Angles
from hfield.ledger.scopes import OnlyOver
from rotation.ledger.plane import ARCTG, ON_CIRCLE

Z = "(p[0] + p[1]*i)"
FORM = "(y + s*i)"
ARCTG_FORM = f"{ARCTG} => {Z} == z*{FORM}"
ANGLE_FORM = (
    f"z**2 == p[0]**2 + p[1]**2 and z != 0 => {Z} == z*(p[0]/z + (p[1]/z)*i)"
    " and (p[0]/z)**2 + (p[1]/z)**2 == 1"
)
POLAR_FORM = Angles(
    Assertion(
        ANGLE_FORM,
        words="if r² = a² + b² and r ≠ 0, then a + bi = r(cos θ + i sin θ) for the angle θ of the point "
        "(a/r, b/r) of the circle",
    )
)

COMPUTED = {
    "C2.1.3-a": Propositions(
        as_printed=OnlyOver(
            Assertion(ARCTG_FORM, words="θ = arctg b/a makes a + bi = |z|(cos θ + i sin θ)"),
            (REAL,),
            "arctg is a real function.",
            (CIRCLE,),
        ),
        spoilt=OnlyOver(
            Assertion(f"{ARCTG} => norm({Z}) == norm(z*{FORM})"),
            (REAL,),
            "arctg is a real function.",
        ),
        corrected=POLAR_FORM,
    ),
    "C2.1.3-b": Propositions(
        as_printed=Angles(
            Assertion(
                f"{ON_CIRCLE} => {Z} == {Z}*{FORM}",
                words="a + bi = (a + bi)(cos θ + i sin θ) for every θ",
            )
        ),
        spoilt=POLAR_FORM,
        corrected=POLAR_FORM,
    ),
}

"""Section 2.1.3: the rotation of the plane as a product of complex numbers.

The complex numbers are the elements a + b·i of H(F), as in section 1.4.3; so ``i`` is the i of the
thesis, and everything has its core over every commutative ring.
"""

from hfield.certificates.theorems import CIRCLE
from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Only, Statement
from hfield.ledger.real import REAL, Angles
from rotation.ledger.entries import apply
from rotation.ledger.plane import ARCTG, ON_CIRCLE, POINT, rotation

Z = "(p[0] + p[1]*i)"
FORM = "(y + s*i)"
ARCTG_FORM = f"{ARCTG} => {Z} == z*{FORM}"
ANGLE_FORM = (
    f"z**2 == p[0]**2 + p[1]**2 and z != 0 => {Z} == z*(p[0]/z + (p[1]/z)*i)"
    " and (p[0]/z)**2 + (p[1]/z)**2 == 1"
)
POLAR_FORM = Angles(
    Statement(
        ANGLE_FORM,
        words="if r² = a² + b² and r ≠ 0, then a + bi = r(cos θ + i sin θ) for the angle θ of the point "
        "(a/r, b/r) of the circle",
    )
)
ADDED = "(p[0]*q[0] - p[1]*q[1] + (p[1]*q[0] + p[0]*q[1])*i)"
PRODUCT = f"(y*{Z})*(z*(q[0] + q[1]*i)) == y*z*{ADDED}"
X, Y = apply(rotation("y", "s"), POINT)
TURN = f"{FORM}*{Z} == ({X}) + ({Y})*i"

CLAIMS = (
    Claim(
        "C2.1.3-a",
        "polar-form",
        "formula",
        "z=|z|(cosθ+i sinθ), ‖z‖=√(a²+b²), θ=arctg(b/a)",
        "θ=arctg b/a",
        Only(
            Statement(ARCTG_FORM, words="θ = arctg b/a makes a + bi = |z|(cos θ + i sin θ)"),
            (REAL,),
            "arctg is a real function.",
            (CIRCLE,),
        ),
        spoilt=Only(
            Statement(f"{ARCTG} => norm({Z}) == norm(z*{FORM})"),
            (REAL,),
            "arctg is a real function.",
        ),
        corrected=POLAR_FORM,
        note="As in C2.1-a: arctg b/a is an angle of a + bi only for a > 0.",
    ),
    Claim(
        "C2.1.3-b",
        "polar-form-of-factor",
        "formula",
        "z1=z1(cosθ+i sinθ)",
        "z1 = z1(cosθ+i sinθ)",
        Angles(
            Statement(
                f"{ON_CIRCLE} => {Z} == {Z}*{FORM}",
                words="a + bi = (a + bi)(cos θ + i sin θ) for every θ",
            )
        ),
        spoilt=POLAR_FORM,
        corrected=POLAR_FORM,
        note="z1 stands on both sides; the factor is the radius r1, as the formula for z2 has it.",
    ),
    Claim(
        "C2.1.3-c",
        "product-in-polar-form",
        "formula",
        "z1z2=r1r2(cos(θ+ψ)+i sin(θ+ψ))",
        "z1z2 = r1r2(cos(θ+ψ)+i sin(θ+ψ))",
        Statement(
            PRODUCT,
            words="r1(cos θ + i sin θ)·r2(cos ψ + i sin ψ) = r1r2(cos(θ+ψ) + i sin(θ+ψ))",
        ),
        spoilt=Statement(PRODUCT.replace("- p[1]*q[1]", "+ p[1]*q[1]")),
        note="cos(θ+ψ) and sin(θ+ψ) by the addition formulas.",
    ),
    Claim(
        "C2.1.3-d",
        "rotation-by-product",
        "claim",
        "rotation by ψ = multiplication by cosψ+i sinψ = e^{iψ}",
        "e^{iψ}",
        Statement(TURN),
        spoilt=Statement(TURN.replace(FORM, "(y - s*i)")),
        note="e^{iψ} is read as a name of cos ψ + i sin ψ (Euler's formula).",
    ),
)

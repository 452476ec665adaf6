"""Section 1.4.4: the trigonometric form.

An angle θ is met through the point (cos θ, sin θ) of the unit circle alone; what only speaks of
such points has an algebraic core over every field. In the formulas s, y and z stand for |q|, ‖q⃗‖,
cos θ or sin θ as the claim needs them, since x and t name variables of some fields.
"""

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Only, Statement

VECTOR = "(q[1]**2 + q[2]**2 + q[3]**2)"
CIRCLE = "(cos θ, sin θ) runs once through the points of the circle c² + s² = 1 for θ in [0, 2π)"
REAL = "Angles are real numbers."


def real(formula: str) -> Only:
    """Return a statement about angles: it means something over RR only."""
    return Only(Statement(formula), ("RR",), REAL, (CIRCLE,))


# q0 = y and ‖q⃗‖ = z; the angle sought is that of (y, z) or of (−y, z), whichever is not (1, 0).
SQUARES = (
    "y**2 + z**2 == 1 => "
    "(y != 1 and y**2 + z**2 == 1) or (-y != 1 and (-y)**2 + z**2 == 1 and (-y)**2 == y**2)"
)
# (s, t) = (cos θ, sin θ) with θ in (0, 2π), so that it is not (1, 0).
ROOTS = (
    "s**2 + t**2 == 1 and s != 1 and y**2 + z**2 == 1 and y**2 == s**2 and z**2 == t**2"
    " => y == s and z == t"
)
AXIS = f"y**2 == {VECTOR} and q[0]**2 + y**2 == 1 => q == q[0] + y*(vector(q)/y)"
SCALED = "s**2 == norm(q) => q == s*(q[0]/s + vector(q)/s) and norm(q[0]/s + vector(q)/s) == 1"
POLAR = (
    f"s != 0 and y != 0 and s**2 == norm(q) and y**2 == {VECTOR} => "
    "q == s*(q[0]/s + (vector(q)/y)*(y/s)) and (q[0]/s)**2 + (y/s)**2 == 1"
)
CONJUGATE = (
    "conj(s*(y + vector(q)*z)) == s*(y - vector(q)*z)"
    " and s*(y - vector(q)*z) == s*(y + vector(q)*(-z))"
)

CLAIMS = (
    Claim(
        "C1.4.4-a",
        "unit-quaternion",
        "formula",
        "|q|=1 ⇒ N(q)=1 and q0²+‖q⃗‖²=1",
        "(system)",
        Statement(f"s**2 == norm(q) and s == 1 => norm(q) == 1 and q[0]**2 + {VECTOR} == 1"),
        spoilt=Statement(f"s**2 == norm(q) and s == 1 => norm(q) == 1 and q[0]**2 - {VECTOR} == 1"),
    ),
    Claim(
        "C1.4.4-b",
        "angle-exists",
        "claim",
        "There is θ ∈ (0,2π) with q0²=cos²θ, ‖q⃗‖²=sin²θ",
        "θ∈(0,2π)",
        real(SQUARES),
        spoilt=real("y**2 + z**2 == 1 => y != 1 and y**2 + z**2 == 1"),
        note="The point (q0,‖q⃗‖), or (−q0,‖q⃗‖) where the first is (1,0), which has no angle in (0,2π).",
    ),
    Claim(
        "C1.4.4-c",
        "angle-without-squares",
        "claim",
        "⇒ q0=cosθ, ‖q⃗‖=sinθ",
        "q0²=cos²θ, ‖q⃗‖²=sin²θ ⇒ q0=cosθ, ‖q⃗‖=sinθ",
        real(ROOTS),
        spoilt=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
        corrected=real("s**2 + t**2 == 1 and y == s and z == t => y**2 + z**2 == 1"),
        note="Squares do not tell signs: q = e has q0 = 1, and its only angle in (0,2π) is π, with "
        "cos π = −1. Choose θ in [0,π] with cos θ = q0; then sin θ = ‖q⃗‖.",
    ),
    Claim(
        "C1.4.4-d",
        "axis",
        "definition",
        "u=q⃗/‖q⃗‖; q=cosθ+u sinθ",
        "u = q⃗/‖q⃗‖",
        Statement(AXIS),
        spoilt=Statement(f"y != 0 and {AXIS}"),
        corrected=Statement(f"y != 0 and {AXIS}"),
        note="For q = ±e the vector part is 0 and has no direction; any unit vector u serves there.",
    ),
    Claim(
        "C1.4.4-e",
        "scaled-form",
        "claim",
        "Any q is |q|(q0/|q|+q⃗/|q|), and the bracket has modulus 1",
        "dowolny kwaternion",
        Statement(SCALED),
        spoilt=Statement(f"s != 0 and {SCALED}"),
        corrected=Statement(f"s != 0 and {SCALED}"),
        note="Not for |q| = 0.",
    ),
    Claim(
        "C1.4.4-f",
        "trigonometric-form",
        "formula",
        "q=|q|(cosθ+u sinθ)",
        "q=|q|(cosθ+u⃗ sinθ)",
        Statement(POLAR),
        spoilt=Statement(POLAR.replace("q == s*(q[0]/s + ", "q == s*(q[0]/s - ")),
        note="Read with the hypotheses |q| ≠ 0 and q⃗ ≠ 0, charged to the two rows before it.",
    ),
    Claim(
        "C1.4.4-g",
        "trigonometric-conjugate",
        "formula",
        "q̄=|q|(cosθ−u sinθ)=|q|(cos(−θ)+u sin(−θ))",
        "q̄=|q|(cosθ−u sinθ)=|q|(cos(−θ)+u sin(−θ))",
        Statement(CONJUGATE),
        spoilt=Statement(
            CONJUGATE.replace("== s*(y - vector(q)*z) and", "== s*(y + vector(q)*z) and")
        ),
        note="cos(−θ) = cos θ and sin(−θ) = −sin θ.",
    ),
    Claim(
        "C1.4.4-h",
        "trigonometric-rest",
        "announcement",
        "“Now conjugate, norm and inverse in trigonometric form”; only the conjugate is given",
        "—",
        note="An announcement. What it announces: N(q) = |q|² and q⁻¹ = |q|⁻¹(cos θ − u sin θ).",
    ),
)

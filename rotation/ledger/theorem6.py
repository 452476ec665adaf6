"""Section 2.2.5: unit and pure quaternions, and Theorem 6 on the rotation T_q.

c = cos θ and s = sin θ are the scalars ``y`` and ``s``; the axis u and the point v are the vector parts
``vector(u)`` and ``vector(v)``, so that all holds over every commutative ring, in
ℤ[c, s, u₁, u₂, u₃]/(c² + s² − 1, u∘u − 1) and any ring that it maps to.
"""

from itertools import pairwise

from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Every, Statement
from hfield.ledger.real import Angles
from rotation.ledger.entries import Vector, coordinates, cross, dot
from rotation.ledger.plane import ON_CIRCLE


def pure(v: Vector) -> str:
    """Return the pure quaternion with these coordinates."""
    x, y, z = v
    return f"(({x})*i + ({y})*j + ({z})*k)"


A, B = coordinates("u"), coordinates("v")
U, V, W = "vector(u)", "vector(v)", pure(cross(A, B))
Q, BAR = f"(y + s*{U})", f"(y - s*{U})"
UNIT, PERPENDICULAR = f"norm({U}) == 1", f"{dot(A, B)} == 0"
COS, SIN = "(y**2 - s**2)", "(2*y*s)"  # of 2θ
PURE_PRODUCT = f"vector(u)*vector(v) == -({dot(A, B)}) + {W}"
# Rodrigues' formula for the angle 2θ: 1 − cos 2θ is 2s².
TURNED = f"{COS}*{V} + {SIN}*{W} + 2*s**2*({dot(A, B)})*{U}"
THEOREM_6 = (
    f"{ON_CIRCLE} and {UNIT} => {Q}*{V}*{BAR} == {TURNED} and {Q}*{BAR} == 1 and {BAR}*{Q} == 1"
)
ON_AXIS = f"{Q}*{U}*{BAR}"
CUBE = f"y**2*{U} - s**2*{U}*{U}*{U}"
EXPANDED = f"y**2*{V} - s*y*{V}*{U} + s*y*{U}*{V} - s**2*{U}*{V}*{U}"


IF_UNIT = "if |u| = 1 and u ⟂ v"


def of_modulus(n: int) -> Statement:
    """Say what the modulus of c + su is for a unit vector u, by its square."""
    words = f"|c + su| = {n} if c² + s² = 1 and |u| = 1"
    return Statement(f"{ON_CIRCLE} and {UNIT} => norm{Q} == {n}", words=words)


def across(result: str, *given: str, words: str = "") -> Statement:
    """Say what T_q(v) is for a unit vector u and a vector v perpendicular to it."""
    hypotheses = " and ".join((*given, UNIT, PERPENDICULAR))
    return Statement(f"{hypotheses} => {Q}*{V}*{BAR} == {result}", words=words)


def chain(*links: str) -> str:
    """Say that terms are equal one after the other, for a unit vector u and v perpendicular to it."""
    equations = " and ".join(f"{x} == {y}" for x, y in pairwise(links))
    return f"{UNIT} and {PERPENDICULAR} => {equations}"


LAST = (
    f"{Q}*{W}*{BAR}",
    f"({Q}*{U}*{BAR})*({Q}*{V}*{BAR})",
    f"{U}*({COS}*{V} + {SIN}*{W})",
    f"{COS}*{W} - {SIN}*{V}",
)


def last(result: str, words: str = "") -> Statement:
    """Say the chain for T_q(w) with the given end."""
    return Statement(f"{ON_CIRCLE} and {chain(*LAST[:3], result)}", words=words)


CLAIMS = (
    Claim(
        "C2.2.5-0",
        "theorem-6-announced",
        "announcement",
        "“we prove the theorem saying that rotation in R^3.” (sentence unfinished)",
        "udowodnimy twierdzenie mówiące o tym, że obrót w przestrzeni R³.",
        note="An announcement that breaks off; Theorem 6 (C2.2.5-e) is what it announces.",
    ),
    Claim(
        "C2.2.5-a",
        "unit-modulus",
        "definition 8",
        "Unit quaternion: modulus equal to 0",
        "moduł jest równy 0",
        of_modulus(0),
        spoilt=of_modulus(1),
        corrected=of_modulus(1),
        note="Checked on what Theorem 6 calls a unit quaternion, c + su with |u| = 1: its modulus is "
        "1. A quaternion of modulus 0 has no inverse.",
    ),
    Claim(
        "C2.2.5-b",
        "pure-quaternion",
        "definition 9",
        "Pure quaternion: scalar part 0",
        "część skalarna równa 0",
        Statement("scalar(q) == 0 <=> q == vector(q)"),
        spoilt=Statement("scalar(q) == 0 <=> q == -vector(q)"),
    ),
    Claim(
        "C2.2.5-c",
        "points-as-quaternions",
        "corollary",
        "R³ ↔ pure quaternions",
        "dowolny element R³ w postaci kwaternionu czysto wektorowego",
        Every(
            (
                Statement(f"scalar({pure(B)}) == 0"),
                Statement(
                    f"{pure(A)} == {pure(B)} => u[1] == v[1] and u[2] == v[2] and u[3] == v[3]"
                ),
                Statement(f"scalar(v) == 0 => v == {pure(B)}"),
            ),
            "(x,y,z) ↦ xi + yj + zk is a bijection of R³ to the pure quaternions",
        ),
        spoilt=Statement(f"v == {pure(B)}"),
    ),
    Claim(
        "C2.2.5-d",
        "pure-product",
        "corollary",
        "q1q2=−q1∘q2+q1×q2 for pure quaternions",
        "q1q2 = −q1∘q2 + q1×q2",
        Statement(PURE_PRODUCT),
        spoilt=Statement(PURE_PRODUCT.replace("== -", "== ")),
    ),
    Claim(
        "C2.2.5-e",
        "theorem-6",
        "theorem 6",
        "T_q(v)=qvq^{-1}, q=c+su, |u|=1, θ∈[0,π], rotates about u by 2θ, right-hand rule",
        "T_q(v)=qvq^{-1}",
        Angles(
            Statement(
                THEOREM_6,
                words="if c² + s² = 1 and |u| = 1, then (c + su)v(c − su) = (c² − s²)v + 2cs(u×v) + "
                "2s²(u∘v)u, and c − su is the inverse of c + su",
            )
        ),
        spoilt=Angles(Statement(THEOREM_6.replace("+ 2*s**2", "- 2*s**2"))),
        headline=True,
        note="q⁻¹ = c − su, and T_q(v) = cos 2θ·v + sin 2θ·(u×v) + (1 − cos 2θ)(u∘v)u for every v, "
        "which is Rodrigues' formula for the axis u and the angle 2θ.",
    ),
    Claim(
        "C2.2.5-f",
        "axis-is-fixed",
        "proof",
        "T_q(u)=(c+su)u(s−cu)=c²u−s²u³",
        "(c+su)u(s−cu)",
        Statement(
            f"{ON_CIRCLE} and {UNIT} => {ON_AXIS} == {Q}*{U}*(s - y*{U})"
            f" and {Q}*{U}*(s - y*{U}) == {CUBE}",
            words="T_q(u) = (c + su)u(s − cu) = c²u − s²u³ if c² + s² = 1 and |u| = 1",
        ),
        spoilt=Statement(f"{ON_AXIS} == {CUBE}"),
        corrected=Statement(f"{ON_AXIS} == {CUBE}", words="(c + su)u(c − su) = c²u − s²u³"),
        note="The inverse of c + su is c − su, not s − cu.",
    ),
    Claim(
        "C2.2.5-g",
        "square-of-axis",
        "proof",
        "u²=−1",
        "u²=−1",
        Statement(f"{UNIT} => {U}*{U} == -1"),
        spoilt=Statement(f"{UNIT} => {U}*{U} == 1"),
    ),
    Claim(
        "C2.2.5-h",
        "axis-is-fixed-end",
        "proof",
        "c²u+s²u=(c²+s²)u=u",
        "T_q(u) = c²u + s²u = (c² + s²)u = u",
        Statement(
            f"{ON_CIRCLE} and {UNIT} => {ON_AXIS} == y**2*{U} + s**2*{U}"
            f" and y**2*{U} + s**2*{U} == (y**2 + s**2)*{U} and (y**2 + s**2)*{U} == {U}",
            words="T_q(u) = c²u + s²u = (c² + s²)u = u if c² + s² = 1 and |u| = 1",
        ),
        spoilt=Statement(f"{ON_CIRCLE} and {UNIT} => {ON_AXIS} == y**2*{U} - s**2*{U}"),
    ),
    Claim(
        "C2.2.5-i",
        "expanded-rotation",
        "proof",
        "T_q(v)=(c+su)v(c−su)=c²v−scvu+scuv−s²uvu",
        "c²v−scvu+scuv−s²uvu",
        Statement(
            f"{Q}*{V}*{BAR} == {EXPANDED}", words="(c + su)v(c − su) = c²v − scvu + scuv − s²uvu"
        ),
        spoilt=Statement(f"{Q}*{V}*{BAR} == {EXPANDED.replace('+ s*y', '- s*y')}"),
    ),
    Claim(
        "C2.2.5-j",
        "axis-on-both-sides",
        "proof",
        "uvu=(u×v)u=wu=w×u=v (u⟂v, |u|=1)",
        "uvu = (u×v)u = wu = w×u = v",
        Statement(
            chain(f"{U}*{V}*{U}", f"{W}*{U}", pure(cross(cross(A, B), A)), V),
            words=f"uvu = (u×v)u = (u×v)×u = v {IF_UNIT}",
        ),
        spoilt=Statement(chain(f"{U}*{V}*{U}", f"{W}*{U}", pure(cross(A, cross(A, B))), V)),
    ),
    Claim(
        "C2.2.5-k",
        "exchanged-factors",
        "proof",
        "vu=v×u=−u×v=−uv=−w",
        "vu = v×u = −u×v = −uv = −w",
        Statement(
            chain(f"{V}*{U}", pure(cross(B, A)), f"-{W}", f"-{U}*{V}", f"-{W}"),
            words=f"vu = v×u = −u×v = −uv = −u×v {IF_UNIT}",
        ),
        spoilt=Statement(chain(f"{V}*{U}", pure(cross(A, B)), f"-{U}*{V}")),
    ),
    Claim(
        "C2.2.5-l",
        "rotation-of-v-printed",
        "proof",
        "T_q(v)=(c²−s²)v+2csu",
        "2csu",
        across(
            f"{COS}*{V} + {SIN}*{U}",
            words=f"(c + su)v(c − su) = (c² − s²)v + 2csu {IF_UNIT}",
        ),
        spoilt=across(f"{COS}*{V} + {SIN}*{W}"),
        corrected=across(
            f"{COS}*{V} + {SIN}*{W}",
            words=f"(c + su)v(c − su) = (c² − s²)v + 2cs·(u×v) {IF_UNIT}",
        ),
        note="The last summand is 2csw. As in the line before it, c and s may be any two scalars.",
    ),
    Claim(
        "C2.2.5-m",
        "rotation-of-v",
        "proof",
        "T_q(v)=cos2θ v+sin2θ w",
        "T_q(v) = cos(2θ)v + sin(2θ)w",
        across(
            f"{COS}*{V} + {SIN}*{W}",
            ON_CIRCLE,
            words=f"T_q(v) = cos 2θ·v + sin 2θ·(u×v) {IF_UNIT}",
        ),
        spoilt=across(f"(y**2 + s**2)*{V} + {SIN}*{W}", ON_CIRCLE),
        note="cos 2θ = c² − s², sin 2θ = 2cs.",
    ),
    Claim(
        "C2.2.5-n",
        "rotation-of-w",
        "proof",
        "T_q(w)=T_q(u)T_q(v)=u(v cos2θ+w sin2θ)=w cos2θ−v sin2θ",
        "T_q(w) = T_q(u)T_q(v) = u(v cos 2θ + w sin 2θ) = w cos 2θ − v sin 2θ",
        last(
            LAST[3],
            "T_q(w) = T_q(u)T_q(v) = u(cos 2θ·v + sin 2θ·w) = cos 2θ·w − sin 2θ·v for w = u×v, "
            f"{IF_UNIT}",
        ),
        spoilt=last(f"(y**2 + s**2)*{W} - {SIN}*{V}"),
    ),
)

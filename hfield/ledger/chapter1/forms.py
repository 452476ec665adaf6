"""Sections 1.4.1 and 1.4.2: the canonical and the Hamiltonian form."""

from hfield.ledger.chapter1.multiplication import I_PART, J_PART, K_PART, SCALAR, TABLE
from hfield.ledger.claim import Claim
from hfield.ledger.multilinear import IsBasis
from hfield.ledger.propositions import Every, Statement

UNITS = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
DOT = "(p[1]*q[1] + p[2]*q[2] + p[3]*q[3])"
CROSS = "((p[2]*q[3] - p[3]*q[2])*i + (p[3]*q[1] - p[1]*q[3])*j + (p[1]*q[2] - p[2]*q[1])*k)"
MIXED = "((p[0]*q[1] + q[0]*p[1])*i + (p[0]*q[2] + q[0]*p[2])*j + (p[0]*q[3] + q[0]*p[3])*k)"
SUM = "(p[0] + q[0])*e + (p[1] + q[1])*i + (p[2] + q[2])*j + (p[3] + q[3])*k"
HAMILTON = f"p*q == p[0]*q[0] - {DOT} + q[0]*vector(p) + p[0]*vector(q) + {CROSS}"

CLAIMS = (
    Claim(
        "C1.4.1-a",
        "canonical-form",
        "claim",
        "The standard basis of R⁴ with Table 1.1 gives H(R)",
        "(1,0,0,0),…",
        Every((IsBasis(UNITS, 4, "(1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,0,1)"), Statement(TABLE))),
        spoilt=IsBasis((*UNITS[:3], UNITS[2]), 4, "the list with its third vector twice"),
    ),
    Claim(
        "C1.4.2-a",
        "hamiltonian-basis",
        "claim",
        "The listed set is a basis of R×R³",
        "{(1,(0,0)),(0,1,0),(0,0,1)}",
        IsBasis(((1, 0, 0), (0, 1, 0), (0, 0, 1)), 4, "{(1,(0,0)), (0,1,0), (0,0,1)}"),
        spoilt=IsBasis(UNITS, 4, "the list of four vectors"),
        corrected=IsBasis(UNITS, 4, "{(1,(0,0,0)), (0,(1,0,0)), (0,(0,1,0)), (0,(0,0,1))}"),
        note="Three vectors with three entries each, for a space of dimension four.",
    ),
    Claim(
        "C1.4.2-b",
        "hamiltonian-sum",
        "formula",
        "Sum in scalar+vector form",
        "q1+q2=a1+a2+(b1+b2,c1+c2,d1+d2)",
        Statement(f"p + q == {SUM}"),
        spoilt=Statement(f"p + q == {SUM.replace('p[3] + q[3]', 'p[3] - q[2]')}"),
    ),
    Claim(
        "C1.4.2-c",
        "hamiltonian-product",
        "formula",
        "Product in scalar+vector form",
        "(a1a2−…)+(a1b2+…, a1c2−b1d2+…, a1d2+…)",
        Statement(
            f"scalar(p*q) == {SCALAR} and vector(p*q) == {I_PART}*i + {J_PART}*j + {K_PART}*k"
        ),
        spoilt=Statement(
            f"scalar(p*q) == {SCALAR} and vector(p*q) == {I_PART}*i + {K_PART}*j + {J_PART}*k"
        ),
    ),
    Claim(
        "C1.4.2-d",
        "scalar-and-vector",
        "definition",
        "Scalar part: the coefficient of the identity; vector part: the rest",
        "część skalarna / wektorowa",
        Statement(
            "q == scalar(q)*e + vector(q) and scalar(q) == q[0]"
            " and vector(q) == q[1]*i + q[2]*j + q[3]*k"
        ),
        spoilt=Statement("q == scalar(q)*e + vector(q) and scalar(q) == q[1]"),
    ),
    Claim(
        "C1.4.2-e",
        "scalar-of-product",
        "formula",
        "Scalar part of the product",
        "a1a2 − q⃗1∘q⃗2",
        Statement(f"scalar(p*q) == p[0]*q[0] - {DOT}"),
        spoilt=Statement(f"scalar(p*q) == p[0]*q[0] + {DOT}"),
    ),
    Claim(
        "C1.4.2-f",
        "vector-of-product",
        "formula",
        "Vector part of the product as w1+w2",
        "(a1b2+a2b1,…)+(c1d2−d1c2,d1b2−b1d2,b1c2−c1b2)",
        Statement(f"vector(p*q) == {MIXED} + {CROSS}"),
        spoilt=Statement(f"vector(p*q) == {MIXED} - {CROSS}"),
    ),
    Claim(
        "C1.4.2-g",
        "mixed-part",
        "formula",
        "w1=a1 q⃗2+a2 q⃗1",
        "a1 q⃗2 + a2 q⃗1",
        Statement(f"{MIXED} == p[0]*vector(q) + q[0]*vector(p)"),
        spoilt=Statement(f"{MIXED} == p[0]*vector(p) + q[0]*vector(q)"),
    ),
    Claim(
        "C1.4.2-h",
        "cross-product",
        "formula",
        "w2=q⃗1×q⃗2",
        "w2 = q⃗1×q⃗2",
        Statement(f"vector(vector(p)*vector(q)) == {CROSS}"),
        spoilt=Statement(f"vector(vector(q)*vector(p)) == {CROSS}"),
        note="w2 is what remains of the vector part for q⃗1 and q⃗2 alone, without scalar parts.",
    ),
    Claim(
        "C1.4.2-i",
        "hamiltonian-form",
        "formula",
        "q1q2 = a1a2 − v1∘v2 + a2v1 + a1v2 + v1×v2",
        "q1q2 = a1a2 − v1∘v2 + a2v1 + a1v2 + v1×v2",
        Statement(HAMILTON),
        spoilt=Statement(HAMILTON.replace(f"+ {CROSS}", f"- {CROSS}")),
    ),
)

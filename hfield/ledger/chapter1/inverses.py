"""Section 1.3.1 from Definition 4 on: inverses, zero norms, formally real fields, Theorem 3."""

from hfield.ledger.claim import Claim
from hfield.ledger.facts import Division, LevelAbove, PositiveNorm
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
CHAR_TWO = ("2 == 0",)
RIGHT = "norm(q) != 0 => q*(conj(q)/norm(q)) == e and (conj(q)/norm(q))*q == e"

CLAIMS = (
    Claim(
        "C1.3.1-r",
        "inverse-formula",
        "definition 4",
        "q^{-1}=q̄/N(q) for N(q)≠0",
        "q̄/N(q)",
        Statement(RIGHT),
        spoilt=Statement(RIGHT.replace("norm(q) != 0 => ", "")),
    ),
    Claim(
        "C1.3.1-s",
        "inverse-exists",
        "claim",
        "The inverse exists if and only if N(q) is greater than 0",
        "wtw, gdy norma … większa od 0",
        PositiveNorm(),
        spoilt=PositiveNorm(-1),
        corrected=Every(
            (
                Statement("norm(q) != 0 => q*(conj(q)/norm(q)) == e"),
                Statement("p*q == e => norm(q) != 0"),
            ),
            "q has an inverse if and only if N(q) ≠ 0",
        ),
        note="Most fields have no order in which a norm could be greater than 0; N(q) ≠ 0 is meant.",
        headline=True,
    ),
    Claim(
        "C1.3.1-t",
        "no-inverse-of-norm-zero",
        "claim",
        "N(q)=0 ⇒ no inverse",
        "norma 0 ⇒ nie ma elementu odwrotnego",
        Statement("norm(q) == 0 => p*q != e"),
        spoilt=Statement("trace(q) == 0 => p*q != e"),
        headline=True,
    ),
    Claim(
        "C1.3.1-u",
        "example-1-norm",
        "example 1",
        "In characteristic 2, q=ae+ai: N(q)=a²+a²=2a²=0",
        "N(q)=a²+a²=2a²=0",
        Statement(
            "norm(s*e + s*i) == s**2 + s**2 and s**2 + s**2 == 2*s**2 and 2*s**2 == 0", CHAR_TWO
        ),
        spoilt=Statement("norm(s*e + s*i + s*j) == 0", CHAR_TWO),
    ),
    Claim(
        "C1.3.1-v",
        "example-1-inverse",
        "example 1",
        "q=ae+ai has no inverse (characteristic 2)",
        "nie ma elementu odwrotnego",
        Statement("p*(s*e + s*i) != e", CHAR_TWO),
        spoilt=Statement("p*(s*e + s*i + s*j) != e", CHAR_TWO),
    ),
    Claim(
        "C1.3.1-w",
        "converse-fails-in-char-2",
        "claim",
        "N(q)=0 ⇒ q=0 fails if the characteristic is 2",
        "implikacja odwrotna nie zachodzi jeśli char = 2",
        Implication(
            Statement("2 == 0"),
            Statement("exists q: q != 0 and norm(q) == 0"),
            Every((Statement("2 == 0 => norm(e + i) == 0"), Statement("e + i != 0"))),
        ),
        spoilt=Implication(
            Statement("2 == 0"), Statement("exists q: q != 0 and norm(q) == 1 and trace(q) == 1")
        ),
    ),
    Claim(
        "C1.3.1-x",
        "formally-real",
        "corollary",
        "All nonzero elements are invertible if F is formally real",
        "jeśli F jest ciałem formalnie rzeczywistym",
        Implication(LevelAbove(INFINITY), Division(), THREE_SQUARES),
        spoilt=Implication(LevelAbove(1), Division()),
        headline=True,
    ),
    Claim(
        "C1.3.1-y",
        "formally-real-converse",
        "implied converse",
        "If every nonzero element is invertible, then F is formally real",
        "—",
        Implication(Division(), LevelAbove(INFINITY)),
        spoilt=Implication(Division(), LevelAbove(2), TWO_SQUARES),
        corrected=Equivalence(Division(), LevelAbove(2), TWO_SQUARES),
        note="The exact condition is that −1 is not a sum of two squares in F.",
        headline=True,
    ),
    Claim(
        "C1.3.1-z",
        "theorem-3",
        "theorem 3",
        "qq^{-1}=q^{-1}q=e",
        "qq^{-1}=q^{-1}q=e",
        Statement("norm(q) != 0 => q*inv(q) == e and inv(q)*q == e"),
        spoilt=Statement("norm(q) != 0 => q*inv(q) == e and inv(q)*q == q"),
        headline=True,
    ),
    Claim(
        "C1.3.1-aa",
        "theorem-3-chain",
        "proof",
        "Proof by “the last property of Theorem 2”, a chain that ends in q^1 q",
        "q q̄/N = N/N = e = N/N = q̄/N·q = q^1q",
        Statement("norm(q) != 0 => q*(conj(q)/norm(q)) == e and (conj(q)/norm(q))*q == q**1*q"),
        spoilt=Statement(
            "norm(q) != 0 => q*(conj(q)/norm(q)) == e and (conj(q)/norm(q))*q == inv(q)*q"
        ),
        corrected=Statement(
            "norm(q) != 0 => q*(conj(q)/norm(q)) == e and (conj(q)/norm(q))*q == inv(q)*q"
        ),
        note="The chain must end in q⁻¹q; and it rests on property 3 of Theorem 2, not on the last one.",
    ),
)

"""Section 1.3 up to the norm's multiplicativity: norm, modulus, conjugate, Theorem 2."""

from hfield.ledger.chapter1.multiplication import COORDINATES, I_PART, J_PART, K_PART, SCALAR
from hfield.ledger.claim import Claim
from hfield.ledger.facts import Division
from hfield.ledger.propositions import Negation, Statement
from hfield.ledger.roots import ModulusDefined, ModulusLaw

SQUARES = "q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2"
CONJUGATE = "q[0]*e - q[1]*i - q[2]*j - q[3]*k"
# The i, j, k coordinates of q·conj(q), as the thesis expands them; it prints the same for conj(q)·q.
EXPANDED = (
    f"({SQUARES})*e + (-q[0]*q[1] + q[1]*q[0] - q[2]*q[3] + q[3]*q[2])*i"
    " + (-q[0]*q[2] + q[1]*q[3] + q[2]*q[0] - q[3]*q[1])*j"
    " + (-q[0]*q[3] - q[1]*q[2] + q[2]*q[1] + q[3]*q[0])*k"
)
CONJUGATED = f"{SCALAR}*e - {I_PART}*i - {J_PART}*j - {K_PART}*k"
TWO_ROOTS = "norm(p*q)*e == p*q*conj(p)*conj(q)"
MENDED = (
    "norm(p*q)*e == p*q*conj(p*q) and p*q*conj(p*q) == p*q*conj(q)*conj(p)"
    " and p*q*conj(q)*conj(p) == norm(p)*norm(q)*e"
)

CLAIMS = (
    Claim(
        "C1.3-a",
        "inverse",
        "definition",
        "Inverse of q: the element whose product with q is the identity",
        "zwróci element neutralny",
        Statement("p*q == e => q*p == e"),
        spoilt=Statement("p*q == -e => q*p == e"),
        note="The definition does not say on which side; it need not: a one-sided inverse has two sides.",
    ),
    Claim(
        "C1.3-b",
        "invertibility-question",
        "announcement",
        "Question: which algebras have every nonzero q invertible",
        "jakie warunki musi spełniać algebra",
        note="A question, answered by C1.3.1-x and C1.3.1-y.",
    ),
    Claim(
        "C1.3.1-a",
        "modulus",
        "definition 1",
        "Modulus |q| = √(a²+b²+c²+d²)",
        "√(a²+b²+c²+d²)",
        ModulusDefined(),
        spoilt=Statement(f"s*s == norm(q) => s*s == {SQUARES}"),
        corrected=Statement(f"s*s == norm(q) => s*s == {SQUARES}"),
        note="Not every field has the square root: |q| exists for those q whose norm is a square in F.",
    ),
    Claim(
        "C1.3.1-b",
        "norm",
        "definition 2",
        "Norm N(q)=a²+b²+c²+d²",
        "N(q)",
        Statement(f"norm(q) == {SQUARES}"),
        spoilt=Statement(f"norm(q) == {SQUARES.replace('+ q[3]', '- q[3]')}"),
    ),
    Claim(
        "C1.3.1-c",
        "norm-of-zero",
        "corollary",
        "q=0 ⇒ N(q)=0",
        "q=0 ⇒ N(q)=0",
        Statement("q == 0 => norm(q) == 0"),
        spoilt=Statement("q == i => norm(q) == 0"),
    ),
    Claim(
        "C1.3.1-d",
        "zero-norms",
        "corollary",
        "The converse, N(q)=0 ⇒ q=0, does not always hold",
        "odwrotna implikacja nie zawsze zachodzi",
        Negation(Division("N(q) = 0 ⇒ q = 0")),
        spoilt=Negation(Statement("q == 0 => norm(q) == 0")),
        headline=True,
        fieldless=True,
    ),
    Claim(
        "C1.3.1-e",
        "conjugate",
        "definition 3",
        "Conjugate q̄=ae−bi−cj−dk",
        "ae − bi − cj − dk",
        Statement(f"conj(q) == {CONJUGATE}"),
        spoilt=Statement(f"conj(q) == {CONJUGATE.replace('- q[3]', '+ q[3]')}"),
    ),
    Claim(
        "C1.3.1-f",
        "theorem-2.1",
        "theorem 2.1",
        "conj conj q = q",
        "q̄̄ = q",
        Statement("conj(conj(q)) == q"),
        spoilt=Statement("conj(q) == q"),
        headline=True,
    ),
    Claim(
        "C1.3.1-g",
        "theorem-2.2",
        "theorem 2.2",
        "conj is additive",
        "conj(q1+q2)=conj q1+conj q2",
        Statement("conj(p + q) == conj(p) + conj(q)"),
        spoilt=Statement("conj(p + q) == conj(p) - conj(q)"),
        headline=True,
    ),
    Claim(
        "C1.3.1-h",
        "theorem-2.3",
        "theorem 2.3",
        "q̄q=qq̄=N(q)e",
        "q̄q = qq̄ = N(q)e",
        Statement("conj(q)*q == q*conj(q) and q*conj(q) == norm(q)*e"),
        spoilt=Statement("conj(q)*q == q*conj(q) and q*q == norm(q)*e"),
        headline=True,
    ),
    Claim(
        "C1.3.1-i",
        "theorem-2.4",
        "theorem 2.4",
        "conj(q1q2)=conj q2 conj q1",
        "conj(q1q2)= q̄2 q̄1",
        Statement("conj(p*q) == conj(q)*conj(p)"),
        spoilt=Statement("conj(p*q) == conj(p)*conj(q)"),
        headline=True,
    ),
    Claim(
        "C1.3.1-j",
        "expansion-q-conj",
        "proof formula",
        "Expansion of qq̄",
        "(a²+b²+c²+d²)e+(−ab+ba−cd+dc)i+(−ac+bd+ca−db)j+(−ad−bc+cb+da)k",
        Statement(f"q*conj(q) == {EXPANDED}"),
        spoilt=Statement(f"q*conj(q) == {EXPANDED.replace('- q[2]*q[3]', '+ q[2]*q[3]')}"),
    ),
    Claim(
        "C1.3.1-k",
        "expansion-conj-q",
        "proof formula",
        "Expansion of conj(q)·q as printed",
        "(the same as for qq̄)",
        Statement(f"conj(q)*q == {EXPANDED}"),
        spoilt=Statement(f"conj(q)*q == {EXPANDED.replace('+ q[3]*q[2]', '- q[3]*q[2]')}"),
        note="The signs belong to qq̄; each bracket vanishes all the same, so the equality holds.",
    ),
    Claim(
        "C1.3.1-l",
        "conjugate-of-product",
        "proof formula",
        "The conjugate of the product, displayed",
        "q̄1q̄2 = (a1a2−b1b2−c1c2−d1d2)e+(a1b2+b1a2+c1d2−d1c2)i+(…)j+(…)k",
        Statement(f"conj(p*q) == {COORDINATES}"),
        spoilt=Statement(f"conj(p*q) == {CONJUGATED}"),
        corrected=Statement(f"conj(p*q) == {CONJUGATED}"),
        note="The display is the product itself: the signs of i, j and k were not changed.",
    ),
    Claim(
        "C1.3.1-m",
        "product-of-conjugates",
        "proof formula",
        "The product of the conjugates, displayed",
        "q̄2q̄1 = (a1a2−…)e+(a1b2+b1a2+c1d2−d1c2)i+…",
        Statement(f"conj(q)*conj(p) == {COORDINATES}"),
        spoilt=Statement(f"conj(q)*conj(p) == {CONJUGATED}"),
        corrected=Statement(f"conj(q)*conj(p) == {CONJUGATED}"),
        note="The same slip as in the display before it.",
    ),
    Claim(
        "C1.3.1-n",
        "modulus-multiplicative",
        "corollary",
        "|q1q2|=|q1||q2|",
        "|q1q2| = |q1||q2|",
        ModulusLaw("*"),
        spoilt=ModulusLaw("+"),
        corrected=Statement("s*s == norm(p) and y*y == norm(q) => (s*y)*(s*y) == norm(p*q)"),
        note="Where −1 is a square no choice of roots is multiplicative; |p||q| is only one of the "
        "roots of N(pq).",
    ),
    Claim(
        "C1.3.1-o",
        "root-of-e",
        "proof",
        "√e=e because e²=e",
        "√e = e, bo e²=e",
        Statement("e*e == e"),
        spoilt=Statement("i*i == e"),
        note="Read as a choice of the root; −e is the other one.",
    ),
    Claim(
        "C1.3.1-p",
        "modulus-chain",
        "proof formula",
        "|q1q2|e=√(N(q1q2)e)=√(q1q2 q̄1q̄2)=√(q1q2q̄2q̄1)=√(N(q1)e N(q2)e)=|q1||q2|",
        "q1q2q̄1q̄2",
        Statement(TWO_ROOTS),
        spoilt=Statement(TWO_ROOTS.replace("conj(p)*conj(q)", "conj(q)*conj(p)")),
        corrected=Statement(MENDED),
        note="Under the second root the conjugate of q1q2 stands in the wrong order.",
    ),
    Claim(
        "C1.3.1-q",
        "norm-multiplicative",
        "corollary",
        "N(q1q2)=N(q1)N(q2)",
        "N(q1q2)=N(q1)N(q2)",
        Statement("norm(p*q) == norm(p)*norm(q)"),
        spoilt=Statement("norm(p*q) == norm(p) + norm(q)"),
        headline=True,
        note="Derived in the print from |q1q2| = |q1||q2|; true without any root.",
    ),
)

"""Sections 1, 1.1.1 and 1.1.2: the table, its extension to all of H(F), identity, commutativity."""

from hfield.ledger.centre import Centre
from hfield.ledger.claim import Claim
from hfield.ledger.propositions import Equivalence, Every, Statement

TABLE = (
    "e*e == e and e*i == i and e*j == j and e*k == k and "
    "i*e == i and i*i == -e and i*j == k and i*k == -j and "
    "j*e == j and j*i == -k and j*j == -e and j*k == i and "
    "k*e == k and k*i == j and k*j == -i and k*k == -e"
)

# p = a1 e + b1 i + c1 j + d1 k and q = a2 e + b2 i + c2 j + d2 k, the q1 and q2 of the thesis.
SIXTEEN = (
    "p*q == p[0]*q[0]*e**2 + p[0]*q[1]*(e*i) + p[0]*q[2]*(e*j) + p[0]*q[3]*(e*k)"
    " + p[1]*q[0]*(i*e) + p[1]*q[1]*i**2 + p[1]*q[2]*(i*j) + p[1]*q[3]*(i*k)"
    " + p[2]*q[0]*(j*e) + p[2]*q[1]*(j*i) + p[2]*q[2]*j**2 + p[2]*q[3]*(j*k)"
    " + p[3]*q[0]*(k*e) + p[3]*q[1]*(k*i) + p[3]*q[2]*(k*j) + p[3]*q[3]*k**2"
)
REPLACED = (
    "p*q == p[0]*q[0]*e + p[0]*q[1]*i + p[0]*q[2]*j + p[0]*q[3]*k"
    " + p[1]*q[0]*i - p[1]*q[1]*e + p[1]*q[2]*k - p[1]*q[3]*j"
    " + p[2]*q[0]*j - p[2]*q[1]*k - p[2]*q[2]*e + p[2]*q[3]*i"
    " + p[3]*q[0]*k + p[3]*q[1]*j - p[3]*q[2]*i - p[3]*q[3]*e"
)
# The coordinates of p*q, as the thesis prints them (and prints them again in 1.3.1 and 1.4.2).
SCALAR = "(p[0]*q[0] - p[1]*q[1] - p[2]*q[2] - p[3]*q[3])"
I_PART = "(p[0]*q[1] + p[1]*q[0] + p[2]*q[3] - p[3]*q[2])"
J_PART = "(p[0]*q[2] - p[1]*q[3] + p[2]*q[0] + p[3]*q[1])"
K_PART = "(p[0]*q[3] + p[1]*q[2] - p[2]*q[1] + p[3]*q[0])"
COORDINATES = f"{SCALAR}*e + {I_PART}*i + {J_PART}*j + {K_PART}*k"
COMMUTATOR = (
    "p*q - q*p == (2*p[2]*q[3] - 2*p[3]*q[2])*i + (2*p[3]*q[1] - 2*p[1]*q[3])*j"
    " + (2*p[1]*q[2] - 2*p[2]*q[1])*k"
)
UNIQUE = "p[0]*e + p[1]*i + p[2]*j + p[3]*k == q[0]*e + q[1]*i + q[2]*j + q[3]*k => p == q"

CLAIMS = (
    Claim(
        "C1-a",
        "table",
        "definition",
        "Table 1.1: the products of the basis e, i, j, k",
        "e e=e, ei=ie=i, …; i²=j²=k²=−e; ij=k, ji=−k, jk=i, kj=−i, ki=j, ik=−j",
        Statement(TABLE),
        spoilt=Statement(TABLE.replace("j*i == -k", "j*i == k")),
        note="The 16 products are computed from i² = j² = −1, ij = k, ji = −k by the one formula.",
        headline=True,
    ),
    Claim(
        "C1-b",
        "coordinates",
        "claim",
        "Every element is ae+bi+cj+dk with unique a, b, c, d in F",
        "ae + bi + cj + dk",
        Every((Statement("q == q[0]*e + q[1]*i + q[2]*j + q[3]*k"), Statement(UNIQUE))),
        spoilt=Statement("q == q[0]*e + q[1]*i + q[2]*j + q[2]*k"),
    ),
    Claim(
        "C1-c",
        "expansion",
        "formula",
        "16-term expansion of q1q2 (first line)",
        "a1a2e²+a1b2ei+…+d1d2k²",
        Statement(SIXTEEN),
        spoilt=Statement(SIXTEEN.replace("p[1]*q[2]*(i*j)", "p[1]*q[2]*(i*k)")),
    ),
    Claim(
        "C1-d",
        "expansion-by-table",
        "formula",
        "Second line: the products replaced from the table",
        "a1a2e + a1b2i + … − d1d2e",
        Statement(REPLACED),
        spoilt=Statement(REPLACED.replace("- p[3]*q[3]*e", "+ p[3]*q[3]*e")),
    ),
    Claim(
        "C1-e",
        "product",
        "formula",
        "Coordinates of q1q2",
        "(a1a2−b1b2−c1c2−d1d2)e+(a1b2+b1a2+c1d2−d1c2)i+(a1c2−b1d2+c1a2+d1b2)j"
        "+(a1d2+b1c2−c1b2+d1a2)k",
        Statement(f"p*q == {COORDINATES}"),
        spoilt=Statement(f"p*q == {COORDINATES.replace('- p[2]*q[1]', '+ p[2]*q[1]')}"),
    ),
    Claim(
        "C1-f",
        "algebra",
        "claim",
        "The conditions of the definition of an algebra hold: the product is bilinear",
        "warunki z definicji ???",
        Statement("(s*p + y*q)*r == s*(p*r) + y*(q*r) and r*(s*p + y*q) == s*(r*p) + y*(r*q)"),
        spoilt=Statement(
            "(s*p + y*q)*r == s*(p*r) + y*(q*r) and r*(s*p + y*q) == s*(r*p) + y*(q*r)"
        ),
        note="The thesis refers to a definition it never gives (???); read as bilinearity.",
    ),
    Claim(
        "C1.1.1-a",
        "identity",
        "claim",
        "e is the two-sided identity: eq=q=qe",
        "eq = q = qe",
        Statement("e*q == q and q == q*e"),
        spoilt=Statement("i*q == q and q == q*i"),
        headline=True,
    ),
    Claim(
        "C1.1.2-a",
        "commutator",
        "formula",
        "The commutator",
        "q1q2−q2q1=(2c1d2−2d1c2)i+(2d1b2−2b1d2)j+(2b1c2−2c1b2)k",
        Statement(COMMUTATOR),
        spoilt=Statement(COMMUTATOR.replace("2*p[1]*q[2] - 2*p[2]*q[1]", "p[1]*q[2] - p[2]*q[1]")),
    ),
    Claim(
        "C1.1.2-b",
        "commutative",
        "claim",
        "H(F) is commutative if and only if char F = 2",
        "zachodzi wtw gdy char(F)=2",
        Equivalence(
            Statement("p*q == q*p"),
            Statement("2 == 0"),
            Every((Statement("2 == 0 => p*q == q*p"), Statement("i*j == j*i => 2 == 0"))),
        ),
        spoilt=Equivalence(
            Statement("p*q == q*p"),
            Statement("3 == 0"),
            Every((Statement("3 == 0 => p*q == q*p"), Statement("i*j == j*i => 3 == 0"))),
        ),
        headline=True,
    ),
    Claim(
        "C1.1.2-c",
        "centre",
        "corollary",
        "Centre: in characteristic 2 the whole algebra, else F",
        "centrum … jest równe F",
        Centre(2),
        spoilt=Centre(3),
        headline=True,
    ),
    Claim(
        "C1.1.2-d",
        "impression",
        "remark",
        "From Table 1.1 multiplication “seems noncommutative”",
        "możemy odnieść wrażenie, że … nieprzemienne",
        note="An impression of the reader, which no program can check; C1.1.2-b decides the matter.",
    ),
)

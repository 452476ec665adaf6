"""Section 1.1.3: Lemma 1 on multilinear maps, and associativity through it, triple by triple."""

from collections.abc import Sequence
from itertools import pairwise, permutations
from itertools import product as tuples

from hfield.certificates.theorems import INDUCTION
from hfield.ledger.claim import Claim
from hfield.ledger.multilinear import (
    CurriedIsLinear,
    DeterminedBy,
    LastArgument,
    all_tuples,
    constant_tuples,
    short_tuples,
    spoilt_tuples,
)
from hfield.ledger.propositions import Statement

Triple = tuple[str, ...]


def associate(triples: Sequence[Triple]) -> str:
    """Return ``(xy)z == x(yz)`` for every triple, joined."""
    return " and ".join(f"({x}*{y})*{z} == {x}*({y}*{z})" for x, y, z in triples)


def triples_claim(
    number: str, name: str, words: str, printed: str, triples: Sequence[Triple]
) -> Claim:
    """Return a claim that f = g on the triples given; its twin has one sign changed."""
    text = associate(triples)
    spoilt = text.replace(" == ", " == -1*", 1)
    return Claim(number, name, "proof", words, printed, Statement(text), spoilt=Statement(spoilt))


WITH_E = [t for t in tuples("eijk", repeat=3) if "e" in t]
EQUAL = [(x, x, x) for x in "ijk"]
DISTINCT = list(permutations("ijk"))
ADJACENT = [t for x, y in permutations("ijk", 2) for t in ((x, x, y), (y, x, x))]


def equations(chain: str) -> Statement:
    """Turn a chain ``x = y = z`` into ``x == y and y == z``."""
    terms = [term.strip() for term in chain.split("=")]
    return Statement(" and ".join(f"{x} == {y}" for x, y in pairwise(terms)))


def chain_claim(number: str, name: str, printed: str, chain: str, spoilt: str) -> Claim:
    """Return the claim that a printed chain for one triple holds."""
    words = f"Triple {printed.split('=')[0].strip()}"
    return Claim(
        number, name, "formula", words, printed, equations(chain), spoilt=equations(spoilt)
    )


CLAIMS = (
    Claim(
        "C1.1.3-a",
        "lemma-1",
        "lemma 1",
        "k-linear f, g: Vᵏ→V are equal if and only if they are equal on all tuples of basis vectors",
        "f(e_{i_1},…,e_{i_k}) = g(e_{i_1},…,e_{i_k})",
        DeterminedBy(all_tuples, (1, 2, 3), "all nᵏ tuples of basis vectors", (INDUCTION,)),
        spoilt=DeterminedBy(spoilt_tuples, (1, 2, 3), "all tuples of basis vectors but one"),
        headline=True,
    ),
    Claim(
        "C1.1.3-b",
        "tuple-notation",
        "notation",
        "A sequence of basis vectors is written {e_{i_1}}_{i=1}^k",
        "{e_{i_1}}_{i=1}^k",
        DeterminedBy(constant_tuples, (2, 3), "the sequences {e_{i_1}}_{i=1}^k"),
        spoilt=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k"),
        corrected=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k", (INDUCTION,)),
        note="The index i_1 does not move with i, so the print names constant sequences only.",
    ),
    Claim(
        "C1.1.3-c",
        "lemma-1-base",
        "proof",
        "Base case k=1",
        "f(a)=Σα_i f(e_i)=Σα_i g(e_i)=g(a)",
        LastArgument(arities=(1,)),
        spoilt=LastArgument(upper=3, arities=(1,)),
    ),
    Claim(
        "C1.1.3-d",
        "lemma-1-curried",
        "proof",
        "f~, g~ (the last argument fixed at a basis vector) are m-linear",
        "f~(a1..am)=f(a1..am,e0)",
        CurriedIsLinear(),
        spoilt=CurriedIsLinear(power=2),
    ),
    Claim(
        "C1.1.3-e",
        "lemma-1-chain",
        "proof",
        "Final chain of the induction step",
        "… = g(a1,…,a_n, Σ_{i=1}^{n+1} α_i e_i) = g(a1,…,am,α)",
        LastArgument(upper=5),
        spoilt=LastArgument(),
        corrected=LastArgument(),
        note="The basis has n vectors, so the sum cannot run to n+1 (and a_n should be a_m).",
    ),
    Claim(
        "C1.1.3-f",
        "lemma-1-hypothesis",
        "proof",
        "The induction hypothesis is stated over sequences of length m though f has m+1 arguments",
        "{e_{i_1}}_{i=1}^m … f(e_{i_1},…,e_{i_{m+1}})",
        DeterminedBy(short_tuples, (2, 3), "sequences of m basis vectors, the last argument fixed"),
        spoilt=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors"),
        corrected=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors", (INDUCTION,)),
        note="With m running indices the last of the m+1 arguments stays where it is.",
    ),
    triples_claim(
        "C1.1.3-g",
        "triples-with-e",
        "Triples containing e need no check",
        "wystarczy … bez wektora e",
        WITH_E,
    ),
    triples_claim(
        "C1.1.3-h",
        "triples-equal",
        "Triples of three equal basis vectors: f=g",
        "dla trzech tych samych",
        EQUAL,
    ),
    triples_claim(
        "C1.1.3-i",
        "triples-distinct",
        "Triples of pairwise distinct basis vectors: f=g",
        "wszystkie elementy różne",
        DISTINCT,
    ),
    triples_claim(
        "C1.1.3-j",
        "triples-adjacent",
        "Repeated elements adjacent: f=g",
        "powtarzające się elementy sąsiadują",
        ADJACENT,
    ),
    chain_claim(
        "C1.1.3-k",
        "triple-iji",
        "f(i,j,i)=(ij)i=j=i(ji)=g(i,j,i)",
        "(i*j)*i = j = i*(j*i)",
        "(i*j)*i = k = i*(j*i)",
    ),
    chain_claim(
        "C1.1.3-l",
        "triple-jij",
        "f(j,i,j)=(ji)j=i=j(ij)=g(j,i,j)",
        "(j*i)*j = i = j*(i*j)",
        "(j*i)*j = i = j*(j*i)",
    ),
    chain_claim(
        "C1.1.3-m",
        "triple-kik",
        "f(k,i,k)=(ki)k=i=k(ik)=g(k,i,k)",
        "(k*i)*k = i = k*(i*k)",
        "(k*i)*k = i = k*(i*i)",
    ),
    Claim(
        "C1.1.3-n",
        "triple-iki",
        "formula",
        "Triple f(i,k,i)",
        "f(i,k,i) = (ki)k = i = k(ik) = g(i,k,i)",
        equations("(i*k)*i = (k*i)*k = i = k*(i*k) = i*(k*i)"),
        spoilt=equations("(k*i)*k = i = k*(i*k)"),
        corrected=equations("(i*k)*i = k = i*(k*i)"),
        note="The print repeats the chain of f(k,i,k); but (ik)i = k, not i.",
    ),
    Claim(
        "C1.1.3-o",
        "triple-kjk",
        "formula",
        "Triple f(k,j,k)",
        "f(k,j,k) = (kj)k = j = k(jk) = g(i,j,i)",
        equations("(k*j)*k = j = k*(j*k) = i*(j*i)"),
        spoilt=equations("(k*j)*k = j = k*(j*k) = j*(i*j)"),
        note="The print ends in g(i,j,i) where g(k,j,k) is meant; both are j, so the chain holds.",
    ),
    chain_claim(
        "C1.1.3-p",
        "triple-jkj",
        "f(j,k,j)=(jk)j=k=j(kj)=g(j,k,j)",
        "(j*k)*j = k = j*(k*j)",
        "(j*k)*j = k = j*(k*k)",
    ),
    Claim(
        "C1.1.3-q",
        "associativity",
        "claim",
        "Multiplication in H(F) is associative",
        "(xy)z = x(yz)",
        Statement("(p*q)*r == p*(q*r)"),
        spoilt=Statement("(p*q)*r == p*(r*q)"),
        headline=True,
    ),
)

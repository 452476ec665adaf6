"""Section 1.2: Theorem 1, that i² = j² = k² = ijk = −e gives the whole table."""

from hfield.ledger.claim import Claim
from hfield.ledger.presented import Presented
from hfield.ledger.propositions import Every, Statement

PRODUCTS = ("i*j == k", "j*i == -k", "j*k == i", "k*j == -i", "k*i == j", "i*k == -j")
UNITS = ("e*e == e", *(f"{x} == {y}" for y in "ijk" for x in (f"e*{y}", f"{y}*e")))
RELATIONS = "i*i == -e and j*j == -e and k*k == -e and (i*j)*k == -e"


def derived(
    number: str, name: str, printed: str, goals: str, spoilt: str, words: str = ""
) -> Claim:
    """Return a claim of the theorem's proof: ``goals``, comma separated, follow by the relations."""
    first, second = (tuple(g.strip() for g in text.split(",")) for text in (goals, spoilt))
    return Claim(
        number,
        name,
        "formula",
        words or printed,
        printed,
        Presented(first),
        spoilt=Presented(second),
        note="Read with e as the identity, the hypothesis that the theorem leaves out (C1.2-a).",
    )


CLAIMS = (
    Claim(
        "C1.2-a",
        "theorem-1",
        "theorem 1",
        "In an associative algebra with basis (e,i,j,k), Table 1.1 ⇔ i²=j²=k²=ijk=−e",
        "i² = j² = k² = −e = ijk",
        Every(
            (Statement(RELATIONS), Presented((*PRODUCTS, *UNITS), identity=False)),
            "in an associative algebra with basis (e,i,j,k), Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
        spoilt=Every(
            (Statement(RELATIONS), Presented(PRODUCTS)),
            "in an associative algebra with identity e, Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
        corrected=Every(
            (Statement(RELATIONS), Presented(PRODUCTS)),
            "in an associative algebra with identity e, Table 1.1 ⇔ i² = j² = k² = −e = ijk",
        ),
        note="Nothing printed says that e is the identity, and without that ij = k does not follow.",
        headline=True,
    ),
    Claim(
        "C1.2-b",
        "theorem-1-forward",
        "proof",
        "1 ⇒ 2 is immediate",
        "z warunku 1. wynikają równości 2.",
        Statement(RELATIONS),
        spoilt=Statement(RELATIONS.replace("(i*j)*k", "(j*i)*k")),
    ),
    derived(
        "C1.2-c",
        "identity-from-relations",
        "ee=ijkijk=e; ei=(−ijk)jk=i=jk(−ijk)=ie; ej=(−ijk)ki=j=ki(−ijk)=je; ek=(−ijk)ij=k=ij(−ijk)=ke",
        "e*e == i*j*k*i*j*k, i*j*k*i*j*k == e,"
        "e*i == -i*j*k*j*k, -i*j*k*j*k == i, i == -j*k*i*j*k, -j*k*i*j*k == i*e,"
        "e*j == -i*j*k*k*i, -i*j*k*k*i == j, j == -k*i*i*j*k, -k*i*i*j*k == j*e,"
        "e*k == -i*j*k*i*j, -i*j*k*i*j == k, k == -i*j*i*j*k, -i*j*i*j*k == k*e",
        "e*e == i*j*k*i*j*k, i*j*k*i*j*k == -e",
    ),
    derived(
        "C1.2-d", "jk-is-i", "ijk=−1 ⇒ i(ijk)=−i ⇒ jk=i", "i*i*j*k == -i, j*k == i", "j*k == -i"
    ),
    derived(
        "C1.2-e", "ij-is-k", "ijk=−1 ⇒ (ijk)k=−k ⇒ ij=k", "i*j*k*k == -k, i*j == k", "i*j == -k"
    ),
    derived(
        "C1.2-f",
        "ik-is-minus-j",
        "ijk=−1 ⇒ i(ijk)k = −ik ⇒ −ik=j",
        "i*i*j*k*k == -i*k, -i*k == j",
        "i*k == j",
    ),
    derived(
        "C1.2-g",
        "ji-is-minus-k",
        "j²i=−i ⇒ j(ji)=j(−k) ⇒ ji=−k ⇒ ki=j, kj=−i",
        "j*j*i == -i, j*j*i == -j*k, j*i == -k, k*i == j, k*j == -i",
        "j*i == k",
    ),
)

"""Section 1.2: Theorem 1, that i² = j² = k² = ijk = −e gives the whole table."""

from hfield.ledger.document import Propositions
from hfield.ledger.presented import Presented
from hfield.ledger.propositions import Every, Statement

PRODUCTS = ("i*j == k", "j*i == -k", "j*k == i", "k*j == -i", "k*i == j", "i*k == -j")
UNITS = ("e*e == e", *(f"{x} == {y}" for y in "ijk" for x in (f"e*{y}", f"{y}*e")))
RELATIONS = "i*i == -e and j*j == -e and k*k == -e and (i*j)*k == -e"


COMPUTED = {
    "C1.2-a": Propositions(
        as_printed=Every(
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
    ),
    "C1.2-c": Propositions(
        as_printed=Presented(
            goals=(
                "e*e == i*j*k*i*j*k",
                "i*j*k*i*j*k == e",
                "e*i == -i*j*k*j*k",
                "-i*j*k*j*k == i",
                "i == -j*k*i*j*k",
                "-j*k*i*j*k == i*e",
                "e*j == -i*j*k*k*i",
                "-i*j*k*k*i == j",
                "j == -k*i*i*j*k",
                "-k*i*i*j*k == j*e",
                "e*k == -i*j*k*i*j",
                "-i*j*k*i*j == k",
                "k == -i*j*i*j*k",
                "-i*j*i*j*k == k*e",
            ),
            identity=True,
        ),
        spoilt=Presented(goals=("e*e == i*j*k*i*j*k", "i*j*k*i*j*k == -e"), identity=True),
    ),
    "C1.2-d": Propositions(
        as_printed=Presented(goals=("i*i*j*k == -i", "j*k == i"), identity=True),
        spoilt=Presented(goals=("j*k == -i",), identity=True),
    ),
    "C1.2-e": Propositions(
        as_printed=Presented(goals=("i*j*k*k == -k", "i*j == k"), identity=True),
        spoilt=Presented(goals=("i*j == -k",), identity=True),
    ),
    "C1.2-f": Propositions(
        as_printed=Presented(goals=("i*i*j*k*k == -i*k", "-i*k == j"), identity=True),
        spoilt=Presented(goals=("i*k == j",), identity=True),
    ),
    "C1.2-g": Propositions(
        as_printed=Presented(
            goals=("j*j*i == -i", "j*j*i == -j*k", "j*i == -k", "k*i == j", "k*j == -i"),
            identity=True,
        ),
        spoilt=Presented(goals=("j*i == k",), identity=True),
    ),
}

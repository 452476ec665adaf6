"""Sections 1, 1.1.1 and 1.1.2: the table, its extension to all of H(F), identity, commutativity."""

from hfield.ledger.document import Propositions
from hfield.ledger.linear_algebra import Centre
from hfield.ledger.propositions import Equivalence, Every, Statement

TABLE = (
    "e*e == e and e*i == i and e*j == j and e*k == k and "
    "i*e == i and i*i == -e and i*j == k and i*k == -j and "
    "j*e == j and j*i == -k and j*j == -e and j*k == i and "
    "k*e == k and k*i == j and k*j == -i and k*k == -e"
)


COMPUTED = {
    "C1.1.2-b": Propositions(
        as_printed=Equivalence(
            Statement("p*q == q*p"),
            Statement("2 == 0"),
            Every((Statement("2 == 0 => p*q == q*p"), Statement("i*j == j*i => 2 == 0"))),
        ),
        spoilt=Equivalence(
            Statement("p*q == q*p"),
            Statement("3 == 0"),
            Every((Statement("3 == 0 => p*q == q*p"), Statement("i*j == j*i => 3 == 0"))),
        ),
    ),
    "C1.1.2-c": Propositions(as_printed=Centre(2), spoilt=Centre(3)),
}

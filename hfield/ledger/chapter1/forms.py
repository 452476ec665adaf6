"""Sections 1.4.1 and 1.4.2: the canonical and the Hamiltonian form."""

from hfield.ledger.chapter1.multiplication import TABLE
from hfield.ledger.document import Propositions
from hfield.ledger.linear_algebra import IsBasis
from hfield.ledger.propositions import Every, Statement

UNITS = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))

COMPUTED = {
    "C1.4.1-a": Propositions(
        as_printed=Every(
            (IsBasis(UNITS, 4, "(1,0,0,0), (0,1,0,0), (0,0,1,0), (0,0,0,1)"), Statement(TABLE))
        ),
        spoilt=IsBasis((*UNITS[:3], UNITS[2]), 4, "the list with its third vector twice"),
    ),
    "C1.4.2-a": Propositions(
        as_printed=IsBasis(((1, 0, 0), (0, 1, 0), (0, 0, 1)), 4, "{(1,(0,0)), (0,1,0), (0,0,1)}"),
        spoilt=IsBasis(UNITS, 4, "the list of four vectors"),
        corrected=IsBasis(UNITS, 4, "{(1,(0,0,0)), (0,(1,0,0)), (0,(0,1,0)), (0,(0,0,1))}"),
    ),
}

"""Section 1.3 up to the norm's multiplicativity: norm, modulus, conjugate, Theorem 2."""

from hfield.ledger.base_field import Division
from hfield.ledger.document import Propositions
from hfield.ledger.modulus import ModulusDefined, ModulusLaw
from hfield.ledger.propositions import Statement
from hfield.ledger.scopes import Negation

COMPUTED = {
    "C1.3.1-a": Propositions(as_printed=ModulusDefined()),
    "C1.3.1-d": Propositions(
        as_printed=Negation(Division("N(q) = 0 ⇒ q = 0")),
        spoilt=Negation(Statement("q == 0 => norm(q) == 0")),
    ),
    "C1.3.1-n": Propositions(as_printed=ModulusLaw("*"), spoilt=ModulusLaw("+")),
}

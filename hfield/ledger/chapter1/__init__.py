"""Chapter 1 of the thesis: the 92 claims of sections 1 to 1.4.4, in the order of the text."""

from hfield.ledger.chapter1.propositions import COMPUTED
from hfield.ledger.claim import Claim
from hfield.ledger.document import load

CLAIMS: tuple[Claim, ...] = load(__name__, "chapter1.toml", COMPUTED)

"""Section 1.1.3: Lemma 1 on multilinear maps, and associativity through it, triple by triple."""

from hfield.certificates.glossary import INDUCTION
from hfield.ledger.document import Propositions
from hfield.ledger.multilinear import (
    CurriedIsLinear,
    DeterminedBy,
    LastArgument,
    all_tuples,
    constant_tuples,
    short_tuples,
    spoilt_tuples,
)

COMPUTED = {
    "C1.1.3-a": Propositions(
        as_printed=DeterminedBy(
            all_tuples, (1, 2, 3), "all nᵏ tuples of basis vectors", (INDUCTION,)
        ),
        spoilt=DeterminedBy(spoilt_tuples, (1, 2, 3), "all tuples of basis vectors but one"),
    ),
    "C1.1.3-b": Propositions(
        as_printed=DeterminedBy(constant_tuples, (2, 3), "the sequences {e_{i_1}}_{i=1}^k"),
        spoilt=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k"),
        corrected=DeterminedBy(all_tuples, (2, 3), "the sequences {e_{i_l}}_{l=1}^k", (INDUCTION,)),
    ),
    "C1.1.3-c": Propositions(
        as_printed=LastArgument(arities=(1,)), spoilt=LastArgument(upper=3, arities=(1,))
    ),
    "C1.1.3-d": Propositions(as_printed=CurriedIsLinear(), spoilt=CurriedIsLinear(power=2)),
    "C1.1.3-e": Propositions(
        as_printed=LastArgument(upper=5), spoilt=LastArgument(), corrected=LastArgument()
    ),
    "C1.1.3-f": Propositions(
        as_printed=DeterminedBy(
            short_tuples, (2, 3), "sequences of m basis vectors, the last argument fixed"
        ),
        spoilt=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors"),
        corrected=DeterminedBy(all_tuples, (2, 3), "sequences of m+1 basis vectors", (INDUCTION,)),
    ),
}

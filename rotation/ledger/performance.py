"""Section 3.2: the two tests, their tables, and the thesis's conclusions from them.

Numbers are recomputed from the printed times over ℚ. The functions of the second test are run on symbolic
points to find their formulas.
"""

from hfield.ledger.claim import Computed, ComputedResult
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion
from hfield.ledger.scopes import InField
from rotation.ledger import generator, printed_times, second_benchmark
from rotation.ledger.inequalities import Less, between
from rotation.ledger.printed_times import MATRICES_1, MATRICES_2, QUATERNIONS_1, QUATERNIONS_2

SAVING = "the per cent by which the matrices' mean of test 1 is shorter"
RATIO = "the matrices' mean of test 2 over the quaternions'"
GAP = "the quaternions' mean of test 2 less that of test 1"


def mean_is(times: printed_times.Times, printed: str) -> InField:
    """Return the claim that the mean of the times is the printed number."""
    return InField("QQ", Assertion(f"{printed_times.mean(times)} == {printed}"))


def repeated(count: int) -> Computed:
    """Return the claim that each of the four table rows has so many times, in whole seconds."""

    def check_claim() -> ComputedResult:
        lengths = [len(row) for row in printed_times.ALL]
        whole = all(isinstance(time, int) for row in printed_times.ALL for time in row)
        return ComputedResult(
            whole and set(lengths) == {count},
            (
                f"rows of {', '.join(map(str, lengths))} times, {'all' if whole else 'not all'} whole",
            ),
        )

    return Computed(f"each row of the tables has {count} times in whole seconds", check_claim)


COMPUTED = {
    "C3.2.1-a": Propositions(
        as_printed=generator.within("[0, 1]", lambda low, high: low >= 0 and high <= 1),
        spoilt=generator.within("(0, 1]", lambda low, high: low > 0 and high <= 1),
    ),
    "C3.2.1-c": Propositions(
        as_printed=InField("QQ", Assertion("10*30 == 300")),
        spoilt=InField("QQ", Assertion("10*25 == 300")),
    ),
    "C3.2.1-d": Propositions(as_printed=repeated(10), spoilt=repeated(11)),
    "C3.2.1-e": Propositions(
        as_printed=mean_is(QUATERNIONS_1, "434.9"), spoilt=mean_is(QUATERNIONS_2, "434.9")
    ),
    "C3.2.1-f": Propositions(
        as_printed=mean_is(MATRICES_1, "385.2"),
        spoilt=mean_is(MATRICES_1, "385.1"),
        corrected=mean_is(MATRICES_1, "385.1"),
    ),
    "C3.2.1-g": Propositions(
        as_printed=mean_is(QUATERNIONS_2, "444.5"), spoilt=mean_is(QUATERNIONS_1, "444.5")
    ),
    "C3.2.1-h": Propositions(
        as_printed=mean_is(MATRICES_2, "1763.7"), spoilt=mean_is(MATRICES_2, "1763.8")
    ),
    "C3.2.1-i": Propositions(
        as_printed=second_benchmark.STAYS, spoilt=second_benchmark.STAYS_ABOUT_ANOTHER
    ),
    "C3.2.1-j": Propositions(
        as_printed=second_benchmark.determined("q[0] != 0", "q[0] + v[0] != 0"),
        spoilt=second_benchmark.determined("q[0] != 0", "v[0] != 0"),
    ),
    "C3.2.1-k": Propositions(
        as_printed=second_benchmark.euler_turned("x"), spoilt=second_benchmark.euler_turned("zero")
    ),
    "C3.2.1-l": Propositions(
        as_printed=second_benchmark.MOVES,
        spoilt=second_benchmark.MOVES_ABOUT_ANOTHER,
        corrected=second_benchmark.MOVES_ABOUT_ANOTHER,
    ),
    "C3.2.1-n": Propositions(
        as_printed=InField(
            "QQ", between("11.45", printed_times.saving(QUATERNIONS_1, MATRICES_1), "11.55", SAVING)
        ),
        spoilt=InField(
            "QQ", between("11.45", printed_times.saving(MATRICES_1, QUATERNIONS_1), "11.55", SAVING)
        ),
    ),
    "C3.2.1-n2": Propositions(
        as_printed=InField(
            "QQ",
            Less(
                printed_times.mean(MATRICES_1),
                printed_times.mean(QUATERNIONS_1),
                "the matrices' mean of test 1 < the quaternions'",
            ),
        ),
        spoilt=InField(
            "QQ", Less(printed_times.mean(QUATERNIONS_1), printed_times.mean(MATRICES_1))
        ),
    ),
    "C3.2.1-o": Propositions(
        as_printed=InField(
            "QQ", between("2.5", printed_times.ratio(MATRICES_2, QUATERNIONS_2), "3", RATIO)
        ),
        spoilt=InField(
            "QQ", between("3.5", printed_times.ratio(MATRICES_2, QUATERNIONS_2), "4", RATIO)
        ),
        corrected=InField(
            "QQ", between("3.5", printed_times.ratio(MATRICES_2, QUATERNIONS_2), "4", RATIO)
        ),
    ),
    "C3.2.1-p": Propositions(
        as_printed=InField(
            "QQ",
            between(
                "9.5",
                f"{printed_times.mean(QUATERNIONS_2)} - {printed_times.mean(QUATERNIONS_1)}",
                "10",
                GAP,
            ),
        ),
        spoilt=InField(
            "QQ",
            between(
                "9.5",
                f"{printed_times.mean(QUATERNIONS_1)} - {printed_times.mean(QUATERNIONS_2)}",
                "10",
                GAP,
            ),
        ),
    ),
}

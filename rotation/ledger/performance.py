"""Section 3.2: the two tests, their tables, and what is concluded from them.

Numbers are recomputed from the printed times over ℚ. Of the second test, what its functions do to
a point is found by running them on symbols.
"""

from hfield.ledger.computed import Computed, Finding
from hfield.ledger.propositions import Over, Statement
from rotation.ledger import generator, second_test, tables
from rotation.ledger.order import Less, between
from rotation.ledger.programs import claim
from rotation.ledger.tables import MATRICES_1, MATRICES_2, QUATERNIONS_1, QUATERNIONS_2

SAVING = "the per cent by which the matrices' mean of test 1 is shorter"
RATIO = "the matrices' mean of test 2 over the quaternions'"
GAP = "the quaternions' mean of test 2 less that of test 1"


def mean_is(times: tables.Times, printed: str) -> Over:
    """Say that the mean of the times is the number printed."""
    return Over("QQ", Statement(f"{tables.mean(times)} == {printed}"))


def repeated(count: int) -> Computed:
    """Say that each of the four rows of the tables has so many times, in whole seconds."""

    def look() -> Finding:
        lengths = [len(row) for row in tables.ALL]
        whole = all(isinstance(time, int) for row in tables.ALL for time in row)
        return Finding(
            whole and set(lengths) == {count},
            (
                f"rows of {', '.join(map(str, lengths))} times, {'all' if whole else 'not all'} whole",
            ),
        )

    return Computed(f"each row of the tables has {count} times in whole seconds", look)


CLAIMS = (
    claim(
        "C3.2-a",
        "premiere",
        "fact",
        "The game's premiere was at the beginning of 2017",
        "na początku 2017",
        note="A fact about a game.",
    ),
    claim(
        "C3.2-b",
        "triangles",
        "fact",
        "The model Aloy has about 550 000 triangles",
        "około 550 tys. trójkątów",
        note="A fact about a game.",
    ),
    claim(
        "C3.2-c",
        "exactly-550000",
        "assumption",
        "The model is taken to be exactly 550 000 points",
        "dokładnie 550 tys",
        note="An assumption, made to simplify. A closed surface of 550 000 triangles has half as many "
        "vertices, give or take its holes.",
    ),
    claim(
        "C3.2.1-a",
        "random-interval",
        "fact",
        "random() returns a number in [0, 1]",
        "[0, 1]",
        generator.within("[0, 1]", lambda low, high: low >= 0 and high <= 1),
        spoilt=generator.within("(0, 1]", lambda low, high: low > 0 and high <= 1),
        note="It is [0, 1): the largest number returned is 1 − 2⁻⁵³, so that 1 never occurs.",
    ),
    claim(
        "C3.2.1-b",
        "points-loop",
        "spec",
        "A loop of 550 000 rounds appends a list of three random numbers each time",
        "trójkątemową",
        note="What a program is to do, neither true nor false. “Trójkątemową” should read "
        "“trójelementową”.",
    ),
    claim(
        "C3.2.1-c",
        "three-hundred-frames",
        "number",
        "300 angles about the z axis: 10 seconds of 30 frames",
        "300 = 10·30",
        Over("QQ", Statement("10*30 == 300")),
        spoilt=Over("QQ", Statement("10*25 == 300")),
    ),
    claim(
        "C3.2.1-d",
        "ten-repetitions",
        "number",
        "The test is repeated 10 times; times are rounded to seconds",
        "10 razy",
        repeated(10),
        spoilt=repeated(11),
        note="Read of both tables; that they were rounded shows in that they are whole.",
    ),
    claim(
        "C3.2.1-e",
        "mean-quaternions-1",
        "number",
        "Test 1: the mean of the quaternion model",
        "434.9",
        mean_is(QUATERNIONS_1, "434.9"),
        spoilt=mean_is(QUATERNIONS_2, "434.9"),
    ),
    claim(
        "C3.2.1-f",
        "mean-matrices-1",
        "number",
        "Test 1: the mean of the matrix model",
        "385.2",
        mean_is(MATRICES_1, "385.2"),
        spoilt=mean_is(MATRICES_1, "385.1"),
        corrected=mean_is(MATRICES_1, "385.1"),
        note="The ten times add up to 3851.",
    ),
    claim(
        "C3.2.1-g",
        "mean-quaternions-2",
        "number",
        "Test 2: the mean of the quaternion model",
        "444.5",
        mean_is(QUATERNIONS_2, "444.5"),
        spoilt=mean_is(QUATERNIONS_1, "444.5"),
    ),
    claim(
        "C3.2.1-h",
        "mean-matrices-2",
        "number",
        "Test 2: the mean of the matrix model",
        "1763.7",
        mean_is(MATRICES_2, "1763.7"),
        spoilt=mean_is(MATRICES_2, "1763.8"),
    ),
    claim(
        "C3.2.1-i",
        "own-axis",
        "spec",
        "Test 2, quaternion model: the axis of a point x is x/|x|, so the point itself is the axis",
        "1/r [x1,x2,x3]",
        second_test.STAYS,
        spoilt=second_test.STAYS_ABOUT_ANOTHER,
        note="Whatever the angle, no point moves. The twin takes another axis.",
    ),
    claim(
        "C3.2.1-j",
        "matrix-for-each-point",
        "claim",
        "Matrix model of test 2: every point needs a matrix of its own, for the Euler angle equal to it",
        "kąt Eulera równy elementowi",
        second_test.determined("q[0] != 0", "q[0] + v[0] != 0"),
        spoilt=second_test.determined("q[0] != 0", "v[0] != 0"),
        note="Read: different points have different matrices. Coordinates are angles in [0, 1), whose "
        "cosines are positive; there cosine and sine determine the angle.",
    ),
    claim(
        "C3.2.1-k",
        "different-rotations",
        "claim",
        "The two rotations of test 2 are not identical",
        "oba obroty nie są identyczne",
        second_test.euler_turned("x"),
        spoilt=second_test.euler_turned("zero"),
        note="The quaternion model moves no point (C3.2.1-i). The matrix model moves (x, 0, 0) by the "
        "Euler angle (x, 0, 0), for every x in (0, 1), since sin x is not 0 there.",
    ),
    claim(
        "C3.2.1-l",
        "credible-test",
        "claim",
        "This should not affect the credibility of the test",
        "nie powinno wpływać",
        second_test.MOVES,
        spoilt=second_test.MOVES_ABOUT_ANOTHER,
        corrected=second_test.MOVES_ABOUT_ANOTHER,
        note="Read: a test of rotations is credible if it turns points. This one turns none, by no "
        "angle. With an axis that is not parallel to its point, every point moves.",
    ),
    claim(
        "C3.2.1-m",
        "plausible-times",
        "number",
        "The absolute times are plausible for 550 000·300 rotations",
        "402–1769 s",
        note="Timings of a machine that is not named; `hfield bench` measures the same work.",
    ),
    claim(
        "C3.2.1-n",
        "eleven-per-cent",
        "number",
        "Test 1: the matrix model is faster by about 11.5 %",
        "około 11.5%",
        Over("QQ", between("11.45", tables.saving(QUATERNIONS_1, MATRICES_1), "11.55", SAVING)),
        spoilt=Over(
            "QQ", between("11.45", tables.saving(MATRICES_1, QUATERNIONS_1), "11.55", SAVING)
        ),
        note="Read: its mean is shorter by 11.5 % of the quaternion model's, to one decimal. The mean "
        "as misprinted (385.2) would give 11.4 %. In rotations a second the matrix model leads by 12.9 %.",
    ),
    claim(
        "C3.2.1-n2",
        "matrices-faster-1",
        "data",
        "The matrix model is faster in test 1",
        "Obrót macierzowy jest szybszy",
        Over(
            "QQ",
            Less(
                tables.mean(MATRICES_1),
                tables.mean(QUATERNIONS_1),
                "the matrices' mean of test 1 < the quaternions'",
            ),
        ),
        spoilt=Over("QQ", Less(tables.mean(QUATERNIONS_1), tables.mean(MATRICES_1))),
        note="By the means; in the first two of the ten runs it is the slower one.",
    ),
    claim(
        "C3.2.1-o",
        "three-times-faster",
        "number",
        "Test 2: the quaternion model is almost 3 times faster",
        "prawie 3-krotnie",
        Over("QQ", between("2.5", tables.ratio(MATRICES_2, QUATERNIONS_2), "3", RATIO)),
        spoilt=Over("QQ", between("3.5", tables.ratio(MATRICES_2, QUATERNIONS_2), "4", RATIO)),
        corrected=Over("QQ", between("3.5", tables.ratio(MATRICES_2, QUATERNIONS_2), "4", RATIO)),
        note="Read: the matrix model takes almost 3 times as long. It takes 3.97 times as long, almost "
        "4 times; “by almost 300 %” would be right.",
    ),
    claim(
        "C3.2.1-p",
        "ten-seconds",
        "number",
        "The means of the quaternion model in the two tests differ by almost 10 seconds",
        "prawie 10 sekund",
        Over(
            "QQ",
            between(
                "9.5", f"{tables.mean(QUATERNIONS_2)} - {tables.mean(QUATERNIONS_1)}", "10", GAP
            ),
        ),
        spoilt=Over(
            "QQ",
            between(
                "9.5", f"{tables.mean(QUATERNIONS_1)} - {tables.mean(QUATERNIONS_2)}", "10", GAP
            ),
        ),
    ),
    claim(
        "C3.2.1-q",
        "cause-of-the-difference",
        "claim",
        "The difference is due to normalisation",
        "Wynika to z faktu, użycia normalizacji",
        note="The cause of a timing. The single times of test 1 spread over 59 seconds by themselves.",
    ),
    claim(
        "C3.2.1-r",
        "which-to-choose",
        "claim",
        "Choose quaternions in general; matrices are faster in single cases",
        "(as stated)",
        note="Advice.",
    ),
)

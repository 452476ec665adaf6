"""The report: marks, table, errata, the smallest witness, sets of fields in words."""

import pytest

from hfield.ledger.claim import PANEL, Claim, Row
from hfield.ledger.claims_table import TerminalStyle, matrix
from hfield.ledger.columns import head, split_columns
from hfield.ledger.errata import errata
from hfield.ledger.markdown import markdown
from hfield.ledger.notebook import Report
from hfield.ledger.report import report, summary, totals
from hfield.ledger.selection import SelectionError, rows_to_decide
from hfield.ledger.wording import name_fields, pretty, witness_text
from hfield.prover.decision import VERDICTS, Decision


class Words:
    text = "comm(p, q) == p*q - q*p"

    def decide(self, field):
        raise AssertionError("the report decides nothing")


def claim(number="C1.1-a", name="name", **more):
    return Claim(number, name, "claim", "The statement", "the print", Words(), **more)


def row(field, verdict, c, witness=None, corrected=None, steps=()):
    decision = Decision(verdict, "method", witness=witness, steps=steps)
    return Row(c, field, decision, corrected and Decision(corrected, "method"))


UNIT_I, UNIT_J = ["0", "1", "0", "0"], ["0", "0", "1", "0"]
ALL = ["0", "1", "1", "1"]


# --- columns -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("field", "shown", "ascii_shown"),
    [
        ("QQ", "ℚ", "Q"),
        ("GF(13)", "F₁₃", "F13"),
        ("QQ(sqrt(-7))", "ℚ√−7", "QV-7"),
        ("QQ(I)", "ℚ(i)", "Q(i)"),
        ("QQ(x)", "ℚ(x)", "Q(x)"),
        ("GF(2)(t)", "F₂(t)", "F2(t)"),
        ("universal", "∀", "all"),
        ("-", "-", "-"),
        ("RDF", "RDF", "RDF"),
    ],
)
def test_heads(field, shown, ascii_shown):
    assert head(field) == shown
    assert head(field, ascii_only=True) == ascii_shown


def test_heads_of_the_panel_differ():
    for ascii_only in (False, True):
        assert len({head(field, ascii_only) for field in PANEL}) == len(PANEL)


def test_the_panel_reads_back():
    assert split_columns(PANEL) == list(PANEL)
    assert split_columns([",".join(PANEL)]) == list(PANEL)
    assert split_columns([" - , UNIVERSAL"]) == ["-", "universal"]


def test_names_of_sets_of_fields():
    every = list(PANEL)
    assert name_fields(every, every) == "all 17 columns"
    assert name_fields(every[1:], every) == "all columns but QQ"
    assert name_fields(["QQ", "RR"], every) == "QQ, RR"
    assert name_fields(["QQ"], ["QQ"]) == "QQ"


def test_rows_to_decide():
    with_fields, without = claim("C1-a"), claim("C1-b", fields=("-",))
    both = [with_fields, without]
    assert rows_to_decide(both, []) == [*((with_fields, f) for f in PANEL), (without, "-")]
    assert rows_to_decide(both, ["QQ"]) == [(with_fields, "QQ")]
    assert rows_to_decide(both, ["QQ"], strict=True) == [(with_fields, "QQ"), (without, "-")]
    with pytest.raises(SelectionError, match="C1-a is about fields"):
        rows_to_decide(both, ["-"], strict=True)
    with pytest.raises(SelectionError, match="none of the claims"):
        rows_to_decide([with_fields], ["-"])


# --- the table ---------------------------------------------------------------------------------

NAMES = ["table", "identity", "commutative", "associativity", "a-name-that-is-much-too-long-to-fit"]


def panel_rows():
    claims = [claim(f"C1.3.1-{n}{n}", name, headline=True) for n, name in enumerate(NAMES)]
    return [
        row(field, VERDICTS[(n + m) % 5], c)
        for m, c in enumerate(claims)
        for n, field in enumerate(PANEL)
    ]


@pytest.mark.parametrize("width", [100, 80, 60, 40])
@pytest.mark.parametrize("ascii_only", [False, True])
def test_the_table_fits(width, ascii_only):
    style = TerminalStyle(width, ascii_only)
    out = matrix(panel_rows(), style)
    assert max(map(len, out.splitlines())) <= width
    assert ascii_only is out.isascii() or "…" in out
    marks = [style.mark(verdict) for verdict in VERDICTS]
    for n in range(len(NAMES)):
        cells = [
            line.split("  ", 1)[1] for line in out.splitlines() if line.startswith(f"C1.3.1-{n}{n}")
        ]
        shown = [char for line in cells for char in line.split() if char in marks]
        assert shown == [style.mark(VERDICTS[(n + m) % 5]) for m in range(17)]


def test_at_100_columns_the_panel_is_one_block():
    out = matrix(panel_rows(), TerminalStyle(100))
    assert len(out.splitlines()) == 2 + len(NAMES)


def test_marks_stand_under_their_heads():
    lines = matrix(panel_rows(), TerminalStyle(100)).splitlines()
    for n, field in enumerate(PANEL):
        start = lines[0].index(f" {head(field)}") + 1
        under = lines[2][start : start + len(head(field))]
        assert under.strip() == TerminalStyle().mark(VERDICTS[n % 5])


def test_few_columns_are_written_out():
    c = claim()
    out = matrix([row("QQ(sqrt(2))", "proved", c), row("GF(9)", "refuted", c)], TerminalStyle(100))
    assert "QQ(sqrt(2))" in out.splitlines()[0]


def test_colour_only_where_wanted():
    assert "\x1b" not in matrix(panel_rows(), TerminalStyle(100))
    assert "\x1b[32m✓\x1b[0m" in matrix(panel_rows(), TerminalStyle(100, colour=True))


def test_summary_and_totals():
    rows = [
        row("QQ", "proved", claim("C1.1-a")),
        row("RR", "refuted", claim("C1.1-a")),
        row("QQ", "vacuous", claim("C1.2-a")),
        row("QQ", "not-applicable", Claim("C1.2-b", "b", "remark", "An opinion", "", None)),
    ]
    lines = [line.split() for line in summary(rows, TerminalStyle()).splitlines()]
    assert lines[1] == ["1.1", "1", "1", "1", "0", "0", "0"]
    assert lines[2] == ["1.2", "2", "0", "0", "1", "0", "1"]
    assert lines[3] == ["total", "3", "1", "1", "1", "0", "1"]
    text = totals(rows)
    assert "3 claims, 4 rows: 1 proved, 1 refuted, 1 vacuous, 1 not applicable." in text
    assert "C1.2-b" in text


# --- the errata --------------------------------------------------------------------------------


def test_the_smallest_witness_tells():
    c = claim(corrected=Words(), note="A sign.")
    rows = [
        row("QQ", "refuted", c, {"p": ALL, "q": UNIT_J}, "proved"),
        row("RR", "refuted", c, {"p": UNIT_I, "q": UNIT_J}, "proved"),
        row("CC", "refuted", c, {"p": UNIT_I, "q": UNIT_J}, "vacuous"),
        row("GF(2)", "proved", c),
        row("universal", "refuted", c, {"F": ["GF(3)"], "p": UNIT_I}, "proved"),
    ]
    (erratum,) = errata(rows)
    assert erratum.telling.field == "RR"
    assert erratum.witness == "p = i, q = j over RR"
    assert erratum.lines == [
        ("claim", "The statement"),
        ("prints", "the print"),
        ("refuted", "over QQ, RR, CC, universal"),
        ("elsewhere", "proved over GF(2)"),
        ("why", "A sign."),
        ("witness", "p = i, q = j over RR"),
        ("corrected", "[p, q] = p·q − q·p"),
        ("", "proved over QQ, RR, universal; vacuous over CC"),
    ]


def test_without_a_witness_the_last_step_is_shown():
    (erratum,) = errata([row("QQ", "refuted", claim(), None, steps=("first", "  N(q) = 2"))])
    assert erratum.lines[-1] == ("there", "N(q) = 2")


def test_a_correction_that_holds_wherever_it_is_needed():
    c = claim(corrected=Words())
    (erratum,) = errata([row(field, "refuted", c, None, "proved") for field in ("QQ", "RR")])
    assert erratum.lines[-1] == ("", "proved over the same columns")
    (erratum,) = errata(
        [row("-", "refuted", claim(fields=("-",), corrected=Words()), None, "proved")]
    )
    assert ("refuted", "as it stands") in erratum.lines
    assert erratum.lines[-1] == ("", "proved as it stands")


def test_a_witness_found_for_all_fields_lives_in_its_own():
    (erratum,) = errata([row("universal", "refuted", claim(), {"F": ["GF(3)"], "q": UNIT_I})])
    assert erratum.witness == "q = i over GF(3)"


@pytest.mark.parametrize(
    ("witness", "field", "shown"),
    [
        ({"p": UNIT_I, "q": ["1", "0", "-1/2", "0"]}, "QQ", "p = i, q = 1 − 1/2j"),
        ({"x": ["x+1"]}, "GF(4)", "x = x+1"),
        ({"F": ["GF(7)"]}, "universal", "F = GF(7)"),
        ({"m": ["a", "b"]}, "QQ", "m = (a, b)"),
        ({"m": ["a", "b", "c", "d"]}, "QQ", "m = (a, b, c, d)"),
        ({"n": ["4"]}, "-", "n = 4"),
        ({}, "QQ", ""),
        (None, "QQ", ""),
    ],
)
def test_witness_text(witness, field, shown):
    assert witness_text(witness, field) == shown


def test_statements_are_prettified_and_words_left_alone():
    assert pretty("norm(q) != 0 => q*inv(q) == e") == "N(q) ≠ 0 ⇒ q·q⁻¹ = e"
    assert pretty("the centre is F·e") == "the centre is F·e"


def test_the_report_has_all_its_parts():
    headline, slip = claim("C1-a", "table", headline=True), claim("C1-b", "slip", corrected=Words())
    rows = [
        row("QQ", "proved", headline),
        row("QQ", "refuted", slip, {"p": UNIT_I, "q": UNIT_J}, "proved"),
        row("RR", "undecided", slip),
    ]
    out = report(rows, TerminalStyle(100))
    order = ["Headline claims", "The other claims", "Undecided", "Errata", "2 claims, 3 rows"]
    assert [out.index(text) for text in order] == sorted(out.index(text) for text in order)
    assert "[p, q] = p·q − q·p" in out
    assert "p = i, q = j over QQ" in out
    chosen = report(rows, TerminalStyle(100), chosen=True)
    assert "The other claims" not in chosen
    assert "C1-b" in chosen.partition("Errata")[0]


def test_a_false_correction_is_a_contradiction():
    out = report(
        [row("QQ", "refuted", claim(corrected=Words()), None, "refuted")], TerminalStyle(100)
    )
    assert "Contradictions" in out
    assert "its correction is refuted over QQ" in out


def test_markdown_escapes_and_stays_in_its_table():
    c = Claim("C1-a", "norm", "claim", "s", "|pq| = |p||q| * _", Words())
    out = markdown([row("QQ", "refuted", c, {"q": UNIT_I})])
    assert r"\|pq\|" in out
    table = [line for line in out.splitlines() if line.startswith("|")]
    assert len({line.replace(r"\|", "").count("|") for line in table}) == 1


def test_notebook():
    shown = Report(tuple(panel_rows()))
    assert shown._repr_latex_().startswith(r"$\begin{array}{l|ccccccccccccccccc}")
    assert shown._repr_latex_().count(r"\checkmark") == 17
    assert "Headline claims" in repr(shown)

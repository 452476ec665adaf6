"""``hfield order``, ``classes``, ``brandt`` and ``survey``."""

import json
import re
from fractions import Fraction

import pytest

from hfield import QuaternionAlgebra, surveys
from hfield.cli import main, order_arguments
from hfield.cli.commands.brandt import polynomial
from hfield.cli.commands.survey import numbers
from hfield.orders.class_file import ClassFile
from tests.cli.running import page, run


@pytest.mark.parametrize(
    ("words", "lines"),
    [
        (["order", "(-1,-11|QQ)"], ["reduced discriminant 11", "maximal", "4, the group C4"]),
        (["order", "30", "--level", "7"], ["210, of level 7: an Eichler order", "class number 8"]),
        (["order", "(2,3|QQ)"], ["infinitely many", "1, by strong approximation"]),
        (["order", "(-1,-1|QQ)", "--generators", "i, j"], ["basis 1, i, j, k", "no Eichler order", "Q8"]),
        (["order", "(-1,-1|QQ(sqrt(5)))", "--level", "11, 4 + sqrt(5)"],
         ["ideal(11, 5+4*sqrt(5)): an Eichler order", "hereditary, Bass, Gorenstein", "units 5 mod"]),
        (["order", "(-1,-1|QQ(sqrt(10)))", "--generators", "i, j"],
         ["sum of (1) + (i) + (j) + (k)", "no Eichler order", "not maximal its discriminant ideal(4)"]),
        (["order", "(-1,-3|QQ(sqrt(-5)))", "--format", "latex"], [r"\frac{1}{2}\sqrt{-5}\right)\left("]),
        (["field", "QQ(sqrt(10))"], ["discriminant 40", "class group ℤ/2 of ideal(2, sqrt(10))", "3+sq"]),
        (["order", "17", "--extremal"], ["reduced discriminant 17"]),
        (["order", "5", "--format", "latex"], [r"\mathbb{Z}\left\langle"]),
        (["classes", "(-1,-11|QQ)", "--level", "3"], ["4, by Eichler's", "mass 10/3", "type number 3"]),
        (["classes", "1000003", "--formula"], ["class number 83334, by Eichler's formula"]),
        (["classes", "11", "--level", "3", "--newforms"],
         ["newform f1 a_2 = 1, a_5 = -2, a_7 = 4,", "w_3 = 1, w_11 = -1"]),
        (
            ["classes", "(-1,-1|QQ(sqrt(5)))", "--level", "6 + sqrt(5)", "--newforms"],
            ["2, by enumeration", "mass 8/15", "type number 2", "C5",
             "newform f1 a_2 = -3, a_(5, sqrt(5)) = -2,"],
        ),
        (
            ["brandt", "(-1,-1|QQ(sqrt(5)))", "6 + sqrt(5)", "--prime", "sqrt(5)"],
            ["2 classes", "1 5", "3 3", "x^2 - 4*x - 12"],
        ),
        (["classes", "11", "--format", "latex"], [r"\begin{tabular}", r"1 & 2 & 6 & $\mathrm{C6}$ & 1 \\"]),
        (["classes", "(3,5|QQ)", "--level", "7"], ["order 105: indefinite", "class number 1, by strong"]),
        (["classes", "(-1,3|QQ(sqrt(10)))"], ["number 2, by", "norms ideal(1), ideal(2, sqrt(10))"]),
        (["classes", "1019"], ["more; --format json lists all"]),
        (["newforms", "43"],
         ["3 of weight 2, newforms among them 3, in 2 Galois orbits", "43.2.a.b field QQ[s]/(s^2-2)",
          "a_5 = 2-s, a_7 = -2+s", "w_43 = -1", "q + s*q^2 - s*q^3 + (2-s)*q^5"]),
        (["newforms", "3", "--level", "5", "--weight", "4", "--primes", "30"],
         ["15.4.a.b", "a_29 = -78", "w_5 = 1, w_3 = 1"]),
        (["newforms", "(-1,-1|QQ(sqrt(5)))", "--level", "6 + sqrt(5)"],
         ["in 1 Galois orbit f1 field QQ", "a_2 = -3, a_(5, sqrt(5)) = -2", "w_(31, sqrt(5)-25) = 1"]),
        (["newforms", "167"], ["167.2.a.b degree 12 traces a_2 = 2"]),
        (["brandt", "37", "--prime", "2"], ["1 1 1 1 0 2 1 2 0", "x^3 - x^2 - 6*x"]),
        (["brandt", "11", "3", "--prime", "5", "--format", "edges"], ["0 0 2 0 1 1"]),
        (["brandt", "11", "--format", "latex"], [r"1 & 2 \\ 3 & 0"]),
    ],
)  # fmt: skip
def test_pages(capsys, words, lines):
    out = " ".join(page(capsys, *words).split())
    for line in lines:
        assert line in out


def test_newforms_over_functions_as_json(capsys):
    words = ("newforms", "[1,t^3+t+1|GF(2)(t))", "--level", "t", "--primes", "2")
    data = json.loads(page(capsys, *words, "--format", "json"))
    assert data["discriminant"]["factorisation"] == [["ideal(t^3+t+1)", 1]]
    assert data["level"]["generators"] == ["t"]
    assert [f["eigenvalues"] for f in data["newforms"]] == [
        {"ideal(t)": -1, "ideal(t+1)": -2},
        {"ideal(t)": 1, "ideal(t+1)": 0},
    ]


def test_json(capsys):
    data = json.loads(page(capsys, "order", "(-1,-11|QQ)", "--format", "json"))
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    assert (data["den"], data["rows"]) == (O.hnf[0], [list(row) for row in O.hnf[1]])
    assert data["schema"] == "hfield-order/1"
    data = json.loads(page(capsys, "classes", "(-1,3|QQ(sqrt(10)))", "--format", "json"))
    assert [(c["norm"]["norm"], len(c["pseudo_basis"])) for c in data["classes"]] == [
        ("1", 4),
        ("2", 4),
    ]
    data = json.loads(page(capsys, "classes", "30", "--level", "7", "--format", "json"))
    assert data["class_number"] == len(data["classes"]) == 8
    assert Fraction(data["mass"]) == sum(Fraction(2, c["units"]) for c in data["classes"])
    data = json.loads(page(capsys, "newforms", "43", "--primes", "7", "--format", "json"))
    assert data["newforms"][1] == {
        "label": "43.2.a.b",
        "degree": 2,
        "field": [-2, 0, 1],
        "signs": {"43": -1},
        "eigenvalues": {"2": [0, 1], "3": [0, -1], "5": [2, -1], "7": [-2, 1]},
    }
    data = json.loads(page(capsys, "brandt", "37", "--prime", "3", "--format", "json"))
    assert [sum(row) for row in data["matrix"]] == [4, 4, 4]
    assert len(data["characteristic_polynomial"]) == 4


def test_newforms_are_certified(capsys, tmp_path):
    file = str(tmp_path / "newforms.json")
    page(capsys, "newforms", "43", "--primes", "5", "--certificate", file)
    assert "QQ: -2,-2,-4 | QQ[s]/(s^2-2): s,-s,2-s" in page(capsys, "check", file)
    page(capsys, "newforms", "3", "--level", "5", "--weight", "4", "--certificate", file)
    assert "; 4; 2,7,11,13,17,19; " in page(capsys, "check", file)
    icosians = ["(-1,-1|QQ(sqrt(5)))", "--weight", "6", "--primes", "5"]
    assert main(["newforms", *icosians, "--certificate", file]) == 0
    assert "over QQ only" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        ["order", "(-1,-11|QQ)", "--level", "9"],
        ["order", "(2,3|QQ)"],
        ["order", "(-1,-1|QQ)", "--generators", "i, j"],
    ],
    ids=" ".join,
)
def test_an_order_says_the_same_in_every_format(capsys, words):
    plain = page(capsys, *words)
    data = json.loads(page(capsys, *words, "--format", "json"))
    latex = page(capsys, *words, "--format", "latex")
    facts = {line[:22].strip(): line[23:] for line in plain.splitlines() if line[:22].strip()}
    assert list(facts) == re.findall(r"\\item\[\{(.*?)\}\]", latex)
    kind = "maximal" if data["maximal"] else ("an" if data["eichler"] else "no") + " Eichler order"
    level = f"{data['discriminant']}, of level {data['level']}: {kind}"
    assert facts["reduced discriminant"] == level
    number = data["class_number"]
    assert facts.get("class number") == (number and f"{number}, by {data['class_number_by']}")
    assert ("mass" in facts) == (data["mass"] is not None)
    assert facts["conductor"].split(":")[0] == str(data["conductor"])
    assert ("Bass" in facts["conductor"]) == data["bass"]
    assert r"\documentclass" in page(capsys, *words, "--format", "latex", "--standalone")


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["order", "(-1,-11|GF(7))"], "over QQ"),
        (["order", "4"], "product of different primes"),
        (["order", "11", "--level", "22"], "in common"),
        (["order", "11", "--level", "x"], "positive integer"),
        (["order", "11", "--generators", "i"], "rank 2"),
        (["order", "11", "--generators", ","], "no element"),
        (["order", "11", "--generators", "i/2, j"], "generate no order"),
        (["order", "(2,3|QQ)", "--extremal"], "prime discriminant"),
        (["classes", "(2,3|QQ)", "--newforms"], "indefinite"),
        (["brandt", "(2,3|QQ)"], "by strong approximation"),
        (["newforms", "(2,3|QQ)"], "by strong approximation"),
        (["newforms", "37", "--weight", "3"], "is not one of 2, 4, 6"),
        (["newforms", "1000003"], "spaces of at most 10000 are split"),
        (["brandt", "(-1,-1|QQ(sqrt(-5)))"], "split at an infinite place"),
        (["classes", "(-1,-1|QQ(sqrt(5)))", "--formula"], "over QQ"),
        (["classes", "11", "--formula", "--newforms"], "does not enumerate them"),
        (["brandt", "(-1,-1|QQ(sqrt(5)))", "--prime", "1/2"], "ideal of integers"),
        (["classes", str(2**61 - 1)], "Eichler's formula"),
        (["brandt", "37", "--prime", "x"], "the index 'x' is not a positive integer"),
        (["brandt", "37", "0"], "positive integer"),
        (
            ["brandt", "1000003"],
            "the Brandt matrix of 83334 classes has 6944555556 entries and would take about 111.1 GB",
        ),
        (
            ["brandt", "1000003", "--prime", "4", "--format", "edges"],
            "--format edges, with a prime",
        ),
        (["survey", "4"], "no pair of a definite"),
        (["survey", "2..5", "--groups"], "no pair of an indefinite"),
        (["survey"], "or --field F"),
        (["survey", "2..5", "--field", "QQ(sqrt(5))"], "leave D and --groups out"),
        (["survey", "--field", "QQ(I)"], "not totally real"),
        (["survey", "--field", "GF(5)"], "GF(5) is not a number field"),
        (["survey", "5..2"], "ascending"),
        (["survey", "2..100000000"], "at most 1000000 of them"),
        (["survey", "2..1000", "--levels", "1..1000000"], "are more than 1000000 pairs"),
        (["survey", "2..x"], "2..100"),
        (["survey", "2..9", "-o", "rows.txt"], "ends in .jsonl or .parquet"),
        (["survey", "2..9", "-o", "missing/x.jsonl"], "cannot write"),
    ],
)
def test_bad_input(capsys, tmp_path, monkeypatch, words, hint):
    monkeypatch.chdir(tmp_path)
    status, out, err = run(capsys, *words)
    assert (status, out) == (2, ""), err
    assert hint in err
    assert err.startswith("hfield: error: ")
    assert err.count("\n") == 1


def test_an_interrupted_survey_says_where_its_rows_are_and_goes_on(capsys, tmp_path, monkeypatch):
    rows = tmp_path / "rows.jsonl"
    whole, found = surveys.Plan.run, []

    def stopped(*words):
        yield next(iter(whole(*words)))
        raise KeyboardInterrupt

    def watched(*words):
        for some in whole(*words):
            found.extend(some)
            yield some

    monkeypatch.setattr(surveys.Plan, "run", stopped)
    status, _, err = run(capsys, "survey", "2..200", "-o", str(rows))
    kept = len(rows.read_text().splitlines())
    assert status == 130
    assert f"{kept} of 65 rows are in {rows}; the same command goes on there" in " ".join(
        err.split()
    )
    monkeypatch.setattr(surveys.Plan, "run", watched)
    assert run(capsys, "survey", "2..200", "-o", str(rows))[0] == 0
    assert 0 < kept < len(rows.read_text().splitlines()) == kept + len(found)


@pytest.mark.parametrize(
    ("words", "seconds", "said"),
    [
        (["classes", "1019"], 1e-3, "86 classes, by Eichler's formula, and this takes about"),
        (["classes", "1019"], 10, ""),
        (
            ["brandt", "1019"],
            1e-3,
            "--format edges, with a prime, writes only the entries that are not 0",
        ),
        (["brandt", "1019", "--format", "edges"], 1e-3, "hfield classes --formula counts them"),
    ],
)
def test_long_enumerations_are_announced(capsys, monkeypatch, words, seconds, said):
    monkeypatch.setattr(order_arguments, "PATIENCE", seconds)
    status, _, err = run(capsys, *words)
    assert status == 0
    assert (said in " ".join(err.split())) if said else err == ""


def test_how_long_enumerations_are_said_to_take(capsys):
    for seconds, said in (
        (30, "30 seconds"),
        (200, "3 minutes"),
        (1e4, "3 hours"),
        (1e7, "116 days"),
    ):
        order_arguments.announce(83334, seconds, "--formula enumerates none")
        assert f"takes about {said}; --formula" in " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize("level", ["1", "3", "9"])
@pytest.mark.parametrize("prime", ["2", "3"])
def test_edges_are_the_entries_of_the_matrix(capsys, level, prime):
    """They come from the neighbours, without the matrix."""
    edges = page(capsys, "brandt", "37", level, "--prime", prime, "--format", "edges").split("\n")
    matrix = json.loads(page(capsys, "brandt", "37", level, "--prime", prime, "--format", "json"))[
        "matrix"
    ]
    rows = [f"{i} {j} {m}" for i, row in enumerate(matrix) for j, m in enumerate(row) if m]
    assert [line for line in edges if line] == rows


def test_certificates(capsys, tmp_path):
    """What is written is accepted by ``hfield check``; what cannot be is reported."""
    for words, said in (
        (["order", "(-1,-11|QQ)"], "; 11; maximal}"),
        (["order", "(2,3|QQ)", "--level", "5"], "; 30}"),
        (["order", "(-1,-1|QQ)", "--generators", "i, j"], "; 4}"),
        (["classes", "30", "--level", "7"], "; 8}"),
        (["classes", "(-1,-11|QQ)", "--level", "3", "--format", "json"], "; 4}"),
    ):
        path = tmp_path / "certificate.json"
        page(capsys, *words, "--certificate", str(path))
        statement = json.loads(path.read_text())["statement"]
        assert statement.endswith(said)
        assert statement in page(capsys, "check", str(path))
    status, _, err = run(capsys, "classes", "11", "--formula", "--certificate", str(path))
    assert status == 2
    assert "does not enumerate them" in err
    # 2⁶¹ − 1 classes are too many to enumerate, and the file stays as it was
    before = path.read_text()
    assert run(capsys, "classes", str(2**61 - 1), "--certificate", str(path))[0] == 2
    assert path.read_text() == before


def test_a_plot(capsys, tmp_path):
    path = tmp_path / "graph.svg"
    page(capsys, "brandt", "37", "--plot", str(path))
    assert b"<svg" in path.read_bytes()
    assert run(capsys, "brandt", "37", "--plot", str(tmp_path / "graph.xyz"))[0] == 2


def test_a_survey(capsys):
    rows = [
        json.loads(line)
        for line in page(capsys, "survey", "2..31", "--levels", "1..3").splitlines()
    ]
    pairs = surveys.definite_pairs(range(2, 32), range(1, 4))
    assert sorted((r["discriminant"], r["level"]) for r in rows) == sorted(pairs)
    assert (30, 1) in pairs
    assert (6, 1) not in pairs
    assert (2, 2) not in pairs
    for row in rows:
        A = QuaternionAlgebra.from_text(row["algebra"])
        C = A.eichler_order(row["level"]).class_set()
        assert (row["class_number"], row["type_number"]) == (len(C), C.type_number)
        assert sum(Fraction(2 * m, int(u)) for u, m in row["units"].items()) == Fraction(
            row["mass"]
        )


def test_a_survey_goes_on_where_it_was_killed(capsys, tmp_path):
    path = tmp_path / "rows.jsonl"
    page(capsys, "survey", "2..60", "-o", str(path))
    whole = path.read_bytes()
    lines = whole.splitlines(keepends=True)
    for kept in (0, 1, 7, len(lines) - 1):
        for torn in (b"", lines[kept][:20]):  # as a kill in the middle of a write leaves it
            path.write_bytes(b"".join(lines[:kept]) + torn)
            page(capsys, "survey", "2..60", "-o", str(path), "--jobs", "1")
            found = path.read_bytes().splitlines(keepends=True)
            assert found[:kept] == lines[:kept]
            assert sorted(found) == sorted(lines)
    page(capsys, "survey", "2..60", "-o", str(path))
    assert sorted(path.read_bytes().splitlines(keepends=True)) == sorted(lines)
    path.write_text("no survey\n")
    status, _, err = run(capsys, "survey", "2..60", "-o", str(path))
    assert status == 2
    assert "not a survey" in err
    assert path.read_text() == "no survey\n"


def test_a_survey_over_fields(capsys, tmp_path):
    path, words = tmp_path / "rows.jsonl", ["survey", "--field", "QQ(sqrt(5))", "--levels", "1..31"]
    page(capsys, *words, "--field", "QQ[s]/(s^3-s^2-2*s+1)", "-o", str(path), "--most", "2")
    rows = [json.loads(line) for line in path.read_text().splitlines()]
    golden = [row["norm"] for row in rows if row["field"] == "QQ(sqrt(5))"]
    split = {
        n: sum((0, 1, -1, -1, 1)[d % 5] for d in range(1, n + 1) if n % d == 0)
        for n in range(1, 32)
    }
    assert {n: golden.count(n) for n in split} == split  # the coefficients of ζ(s)·L(s, (·/5))
    for row in rows:
        known = row["class_number"] is not None
        assert known == (Fraction(row["mass"]) <= 2)
        if known:
            counted = [(Fraction(1, int(u)), m) for u, m in row["units"].items()]
            assert sum(m * x for x, m in counted) == Fraction(row["mass"])
            assert sum(m for _, m in counted) == row["class_number"] >= row["type_number"]
    assert [row["class_number"] for row in rows if row["norm"] == 31] == [2, 2]
    before = path.read_bytes()
    page(capsys, *words, "-o", str(path))
    assert path.read_bytes() == before


def test_a_survey_of_groups(capsys):
    lines = page(capsys, "survey", "1..22", "--groups", "--most", "1").splitlines()
    rows = {row["discriminant"]: row for row in map(json.loads, lines)}
    assert list(rows) == [1, 6, 10, 14, 15, 21, 22]
    known = {6: (0, [2, 2, 3, 3]), 14: (1, [2, 2]), 15: (1, [3, 3]), 22: (0, [2, 2, 3, 3, 3, 3])}
    assert {d: (rows[d]["genus"], rows[d]["orders"]) for d in known} == known
    assert (rows[1]["cusps"], rows[1]["area"]) == (1, "1/6")
    assert rows[6]["sides"] == 5
    assert len(rows[6]["generators"]) > 1
    assert rows[22]["area"] == "5/3"
    assert rows[22]["generators"] is rows[22]["systole"] is None


@pytest.mark.parametrize(
    ("field", "more", "statement"),
    [
        ("QQ(sqrt(10))", [], "class-group{2}"),
        ("QQ[s]/(s^3-2)", ["--units"], "unit-group{2; 1-s}"),
    ],
)
def test_certificates_of_fields(capsys, tmp_path, field, more, statement):
    file = tmp_path / "field.json"
    data = json.loads(
        page(capsys, "field", field, *more, "--certificate", str(file), "--format", "json")
    )
    assert data["units"]["rank"] == 1
    status, out, _ = run(capsys, "check", str(file))
    assert status == 0
    assert f"statement: {statement}" in out
    status, _, err = run(capsys, "field", "QQ(x)")
    assert status == 2
    assert "not a number field" in err


def test_a_survey_in_processes(capsys, tmp_path):
    path = tmp_path / "rows.jsonl"
    page(capsys, "survey", "2..40", "-o", str(path), "--jobs", "2", "--most", "1")
    rows = [json.loads(line) for line in path.read_text().splitlines()]
    assert all((row["type_number"] is None) == (row["class_number"] > 1) for row in rows)
    assert len(rows) == len(surveys.definite_pairs(range(2, 41), [1]))


def test_parquet(capsys, tmp_path):
    path = tmp_path / "rows.parquet"
    parquet = pytest.importorskip("pyarrow.parquet")
    page(capsys, "survey", "2..40", "-o", str(path))
    table = parquet.read_table(path).to_pylist()
    assert [row["discriminant"] for row in table] == [
        d for d, _ in surveys.definite_pairs(range(2, 41), [1])
    ]
    assert list(tmp_path.iterdir()) == [path]


def test_ranges_and_polynomials():
    assert numbers("2..5,9", "D") == [2, 3, 4, 5, 9]
    assert polynomial([0, -6, -1, 1]) == "x^3 - x^2 - 6*x"
    assert polynomial([-1, 1]) == "x - 1"
    assert polynomial([1]) == "1"


@pytest.mark.parametrize("name", ["classes", "brandt"])
def test_documents_have_one_form_over_every_base(capsys, name):
    """Over ℚ and the number field of degree 1 numbers agree, and keys over any field."""
    documents = [
        json.loads(page(capsys, name, text, *words, "--format", "json"))
        for text, *words in (
            ("(-1,-11|QQ)",),
            ("(-1,-11|QQ[s]/(s-1))",),
            ("(-1,-1|QQ(sqrt(5)))",),
            ("(2,3|QQ)",),
            ("(-1,3|QQ(sqrt(10)))",),
        )[: 5 if name == "classes" else 3]
    ]
    over_q, degree_one, larger, *indefinite = documents
    assert over_q.keys() == degree_one.keys() == larger.keys()
    if name == "brandt":
        assert over_q["matrix"] == degree_one["matrix"]
        assert over_q["units"] == degree_one["units"] == [4, 6]
        return
    for first, second in zip(over_q["classes"], degree_one["classes"], strict=True):
        assert first.keys() == second.keys()
        assert (first["units"], first["type"]) == (second["units"], second["type"])
    assert first.keys() | {"pseudo_basis"} == larger["classes"][0].keys()
    assert indefinite[0].keys() == indefinite[1].keys()


def test_classes_and_neighbours_are_kept_in_a_file(tmp_path, capsys):
    path = tmp_path / "classes.jsonl"
    words = ["brandt", "389", "--prime", "3", "--format", "edges"]
    assert main(words) == 0
    edges = capsys.readouterr().out
    for _ in range(2):  # found, and read
        assert main([*words, "--resume", str(path)]) == 0
        assert capsys.readouterr().out == edges
    assert main(["classes", "37", "--resume", str(path)]) == 2
    assert "another order" in capsys.readouterr().err
    assert main(["classes", "389", "--resume", str(tmp_path / "no" / "file")]) == 2
    assert "No such file" in capsys.readouterr().err


def test_an_interrupted_search_names_its_file(tmp_path, capsys, monkeypatch):
    path = tmp_path / "classes.jsonl"

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(ClassFile, "append", interrupted)
    assert main(["classes", "37", "--resume", str(path)]) == 130
    assert f"the same command goes on from {path}" in " ".join(capsys.readouterr().err.split())
    monkeypatch.undo()
    assert main(["classes", "37", "--resume", str(path)]) == 0

"""``hfield verify`` from a cold start, as a newcomer runs it: the claims of the thesis themselves."""

import json
import os
import subprocess
import sys

import pytest

from hfield.ledger.claim import PANEL

BYTES = 1 << 30
KEYS = {
    *(
        "id",
        "field",
        "as_printed",
        "as_corrected",
        "method",
        "witness",
        "correction",
        "certificate",
    ),
}
VERDICTS = {"proved", "refuted", "vacuous", "undecided", "not-applicable"}


def shell(*words):
    return subprocess.run(
        [sys.executable, "-m", "hfield", *words], capture_output=True, text=True, timeout=300
    )


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Run all claims over the panel once: the results, and the most memory used."""
    page = tmp_path_factory.mktemp("whole") / "page.json"
    with page.open("w") as out:
        run = subprocess.Popen(
            [sys.executable, "-m", "hfield", "verify", "--format", "json"], stdout=out
        )
        _, status, used = os.wait4(run.pid, 0)  # what this run took, not the largest of all so far
    run.returncode = os.waitstatus_to_exitcode(status)
    assert run.returncode == 0
    return json.loads(page.read_text("utf-8"))["results"], used.ru_maxrss * 1024  # in KiB on Linux


def test_every_row_has_a_verdict(whole):
    rows, _ = whole
    assert len(rows) == len({(row["id"], row["field"]) for row in rows})
    for row in rows:
        assert set(row) == KEYS
        assert row["as_printed"] in VERDICTS - {"undecided"}
        assert row["as_corrected"] in {None, *VERDICTS} - {"undecided", "refuted"}


def test_every_claim_has_all_its_columns(whole):
    rows, _ = whole
    columns = {}
    for row in rows:
        columns.setdefault(row["id"], []).append(row["field"])
    assert len(columns) >= 92
    assert all(fields in (list(PANEL), ["-"]) for fields in columns.values())


def test_memory(whole):
    _, peak = whole
    assert peak < BYTES


def test_processes_find_the_same(whole):
    rows, _ = whole
    words = ["centre", "theorem-1", "triple-iki", "--field", "GF9,QQ", "--field", "universal"]
    done = shell("verify", *words, "--jobs", "2", "--format", "json")
    assert done.returncode == 0, done.stderr
    some = json.loads(done.stdout)["results"]
    assert len(some) == 9
    assert all(row in rows for row in some)


def test_the_report_fits_100_columns(tmp_path):
    done = shell("verify", "-o", str(tmp_path / "report.txt"))
    assert done.returncode == 0, done.stderr
    lines = (tmp_path / "report.txt").read_text("utf-8").splitlines()
    assert max(map(len, lines)) <= 100
    assert "Headline claims, as printed" in lines
    assert "Errata" in lines
    headline = lines[lines.index("Headline claims, as printed") :]
    assert all("theorem-1" not in line or "✗" in line for line in headline[:20])


@pytest.mark.parametrize("field", ["GF(4)(t)", "GF(9, x^2+1)", "QQ(sqrt(-3))", "ZZ/6"])
def test_rings_outside_the_panel_end_well(field):
    done = shell("verify", "--field", field, "--format", "json")
    assert done.returncode in (0, 1), done.stderr
    assert {row["field"] for row in json.loads(done.stdout)["results"]} == {field}

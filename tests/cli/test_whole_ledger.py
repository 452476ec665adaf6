"""``hfield verify`` from a cold start, as a newcomer runs it: the claims of the thesis themselves."""

import json
import subprocess
import sys

import pytest

from hfield.ledger.claim import PANEL
from tests.patience import PATIENCE

pytestmark = pytest.mark.slow  # the quick tests of the ledger and of the command see parts of this
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
        [sys.executable, "-m", "hfield", *words], capture_output=True, text=True, timeout=PATIENCE
    )


# The kernel's own count starts anew with a program; what rusage tells includes the process that forked it.
MEASURED = """
import sys
from pathlib import Path
from hfield.cli import main
status = main(["verify", "--format", "json"])
if (memory := Path("/proc/self/status")).exists():
    lines = memory.read_text().splitlines()
    print(next(line.split()[1] for line in lines if line.startswith("VmHWM")), file=sys.stderr)
sys.exit(status or main(["verify", "-o", sys.argv[1]]))  # what is decided is remembered
"""


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Run all claims over the panel once: the results, the most memory used, and the report."""
    report = tmp_path_factory.mktemp("whole") / "report.txt"
    command = [sys.executable, "-c", MEASURED, str(report)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    rows = json.loads(done.stdout)["results"]
    return rows, 1024 * int(done.stderr or 0), report.read_text("utf-8").splitlines()


def test_every_row_has_a_verdict(whole):
    rows, _, _ = whole
    assert len(rows) == len({(row["id"], row["field"]) for row in rows})
    for row in rows:
        assert set(row) == KEYS
        assert row["as_printed"] in VERDICTS - {"undecided"}
        assert row["as_corrected"] in {None, *VERDICTS} - {"undecided", "refuted"}


def test_every_claim_has_all_its_columns(whole):
    rows, _, _ = whole
    columns = {}
    for row in rows:
        columns.setdefault(row["id"], []).append(row["field"])
    assert len(columns) >= 92
    assert all(fields in (list(PANEL), ["-"]) for fields in columns.values())


@pytest.mark.skipif(sys.platform != "linux", reason="asks Linux for the memory used")
def test_memory(whole):
    _, peak, _ = whole
    assert peak < BYTES


def test_processes_find_the_same(whole):
    rows, _, _ = whole
    words = ["centre", "theorem-1", "triple-iki", "--field", "GF9,QQ", "--field", "universal"]
    done = shell("verify", *words, "--jobs", "2", "--format", "json")
    assert done.returncode == 0, done.stderr
    some = json.loads(done.stdout)["results"]
    assert len(some) == 9
    assert all(row in rows for row in some)


def test_the_report_fits_100_columns(whole):
    _, _, lines = whole
    assert max(map(len, lines)) <= 100
    assert "Headline claims, as printed" in lines
    assert "Errata" in lines
    headline = lines[lines.index("Headline claims, as printed") :]
    assert all("theorem-1" not in line or "✗" in line for line in headline[:20])


@pytest.mark.parametrize("field", ["GF(4)(t)", "ZZ/6"])
def test_rings_outside_the_panel_end_well(field):
    done = shell("verify", "--field", field, "--format", "json")
    assert done.returncode in (0, 1), done.stderr
    assert {row["field"] for row in json.loads(done.stdout)["results"]} == {field}

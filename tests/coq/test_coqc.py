"""What Coq says of the files. Skipped where ``coqc`` is missing; CI installs it."""

import shutil
import subprocess

import pytest

from hfield.coq.export import Export, export_statements
from hfield.coq.ledger import export_ledger
from hfield.coq.theorems import EQUATIONS, RINGS, Theorem, proposition
from hfield.ledger.propositions import Statement
from hfield.ledger.registry import claims, find
from hfield.proving.statements.language import read_statement
from hfield.proving.statements.setting import read_setting
from tests.coq.test_export_ledger import TOO_LARGE

COQC = shutil.which("coqc")
pytestmark = pytest.mark.skipif(COQC is None, reason="coqc is not installed (Debian: coq)")
CLOSED = "Closed under the global context\n"
LIMIT = 180  # seconds that the whole file may take; two thirds go into one theorem, C3.4.2-b
HARD = (
    "comm(comm(p,q)*comm(p,q), r) == 0",
    "((p*q)*r)*p == p*(q*(r*p))",
    "q**2 - trace(q)*q + norm(q) == 0",
    "p*q == q*p <=> 2 == 0 or p*q == q*p",
    "s*s == 0 => s == 0",
    "s*y == 0 => s == 0 or y == 0",
    "6*s == 0 and 2 != 0 and 3 != 0 => s == 0",
    "3*s == 0 and 2*s == 0 => s == 0",
    "2 == 0 and s**2 == 1 => (s + 1)**2 == 0",
    "1 == 0 => p == q",
    "p*q == 0 => norm(p) == 0 or norm(q) == 0",
    "norm(p) != 0 and norm(q) != 0 => inv(p*q) == inv(q)*inv(p)",
    "norm(q) != 0 => q**(-2) == inv(q)**2",
    "not (s == 0 <=> y == 0) => s != y",
    "(s == 0 => y == 0) and y != 0 => s != 0",
    "not (s == 0 and (y == 0 or p == q)) => s != 0 or (y != 0 and p != q)",
    "exists q: q != 0 and q*q == -1",
    "norm(q) == 1 => (exists p: p*q == e)",
    "2 != 0 => 0.5*q + 0.5*q == q",
)


def coqc(text, folder):
    (folder / "theorems.v").write_text(text, encoding="utf-8")
    return subprocess.run(
        [COQC, "-q", "theorems.v"],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=2 * LIMIT,
        check=False,
    )


def test_the_ledger_and_hard_statements_hold_without_axioms(tmp_path):
    whole = export_ledger() + export_statements(HARD)
    assert len(whole.theorems) > 90 + len(HARD)
    assert {x.name for x in whole.left} == TOO_LARGE
    done = coqc(whole.text, tmp_path)
    assert (done.returncode, done.stdout) == (0, CLOSED), done.stderr


def test_other_algebras_hold_too(tmp_path):
    general = export_statements(["norm(q) != 0 => q*inv(q) == e", "(p*q)*r == p*(q*r)"], "[a,b|F)")
    done = coqc(general.text, tmp_path)
    assert (done.returncode, done.stdout) == (0, CLOSED), done.stderr


@pytest.mark.parametrize(
    ("claim", "right", "wrong"),
    [
        ("C1-a", "j [*H] i = [-] k", "j [*H] i = k"),
        ("C1.3.1-i", "conj H q [*H] conj H p", "conj H p [*H] conj H q"),
        ("C1-e", "+ jm p * km q - km p * jm q", "+ jm p * km q + km p * jm q"),
        ("C1.2-a", "(f_equal km E) nil", "(f_equal jm E) nil"),
        ("C1.2-e", "(cons (i * j) (1) h3 nil)", "(cons (j * i) (1) h3 nil)"),
        ("C1.3.1-x", "(cons (pow (inv (re q)) 2) h2", "(cons (- pow (inv (re q)) 2) h2"),
    ],
)
def test_a_wrong_sign_is_rejected(tmp_path, claim, right, wrong):
    text = export_ledger([find(claim)]).text
    assert right in text
    head, _, tail = text.rpartition(right)
    done = coqc(head + wrong + tail, tmp_path)
    assert done.returncode != 0
    assert "Error" in done.stderr


def rejected(propositions):
    """Return a file in which the tactic for identities must fail on each proposition."""
    goals = "\n".join(f"Goal {text}.\nFail equations.\nAbort." for text in propositions)
    return Export((Theorem("last", RINGS, "", "e [*H] e = e", f"{EQUATIONS}\n{goals}"),)).text


def test_spoilt_twins_are_rejected(tmp_path):
    """The false twin of every identity of the ledger, put to the tactic that proves identities."""
    setting = read_setting()
    twins = []
    for claim in claims():
        twin = claim.spoilt
        if isinstance(twin, Statement) and twin.decide(None).verdict == "refuted":
            read = read_statement(twin.formula, None, twin.given)
            if not (read.hypotheses or read.divides or read.compares_unequal or read.exists):
                twins.append(proposition(read, setting))
    assert len(twins) > 35
    done = coqc(rejected(twins), tmp_path)
    assert done.returncode == 0, done.stderr
    done = coqc(rejected([*twins[:2], "e [*H] i = i"]), tmp_path)
    assert "The command has not failed" in done.stderr


def test_an_admitted_theorem_would_be_seen(tmp_path):
    text = export_statements(["e*q == q"]).text
    done = coqc(
        text.replace("Theorem statement_1", "Axiom statement_1").replace(
            EQUATIONS + "\n\nEnd Commutative_rings", "End Commutative_rings"
        ),
        tmp_path,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("Axioms:\nstatement_1")

"""What Coq says of the files. Skipped where ``coqc`` is missing; CI installs it."""

import json
import shutil
import subprocess
from contextlib import nullcontext
from dataclasses import replace
from itertools import zip_longest

import pytest

from hfield.cli.commands import check
from hfield.cli.commands.check_with_coq import NOT_CONFIRMED
from hfield.cli.parser import Parser
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.coqc import Coqc, NotJudgedError
from hfield.export.coq.export import export_certificates, export_statements
from hfield.export.coq.ledger import export_ledger
from hfield.export.coq.sentences import Proved
from hfield.export.coq.theorem import Theorem, theorem
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import UNIVERSAL
from hfield.ledger.propositions import Assertion
from hfield.ledger.registry import claims
from tests.export.certificates import LEDGER, TRUE, forged_certificates, true_certificates
from tests.export.one_process import reject_each
from tests.thorough import part

COQC = shutil.which("coqc")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(COQC is None, reason="coqc is not installed (Debian: coq)"),
]
CLOSED = "Closed under the global context\n"


@pytest.fixture(scope="module")
def coq():
    with Coqc() as found:
        yield found


def coqc(text, folder):
    (folder / "theorems.v").write_text(text, encoding="utf-8")
    return subprocess.run(
        [COQC, "-q", "theorems.v"], cwd=folder, capture_output=True, text=True, check=False
    )


def name_of(text):
    return "c_" + "".join(char if char.isalnum() else "_" for char in text)


def test_the_ledger_and_certificates_hold_without_axioms_in_a_file_that_stands_alone(tmp_path):
    whole = export_ledger(part(claims(), 4))
    assert len(whole.theorems) > 50
    chosen = {name_of(n): d for n, d in list(true_certificates().items())[::9]}
    done = coqc((whole + export_certificates(chosen)).text, tmp_path)
    assert (done.returncode, done.stdout) == (0, CLOSED), done.stderr


def test_certificates_of_every_kind_hold(coq):
    theorems = [theorem(name_of(name), data) for name, data in true_certificates().items()]
    assert len(theorems) == len(TRUE) + len(LEDGER) + 3 > 50
    assert len(coq.judge(theorems).propositions) == len(theorems)
    kinds = {data["evidence"]["kind"] for data in true_certificates().values()}
    assert {"identity", "implication", "witness", "exhaustion", "terms"} <= kinds
    assert {
        "none exists",
        "place",
        "unsatisfiable",
        "presentation",
        "multilinear",
        "parts",
    } <= kinds


def test_every_forged_certificate_is_rejected(coq):
    """Refused as evidence of something else, or rejected by Coq, for what it computes.

    True ones, among them in one process, are not.
    """
    left = []
    forged = forged_certificates()
    assert len(forged) > 60
    for name, data in forged.items():
        try:
            left.append(theorem(name_of(name), data))
        except MismatchError:
            continue
    assert len(left) > 40
    true = [theorem(name_of(n), d) for n, d in list(true_certificates().items())[:6]]
    left = part(left, 2)
    mixed = [t for pair in zip_longest(left, true) for t in pair if t]
    verdicts = dict(zip(mixed, reject_each(coq, mixed), strict=True))
    assert [t.name for t, rejected in verdicts.items() if rejected != (t in left)] == []
    for one in left[::10]:  # and in a file of its own the computation is what fails
        assert 'has type "true = true"' in coq.judge([one]).rejected


def test_spoilt_twins_are_rejected(coq):
    """The false twins of a fifth of the ledger's identities, with the evidence of identities."""
    twins = []
    for claim in claims():
        twin = claim.spoilt
        if isinstance(twin, Assertion) and twin.decide(None).verdict == "refuted":
            data = certificate(twin, twin.decide(None), UNIVERSAL)
            if data is None or "exists" in data["statement"]:
                continue
            data = {**data, "verdict": "proved", "evidence": {"kind": "identity"}}
            twins.append(theorem(name_of(claim.id), data))
    assert len(twins) > 35
    twins = part(twins)  # Coq reads all by one rule of evidence
    assert reject_each(coq, twins) == [True] * len(twins)


def test_an_axiom_would_be_seen(coq):
    before = ("Axiom nothing : False.",)
    assumed = Theorem("t", "", Proved("0 = 1 :> Z", ("elim nothing.",), before))
    with pytest.raises(NotJudgedError, match="rests on: Axioms: nothing : False"):
        coq.judge([assumed])
    assert reject_each(coq, [assumed]) == [True]
    admitted = Theorem("u", "", Proved("0 = 1 :> Z", ("admit.",)))
    with pytest.raises(NotJudgedError, match="given up goals"):
        coq.judge([admitted])


def test_wrong_statements_about_the_same_evidence_do_not_compile(coq):
    (right,) = export_statements(["conj(p*q) == conj(q)*conj(p)"]).theorems
    text = right.proved.text.replace("conj H q [*H] conj H p", "conj H p [*H] conj H q")
    assert text != right.proved.text
    with pytest.raises(NotJudgedError, match=r'and "conj H \(x0 \[\*H\] x1\) = conj H x0'):
        coq.judge([replace(right, proved=replace(right.proved, text=text))])


@pytest.fixture
def run(tmp_path, capsys):
    def call(data, *words):
        file = tmp_path / "c.json"
        file.write_text(json.dumps(data), encoding="utf-8")
        parser = Parser("hfield check", check.HELP)
        check.configure(parser)
        status = check.run(parser.read([str(file), "--coq", *words]))
        return status, capsys.readouterr().out

    return call


def test_check_asks_coq_too(run, coq, monkeypatch):
    monkeypatch.setattr(
        "hfield.export.coq.coqc.Coqc", lambda *_: nullcontext(coq)
    )  # it has its library
    status, out = run(true_certificates()["commute over QQ"])
    assert status == 0
    assert "Coq: accepted: a theorem without axioms" in out
    assert "Coq's theorem: ~ (forall p q : quaternion Qc, p [*H] q = q [*H] p)" in out
    status, out = run(true_certificates()["both or none"], "--format", "json")
    said = json.loads(out)["results"][0]["coq"]
    assert said["verdict"] == "accepted"
    assert said["proposition"].endswith("<-> num 2 = 0 :> GF 13")  # nothing else tells the ring


def test_check_says_what_is_not_covered(run):
    level = next(c for c in claims() if c.id == "C1.3.1-y").corrected
    data = certificate(level, level.decide(None), UNIVERSAL)
    status, out = run(data)
    assert status == NOT_CONFIRMED
    assert "Coq: not covered: " in out


def test_check_says_that_coq_is_missing(run, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    status, out = run(true_certificates()["commute"])
    assert status == NOT_CONFIRMED
    assert "Coq: not judged: coqc is not installed" in out

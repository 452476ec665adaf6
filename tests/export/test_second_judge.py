"""What ``hfield check --coq`` says where ``coqc`` fails, is ended, or is none; no Coq is needed here."""

import json
import os
import subprocess
import sys

import pytest

from hfield.checker.check import check as check_data
from hfield.cli import main
from hfield.prover.prove import prove
from tests.subcases import subcases

MARK = """mark=$(sed -n 's/.*idtac "\\([0-9a-f]*\\)".*/\\1/p' Judged.v)
said() { printf '%s\\n     : %s\\n%s\\n%s\\n' certificate "$1" "$mark" "$2"; }
"""
CLOSED = "Closed under the global context"
FALSE = (
    'Error: The term "eq_refl" has type "true = true" while it is expected to have type "j = true".'
)


@pytest.fixture
def coqc(tmp_path, monkeypatch):
    """Put a shell script in the place of coqc; with its library it has no trouble."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")

    def put(script):
        path = folder / "coqc"
        path.write_text(f'#!/bin/sh\n[ "$2" = Judged.v ] || exit 0\n{MARK}{script}\n', "utf-8")
        path.chmod(0o755)
        return path

    return put


@pytest.fixture
def check(tmp_path, capsys):
    """Check a certificate with Coq; return the exit status and what is printed."""
    path = tmp_path / "c.json"
    path.write_text(json.dumps(prove("p*q == q*p", "QQ").certificate), encoding="utf-8")

    def run(*words, file=path):
        status = main(["check", "--coq", str(file), *words])
        return status, capsys.readouterr().out

    return run


def test_what_is_accepted_is_printed(coqc, check):
    coqc(f'said "all is well" "{CLOSED}"')
    status, out = check()
    assert status == 0
    assert "  Coq: accepted: a theorem without axioms\n  Coq's theorem: all is well\n" in out


def test_only_a_computation_that_gives_false_rejects(coqc, check):
    coqc(f"echo '{FALSE}' >&2; exit 1")
    status, out = check()
    assert status == 1
    assert "Coq: rejected: Error: The term" in out


@pytest.mark.slow
@subcases(
    ("script", "reason"),
    [
        (f'said "all is well" "{CLOSED}"; exit 1', "ended with status 1: without a word"),
        (f"echo '{FALSE}' >&2; exit 2", "ended with status 2: Error: The term"),
        (f"echo '{FALSE} And more.' >&2; exit 1", "ended with status 1: Error: The term"),
        ("echo Error: Out of memory. >&2; exit 1", "ended with status 1: Error: Out of memory."),
        ("kill -9 $$", "ended by signal 9 (Killed): without a word; it had 300 s (--coq-timeout)"),
        ("kill -15 $$", "ended by signal 15"),
        ("exit 0", "coqc does not print the theorem: ''"),
        (f"echo '{CLOSED}'", f"coqc does not print the theorem: '{CLOSED}'"),
        (f"said accepted; echo '{CLOSED}'; echo more", "says what the theorem rests on"),
        ("said '0 = 1' 'Axioms: nothing : False'", "rests on: Axioms: nothing : False"),
        (f'mark=0; said "all is well" "{CLOSED}"', "coqc does not print the theorem"),
        ("head -c 300000000 /dev/zero", "coqc ended "),
        ("printf '\\377\\376'", "coqc does not print the theorem"),
    ],
)
def test_whatever_else_coqc_does_is_no_verdict(coqc, check, script, reason):
    coqc(script)
    status, out = check()
    assert status == 4
    assert "  Coq: not judged: " in out
    assert reason in out
    assert "Coq's theorem" not in out


def test_a_coqc_that_cannot_be_run(coqc, check, monkeypatch):
    coqc("").write_bytes(b"\x7fELF")
    status, out = check()
    assert status == 4
    assert "coqc: Exec format error" in out
    monkeypatch.setenv("PATH", "")
    status, out = check()
    assert status == 4
    assert "Coq: not judged: coqc is not installed" in out


def test_time_and_what_was_started_end(coqc, check, tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    coqc(f"(sleep 20; echo alive) > {pipe} & sleep 20")
    reading = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    status, out = check("--coq-timeout", "0.5")
    assert status == 4
    assert "Coq: not judged: coqc did not end in time; it had 0.5 s (--coq-timeout)" in out
    os.set_blocking(reading, True)
    assert os.read(reading, 9) == b""  # whoever could write is gone
    os.close(reading)


@pytest.mark.slow
@pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux ends the children of what was killed"
)
def test_coqc_ends_with_its_parent(coqc, check, tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    code = "import time; print('begun', flush=True); time.sleep(20); print('alive')"
    coqc(f'exec {sys.executable} -c "{code}" > {pipe}')
    words = [sys.executable, "-m", "hfield", "check", "--coq", str(tmp_path / "c.json")]
    asking = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    with pipe.open(encoding="utf-8") as stream:
        assert stream.readline() == "begun\n"
        asking.kill()
        assert stream.read() == ""
    asking.wait()


@pytest.mark.slow
def test_memory_is_bounded(coqc, check, tmp_path):
    coqc(f"ulimit -v > {tmp_path}/memory; ulimit -t > {tmp_path}/seconds; exit 3")
    status, out = check("--coq-memory", "3000", "--coq-timeout", "7")
    assert status == 4
    assert "coqc ended with status 3: without a word; it had 7 s (--coq-timeout), 3000 MiB" in out
    assert (tmp_path / "memory").read_text("utf-8") == f"{3000 * 1024}\n"
    assert (tmp_path / "seconds").read_text("utf-8") == "8\n"


@pytest.mark.slow
def test_libraries_of_others_are_not_seen(coqc, check, monkeypatch):
    for name in ("COQPATH", "XDG_DATA_HOME", "XDG_DATA_DIRS"):
        monkeypatch.setenv(name, "/others")
    coqc('said "$COQPATH$XDG_DATA_HOME$XDG_DATA_DIRS" "$(pwd)"')
    _, out = check()
    assert "/others" not in out
    assert "rests on: /" in out


@pytest.mark.slow
def test_a_folder_that_anyone_may_change(coqc, check, tmp_path, monkeypatch):
    coqc(f'said "all is well" "{CLOSED}"')
    monkeypatch.setattr("hfield.export.coq.coqc.gettempdir", lambda: str(tmp_path / "ours"))
    (tmp_path / "ours").mkdir(mode=0o700)
    assert check()[0] == 0
    tmp_path.chmod(0o777)
    status, out = check()
    assert status == 4
    assert f"Coq: not judged: anyone may rename what is in {tmp_path}" in out
    tmp_path.chmod(0o1777)
    assert check()[0] == 0


@pytest.mark.slow
def test_one_that_is_killed_does_not_judge_the_others(coqc, check, tmp_path):
    files = []
    for n, statement in enumerate(("e*q == q", "q*e == q", "i*i == -1")):
        files.append(tmp_path / f"{n}.json")
        text = json.dumps(prove(statement, "QQ").certificate)
        files[-1].write_text(text, encoding="utf-8")
    coqc(f"grep -q 'QMul (QVar 0)' Judged.v && kill -9 $$; said 'all is well' '{CLOSED}'")
    status, out = check(*map(str, files[1:]), "--format", "json", file=files[0])
    assert status == 4
    words = [result["coq"]["verdict"] for result in json.loads(out)["results"]]
    assert words == ["accepted", "not judged", "accepted"]


@pytest.mark.slow
def test_coq_checks_the_certificate_that_was_accepted(coqc, check, tmp_path, monkeypatch):
    """Also of a file that has changed since, whose name may stand for two texts, and of one of many."""
    coqc(f"said \"$(grep -c '~ (' Judged.v)\" '{CLOSED}'")
    one, two = (json.dumps(prove(s, "QQ").certificate) for s in ("e*q == q", "p*q == q*p"))
    file, many = tmp_path / "changing.json", tmp_path / "many.jsonl"
    file.write_text(one, encoding="utf-8")
    many.write_text(f"{two}\n{one}\n", encoding="utf-8")

    def change(*words):
        found = check_data(*words)
        file.write_text(two, encoding="utf-8")
        return found

    monkeypatch.setattr("hfield.cli.commands.check.check", change)
    status, out = check(str(file), str(many), "--format", "json", file=file)
    assert status == 0
    results = json.loads(out)["results"]
    assert [r["verdict"] for r in results] == ["proved", "refuted", "refuted", "proved"]
    assert [r["coq"]["proposition"] for r in results] == ["0", "1", "1", "0"]


def test_coq_does_not_run_on_rejected_certificates(coqc, check, tmp_path):
    coqc("").unlink()
    bad = tmp_path / "bad.json"
    bad.write_text("{}", encoding="utf-8")
    status, out = check(file=bad)
    assert status == 1
    assert "Coq" not in out


@pytest.mark.parametrize("words", [("--coq-timeout", "0"), ("--coq-memory", "1.5")])
def test_bad_bounds(check, words):
    assert check(*words)[0] == 2

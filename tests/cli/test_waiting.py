"""What a command says on a terminal while one waits, and Ctrl-C: on a pseudo-terminal, and piped."""

import os
import re
import subprocess
import sys

import pytest

from tests.patience import PATIENCE

pty = pytest.importorskip("pty")

SLOW = """
import sys, time
from hfield.cli import main
import hfield.prover.prove as proving
decide = proving.prove
def prove(*words):
    print("started", flush=True)
    while not {enough}:
        time.sleep(0.01)
    return decide(*words)
proving.prove = prove
sys.exit(main(["prove", "q*e == q"]))
"""


class Screen:
    """A command whose stderr, or stdin and all, is a pseudo-terminal."""

    def __init__(self, code, stdin=False):
        self.master, slave = pty.openpty()
        self.process = subprocess.Popen(
            [sys.executable, "-c", code],
            stdin=slave if stdin else subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=slave,
            start_new_session=True,
            env={**os.environ, "PYTHON_BASIC_REPL": "1", "TERM": "dumb"},
        )
        os.close(slave)
        self.seen = ""

    def until(self, pattern):
        """Read what stderr shows until it has the pattern; an end without it is an error."""
        while not re.search(pattern, self.seen):
            try:
                piece = os.read(self.master, 4096)
            except OSError:  # Linux says so at the end
                piece = b""
            assert piece, f"{pattern!r} is not in {self.seen!r}"
            self.seen += piece.decode()

    def finish(self):
        """Return the exit status and stdout; stderr is read to its end."""
        out, _ = self.process.communicate(timeout=PATIENCE)
        try:
            while piece := os.read(self.master, 4096):
                self.seen += piece.decode()
        except OSError:
            pass
        os.close(self.master)
        return self.process.returncode, out.decode()


@pytest.mark.slow
def test_a_command_says_what_it_is_at_and_takes_it_back():
    counted = "from hfield.cli.status import STATUS\nshown, show = [], STATUS.show\n"
    counted += "STATUS.show = lambda text: (show(text), shown.append(text))\n"
    screen = Screen(counted + SLOW.format(enough="len(shown) > 1"))
    status, out = screen.finish()
    assert status == 0
    assert "proving q*e == q …" in screen.seen
    assert "proving q*e == q … 1 s" in screen.seen
    assert screen.seen.endswith("\r\x1b[K")
    assert out.startswith("started\nq·e = q\n")
    assert "proving" not in out


@pytest.mark.slow
def test_nothing_is_said_into_a_pipe():
    code = "from time import monotonic; end = monotonic() + 1.2\n" + SLOW
    code = code.format(enough="monotonic() > end")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=PATIENCE)
    assert (done.returncode, done.stderr) == (0, b"")


def test_ctrl_c_ends_a_command_in_one_line_with_130():
    screen = Screen(SLOW.format(enough="False"))
    screen.until("proving")
    screen.process.send_signal(2)
    status, _ = screen.finish()
    assert status == 130
    assert screen.seen.endswith("\r\x1b[Khfield: error: interrupted\r\n")
    assert "Traceback" not in screen.seen


@pytest.mark.slow
def test_export_counts_its_claims():
    code = "import sys; from hfield.cli import main; "
    code += (
        "sys.exit(main(['export', '--coq', '-', '--claim', 'C1.1.1-a', '--claim', 'theorem-3']))"
    )
    screen = Screen(code)
    status, out = screen.finish()
    assert status == 0
    assert re.search(r"\[#{10} {10}\] 1 of 2 claims, C1\.3\.1-z", screen.seen)
    assert "claims," not in out


@pytest.mark.slow
def test_classes_tell_how_far_they_are():
    code = """
import sys, time
from hfield.cli import main
from hfield.cli.status import STATUS
import hfield.orders.classes as classes
shown, show, report = [], STATUS.show, classes.report
STATUS.show = lambda text: (show(text), shown.append(text))
def slow(done, total, what):
    report(done, total, what)
    while 0 < done < total and not any("some" in text for text in shown):
        time.sleep(0.01)
classes.report = slow
sys.exit(main(["classes", "163"]))
"""
    screen = Screen(code)
    status, out = screen.finish()
    assert status == 0
    assert re.search(
        r"enumerating classes …( \d s)? \(\d+ % of the classes, some \d+ s left\)", screen.seen
    )
    assert "% of" not in out


def test_commands_that_compute_say_so():
    """All others answer at once, or have a Progress of their own."""
    from hfield.cli import catalogue

    silent = {
        name for name in catalogue.names() if not hasattr(catalogue.command(name)[0], "DOING")
    }
    at_once = {"claims", "completion", "docs", "init", "repl", "table"}
    assert silent - at_once <= {"bench", "report", "verify", "render"}


def test_newforms_are_said_to_be_computed(monkeypatch, capsys):
    from hfield.cli import main
    from hfield.cli.status import Waiting

    said = []
    monkeypatch.setattr(Waiting, "at", said.append)
    assert main(["classes", "(-1,-11|QQ)", "--newforms"]) == 0
    assert said == ["computing newforms"]
    assert "newform f1     a_2 = -2, a_3 = -1, a_5 = 1" in capsys.readouterr().out

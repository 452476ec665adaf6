"""The interactive session: its names, lines piped in, and both consoles on a terminal."""

import io
import os
import subprocess
import sys

import pytest

from hfield import repl
from hfield.algebra import H, QuaternionAlgebra
from hfield.cli import main


def piped(monkeypatch, capsys, text, *words):
    monkeypatch.setattr("sys.stdin", io.StringIO(text))
    monkeypatch.setattr("sys.displayhook", sys.__displayhook__)
    status = main(["repl", *words])
    out, err = capsys.readouterr()
    return status, out, err


def test_names_of_a_session():
    names = repl.namespace(QuaternionAlgebra("GF(4)(t)", -1, "t"))
    public = {"H", "GF", "QQ", "RR", "CC", "ZZ", "RDF", "ring", "QuaternionAlgebra", "prove"}
    assert public | {"explain", "verify", "Fraction", "A", "F", "e", "i", "j", "k", "t"} <= set(
        names
    )
    assert names["i"] * names["j"] == names["k"]
    assert names["F"].name == "GF(4)(t)"
    assert names["A"].basis[3] is names["k"]


@pytest.mark.parametrize("name", ["explain", "verify"])
def test_helpers_teach(name):
    assert ">>>" in repl.namespace(H("QQ"))[name].__doc__


def test_the_banner_tells_where_one_is_and_its_lines_run():
    A = H("GF(9)")
    text = repl.banner(A)
    assert "GF(9)" in text
    assert max(map(len, text.splitlines())) <= 100
    names = repl.namespace(A)
    tries = [line[2:].split("   ")[0] for line in text.splitlines() if line.startswith("  ")]
    assert len(tries) > 4
    for line in tries:
        if not line.startswith("explain"):
            exec(line, names)


def test_lines_piped_in(monkeypatch, capsys):
    lines = "i*j\n-k\nfor n in range(2):\n    i**n\n\n2*A(1, 2, 0, 1)\nx = 1\n"
    assert piped(monkeypatch, capsys, lines) == (0, "k\n−k\n1\ni\n2 + 4i + 2k\n", "")


def test_a_block_at_the_end_is_run(monkeypatch, capsys):
    assert piped(monkeypatch, capsys, "if True:\n  i*i", "--field", "GF2") == (0, "1\n", "")


def test_an_error_of_ours_is_one_line(monkeypatch, capsys):
    status, out, err = piped(monkeypatch, capsys, "i/0\nA.ring\n", "--algebra", "(-1,-3|QQ)")
    assert (status, out) == (1, "QQ\n")
    assert err == "NotInvertibleError: cannot invert 0 in (-1,-3|QQ)\n"


def test_other_errors_show_where(monkeypatch, capsys):
    status, _, err = piped(monkeypatch, capsys, "nothing\n1 +* 2\n")
    assert status == 1
    assert "NameError" in err
    assert "SyntaxError" in err


def test_leaving(monkeypatch, capsys):
    assert piped(monkeypatch, capsys, "exit(3)\ni\n") == (3, "", "")


@pytest.mark.parametrize("words", [["--field", "GF(6)"], ["--algebra", "x"], ["--feild", "QQ"]])
def test_bad_usage(monkeypatch, capsys, words):
    status, out, err = piped(monkeypatch, capsys, "", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)


# --- on a terminal -----------------------------------------------------------------------------


def talk(tmp_path, lines, code):
    """Type lines into a session on a pseudo-terminal and return what it shows."""
    pty = pytest.importorskip("pty")
    master, slave = pty.openpty()
    environment = {
        **os.environ,
        "TERM": "dumb",
        "IPYTHONDIR": str(tmp_path),
        "HOME": str(tmp_path),
        "PYTHON_BASIC_REPL": "1",
    }
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=slave,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=environment,
    )
    os.close(slave)
    os.write(master, "".join(f"{line}\n" for line in lines).encode())
    out, _ = process.communicate(timeout=60)
    os.close(master)
    return out.decode()


SESSION = "import sys; {0}; from hfield.cli import main; sys.exit(main(['repl', '--field', 'GF7']))"


@pytest.mark.parametrize("without", ["pass", "sys.modules['IPython'] = None"])
def test_a_session(tmp_path, without):
    lines = ["(1+i)*(j-k)**-1", "i/0", "exit()"]
    shown = talk(tmp_path, lines, SESSION.format(without))
    assert "(-1,-1|GF(7))" in shown
    assert "6j" in shown
    assert "NotInvertibleError: cannot invert 0" in shown
    assert "Traceback" not in shown


@pytest.mark.parametrize("line", ["no_such_name", "1 +* 2", "i/0", "raise ImportError('mine')"])
def test_an_error_without_ipython_is_shown_alone(monkeypatch, capsys, line):
    lines = iter([line, "exit()"])
    monkeypatch.setitem(sys.modules, "IPython", None)
    monkeypatch.setitem(sys.modules, "IPython.terminal.ipapp", None)
    monkeypatch.setattr(sys.stdin, "isatty", lambda: True, raising=False)
    monkeypatch.setattr("builtins.input", lambda prompt="": next(lines))
    with pytest.raises(SystemExit):
        repl.start(H("GF(7)"))
    shown = capsys.readouterr().err
    assert "Error" in shown
    assert "IPython" not in shown
    assert "During handling" not in shown


INTERRUPTED = """
import os, time
import hfield.proving.prove as proving
proving.prove = lambda *words: (os.kill(os.getpid(), 2), time.sleep(30))
"""


@pytest.mark.parametrize("without", ["pass", "sys.modules['IPython'] = None"])
def test_ctrl_c_in_a_proof_returns_to_the_prompt_in_one_line(tmp_path, without):
    lines = ["prove('q == q')", "print('still', 'here')", "exit()"]
    shown = talk(tmp_path, lines, INTERRUPTED + SESSION.format(without))
    assert "interrupted\n" in shown
    assert "still here" in shown
    assert "Traceback" not in shown
    assert "KeyboardInterrupt" not in shown

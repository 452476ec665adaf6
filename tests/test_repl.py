"""The interactive session: its names, lines piped in, and both consoles on a terminal."""

import io
import os
import subprocess
import sys

import pytest

from hfield import repl
from hfield.algebra import H, QuaternionAlgebra
from hfield.cli import main
from tests.patience import PATIENCE
from tests.subcases import slow


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
    assert max(map(len, text.splitlines())) <= 80
    names = repl.namespace(A)
    tries = [line[2:].split("   ")[0] for line in text.splitlines() if line.startswith("  ")]
    assert len(tries) > 4
    for line in tries:
        if not line.startswith("explain"):
            exec(repl.python_source(line), names)


def test_names_of_other_systems_say_what_to_write(monkeypatch, capsys):
    status, _, said = piped(monkeypatch, capsys, "BrandtModule(11)\nij\nnothing_of_ours\n")
    assert status == 1
    assert "there is no 'BrandtModule': write O.class_set()" in said
    assert "there is no 'ij': write i*j" in said
    assert "name 'nothing_of_ours' is not defined" in said
    said_of_a_method = piped(monkeypatch, capsys, "A.i.nrd\n")[2]
    assert said_of_a_method == "ForeignNameError: a Quaternion has no 'nrd': write norm()\n"
    said_of_an_import = piped(monkeypatch, capsys, "from hfield import nrd\n")[2]
    assert said_of_an_import == "ForeignImportError: hfield has no 'nrd': write q.norm()\n"


@pytest.mark.parametrize(
    ("typed", "python"),
    [
        ("2i + 3j - 10k", "2*i + 3*j - 10*k"),
        ("(1 + i)j", "(1 + i)*j"),
        ("(1 + 2i)(3 + j)", "(1 + 2*i)*(3 + j)"),
        ("f(1)(i), (f or g)(i)", "f(1)(i), (f or g)(i)"),
        ("q^2 + 1/2i", "q**2 + 1/2*i"),
        ("(−1 + 2i)² · k⁻¹", "(-1 + 2*i)**2 * k**-1"),
        ("x2i + e2k, 2ij", "x2i + e2k, 2ij"),
        ("A('2i^2') + 2i  # 2i^2", "A('2i^2') + 2*i  # 2i^2"),
        ('"""2i\n^""", "\\"2i", 3j', '"""2i\n^""", "\\"2i", 3*j'),
        ("f'2i' \"it's\" 2k", "f'2i' \"it's\" 2*k"),
    ],
)
def test_what_the_shell_reads_is_read(typed, python):
    assert repl.python_source(typed) == python


def test_elements_as_in_the_shell(monkeypatch, capsys):
    lines = "(2i + 3j)^2\n2i·k − 1\nfor n in range(2):\n    2i^n\n\n"
    assert piped(monkeypatch, capsys, lines, "GF7") == (0, "1\n6 + 5*j\n2\n2*i\n", "")


def test_help_of_an_algebra_is_one_screen(monkeypatch, capsys):
    status, out, _ = piped(monkeypatch, capsys, "help(A)\nhelp(A.units)\nhelp\n", "GF3")
    screen, _, rest = out.partition("Help on ")
    assert status == 0
    assert len(screen.splitlines()) <= 24
    assert max(map(len, screen.splitlines())) <= 79
    assert "units" in rest
    assert "help(A) shows" in rest


def test_completion_is_in_the_order_of_a_lesson():
    A = H("GF(3)")
    lesson = " ".join(names for _, _, names in repl.LESSON).split()
    assert len(lesson) == len(set(lesson))
    assert repl.completions(A, "")[: len(lesson)] == lesson  # all of them are there
    assert repl.completions(A, "is_")[0] == "is_commutative"
    assert "__init__" in repl.completions(A, "__")
    assert repl.completions("text", "upp") == ["upper"]


def test_completion_in_ipython():
    pytest.importorskip("IPython")
    from IPython.core.completer import provisionalcompleter
    from IPython.core.interactiveshell import InteractiveShell

    names = repl.namespace(H("GF(3)"))
    shell = InteractiveShell(user_ns=names)
    repl._complete_in_order(shell, names)
    with provisionalcompleter():
        found = [c.text for c in shell.Completer.completions("A.", 2)]
    assert found[:3] == ["basis", "one", "zero"]
    assert len(found) == len(set(found))


def test_lines_piped_in(monkeypatch, capsys):
    lines = "i*j\n-k\nfor n in range(2):\n    i**n\n\n2*A(1, 2, 0, 1)\nx = 1\n"
    assert piped(monkeypatch, capsys, lines) == (0, "k\n-k\n1\ni\n2 + 4*i + 2*k\n", "")


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
    out, _ = process.communicate(timeout=PATIENCE)
    os.close(master)
    return out.decode()


SESSION = "import sys; {0}; from hfield.cli import main; sys.exit(main(['repl', '--field', 'GF7']))"


@pytest.mark.parametrize("without", ["pass", slow("sys.modules['IPython'] = None")])
def test_a_session(tmp_path, without):
    lines = ["(1+i)*(j-k)**-1", "i/0", "exit()"]
    shown = talk(tmp_path, lines, SESSION.format(without))
    assert "(-1,-1|GF(7))" in shown
    assert "6*j" in shown
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
import hfield.prover.prove as proving
proving.prove = lambda *words: (os.kill(os.getpid(), 2), time.sleep(30))
"""


@pytest.mark.slow
@pytest.mark.parametrize("without", ["pass", "sys.modules['IPython'] = None"])
def test_ctrl_c_in_a_proof_returns_to_the_prompt_in_one_line(tmp_path, without):
    lines = ["prove('q == q')", "print('still', 'here')", "exit()"]
    shown = talk(tmp_path, lines, INTERRUPTED + SESSION.format(without))
    assert "interrupted\n" in shown
    assert "still here" in shown
    assert "Traceback" not in shown
    assert "KeyboardInterrupt" not in shown


def test_history_goes_on_without_ipython(tmp_path, monkeypatch):
    readline = pytest.importorskip("readline")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    assert repl.history_file() == tmp_path / "hfield" / "history"
    seen = []

    def session(console, greeting, end):
        seen.append(
            [readline.get_history_item(n + 1) for n in range(readline.get_current_history_length())]
        )
        readline.add_history(f"i*j + {len(seen)}")

    monkeypatch.setattr(repl._Console, "interact", session)
    for _ in range(2):
        readline.clear_history()
        assert repl._run_plain(repl.namespace(H("GF(3)")), "") == 0
    assert seen == [[], ["i*j + 1"]]
    assert repl.history_file().read_text().split("\n")[:2] == ["i*j + 1", "i*j + 2"]
    readline.clear_history()

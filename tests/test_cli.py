"""The command line as such: dispatch, errors of one line, options that look like expressions."""

import os
import shlex
import subprocess
import sys

import pytest

from hfield import __version__, cli
from hfield.cli import catalogue, main
from hfield.cli.catalogue import COMMANDS
from hfield.cli.parser import Parser, UsageError
from hfield.errors import HFieldError
from tests.cli.running import run
from tests.patience import PATIENCE


def refused(capsys, *words):
    """Run what must be refused, and return the one line that says so."""
    status, out, err = run(capsys, *words)
    assert (status, out) == (2, ""), err
    assert err.startswith("hfield: error: ")
    assert err.endswith("\n")
    assert err.count("\n") == 1
    return err


def test_version(capsys):
    assert run(capsys, "--version") == (0, f"hfield {__version__}\n", "")


@pytest.mark.parametrize("words", [[], ["--help"], ["-h"]])
def test_help_names_every_command(capsys, words):
    status, out, _ = run(capsys, *words)
    assert status == 0
    for name, text in COMMANDS.items():
        assert f"{name} " in out
        assert text in out


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help(capsys, name):
    status, out, err = run(capsys, name, "--help")
    assert (status, err) == (0, "")
    assert f"usage: hfield {name}" in out
    assert max(map(len, out.splitlines())) <= 100
    assert run(capsys, "help", name) == (0, out, "")


@pytest.mark.parametrize("name", catalogue.names())
def test_every_command_has_examples_that_its_arguments_take(capsys, monkeypatch, name):
    monkeypatch.setenv("COLUMNS", "160")  # wide enough for every example on one line
    module, parser = catalogue.command(name)
    lines = [line for line in module.EXAMPLES if line.startswith("hfield ")]
    assert lines
    for line in lines:
        words = shlex.split(line, comments=True)
        assert words[:2] == ["hfield", name]
        parser.read(words[2:] if "|" not in words else words[2 : words.index("|")])
        assert f"  {line}" in run(capsys, name, "--help")[1].splitlines()


@pytest.mark.parametrize("name", ["", *catalogue.names()])
def test_help_fits_a_narrow_terminal(capsys, monkeypatch, name):
    monkeypatch.setenv("COLUMNS", "60")
    _, out, _ = run(capsys, "help", *([name] if name else []))
    assert [line for line in out.splitlines() if len(line) > 60] == []


def test_a_long_example_goes_on_below_as_a_shell_reads_it(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    long = [line for line in catalogue.command("prove")[0].EXAMPLES if len(line) > 58]
    assert long
    below = run(capsys, "help", "prove")[1].partition("examples:")[2]
    joined = [shlex.split(line) for line in below.replace("\\\n", " ").splitlines()]
    assert all(shlex.split(line) in joined for line in long)


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["tabel"], "did you mean table"),
        (["nonsense"], "hfield --help"),
        (["--nonsense"], "expected a command first"),
        (["-x"], "expected a command first"),
        ([""], "there is no command"),
        (["eval"], "EXPR"),
        (["table", "j"], "'j'"),
        (["eval", "i", "--feild", "QQ"], "did you mean --field"),
        (["eval", "i", "--field=GF9", "--fromat=json"], "did you mean --format"),
        (["eval", "i", "--field", "QQ", "--algebra", "(1,1|QQ)"], "not allowed with"),
        (["eval", "i", "--format", "jsn"], "jsn"),
        (["table", "i"], "'i'"),
    ],
)
def test_bad_usage(capsys, words, hint):
    assert hint in refused(capsys, *words)


@pytest.fixture
def failing(monkeypatch):
    """Return a function that makes ``hfield table`` raise an error."""

    def fail(error):
        def dispatch(words):
            raise error

        monkeypatch.setattr(cli, "_dispatch", dispatch)

    return fail


class TwoLinesError(HFieldError):
    pass


@pytest.mark.parametrize(
    ("error", "status", "line"),
    [
        (TwoLinesError("two\n  lines"), 2, "two lines"),
        (RecursionError(), 2, "nests too deeply"),
        (MemoryError(), 2, "not enough memory"),
        (KeyboardInterrupt(), 130, "interrupted"),
        (AssertionError("oops"), 70, "fault of hfield itself (AssertionError: oops)"),
    ],
)
def test_errors_are_one_line(capsys, failing, error, status, line):
    failing(error)
    code, out, err = run(capsys, "table")
    assert (code, out) == (status, "")
    assert err.startswith("hfield: error: ")
    assert line in err
    assert err.count("\n") == 1


def test_the_traceback_can_be_had(capsys, failing, monkeypatch):
    monkeypatch.setenv(cli.TRACEBACK, "1")
    failing(AssertionError("oops"))
    assert main(["table"]) == 70
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("code", [3, "bye"])
def test_leaving_early_keeps_the_status(failing, code):
    failing(SystemExit(code))
    assert main(["repl"]) == (3 if code == 3 else 1)


def make_parser():
    parser = Parser("hfield test", "A test.")
    parser.add_argument("words", nargs="*")
    parser.add_argument("--given", action="append")
    parser.add_argument("-o", "--output")
    return parser


@pytest.mark.parametrize(
    "text", ["-i*j", "-1*i", "-1", "-(1+i)", "--(1+i)", "- i", "-e", "-", "--1"]
)
def test_expressions_with_a_leading_minus(text):
    assert make_parser().read([text]).words == [text]
    assert make_parser().read(["i", "--given", text, "-o", "x"]).given == [text]
    assert make_parser().read([f"--given={text}"]).given == [text]


def test_everything_after_two_dashes_is_an_expression():
    assert make_parser().read(["--", "--i"]).words == ["--i"]
    assert make_parser().read(["-ofile", "i"]).output == "file"


@pytest.mark.parametrize("text", ["--i", "--outptu=x"])
def test_what_looks_like_a_long_option_is_one(text):
    with pytest.raises(UsageError, match="unknown option"):
        make_parser().read([text])


class Point:
    """An entry point of another package."""

    name = "greet"

    def load(self):
        return sys.modules[__name__]


HELP = "Greet."


def configure(parser):
    parser.add_argument("whom")


def greet(args):
    print(f"hello {args.whom}")
    return 5


def test_commands_of_other_packages(capsys, monkeypatch):
    monkeypatch.setattr(catalogue, "_foreign", lambda: {"greet": Point()})
    monkeypatch.setattr(sys.modules[__name__], "run", greet)
    assert main(["greet", "you"]) == 5
    assert capsys.readouterr().out == "hello you\n"
    assert main(["--help"]) == 0
    assert "greet" in capsys.readouterr().out
    assert main(["gret", "you"]) == 2
    assert "did you mean greet" in capsys.readouterr().err


def test_the_help_tells_what_other_commands_do(capsys, monkeypatch):
    class Broken(Point):
        def load(self):
            raise ImportError("no such module")

    monkeypatch.setattr(catalogue, "_foreign", lambda: {"greet": Point(), "part": Broken()})
    assert main(["--help"]) == 0
    out = capsys.readouterr().out
    assert "greet        (see `hfield greet --help`)" in out
    assert "part         (cannot be loaded: no such module)" in out
    monkeypatch.setattr(sys.modules[__name__], "SUMMARY", "say hello", raising=False)
    assert main(["--help"]) == 0
    assert "greet        say hello" in capsys.readouterr().out


def test_the_help_groups_commands_and_ends_with_one_to_start_with(capsys, monkeypatch):
    monkeypatch.setattr(catalogue, "_foreign", lambda: {"greet": Point()})
    monkeypatch.setattr(sys.modules[__name__], "HEADING", "Manners", raising=False)
    _, out, _ = run(capsys)
    titles = [line for line in out.splitlines() if line.endswith(":") and line[:1].isupper()]
    assert titles == [f"{title}:" for title in (*list(catalogue.GROUPS)[:-1], "Manners", "Tools")]
    *_, last = out.splitlines()
    assert last.startswith("Start with: hfield ")
    capsys.readouterr()
    assert main(shlex.split(last.partition("hfield ")[2])) == 1  # refuted


def test_a_foreign_command_never_hides_one_of_ours(capsys, monkeypatch):
    monkeypatch.setattr(catalogue, "_foreign", lambda: {"table": Point()})
    assert main(["table", "--field", "GF2"]) == 0


@pytest.mark.slow
@pytest.mark.parametrize("redirection", [">&-", "2>&-", ">&- 2>&-"])
def test_closed_streams_are_no_fault(redirection):
    command = f"{sys.executable} -m hfield eval 1+i {redirection}"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert done.stderr == ""


@pytest.mark.slow
@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="the system has no /dev/full")
def test_a_terminal_that_cannot_be_written_is_one_line():
    command = f"{sys.executable} -m hfield eval 1+i > /dev/full"
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr == "hfield: error: cannot write the output: No space left on device\n"


# --- in a process of its own -------------------------------------------------------------------


def shell(*words, **kwargs):
    environment = {**os.environ, **kwargs.pop("env", {})}
    return subprocess.run(
        [sys.executable, "-m", "hfield", *words],
        capture_output=True,
        timeout=PATIENCE,
        env=environment,
        **kwargs,
    )


def test_a_reader_that_leaves_is_no_error():
    code = "from hfield.cli import main; import sys; sys.exit(main(['--help']))"
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(
        [sys.executable, "-c", code], stdout=write, stderr=subprocess.PIPE, timeout=PATIENCE
    )
    os.close(write)
    assert done.stderr == b""
    assert done.returncode == cli.BROKEN_PIPE


@pytest.mark.slow
def test_a_terminal_without_unicode():
    done = shell("eval", "-i", "--format", "unicode", env={"PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stdout, done.stderr) == (0, b"-i\n", b"")
    done = shell("claims", "--format", "no", env={"PYTHONIOENCODING": "ascii"})
    assert done.returncode == 2
    assert done.stderr.decode("ascii").startswith("hfield: error: ")


def test_the_command_runs_as_a_module():
    done = shell("eval", "(1+i)*(j-k)**-1", "--field", "GF(7)")
    assert (done.returncode, done.stdout) == (0, b"6*j\n")

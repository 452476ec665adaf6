"""The interactive session: an algebra with e, i, j, k at hand, in IPython or in plain Python."""

from __future__ import annotations

import sys
from code import InteractiveConsole
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import hfield
from hfield.errors import HFieldError
from hfield.notation import BASIS

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.proving.prove import Answer


def export_session(answers: Iterable[Answer]) -> str:
    """Return a Coq file of the answers of ``prove`` that hold over all fields.

    ``Path("mine.v").write_text(export_session([prove("trace(p*q) == trace(q*p)")]))``
    """
    from hfield.coq.export import export_session

    return export_session(answers).text


def with_symbols(A: QuaternionAlgebra, symbols: Sequence[str]) -> QuaternionAlgebra:
    """Return the algebra over the rational functions in these variables; itself if there are none."""
    return A.change_ring(f"{A.ring.name}({','.join(symbols)})") if symbols else A


def namespace(A: QuaternionAlgebra, symbols: Sequence[str] = ()) -> dict[str, object]:
    """Return the names of a session: the public ones, ``A``, ``F``, its generators, symbols, ``e i j k``."""
    from fractions import Fraction

    names = {name: getattr(hfield, name) for name in dir(hfield)}
    names |= {"Fraction": Fraction, "export_session": export_session}
    names |= {name: x for name, x in A.ring.names().items() if name not in names}
    if symbols:
        import sympy

        names |= {name: sympy.Symbol(name) for name in symbols}
    return {**names, "A": A, "F": A.ring, **dict(zip(BASIS, A.basis, strict=True))}


def banner(A: QuaternionAlgebra) -> str:
    """Return what greets: where one is, and a few lines worth typing."""
    generators = "".join(f", {name}" for name in A.ring.names())
    return f"""\
hfield {hfield.__version__}: the quaternion algebra A = {A} over F = {A.ring}; e, i, j, k{generators}

  (1 + i)*(j - k)**-1                  compute, exactly
  q = A(1, 2, 0, 1); norm(q)           also conj(q), inv(q), trace(q), q.matrix(), help(q)
  print(A.table_text("unicode"))       the multiplication table
  H(GF(7)).zero_norm_element()         another field: GF(9), RR, ring("QQ(sqrt(2))") …
  prove("p*q == q*p", "GF(4)")         decide a statement of your own
  explain("centre", "GF(4)")           a claim of the thesis, step by step; also verify("centre")

F(1)/2 or Fraction(1, 2) is a half; Python's own 1/2 is a float and does not mix.
"""


def start(A: QuaternionAlgebra, symbols: Sequence[str] = ()) -> int:
    """Run a session and return its exit status; text piped in is run without prompts."""
    names = namespace(A, symbols)
    if not sys.stdin.isatty():
        return _run_piped(names)
    app = _ipython()
    if app is None:  # outside the except clause: errors of the session are shown as they are
        return _run_plain(names, banner(A))
    return _run_ipython(app, names, banner(A))


def _ipython() -> Any:
    """Return the class of IPython's terminal sessions, None where IPython is not installed."""
    try:
        from IPython.terminal.ipapp import TerminalIPythonApp
    except ImportError:
        return None
    return TerminalIPythonApp


class _Console(InteractiveConsole):
    """Python's own console; an error of ours is told in one line."""

    failed = False

    def showtraceback(self) -> None:
        """Show the error that was just raised."""
        self.failed = True
        error = sys.exc_info()[1]
        if isinstance(error, (HFieldError, KeyboardInterrupt)):
            self.write(f"{_one_line(error)}\n")
        else:
            super().showtraceback()

    def showsyntaxerror(self, *args: Any, **kwargs: Any) -> None:
        """Show a syntax error."""
        self.failed = True
        super().showsyntaxerror(*args, **kwargs)


def _one_line(error: BaseException) -> str:
    if isinstance(error, KeyboardInterrupt):
        return "interrupted"
    return f"{type(error).__name__}: {' '.join(str(error).split())}"


def _run_piped(names: dict[str, object]) -> int:
    """Run the lines of stdin, as if typed; 1 if one of them failed."""
    console = _Console(names, "<stdin>")
    more = False
    for line in sys.stdin:
        more = console.push(line.rstrip("\n"))
    if more:
        console.push("")
    return int(console.failed)


def _run_plain(names: dict[str, object], greeting: str) -> int:
    try:
        import readline
        from rlcompleter import Completer
    except ImportError:  # a Python without readline still makes a session
        pass
    else:
        readline.set_completer(Completer(names).complete)
        readline.parse_and_bind("tab: complete")
    _Console(names).interact(greeting, "")
    return 0


def _run_ipython(app: Any, names: dict[str, object], greeting: str) -> int:
    from traitlets.config import Config

    config = Config()
    config.TerminalInteractiveShell.banner1 = greeting
    config.TerminalInteractiveShell.banner2 = ""
    session = app.instance(config=config, user_ns=names)
    session.initialize([])

    def tell(
        shell: object, kind: object, error: BaseException, trace: object, tb_offset: object = None
    ) -> None:
        print(_one_line(error), file=sys.stderr)

    session.shell.set_custom_exc((HFieldError, KeyboardInterrupt), tell)
    session.start()
    return 0

"""The interactive session: an algebra with e, i, j, k, in IPython or in plain Python."""

from __future__ import annotations

import builtins
import os
import re
import sys
from code import InteractiveConsole
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import hfield
from hfield.errors import HFieldError, shorten
from hfield.hints import ForeignImportError, ForeignNameError, called_here
from hfield.notation import BASIS

if TYPE_CHECKING:
    from IPython.core.completer import CompletionContext
    from IPython.core.interactiveshell import InteractiveShell
    from IPython.terminal.ipapp import TerminalIPythonApp

    from hfield.algebra import QuaternionAlgebra
    from hfield.prover.prove import Answer

_SHOWN_IN_A_LINE = (HFieldError, ForeignNameError, ForeignImportError, KeyboardInterrupt)


def export_session(answers: Iterable[Answer]) -> str:
    """Return a Coq file of the answers of ``prove`` that hold over all fields.

    ``Path("mine.v").write_text(export_session([prove("trace(p*q) == trace(q*p)")]))``
    """
    from hfield.export.coq.export import export_session

    return export_session(answers).text


# The methods and attributes of an algebra, in the order of a lesson: a title, the subject, and the
# names.
LESSON = (
    ("elements", "A(1, 2, 0, 1), A('1 + 2i')", "basis one zero ring constants random_element elements"),
    ("product", "how the basis multiplies", "table_text multiplication_table explain_product draw"),
    ("listing", "collections: len, in, for, .array()", """
        count units zero_divisors idempotents nilpotents elements_of_norm elements_of_trace"""),
    ("groups", ".order, .structure, .generators", """
        unit_group special_unit_group conjugacy_classes automorphism_group"""),
    ("inside", "ideals, subalgebras, graphs", """
        center radical quotient left_ideals right_ideals two_sided_ideals subalgebras graph"""),
    ("kind", "what sort of algebra it is", """
        is_commutative is_central_simple is_simple is_semisimple is_local is_division_algebra"""),
    ("matrices", "A as 2 x 2 matrices", "split to_matrix from_matrix zero_norm_element matrix"),
    ("fields", "where it ramifies, what embeds", """
        ramified_places discriminant is_isomorphic isomorphism embed change_ring"""),
    ("equations", "solved exactly", "solve solve_linear sylvester polynomials"),
    ("orders", "over the integers", "maximal_order lattice order class_number"),
)  # fmt: skip
HISTORY_LINES = 2000


def completions(value: object, prefix: str) -> list[str]:
    """Return the public names of a value with a prefix; those of an algebra in the order of the lesson.

    >>> from hfield import H
    >>> completions(H("GF(3)"), "")[:4], completions(H("GF(3)"), "unit")
    (['basis', 'one', 'zero', 'ring'], ['units', 'unit_group'])
    """
    from hfield.algebra import QuaternionAlgebra

    names = [name for name in dir(value) if name.startswith(prefix)]
    if not prefix.startswith("_"):
        names = [name for name in names if not name.startswith("_")]
    if not isinstance(value, QuaternionAlgebra):
        return names
    order = {name: n for n, name in enumerate(" ".join(group[2] for group in LESSON).split())}
    return sorted(names, key=lambda name: (order.get(name, len(order)), name))


class Help:
    """Python's ``help``, which shows a one-screen overview for an algebra."""

    def __call__(self, *things: object) -> None:
        """Print help."""
        from hfield.algebra import QuaternionAlgebra

        if things and isinstance(things[0], QuaternionAlgebra):
            print(overview(things[0]))
        else:
            builtins.help(*things)

    def __repr__(self) -> str:
        return "help(A) shows what an algebra A can be asked; help(A.units) tells of one thing"


def overview(A: QuaternionAlgebra) -> str:
    """Return an overview of the methods of an algebra, on one screen."""
    from textwrap import wrap

    lines = [f"A = {A}: what it can be asked; help(A.units) tells of one thing", ""]
    for title, about, names in LESSON:
        text = f"{about}: {' '.join(names.split())}"
        lines += wrap(text, 79, initial_indent=f"{title:<10} ", subsequent_indent=" " * 11)
    return "\n".join(lines)


_STRINGS = re.compile(
    r'''(?s)("""(?:\\.|[^\\])*?(?:"""|\Z)|\'{3}(?:\\.|[^\\])*?(?:\'{3}|\Z)'''
    r"""|"(?:\\.|[^"\\\n])*"?|'(?:\\.|[^'\\\n])*'?|\#[^\n]*)"""
)
_MULTIPLE = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)([ijk])\b|\)([ijk])\b")
_PRODUCT = re.compile(r"(?<![\w)\]])(\s*\([\d\s+\-*/.eijk]+\))\s*(?=\()")
_POWER = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_DIGITS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def python_source(text: str) -> str:
    """Translate a typed line to Python: ``2i`` is a product, ``^`` a power; printed mathematical signs are
    read.

    Strings and comments are not changed.

    >>> python_source("(2i + 3j)^2 − k·'2i^2'")
    "(2*i + 3*j)**2 - k*'2i^2'"
    """
    parts = _STRINGS.split(text)
    parts[::2] = map(_plain_code, parts[::2])
    return "".join(parts)


def _plain_code(text: str) -> str:
    text = text.replace("−", "-").replace("·", "*").replace("^", "**")
    text = _POWER.sub(lambda found: f"**{found[0].translate(_DIGITS)}", text)
    text = _PRODUCT.sub(r"\1*", text)
    return _MULTIPLE.sub(lambda m: f")*{m[3]}" if m[3] else f"{m[1]}*{m[2]}", text)


def with_symbols(A: QuaternionAlgebra, symbols: Sequence[str]) -> QuaternionAlgebra:
    """Return the algebra over rational functions in these variables; the algebra itself if there are none."""
    return A.change_ring(f"{A.ring.name}({','.join(symbols)})") if symbols else A


def namespace(A: QuaternionAlgebra, symbols: Sequence[str] = ()) -> dict[str, object]:
    """Return the names of a session: the public names, ``A``, ``F``, its generators, symbols, ``e i j k``."""
    from fractions import Fraction

    names = {name: getattr(hfield, name) for name in dir(hfield)}
    names |= {"Fraction": Fraction, "export_session": export_session, "help": Help()}
    names |= {name: x for name, x in A.ring.names().items() if name not in names}
    if symbols:
        import sympy

        names |= {name: sympy.Symbol(name) for name in symbols}
    return {**names, "A": A, "F": A.ring, **dict(zip(BASIS, A.basis, strict=True))}


def banner(A: QuaternionAlgebra) -> str:
    """Return the greeting: the algebra, and a few example lines."""
    generators = "".join(f", {name}" for name in A.ring.names())
    return f"""\
hfield {hfield.__version__}: A = {shorten(A, 40)} over F; e, i, j, k{generators}

  (1 + 2i)*(j - k)^-1              compute, exactly
  help(A)                          what an algebra can be asked, on one screen
  q = A(1, 2, 0, 1); norm(q)       also conj(q), inv(q), trace(q), q.matrix()
  print(A.table_text("unicode"))   the multiplication table
  H(GF(7)).zero_divisors()         another field: GF(9), RR, ring("QQ(sqrt(2))")
  prove("p*q == q*p", "GF(4)")     decide a statement of your own
  explain("centre", "GF(4)")       a claim of the thesis; also verify("centre")

F(1)/2 or Fraction(1, 2) is a half; Python's own 1/2 is a float and is refused.
"""


def start(A: QuaternionAlgebra, symbols: Sequence[str] = ()) -> int:
    """Run a session and return its exit status; piped input is run without prompts."""
    names = namespace(A, symbols)
    if not sys.stdin.isatty():
        return _run_piped(names)
    app = _ipython()
    if app is None:  # outside the except clause: errors of the session are shown as they are
        return _run_plain(names, banner(A))
    return _run_ipython(app, names, banner(A))


def _ipython() -> type[TerminalIPythonApp] | None:
    """Return the class of IPython's terminal sessions, or None if IPython is not installed."""
    try:
        from IPython.terminal.ipapp import TerminalIPythonApp
    except ImportError:
        return None
    app: type[TerminalIPythonApp] = TerminalIPythonApp
    return app


class _Console(InteractiveConsole):
    """Python's own console; errors of hfield are printed on one line."""

    failed = False

    def runsource(self, source: str, filename: str = "<input>", symbol: str = "single") -> bool:
        """Run the typed lines, or return True if more are needed."""
        return super().runsource(python_source(source), filename, symbol)

    def showtraceback(self) -> None:
        """Show the error that was just raised."""
        self.failed = True
        error = sys.exc_info()[1]
        if isinstance(error, _SHOWN_IN_A_LINE):
            self.write(f"{_one_line(error)}\n")
        elif isinstance(error, NameError) and (mend := mend_of_name(error)):
            self.write(f"{mend}\n")
        else:
            super().showtraceback()

    def showsyntaxerror(self, *args: Any, **kwargs: Any) -> None:
        """Show a syntax error."""
        self.failed = True
        super().showsyntaxerror(*args, **kwargs)


def mend_of_name(error: NameError) -> str:
    """Return a hint for an undefined name, or nothing.

    >>> mend_of_name(NameError("", name="BrandtModule")), mend_of_name(NameError("", name="ij"))
    ("NameError: there is no 'BrandtModule': write O.class_set()", "NameError: there is no 'ij': write i*j")
    """
    name = error.name or ""
    here = called_here(name)
    if not here and set(name) <= set(BASIS):
        here = "*".join(name)
    return f"NameError: there is no {name!r}: write {here}" if here else ""


def _one_line(error: BaseException) -> str:
    if isinstance(error, KeyboardInterrupt):
        return "interrupted"
    return f"{type(error).__name__}: {' '.join(str(error).split())}"


def _run_piped(names: dict[str, object]) -> int:
    """Run the lines of stdin as if typed; return 1 if one of them failed."""
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
        _Console(names).interact(greeting, "")
        return 0

    class InOrder(Completer):
        def attr_matches(self, text: str) -> list[str]:
            return _attributes(names, text) or super().attr_matches(text)

    def show(substitution: str, matches: Sequence[str], longest: int) -> None:
        """Show completions in the given order; readline would sort them."""
        from textwrap import fill

        found = _attributes(names, readline.get_line_buffer()) or list(matches)
        print("\n" + fill("  ".join(name.rpartition(".")[2] for name in found), 79))
        print(f">>> {readline.get_line_buffer()}", end="", flush=True)

    readline.set_completer(InOrder(names).complete)
    readline.parse_and_bind("tab: complete")
    readline.set_completion_display_matches_hook(show)
    history = history_file()
    with suppress(OSError):  # the session goes on without
        history.parent.mkdir(parents=True, exist_ok=True)
        if history.exists():
            readline.read_history_file(str(history))
    try:
        _Console(names).interact(greeting, "")
    finally:
        readline.set_history_length(HISTORY_LINES)
        with suppress(OSError):
            readline.write_history_file(str(history))
    return 0


def history_file() -> Path:
    """Return the path of the session history: below ``XDG_STATE_HOME``, or ``~/.local/state``."""
    state = os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state"
    return Path(state) / "hfield" / "history"


_ATTRIBUTE = re.compile(r"([A-Za-z_]\w*)\.(\w*)$")


def _attributes(names: Mapping[str, object], line: str) -> list[str]:
    """Return the completions of a line that ends in ``NAME.prefix``, if NAME is a name of the session."""
    found = _ATTRIBUTE.search(line)
    if found is None or found[1] not in names:
        return []
    return [f"{found[1]}.{name}" for name in completions(names[found[1]], found[2])]


def _run_ipython(app: type[TerminalIPythonApp], names: dict[str, object], greeting: str) -> int:
    from traitlets.config import Config

    config = Config()
    config.TerminalInteractiveShell.banner1 = greeting
    config.TerminalInteractiveShell.banner2 = ""
    session = app.instance(config=config, user_ns=names)
    session.initialize([])

    def tell(
        shell: object, kind: object, error: BaseException, trace: object, tb_offset: object = None
    ) -> None:
        if not isinstance(error, NameError):
            print(_one_line(error), file=sys.stderr)
        elif mend := mend_of_name(error):
            print(mend, file=sys.stderr)
        else:
            session.shell.showtraceback()

    shell = session.shell
    shell.input_transformers_cleanup.append(
        lambda lines: python_source("".join(lines)).splitlines(keepends=True)
    )
    _complete_in_order(shell, names)
    shell.set_custom_exc((*_SHOWN_IN_A_LINE, NameError), tell)
    session.start()
    return 0


def _complete_in_order(shell: InteractiveShell, names: Mapping[str, object]) -> None:
    """Make IPython complete the names of an algebra in the order of the documentation."""
    from hfield.algebra import QuaternionAlgebra

    try:
        from IPython.core.completer import SimpleCompletion, context_matcher
    except ImportError:  # an IPython before 8.6 sorts them
        return

    def algebra_matcher(context: CompletionContext) -> dict[str, object]:
        found = _ATTRIBUTE.search(context.text_until_cursor)
        user: Mapping[str, object] = getattr(shell, "user_ns", names)
        if found is None or not isinstance(user.get(found[1]), QuaternionAlgebra):
            return {"completions": [], "suppress": False}
        listed = [SimpleCompletion(text=name) for name in completions(user[found[1]], found[2])]
        return {
            "completions": listed,
            "ordered": True,
            "suppress": True,
            "matched_fragment": found[2],
        }

    shell.Completer.custom_matchers.append(context_matcher()(algebra_matcher))

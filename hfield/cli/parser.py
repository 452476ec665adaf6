"""The argument parser: expressions may begin with a minus sign, and errors are one line."""

from __future__ import annotations

import re
import sys
from argparse import REMAINDER, ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable, Iterable, Sequence
from difflib import get_close_matches
from textwrap import wrap
from typing import TYPE_CHECKING, Any, NoReturn

from hfield.cli.output import encodable, terminal_width
from hfield.errors import HFieldError, shorten

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from hfield.algebra import QuaternionAlgebra

_OPTION = re.compile(r"\[[^][]*(\[[^][]*\][^][]*)*\]")
_SHELL_WORD = re.compile(r"""(?:'[^']*'|"[^"]*"|[^\s'"])+""")
_LONG_OPTION = re.compile(r"--[A-Za-z][\w-]*(=.*)?", re.DOTALL)
_OUTPUT = re.compile(r"-o|--output(=|$)")
_FILE = re.compile(r"[^\s()*=+,]+\.[A-Za-z]\w{1,6}")
_FIELD = re.compile(r"QQ|ZZ|RR|CC|GF|FF?[_(]?\d|RDF|CDF|Qp|Q\(|[ℚℤℝℂ𝔽]|\\mathbb")
_ALGEBRA = re.compile(r"[(\[].*,.*\|.*\)|[Hℍ]\(.*\)", re.DOTALL)
MAX_PROCESSES = 1024
MAX_SECONDS = 86_400.0


class UsageError(HFieldError, ValueError):
    """A command line that cannot be read."""


def suggest(word: str, known: Iterable[str]) -> str:
    """Return ``did you mean X?`` for the known words closest to ``word``, or nothing."""
    close = get_close_matches(word, list(known), n=2, cutoff=0.5)
    return f"did you mean {' or '.join(close)}?" if close else ""


class Parser(ArgumentParser):
    """An ArgumentParser that raises :class:`UsageError` and reads ``-i*j`` as an expression.

    ``ArgumentParser`` treats every word with a leading minus as an option, except negative numbers. Here a
    word is an option only if its name was declared, or if it looks like a long option, so that misspelt
    options are still found.
    """

    def __init__(self, prog: str, description: str, examples: Sequence[str] = ()) -> None:
        super().__init__(prog=prog, description=description, allow_abbrev=False)
        self.examples = examples

    def error(self, message: str) -> NoReturn:
        """Raise the message as an error, instead of printing the usage and exiting."""
        without_mark = message.replace("' -", "'-")  # the space of _mark_expressions
        raise UsageError(f"{without_mark}; `{self.prog} --help` shows the usage")

    def format_usage(self) -> str:
        """Return the usage, without breaking an option across lines."""
        text = " ".join(super().format_usage().split())
        whole = _OPTION.sub(lambda found: found[0].replace(" ", "\0"), text)
        width = terminal_width()
        lines = wrap(whole, width, subsequent_indent=" " * 8, break_on_hyphens=False)
        return "\n".join(lines).replace("\0", " ") + "\n"

    def format_help(self) -> str:
        """Return the help, with examples below."""
        _, _, text = super().format_help().partition("\n\n")
        below = ["", "examples:", *_fitted(self.examples)] if self.examples else []
        return "\n".join([self.format_usage(), text.rstrip("\n"), *below, ""])

    def print_help(self, file: Any = None) -> None:
        """Print the help in the encoding of the terminal."""
        stream = file or sys.stdout
        print(encodable(self.format_help(), stream), end="", file=stream)

    def read(self, words: Sequence[str]) -> Namespace:
        """Parse the words of a command line. Raises :class:`UsageError`."""
        for word in words:
            if word.startswith("'"):
                self.error(
                    f"{shorten(word)} has single quotes, which this shell passes on: use double quotes"
                )
        self._need_output(words)
        args, unknown = self.parse_known_args(self._mark_expressions(words))
        for word in unknown:
            self._refuse(word.strip())
        for name, value in vars(args).items():
            if isinstance(value, str):
                setattr(args, name, value.strip())
            elif isinstance(value, list):
                setattr(args, name, [v.strip() if isinstance(v, str) else v for v in value])
        _take_field(args)
        return args

    def _need_output(self, words: Sequence[str]) -> None:
        """Raise for a file name without ``-o`` if an output is required, with the correct usage."""
        option = self._option_string_actions.get("-o")
        if option is None or not option.required or any(_OUTPUT.match(word) for word in words):
            return
        files = [word for word in words if _FILE.fullmatch(word)]
        if len(files) == 1:
            rest = [word for word in words if word != files[0]]
            self.error(f"-o names the output: write {' '.join((self.prog, *rest))} -o {files[0]}")

    def _mark_expressions(self, words: Sequence[str]) -> list[str]:
        """Put a space before an expression that looks like an option, so that argparse does not read it as
        one.
        """
        marked: list[str] = []
        for n, word in enumerate(words):
            if word == "--" and not self._takes_the_rest(words[:n]):
                return [*marked, *words[n:]]
            expression = word.startswith("-") and word != "-" and not self._is_option(word)
            if word == "-f" and words[n + 1 :] and _is_field(words[n + 1]):
                if "--field" not in self._option_string_actions:
                    self.error("unknown option '-f': this command has no --field")
                word, expression = "--field", False
            marked.append(f" {word}" if expression else word)
        return marked

    def _takes_the_rest(self, words: Sequence[str]) -> bool:
        """Return whether an option among the words takes all words that follow, including ``--``."""
        known = self._option_string_actions
        return any(word in known and known[word].nargs == REMAINDER for word in words)

    def _is_option(self, word: str) -> bool:
        if word.startswith("--"):
            return bool(_LONG_OPTION.fullmatch(word))
        return word[:2] in self._option_string_actions

    def _refuse(self, word: str) -> NoReturn:
        if not _LONG_OPTION.fullmatch(word):
            if _FILE.fullmatch(word) and "-o" in self._option_string_actions:
                self.error(f"-o names the output: write -o {shorten(word)}")
            self.error(f"did not expect {shorten(word)!r} (is it a part to be quoted?)")
        name = word.partition("=")[0]
        if name in self._option_string_actions:
            self.error(f"{name} stands after --, where no options are read: write it before the --")
        hint = suggest(name, (s for s in self._option_string_actions if s.startswith("--")))
        self.error(f"unknown option {shorten(name)!r}" + (f": {hint}" if hint else ""))


def _is_field(word: str) -> bool:
    """Return whether a word is the name of a ring; a letter such as x is not."""
    from hfield.errors import RingError

    if _FIELD.match(word) is None:
        return False
    from hfield.fields.names import ring

    try:
        ring(word)
    except RingError:
        return False
    return True


def _take_field(args: Namespace) -> None:
    """Read a field or an algebra after the inputs as the value of that option: ``roots 'x^2+1' GF7``."""
    inputs = getattr(args, "inputs", None)
    if not isinstance(inputs, list) or not inputs or not hasattr(args, "field"):
        return
    if args.field is not None or getattr(args, "algebra", None) is not None:
        return
    if len(inputs) == 1:
        if _is_field(inputs[0]):
            raise UsageError(
                f"{shorten(inputs[0])} is a ring: expected {args.wanted} before it; hfield info describes it"
            )
        return
    if _is_field(inputs[-1]):
        args.field = inputs.pop()
    elif hasattr(args, "algebra") and _ALGEBRA.fullmatch(inputs[-1]):
        args.algebra = inputs.pop()


def _fitted(examples: Sequence[str]) -> list[str]:
    """Indent shell examples; lines wider than the terminal continue after a backslash."""
    width = terminal_width()
    lines: list[str] = []
    for example in examples:
        if len(example) + 2 <= width:
            lines.append(f"  {example}")
            continue
        command, mark, remark = example.partition("  # ")
        lines += [f"  # {line}" for line in wrap(remark, width - 4)] if mark else []
        summary = ""
        for word in _SHELL_WORD.findall(command):
            if summary and len(summary) + len(word) + 5 > width:
                lines.append(f"  {summary} \\")
                summary = "  "
            summary += " " * bool(summary.strip()) + word
        lines.append(f"  {summary}")
    return lines


def whole(least: int, most: int, what: str = "whole number") -> Callable[[str], int]:
    """Return a reader, for argparse, of whole numbers from ``least`` to ``most``."""

    def read(text: str) -> int:
        word = text.strip().replace("_", "")
        fits = word.isascii() and word.isdecimal() and len(word) <= 18
        if not fits or not least <= int(word) <= most:
            found = shorten(text.strip())
            raise ArgumentTypeError(f"expected a {what} from {least} to {most}, found {found!r}")
        return int(word)

    return read


def positive(most: float, what: str) -> Callable[[str], float]:
    """Return a reader, for argparse, of positive numbers up to ``most``."""

    def read(text: str) -> float:
        try:
            found = float(text)
        except ValueError:
            found = 0.0
        if not 0 < found <= most:
            raise ArgumentTypeError(f"expected a {what}, found {shorten(text)!r}")
        return found

    return read


processes = whole(1, MAX_PROCESSES, "number")
seconds = positive(MAX_SECONDS, "number of seconds above 0")


def add_repeated(parser: ArgumentParser, name: str, metavar: str, help: str) -> None:
    """Add an option that may be given several times."""
    parser.add_argument(name, action="append", default=[], metavar=metavar, help=help)


def add_jobs(parser: ArgumentParser, dask: str = "") -> None:
    """Declare ``--jobs``, and ``--dask`` if a help text for it is given."""
    parser.add_argument("--jobs", type=processes, default=1, metavar="N", help="use N processes")
    if dask:
        parser.add_argument("--dask", metavar="ADDRESS", help=dask)


def add_format(parser: ArgumentParser, *formats: str) -> None:
    """Declare ``--format``; the first format is the default."""
    parser.add_argument(
        "--format",
        choices=formats,
        default=formats[0],
        metavar="|".join(formats),
        help=f"output format (default: {formats[0]})",
    )


def add_output(parser: ArgumentParser) -> None:
    """Declare ``-o FILE``."""
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="write to FILE; after an error FILE is unchanged"
    )


def add_standalone(parser: ArgumentParser) -> None:
    """Declare ``--standalone``, for commands that write LaTeX."""
    parser.add_argument(
        "--standalone", action="store_true", help="with --format latex: write a complete document"
    )


def add_factors(parser: ArgumentParser) -> None:
    """Declare ``--factors``, for commands that factor the constants of an algebra."""
    parser.add_argument(
        "--factors",
        metavar="P,…",
        help="known prime factors of the numbers in the input or of their norms, separated by commas",
    )


def given_factors(args: Namespace) -> AbstractContextManager[None]:
    """Use the primes of ``--factors`` inside the ``with``. Raises :class:`UsageError`, :class:`RingError`."""
    from hfield.core.factorisation import known_primes

    if args.factors is None:
        return known_primes(None, "--factors")
    words = [word.strip() for word in args.factors.split(",")]
    if not all(word.isdecimal() and word.isascii() for word in words):
        raise UsageError(
            f"--factors {shorten(args.factors)!r}: expected primes such as 3,5,1000003"
        )
    return known_primes([int(word) for word in words], "--factors")


def add_algebra(parser: ArgumentParser, first: bool = False) -> None:
    """Declare ``--field`` and ``--algebra``, or either as the ``first`` argument; at most one is allowed."""
    group = parser.add_mutually_exclusive_group()
    if first:
        group.add_argument(
            "where", metavar="F|A", nargs="?", help="a field or an algebra, as for the options"
        )
    group.add_argument(
        "--field", metavar="F", help="work in H(F), such as GF(9) or QQ(sqrt(2)) (default: QQ)"
    )
    group.add_argument(
        "--algebra",
        metavar="A",
        help="another algebra, such as '(-1,-3|QQ)' or '[1,x|GF(4))', or a discriminant such as 6",
    )


def algebra_of(args: Namespace) -> QuaternionAlgebra:
    """Return the algebra that ``--field`` or ``--algebra`` names; H(QQ) by default."""
    from hfield.algebra import H, QuaternionAlgebra

    where = getattr(args, "where", None)
    is_algebra = where is not None and (
        where == "H" or where.startswith(("(", "[", "H(", "ℍ")) or where.isdecimal()
    )
    algebra = where if is_algebra else args.algebra
    if algebra is not None:
        return QuaternionAlgebra.from_text(algebra)
    return H(where or args.field or "QQ")

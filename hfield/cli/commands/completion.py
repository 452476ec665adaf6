"""``hfield completion``: completions for a shell."""

from __future__ import annotations

from argparse import REMAINDER, ArgumentParser, Namespace
from collections.abc import Iterable

from hfield.errors import HFieldError

HELP = (
    "Print a script that completes commands, options, fields, claims and algebras in a "
    "shell. The examples show the line for the start-up file of each shell."
)
EXAMPLES = (
    'eval "$(hfield completion bash)"        # a line for ~/.bashrc',
    'eval "$(hfield completion zsh)"         # for ~/.zshrc, after compinit',
    "hfield completion fish | source         # for ~/.config/fish/config.fish",
)
SCRIPTS = {
    "bash": """\
_hfield() { mapfile -t COMPREPLY < <(hfield completion --words "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null); }
complete -o default -F _hfield hfield""",
    "zsh": """\
_hfield() {
  local -a found
  found=("${(@f)$(hfield completion --words "${(@)words[2,CURRENT]}" 2>/dev/null)}")
  [[ -n $found[1] ]] && compadd -Q -a found || _files
}
compdef _hfield hfield""",
    # file names only if nothing else can be completed, as in the other shells
    "fish": """\
function _hfield
  set -l found (hfield completion --words (commandline -opc)[2..] (commandline -ct) 2>/dev/null)
  set -q found[1]; and string join -- \\n $found; or __fish_complete_path (commandline -ct)
end
complete -c hfield -f -a '(_hfield)'""",
}
# Spellings that need no quotes in any shell, and algebras as typed within quotes.
FIELDS: tuple[str, ...] = ("Q", "R", "C", "Z", "GF2", "GF3", "GF4", "GF7", "GF9", "GF2t", "Qx")
FIELDS += ("QI", "Qsqrt2", "Qsqrt-7", "universal")
ALGEBRAS = ("'(-1,-1|QQ)'", "'(-1,-3|QQ)'", "'(a,b|F)'", "'[1,t|GF(4)(t))'", "'H(GF(9))'")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("shell", nargs="?", choices=tuple(SCRIPTS), help="the shell")
    parser.add_argument(
        "--words",
        nargs=REMAINDER,
        metavar="WORD",
        help="print completions of the last word (used by the scripts)",
    )


def run(args: Namespace) -> int:
    """Print the script, or the candidates, one per line."""
    from hfield.cli.parser import UsageError

    if args.words is not None:
        for candidate in candidates(args.words):
            print(candidate)
    elif args.shell is None:
        raise UsageError(f"expected a shell: {', '.join(SCRIPTS)}")
    else:
        print(SCRIPTS[args.shell])
    return 0


def candidates(words: list[str]) -> list[str]:
    """Return the completions of the last word of a command line (without ``hfield``)."""
    from hfield.cli.catalogue import names

    *before, last = words or [""]
    if not before:
        return _begin(last, [*names(), "help", "--version", "--help"])
    if before[0] == "help":
        return _begin(last, names())
    try:
        return _begin(last, _arguments(before[0], before[-1], last))
    except HFieldError:  # no such command: no completions
        return []


def _arguments(name: str, previous: str, last: str) -> Iterable[str]:
    from hfield.cli.catalogue import command

    _, parser = command(name)
    options = {option: a for a in parser._actions for option in a.option_strings}
    if previous in options and options[previous].nargs != 0:
        return _values(options[previous].metavar, options[previous].choices)
    if last.startswith("-"):
        return [option for option in options if option.startswith("--")]
    places = [action for action in parser._actions if not action.option_strings]
    return [word for a in places for word in _values(a.metavar, a.choices)]


def _values(metavar: object, choices: Iterable[str] | None) -> Iterable[str]:
    """Return the possible values of an argument by its metavar; none for files, which the shell completes."""
    if choices is not None:
        return choices
    if metavar in ("CLAIM", "ID"):
        from hfield.ledger.registry import claims

        return [text for claim in claims() for text in (claim.id, claim.name)]
    return {"F": FIELDS, "A": ALGEBRAS, "ALGEBRA": ALGEBRAS}.get(str(metavar), ())


def _begin(start: str, words: Iterable[str]) -> list[str]:
    return [word for word in words if word.startswith(start)]

"""``hfield doctor``: list what is installed and what is missing."""

from __future__ import annotations

import platform
import sys
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, requires, version
from shutil import which
from typing import TYPE_CHECKING

from hfield import __version__
from hfield.cli.answer_formats import answer_one, of_parts
from hfield.cli.parser import add_format, add_output

if TYPE_CHECKING:
    from hfield.presenting import AnswerSection

HELP = (
    "List the libraries that hfield needs, and the optional ones with what each adds. Exit "
    "status: 0; 1 if a required library is missing; 2 bad usage."
)
DOING = "looking for libraries"
EXAMPLES = ("hfield doctor", "hfield doctor --format json")
# Optional parts: (what to install, what it adds).
OPTIONAL = {
    "ipython": ("pip install 'hfield[repl]'", "a comfortable `hfield repl`"),
    "scipy": ("pip install 'hfield[bench]'", "scipy beside us in `hfield bench`"),
    "quaternionic": ("pip install 'hfield[bench]'", "quaternionic beside us in `hfield bench`"),
    "numpy-quaternion": ("pip install 'hfield[bench]'", "numpy-quaternion beside us, likewise"),
    "pyarrow": ("pip install 'hfield[survey]'", "Parquet files from `hfield survey`"),
    "distributed": ("pip install 'hfield[dask]'", "`--dask`, work on a cluster"),
}
PROGRAMS = {
    "coqc": ("install Coq 8.16 or later", "`hfield check --coq`, a second judge of certificates"),
}


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_format(parser, "plain", "json")
    add_output(parser)


def run(args: Namespace) -> int:
    """Check each dependency, and report."""
    needed = {name: _version(name) for name in _needed()}
    optional = {name: _version(name) for name in OPTIONAL}
    programs = {name: which(name) for name in PROGRAMS}
    found = {"needed": needed, "optional": optional, "programs": programs}
    head = {
        "schema": "hfield-doctor/1",
        "version": __version__,
        "python": platform.python_version(),
    }
    answer = of_parts(lambda: head | found, lambda: _parts(needed, optional | programs))
    return answer_one(args, lambda: replace(answer, status=int(None in needed.values())))


def _needed() -> list[str]:
    """Return the libraries that hfield requires, from its package metadata."""
    try:
        lines = requires("hfield") or []
    except PackageNotFoundError:  # run from a folder, not installed
        return []
    return [line.split(">")[0].strip() for line in lines if "extra ==" not in line]


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _parts(needed: dict[str, str | None], others: dict[str, str | None]) -> list[AnswerSection]:
    from hfield.presenting import Facts, LayoutBlock

    encoding = getattr(sys.stdout, "encoding", None) or "unknown"
    lines = [
        f"hfield {__version__} on Python {platform.python_version()}, {platform.system()}",
        f"the terminal's encoding is {encoding}",
    ]
    optional: list[tuple[str, str]] = []
    for name, (how, adds) in (OPTIONAL | PROGRAMS).items():
        found = others[name]
        missing = ((name, f"missing; it adds {adds}"), ("", how))
        optional += [(name, found)] if found else missing
    return [
        LayoutBlock(lambda _: lines),
        Facts(
            [(name, found or f"MISSING: pip install {name}") for name, found in needed.items()],
            title="Needed",
        ),
        Facts(optional, title="Not needed"),
    ]

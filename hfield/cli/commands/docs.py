"""``hfield docs``: open the installed documentation in the browser."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

import hfield
from hfield.cli.parser import UsageError

HELP = "Open the installed documentation in a browser. No server is contacted."
EXAMPLES = ("hfield docs", "hfield docs --where", "hfield docs rings")
SITE = Path(hfield.__file__).parent / "site"


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "page",
        nargs="?",
        default="index",
        metavar="PAGE",
        help="name of a page, such as rings or tutorial (default: index)",
    )
    parser.add_argument(
        "--where", action="store_true", help="print the path of the page without opening it"
    )


def run(args: Namespace) -> int:
    """Open a page, or print its location."""
    if not SITE.is_dir():
        raise UsageError(
            "the documentation is not installed: in a checkout, `pip install '.[docs]'` and "
            "`python tasks.py docs` build it, and `pip install .` then installs it"
        )
    path = _find(args.page.removesuffix(".html"))
    print(path)
    if not args.where:
        import webbrowser

        webbrowser.open(path.as_uri())
    return 0


def _find(name: str) -> Path:
    """Return the page of a name such as ``rings`` or ``reference/rings``. Raises :class:`UsageError`."""
    path = SITE / f"{name}.html"
    if path.is_file():
        return path
    pages = {p.relative_to(SITE).with_suffix("").as_posix(): p for p in SITE.rglob("*.html")}
    found = [p for page, p in sorted(pages.items()) if page.rpartition("/")[2] == name]
    if found:
        return found[0]
    hidden = ("_", "api/", "genindex", "py-modindex", "search")
    listed = ", ".join(sorted(page for page in pages if not page.startswith(hidden)))
    raise UsageError(f"there is no page {name!r}; there are {listed}")

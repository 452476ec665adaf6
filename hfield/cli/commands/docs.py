"""``hfield docs``: the documentation that is installed, in the browser."""

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
    """Open a page, or say where it is."""
    if not SITE.is_dir():
        raise UsageError(
            "this installation has no pages: in a checkout, `pip install '.[docs]'` and "
            "`python tasks.py docs` make them, and `pip install .` then brings them here"
        )
    path = SITE / f"{args.page.removesuffix('.html')}.html"
    if not path.is_file():
        found = sorted(p.relative_to(SITE).with_suffix("").as_posix() for p in SITE.rglob("*.html"))
        pages = ", ".join(p for p in found if not p.startswith(("_", "genindex", "py-modindex")))
        raise UsageError(f"there is no page {args.page!r}; there are {pages}")
    print(path)
    if not args.where:
        import webbrowser

        webbrowser.open(path.as_uri())
    return 0

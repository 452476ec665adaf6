"""Write into the console blocks of README and docs what their commands print now; elided lines stay so.

``python scripts/refresh_pages.py [--fill] [PAGE.md…]`` changes the pages in place: read the difference before
you commit it. With ``--fill`` commands that show nothing yet get what they print.
"""

import os
import re
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from tests.docs.console import PAGES, agrees, blocks, run


def refreshed(text: str, fill: bool) -> str:
    """Return a page with its console blocks as they are printed, where nothing is elided."""
    parts, done = [], 0
    for block in blocks(text):
        for line in block:
            if not line.words:
                continue
            printed = run(line.words).strip("\n") + "\n"
            if agrees(line.printed, printed) or not (line.printed or fill):
                continue
            if re.search(r"^ *…$", line.printed, re.MULTILINE):
                print(f"by hand, for lines are left out: $ {line.typed}\n{printed}")
                continue
            parts += [text[done : line.start], printed]
            done = line.end
    return "".join(parts) + text[done:]


if __name__ == "__main__":
    os.environ.pop("COLUMNS", None)
    named = [word for word in sys.argv[1:] if not word.startswith("-")]
    pages = [page for page in PAGES if not named or page.name in named]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for page in pages:
            page.write_text(refreshed(page.read_text("utf-8"), "--fill" in sys.argv), "utf-8")

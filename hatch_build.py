"""What a package index shows: the README without links and pictures that only work beside the repository."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

try:
    from hatchling.metadata.plugin.interface import MetadataHookInterface
except ImportError:  # tests read the function below where nothing is being built
    MetadataHookInterface = object

WHERE = "The pages named below come with the package: `hfield docs` opens them, with all pictures."


def for_an_index(text: str) -> str:
    """Return a README whose relative pictures are left out and whose relative links are plain words.

    >>> print(for_an_index("![a top](top.webp)\\n\\n[rings](docs/rings.md), [toml](https://toml.io)"))
    The pages named below come with the package: `hfield docs` opens them, with all pictures.
    <BLANKLINE>
    rings, [toml](https://toml.io)
    """
    text = re.sub(r"!\[[^][]*\]\((?!https?:)[^)]*\)", WHERE, text, count=1)
    text = re.sub(r"!\[[^][]*\]\((?!https?:)[^)]*\)\n*", "", text)
    return re.sub(r"(?<!!)\[([^][]*)\]\((?!https?:)[^)\s]*\)", r"\1", text)


class Readme(MetadataHookInterface):
    """Puts that text into the metadata."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Set ``readme``."""
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": for_an_index(text)}

"""What this package brings to ``hfield report``: the top, playing, in a frame of its own."""

from __future__ import annotations

from html import escape

from anim.top import Top
from hfield.report import Chapter

_WORDS = {
    "en": (
        "The spinning top",
        "The top of section 3.3, moved by quaternions. Drag to orbit; the space bar plays and pauses, ? lists"
        " the keys.",
    ),
    "pl": (
        "Wirujący bąk",
        "Bąk z rozdziału 3.3, poruszany kwaternionami. Przeciągnij, by obejrzeć go z innej strony; spacja"
        " odtwarza i zatrzymuje, ? wymienia klawisze.",
    ),
}


def top(language: str) -> Chapter:
    """Return the chapter in which the thesis's top spins."""
    title, text = _WORDS[language]
    frame = f'<iframe srcdoc="{escape(Top().page())}" title="{title}" loading="lazy"></iframe>'
    return Chapter("3.3", title, f"<figure>{frame}<figcaption>{text}</figcaption></figure>")

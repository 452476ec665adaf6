"""What this package brings to ``hfield report``: the top, playing in a frame; on paper, a still."""

from __future__ import annotations

from base64 import b64encode
from dataclasses import replace
from html import escape
from io import BytesIO

from anim.picture.look import FILM_LOOK
from anim.rendering import Scene, draw, framed
from anim.top import Top
from hfield.report import Chapter

STILL, SIZE = 60, (480, 480)

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
    top = Top()
    frame = f'<iframe srcdoc="{escape(top.page())}" title="{title}" loading="lazy"></iframe>'
    still = f'<img class="printed" src="data:image/png;base64,{_still(top)}" alt="{title}">'
    return Chapter("3.3", title, f"<figure>{frame}{still}<figcaption>{text}</figcaption></figure>")


def _still(top: Top) -> str:
    """Draw one frame, which stands for the top where nothing can move; PNG in base 64."""
    from PIL import Image

    from rotation.figures.backend import import_matplotlib

    import_matplotlib()
    look = framed(replace(FILM_LOOK, size=SIZE), top.motion)
    file = BytesIO()
    Image.fromarray(draw(Scene(top.model, top.motion, look).task(STILL))).save(file, "PNG")
    return b64encode(file.getvalue()).decode()

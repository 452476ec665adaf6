"""The section of ``hfield report`` on the top: an animation in an inline frame, and a still for print."""

from __future__ import annotations

from base64 import b64encode
from dataclasses import replace
from html import escape
from io import BytesIO

from anim.picture.settings import FILM_SETTINGS
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
        "Bąk z rozdziału 3.3, poruszany kwaternionami. Przeciągnij, aby obejrzeć go z innej strony; spacja"
        " odtwarza i zatrzymuje film, znak ? pokazuje listę klawiszy.",
    ),
}

PLAYER = {  # texts of the page, with tags and quotes that tell them from words in the script
    "pl": {
        ' lang="en"': ' lang="pl"',
        "<title>The spinning top<": "<title>Wirujący bąk<",
        '<h1 class="unseen">The spinning top<': '<h1 class="unseen">Wirujący bąk<',
        "A spinning top in three dimensions: drag to orbit, scroll to zoom": (
            "Wirujący bąk w trzech wymiarach: przeciągnij, aby obrócić widok; przewiń, aby przybliżyć"
        ),
        "<dt>space<": "<dt>spacja<",
        ">play or pause<": ">odtwórz lub zatrzymaj<",
        ">one frame back or on; ten with shift<": (
            ">o klatkę wstecz lub naprzód; z klawiszem Shift o dziesięć<"
        ),
        ">faster, slower<": ">szybciej, wolniej<",
        ">first and last frame<": ">pierwsza i ostatnia klatka<",
        ">zoom (or scroll, or pinch)<": ">przybliż lub oddal (także przewijaniem lub dwoma palcami)<",
        ">orbit (or drag)<": ">obróć widok (także przeciąganiem)<",
        ">all tops, or one alone<": ">wszystkie bąki lub jeden<",
        ">the initial view<": ">widok początkowy<",
        ">this list<": ">ta lista<",
        'aria-label="play"': 'aria-label="odtwórz"',
        '? "pause" : "play"': '? "zatrzymaj" : "odtwórz"',
        'aria-label="frame"': 'aria-label="klatka"',
        ">speed <": ">tempo <",
        'aria-label="speed"': 'aria-label="tempo"',
        'title="the initial view (r)" aria-label="reset the view"': 'title="widok początkowy (r)"'
        ' aria-label="przywróć widok"',
        'title="keys (?)" aria-label="show the keys"': 'title="klawisze (?)" aria-label="pokaż klawisze"',
        "This page draws with WebGL, which this browser does not have or has switched off. Another "
        "browser, or hardware acceleration in its settings, will show the top.": (
            "Ta strona rysuje za pomocą WebGL, którego ta przeglądarka nie ma albo który jest wyłączony. "
            "Użyj innej przeglądarki albo włącz w ustawieniach przyspieszenie sprzętowe."
        ),
        "The graphics are unavailable for a moment.": "Grafika jest chwilowo niedostępna.",
        '<section id="curves" aria-label="over time"': '<section id="curves" aria-label="przebieg w czasie"',
        '"label":"quaternions"': '"label":"kwaterniony"',
    },
}


def top(language: str) -> Chapter:
    """Return the chapter in which the thesis's top spins."""
    title, text = _WORDS[language]
    top = Top()
    page = top.page()
    for said, ours in PLAYER.get(language, {}).items():
        page = page.replace(said, ours)
    frame = f'<iframe srcdoc="{escape(page)}" title="{title}" loading="lazy"></iframe>'
    still = f'<img class="printed" src="data:image/png;base64,{_still(top)}" alt="{title}">'
    return Chapter("3.3", title, f"<figure>{frame}{still}<figcaption>{text}</figcaption></figure>")


def _still(top: Top) -> str:
    """Draw one frame for print; PNG in base 64."""
    from PIL import Image

    from hfield.plotting import import_matplotlib

    import_matplotlib()
    settings = framed(replace(FILM_SETTINGS, size=SIZE), top.model, top.motion)
    file = BytesIO()
    Image.fromarray(draw(Scene(top.model, top.motion, settings).task(STILL))).save(file, "PNG")
    return b64encode(file.getvalue()).decode()

"""The section of ``hfield report`` on rotations: the figures of chapter 2 and the benchmark of 3.2."""

from __future__ import annotations

import json
import subprocess
import sys
from base64 import b64encode
from html import escape
from typing import Any, TypedDict

from hfield.report import Chapter
from hfield.report.chapters import ChapterError
from hfield.report.markup import table

MAX_SECONDS = 300.0
WIDE = 7.0  # inches from which a figure takes the full width

LETTERING = {  # of figures 2.4 and 2.5; the others have formulas alone
    "pl": {
        "the original": "oryginał",
        "(a) as printed, O(θ) of example 3\n[cos θ, sin θ; sin θ, cos θ]": "(a) w druku: O(θ) z przykładu 3\n"
        "[cos θ, sin θ; sin θ, cos θ]",
        "(b) as printed for determinant −1\n[cos θ, −sin θ; sin θ, −cos θ]": "(b) w druku: wyznacznik −1\n"
        "[cos θ, −sin θ; sin θ, −cos θ]",
        "(c) as it should be: reflections\n[cos θ, sin θ; sin θ, −cos θ]": "(c) poprawnie: odbicia\n"
        "[cos θ, sin θ; sin θ, −cos θ]",
        "(c) as it should be: always 10": "(c) poprawnie: zawsze 10",
        "as printed,\n(a) and (b):\n10 |cos 2θ|": "w druku,\n(a) i (b):\n10 |cos 2θ|",
        "(d) area of the image of the T, whose own area is 10": "(d) pole obrazu litery T, której"
        " pole jest równe 10",
        "area": "pole",
    },
}
_FIGURES: dict[str, tuple[str, str, dict[str, str]]] = {
    "en": ("The figures of chapter 2", "Figure {number}. {title}", {}),
    "pl": (
        "Rysunki rozdziału 2",
        "Rysunek {number}. {title}",
        {
            "2.1": "Współrzędne biegunowe i kartezjańskie",
            "2.2": "Obrót wektora wokół początku układu",
            "2.3": "Litera T",
            "2.4": "Obrócona litera T",
            "2.5": "Odbita litera T",
        },
    ),
}


class BenchmarkWords(TypedDict):
    """The words of the chapter on the benchmark, in a language."""

    title: str
    head: tuple[str, ...]
    machine: str
    printed: str
    point: str
    said: dict[str, str]


_BENCHMARK: dict[str, BenchmarkWords] = {
    "en": {
        "title": "The benchmark of section 3.2",
        "head": ("way", "ms per frame, best", "× copy", "× hfield"),
        "machine": "{points} points of float64, best frame; measured quickly when this page was made, on"
        " {processor}, {cores} cores. “hfield bench” measures more carefully.",
        "printed": "The thesis printed {printed}.",
        "point": ".",
        "said": {},
    },
    "pl": {
        "title": "Test wydajności z rozdziału 3.2",
        "head": ("sposób", "najlepszy czas klatki, ms", "× kopia", "× hfield"),
        "machine": "{points} punktów typu float64, czas najlepszej klatki; krótki pomiar podczas tworzenia"
        " tej strony, procesor: {processor}, liczba rdzeni: {cores}. „hfield bench” mierzy staranniej.",
        "printed": "W pracy: {printed}.",
        "point": ",",
        "said": {
            "Test 1: one axis": "Test 1: jedna oś",
            "Test 2, quaternion model, as printed": "Test 2, model kwaternionowy, jak w druku",
            "Test 2, quaternion model, independent axes": "Test 2, model kwaternionowy, niezależne osie",
            "Test 2, matrix model": "Test 2, model macierzowy",
            "434.9 s a run by quaternions, 385.2 s by matrices": (
                "434,9 s na przebieg z kwaternionami, 385,2 s z macierzami"
            ),
            "444.5 s a run": "444,5 s na przebieg",
            "1763.7 s a run": "1763,7 s na przebieg",
            "copy (np.copyto)": "kopia (np.copyto)",
            "plain numpy": "sam numpy",
            "thesis, quaternion": "praca, kwaternion",
            "thesis, matrix on lists": "praca, macierz na listach",
            "thesis, matrix by np.matmul": "praca, macierz z np.matmul",
        },
    },
}


def figures(language: str) -> Chapter:
    """Return the chapter of figures 2.1 to 2.5, drawn at this moment, as pictures inside the page."""
    from rotation.figures import FIGURES
    from rotation.figures.saving import picture

    title, caption, names = _FIGURES[language]
    shown = []
    for number, drawing in FIGURES.items():
        data = b64encode(
            picture(drawing.draw, drawing.size, "svg", words=LETTERING.get(language))
        ).decode()
        text = escape(caption.format(number=number, title=names.get(number, drawing.title)))
        wide = ' class="wide"' if drawing.size[0] > WIDE else ""
        shown.append(
            f'<figure{wide}><img src="data:image/svg+xml;base64,{data}" alt="{text}">'
            f"<figcaption>{text}</figcaption></figure>"
        )
    return Chapter("2.1", title, f'<div class="figures">{"".join(shown)}</div>')


def benchmark(language: str) -> Chapter:
    """Return the chapter of the benchmark, measured at this moment in about fifteen seconds.

    It runs in a subprocess, in which no library has started threads yet. Raises
    :class:`~hfield.report.chapters.ChapterError` if that fails.
    """
    command = [sys.executable, "-m", "hfield", "bench", "--quick", "--format", "json"]
    try:
        done = subprocess.run(command, capture_output=True, timeout=MAX_SECONDS, check=False)
        data = json.loads(done.stdout)
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        raise ChapterError(
            f"the benchmark could not be run ({error}); leave its chapter out"
        ) from error
    return Chapter("3.2", _BENCHMARK[language]["title"], benchmark_html(data, language))


def benchmark_html(data: dict[str, Any], language: str) -> str:
    """Write the JSON of ``hfield bench`` as HTML tables, fastest first."""
    words = _BENCHMARK[language]
    said = words["said"]
    facts = {"points": f"{data['settings']['points']:,}".replace(",", "\u202f"), **data["machine"]}
    parts = [f"<p>{escape(words['machine'].format(**facts))}</p>"]
    for test in data["tests"]:
        results = [r for r in data["results"] if r["test"] == test["test"] and r["status"] == "ok"]
        rows = [
            [
                escape(said.get(r["way"], r["way"])),
                *(text.replace(".", words["point"]) for text in _figures(r)),
            ]
            for r in sorted(results, key=lambda r: float(r["best_frame_ms"]))
        ]
        caption = escape(said.get(test["title"], test["title"]))
        parts.append(
            f'<div class="scroll">{table(list(words["head"]), rows, caption, "counts")}</div>'
        )
        if test["printed"]:
            printed = said.get(test["printed"], test["printed"])
            parts.append(f"<p>{escape(words['printed'].format(printed=printed))}</p>")
    return "".join(parts)


def _figures(result: dict[str, Any]) -> list[str]:
    """Return the time of a frame and the ratios of one result as texts."""
    time = result["best_frame_ms"]
    ratios = (_ratio(result[key]) for key in ("ratio_to_copy", "ratio_to_hfield"))
    return [f"{time:.3g}" if time < 1000 else f"{time:.0f}", *ratios]


def _ratio(x: float | None) -> str:
    return "" if x is None else f"{x:.2f}" if x < 100 else f"{x:.0f}"

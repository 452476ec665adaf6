"""The page: complete, asking for nothing outside, its certificates those of the decisions."""

import json
import re
import tomllib
import zlib
from base64 import b64decode
from html.parser import HTMLParser
from importlib import import_module
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path

import pytest

from hfield.checker.check import check
from hfield.checker.glossary import METHODS, UNCERTIFIED
from hfield.cli import main
from hfield.prover.decision import REFUTED
from hfield.report import chapters as chapters_module
from hfield.report.chapters import Chapter, ChapterError, chapters
from hfield.report.markup import anchor
from hfield.report.page import page
from hfield.report.page_texts import ENGLISH, POLISH, term

ROOT = Path(__file__).parents[2]
VOID = {"meta", "link", "input", "br", "img"}


class Outline(HTMLParser):
    """Checks that tags close in order; collects ids, links, labels and buttons."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.sources, self.buttons = [], [], [], [], []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        if tag not in VOID:
            self.open.append(tag)
        self.ids += [found["id"]] if "id" in found else []
        self.links += [found["href"]] if "href" in found else []
        self.sources += [found["src"]] if "src" in found else []
        if tag == "article":
            self.article = found["id"]
        if tag == "button" and found.get("data-c", "all") != "all":
            self.buttons.append((self.article, found["data-f"], int(found["data-c"])))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def unpacked(html):
    pack = re.search(r'id="pack">([^<]*)<', html)[1]
    return zlib.decompress(b64decode(pack)).decode().split("\n")


def test_the_page_is_well_formed_and_every_link_has_its_place(html):
    outline = Outline(html)
    assert len(set(outline.ids)) == len(outline.ids)
    inside = [link[1:] for link in outline.links if link.startswith("#")]
    assert set(inside) <= set(outline.ids)
    assert {anchor(name) for name in ("L1", "L2", "L3", "L4")} <= set(outline.ids)
    assert "chapter-0" in outline.ids
    assert "{{" not in html


def test_it_asks_for_nothing_outside(html):
    outline = Outline(html)
    assert all(text.startswith(("#", "data:")) for text in outline.links + outline.sources)
    assert "default-src 'none'" in html
    assert "http" not in re.sub("http-equiv", "", html)


def test_what_the_ledger_says_is_no_markup(html):
    assert "<script>alert" not in html
    assert "&lt;script&gt;alert" in html


def test_the_certificates_are_those_of_the_buttons(html, certificates, rows):
    lines = unpacked(html)
    assert len(lines) == len(certificates)
    claims = {anchor(row.claim.id): row.claim for row in rows}
    buttons = Outline(html).buttons
    assert len(buttons) == len(lines) == len({number for *_, number in buttons})
    fields = {"ℚ": "QQ", "F2": "GF(2)", "F9": "GF(9)", "ℚ(√−7)": "QQ(sqrt(-7))", "∀": None}
    for article, label, number in buttons:
        data = json.loads(lines[number])
        check(data)
        corrected = label.endswith("corrected")
        claim = claims[article]
        proposition = claim.corrected if corrected else claim.as_printed
        assert data["statement"] == proposition.statement
        assert data["field"] == fields[label.removesuffix("corrected")]


def test_the_matrix_has_a_cell_for_every_decision(html, rows):
    for verdict in {row.as_printed.verdict for row in rows}:
        cells = html.count(f'<td class="{verdict}"')
        assert cells == sum(row.as_printed.verdict == verdict for row in rows)
    assert html.count('<ol class="errata">') == 1
    assert html.count("<li><h3>") == len(
        {r.claim.id for r in rows if r.as_printed.verdict == REFUTED}
    )


def test_polish(rows, certificates):
    html = page(rows, certificates, "pl", (), "sheet")
    Outline(html)
    assert '<html lang="pl">' in html
    assert "obalone nad" in html
    assert ENGLISH.keys() == POLISH.keys()
    same = {key for key in ENGLISH if ENGLISH[key] == POLISH[key]}
    assert same <= {"errata"}
    braces = re.compile(r"\{\w*\}")
    assert all(
        sorted(braces.findall(ENGLISH[k])) == sorted(braces.findall(POLISH[k])) for k in ENGLISH
    )


def test_the_command_writes_page_and_paper(ledger, tmp_path, capsys):
    for name, start in (("a.html", "<!doctype html>"), ("a.tex", r"\documentclass")):
        target = tmp_path / name
        assert main(["report", str(ledger), "-o", str(target), "--lang", "pl"]) == 0
        text = target.read_text("utf-8")
        assert text.startswith(start)
        assert "sheet" in text
    assert text.isascii()
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ([], "-o FILE.html"),
        (["-o", "report.pdf"], "-o FILE.html"),
        (["-o", "x.html", "--chapters", "nonsense"], "nonsense"),
        (["nowhere.toml", "-o", "x.html"], "nowhere.toml"),
        (["-o", "x.html", "--lang", "de"], "de"),
    ],
)
def test_bad_usage(words, hint, capsys):
    assert main(["report", *words]) == 2
    assert hint in capsys.readouterr().err


def test_chapters_come_from_entry_points_in_the_order_of_their_sections(monkeypatch):
    here = "tests.report.test_page"
    points = EntryPoints(
        EntryPoint(name, f"{here}:{name}", chapters_module.GROUP)
        for name in ("late", "early", "broken")
    )
    monkeypatch.setattr(chapters_module, "entry_points", lambda group: points.select(group=group))
    assert [c.title for c in chapters(["late", "early"], "pl")] == ["pl 2", "pl 10"]
    with pytest.raises(ChapterError, match="str"):
        chapters(["broken"], "en")
    with pytest.raises(ChapterError, match="early"):
        chapters(["missing"], "en")


def late(language):
    return Chapter("10", f"{language} 10", "")


def early(language):
    return Chapter("2", f"{language} 2", "")


def broken(language):
    return language


def test_the_chapters_of_this_distribution_exist():
    data = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    for point in data["project"]["entry-points"][chapters_module.GROUP].values():
        module, _, name = point.partition(":")
        assert callable(getattr(import_module(module), name))


def test_the_kinds_and_ways_of_the_whole_ledger_are_said_in_polish():
    """What claims and decisions are called is a closed list; each word of it is translated."""
    from hfield.ledger.registry import claims

    kinds = {claim.kind for claim in claims()}
    assert len(kinds) > 20
    methods = {*METHODS, *UNCERTIFIED}
    assert [word for word in sorted(kinds | methods) if "lang=" in term(word, POLISH)] == []
    assert term("no such word", POLISH) == '<span lang="en">no such word</span>'


def test_the_polish_page_has_polish_kinds(rows, certificates):
    html = page(rows, certificates, "pl", [], "sheet")
    assert "<small>twierdzenie</small>" in html
    assert "<td>tożsamość</td>" in html

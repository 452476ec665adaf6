"""A style or a format is one file: a file put into the folder is found, and looks, writes and helps."""

import argparse
from pathlib import Path

import numpy as np
import pytest

import anim.output.formats
import anim.picture.styles
from anim.catalogue import Catalogue
from anim.commands.arguments import declare
from anim.model import Model
from anim.output import FORMATS, Film, check, open_film
from anim.picture import STYLES, RenderSettings, painter
from anim.picture.style import Style

NEGATIVE = '''"""Colours turned round.

More.
"""

from anim.picture.styles.flat import Flat

class Negative(Flat):
    def body(self, mesh, colours, light, quality):
        turned = [tuple(255 - c for c in colour) for colour in colours]
        return super().body(mesh, turned, light, quality)

STYLE = Negative()
'''
RAW = '''"""Bytes, one frame after the other."""

from contextlib import contextmanager
from anim.output.format import Format

class Raw(Format):
    def check(self, film):
        pass

    @contextmanager
    def open(self, path, film, samples):
        with path.open("wb") as file:
            yield lambda frame: file.write(frame.tobytes())

FORMAT = Raw()
'''


def add(folder: Path, text: str, catalogue: Catalogue, package, monkeypatch) -> None:
    folder.mkdir()
    (folder / f"{folder.name}.py").write_text(text)
    monkeypatch.setattr(package, "__path__", [*package.__path__, str(folder)])
    fresh = Catalogue(package.__name__, "")
    monkeypatch.setattr(catalogue, "names", fresh.names)
    monkeypatch.setattr(catalogue, "summaries", fresh.summaries)


def test_a_style_joins_by_its_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "negative" not in STYLES
    add(tmp_path / "negative", NEGATIVE, STYLES, anim.picture.styles, monkeypatch)
    colours = ("#d02040", "#204080")
    look = RenderSettings((64, 48), "negative", colours=colours, tilt=0)
    other = RenderSettings((64, 48), "flat", colours=("#2fdfbf", "#dfbf7f"), tilt=0)
    np.testing.assert_array_equal(*(painter(Model(), x).draw(np.eye(3)) for x in (look, other)))
    parser = argparse.ArgumentParser(formatter_class=argparse.RawTextHelpFormatter)
    declare(parser)
    assert "negative: Colours turned round;" in parser.format_help()


def test_a_format_joins_by_its_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    add(tmp_path / "raw", RAW, FORMATS, anim.output.formats, monkeypatch)
    film, path = Film((4, 2), 3, 25), tmp_path / "top.raw"
    check(path, film)
    with open_film(path, film) as write:
        for n in range(3):
            write(np.full((2, 4, 3), n, np.uint8))
    assert path.read_bytes() == bytes(n for n in range(3) for _ in range(24))


@pytest.mark.parametrize("catalogue", [STYLES, FORMATS])
def test_what_is_in_a_catalogue(catalogue: Catalogue) -> None:
    assert list(catalogue) == sorted(catalogue)
    assert len(catalogue) == len(catalogue.names) >= 3
    for name in catalogue:
        assert catalogue[name] is catalogue[name]
        assert catalogue.summaries[name].strip()
    with pytest.raises(KeyError):
        catalogue["nothing"]
    assert "nothing" not in catalogue
    assert isinstance(STYLES["flat"], Style)

"""Output: encodings that lack letters, files whole or not at all, the progress line."""

import io
import json
import os
import sys

import pytest

from hfield.cli.output import OutputError, encodable, open_output, writing
from hfield.cli.status import Progress
from tests.cli.running import run


class Stream(io.StringIO):
    def __init__(self, encoding, terminal=False):
        super().__init__()
        self._encoding, self.terminal = encoding, terminal

    @property
    def encoding(self):
        return self._encoding

    def isatty(self):
        return self.terminal


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("i² = −e", "i^2 = -e"),
        ("q·q⁻¹ = q\u0304", "q*q^-1 = q'"),
        ("źródło √2 ∈ ℚ", "zrodlo sqrt2 in QQ"),
        ("N(q) ≠ 0 ⇒ x₁₂ ∀", "N(q) != 0 => x12 all"),
        ("日本", "??"),
    ],
)
def test_an_encoding_without_the_letters(text, plain):
    assert encodable(text, Stream("ascii")) == plain
    assert encodable(text, Stream("utf-8")) == text


def test_no_more_is_changed_than_has_to_be():
    assert encodable("źle", Stream("iso-8859-2")) == "źle"


def test_json_is_ascii_where_it_must_be(monkeypatch):
    stream = Stream("ascii")
    monkeypatch.setattr("sys.stdout", stream)
    with open_output(None) as out:
        out.write_json({"x": "√2"})
    assert "\\u221a2" in stream.getvalue()


def test_json_is_laid_out_by_lines(capsys):
    data = {"schema": "x", "rows": [{"a": [1, 2]}, {"b": None}], "none": [], "q": ["1", "0"]}
    with open_output(None) as out:
        out.write_json(data)
    text = capsys.readouterr().out
    assert json.loads(text) == data
    assert text.splitlines()[2:5] == [' "rows": [', '  {"a": [1, 2]},', '  {"b": null}']


@pytest.mark.parametrize("path", [None, "-"])
def test_no_file_is_the_terminal(capsys, path):
    with open_output(path) as out:
        out.write("text\n\n")
    assert capsys.readouterr().out == "text\n"


def test_a_file_comes_to_its_place_at_the_end(tmp_path):
    target = tmp_path / "file"
    with open_output(str(target)) as out:
        out.write("źle")
        assert not target.exists()
    assert target.read_bytes() == "źle\n".encode()


def test_a_failure_leaves_nothing_behind(tmp_path):
    target = tmp_path / "file"

    def work():
        with open_output(str(target)) as out:
            out.write("half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        work()
    assert list(tmp_path.iterdir()) == []


def test_where_nothing_is_written_nothing_is_replaced(tmp_path):
    target = tmp_path / "file"
    target.write_text("old")
    with open_output(str(target)):
        pass
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


def test_links_and_permissions_are_kept(tmp_path):
    target, link = tmp_path / "file", tmp_path / "link"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    with open_output(str(link)) as out:
        out.write("new")
    assert link.is_symlink()
    assert target.read_text() == "new\n"
    assert target.stat().st_mode & 0o777 == 0o640


def test_devices_are_written_to():
    with open_output(os.devnull) as out:
        out.write("text")


def test_a_read_only_file(tmp_path, monkeypatch):
    target = tmp_path / "file"
    target.write_text("old")
    monkeypatch.setattr("os.access", lambda *_: False)
    with pytest.raises(OutputError, match="read-only"), open_output(str(target)):
        pass


def test_progress_tells_the_time_left_of_what_this_run_did(monkeypatch):
    now = iter([100.0, 100.1, 120.0])
    monkeypatch.setattr("hfield.cli.status.time.monotonic", lambda: next(now))
    monkeypatch.setattr("sys.stderr", Stream("utf-8", True))
    with Progress("pairs", 60) as progress:
        progress(61, 100, "a")
        progress(70, 100, "b")
        said = sys.stderr.getvalue()
    assert "61 of 100 pairs, a" in said  # too early to say
    assert "70 of 100 pairs, 60 s left, b" in said  # ten in 20 s, thirty to go


def test_progress_only_on_a_terminal(monkeypatch):
    for terminal in (False, True):
        stream = Stream("utf-8", terminal)
        monkeypatch.setattr("sys.stderr", stream)
        with Progress("rows") as progress:
            progress(1, 2, "QQ")
        assert ("1 of 2 rows, QQ" in stream.getvalue()) is terminal
        assert stream.getvalue().endswith("\r\x1b[K") is terminal


def test_names_of_files_that_are_no_text_are_reported(tmp_path, capsys):
    path = tmp_path / "\udcff.v"
    status, out, err = run(capsys, "export", "--coq", str(path), "--claim", "C1.1.2-b")
    assert (status, err) == (0, "")
    assert "?.v: " in out
    assert path.exists()


def test_a_reader_that_leaves_the_terminal_is_no_fault_of_a_file():
    with pytest.raises(BrokenPipeError), writing("'certificate.json'"):
        raise BrokenPipeError

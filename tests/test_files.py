"""Files and folders are there whole or not at all, and nothing that appeared meanwhile is lost."""

# ruff: noqa: PT012
import errno
import os
import signal

import pytest

from hfield.core import files
from hfield.core.files import whole_file, whole_folder


def no_links(*_: object, **__: object) -> None:
    raise OSError(errno.EOPNOTSUPP, "Operation not supported")


@pytest.fixture(params=["links", "no links"], autouse=True)
def file_system(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.param == "no links":
        monkeypatch.setattr(files.os, "link", no_links)


@pytest.mark.parametrize("replace", [None, False])
def test_a_file_that_appears_meanwhile_stays(tmp_path, replace) -> None:
    path = tmp_path / "a.txt"
    with pytest.raises(FileExistsError, match="meantime"), whole_file(path, replace) as part:
        part.write_text("ours")
        path.write_text("precious")
    assert path.read_text() == "precious"
    assert os.listdir(tmp_path) == ["a.txt"]


def test_a_free_name_is_taken_and_only_what_may_be_is_replaced(tmp_path) -> None:
    path = tmp_path / "a.txt"
    for replace, text in ((False, "one"), (None, "two"), (True, "three")):
        with whole_file(path, replace) as part:
            part.write_text(text)
        assert path.read_text() == text
    with pytest.raises(FileExistsError), whole_file(path, False) as part:
        part.write_text("four")
    with whole_file(tmp_path / "b.txt", True) as part:
        part.write_text("five")
    assert path.read_text() == "three"
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.txt"]


@pytest.mark.parametrize("replace", [None, False, True])
def test_where_nothing_was_written_nothing_appears(tmp_path, replace) -> None:
    with whole_file(tmp_path / "a.txt", replace):
        pass
    with pytest.raises(KeyError), whole_file(tmp_path / "a.txt", replace) as part:
        part.write_text("half")
        raise KeyError
    assert os.listdir(tmp_path) == []


def test_a_folder_that_is_filled_meanwhile_stays(tmp_path) -> None:
    path = tmp_path / "a"
    path.mkdir()
    with pytest.raises(OSError, match="not empty"), whole_folder(path, False) as part:
        (part / "ours").touch()
        (path / "precious").touch()
    assert os.listdir(path) == ["precious"]
    (path / "precious").unlink()
    for replace in (False, True):
        with whole_folder(path, replace) as part:
            (part / "ours").touch()
        assert os.listdir(path) == ["ours"]
    assert os.listdir(tmp_path) == ["a"]


def test_sigterm_leaves_nothing_half_written(tmp_path) -> None:
    for place in (whole_file(tmp_path / "a", None), whole_folder(tmp_path / "b", False)):
        with pytest.raises(SystemExit) as stop, place as part:
            (part / "inside" if part.is_dir() else part).write_text("half")
            os.kill(os.getpid(), signal.SIGTERM)
        assert stop.value.code == 143
    assert os.listdir(tmp_path) == []
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL


def test_a_handler_of_ones_own_stays(tmp_path) -> None:
    def mine(*_: object) -> None:
        """Do nothing."""

    before = signal.signal(signal.SIGTERM, mine)
    try:
        with whole_file(tmp_path / "a"):
            assert signal.getsignal(signal.SIGTERM) is mine
    finally:
        signal.signal(signal.SIGTERM, before)

"""A command, run: its status and what it wrote."""

from hfield.cli import main


def run(capsys, *words):
    status = main(words)
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return status, out, err


def page(capsys, *words):
    status, out, err = run(capsys, *words)
    assert (status, err) == (0, "")
    return out

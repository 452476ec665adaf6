"""The notebooks of the documentation run from top to bottom, and every cell shows what it says."""

import json
from pathlib import Path

import pytest

from tests.patience import PATIENCE

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parents[1] / "docs" / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
RICH = {"text/latex", "text/html", "text/markdown"}


def cells(path: Path):
    return json.loads(path.read_text(encoding="utf-8"))["cells"]


def test_there_are_notebooks():
    assert len(NOTEBOOKS) >= 4


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_output_is_kept(path):
    code = [cell for cell in cells(path) if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in code)
    assert path.stat().st_size < 20_000


@pytest.mark.filterwarnings("default")  # Jupyter's own are not ours to mend
def test_notebooks_run(tmp_path, monkeypatch):
    """One kernel runs all of them, and forgets the names of one before the next."""
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    monkeypatch.setenv("PYTHONPATH", str(FOLDER.parents[1]))
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    everything = nbformat.v4.new_notebook()
    books = [nbformat.read(path, as_version=4) for path in NOTEBOOKS]
    for book in books:
        nbformat.validate(book)
        everything.cells += [nbformat.v4.new_code_cell("%reset -f"), *book.cells]
    nbclient.NotebookClient(everything, timeout=PATIENCE, kernel_name="python3").execute()
    for path, book in zip(NOTEBOOKS, books, strict=True):
        assert shown(book.cells) & RICH, path.stem


def shown(cells):
    """Return the types of what the cells show; each shows its value, and nothing on stderr."""
    types = set()
    for cell in cells:
        if cell.cell_type == "code":
            (output,) = cell.outputs
            assert output.output_type == "execute_result", cell.source
            assert any(output.data.values()), cell.source
            types |= set(output.data)
    return types

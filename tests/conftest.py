"""What tests of several rooms share."""

import doctest
import sys
import types
from pathlib import Path

import pytest

# Files whose tests take most of the time; `-m "not slow"` leaves them out.
SLOW = {
    *("test_coqc.py", "test_statements.py", "test_forgeries.py", "test_hostile_commands.py"),
    *(
        "test_accepted.py",
        "test_rejected.py",
        "test_whole_ledger.py",
        "test_exhaustive.py",
        "test_thesis.py",
    ),
    *("test_certified.py", "test_existence.py", "test_scopes.py", "test_broken_product.py"),
    *(
        "test_picture_depth.py",
        "test_picture_in_frame.py",
        "test_output.py",
        "test_output_failures.py",
        "test_render_command.py",
    ),
    *("test_ledger_programs.py", "test_guard_pages.py", "test_processes.py", "test_bench.py"),
    *(
        "test_compat_scipy.py",
        "test_kernels_accuracy.py",
        "test_norm_equations.py",
        "test_imports.py",
    ),
    *("warming.py", "test_figures.py", "test_fused.py", "test_defects.py", "test_isometry.py"),
    *("test_dask.py", "test_many_classes.py"),
    *("test_number_field_ramification.py", "test_notebooks.py", "test_site.py"),
}
PAGE = Path(__file__).parents[1] / "docs" / "rings.md"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what is in the files that take long."""
    for item in items:
        if item.path.name in SLOW:
            item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="module")
def dual_numbers():
    """The class of rings that docs/rings.md builds from scratch, a ring of a user's own."""
    page = types.ModuleType("rings_page")  # a module, so that its classes can be pickled
    sys.modules[page.__name__] = page
    for example in doctest.DocTestParser().get_examples(PAGE.read_text(encoding="utf-8")):
        if example.source.startswith(("from ", "@dataclass", "class ")):
            exec(example.source, vars(page))
    yield page.DualNumbers
    del sys.modules[page.__name__]

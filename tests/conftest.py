"""What tests of several rooms share."""

import doctest
import sys
import types
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[1] / "docs" / "rings.md"


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

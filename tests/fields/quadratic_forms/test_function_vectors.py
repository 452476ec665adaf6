"""Division over fields of rational functions against Sage's conics, see tests/vectors/README.md."""

import pytest

from hfield.errors import UndecidedError
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import is_division
from tests.fields.algebra_cases import cases, constants

CASES = cases("function_division")


@pytest.mark.parametrize("name", list(dict.fromkeys(case["ring"] for case in CASES)))
def test_division_over_functions_agrees_with_sage(name: str) -> None:
    here = [case for case in CASES if case["ring"] == name]
    wrong, undecided = [], []
    for case in here:
        try:
            answer = is_division(ring(name), constants(name, case["a"], 0, case["b"]))
        except UndecidedError as error:
            undecided.append((case, str(error)))
        else:
            if answer != case["division"]:
                wrong.append(case)
    assert len(here) >= 40
    assert {case["division"] for case in here} == {True, False}
    assert wrong == []
    assert undecided == []

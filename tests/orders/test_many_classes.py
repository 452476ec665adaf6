"""Four thousand classes: enumerated in bounded memory, and certified."""

import json
import subprocess
import sys

import pytest
from flint import fmpz_mat

from hfield import QuaternionAlgebra
from hfield.orders.classes import Classes
from tests.subcases import first_quick

PROGRAM = """
import json, resource
from hfield import QuaternionAlgebra
A = QuaternionAlgebra.from_ramification("QQ", [48023])
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
before = peak()
C = A.maximal_order().class_set()
after = peak()
print(json.dumps([len(C), A.class_number(), after - before, C.certificate is not None]))
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="counts memory in KiB, as Linux does")
def test_four_thousand_classes():
    words = [sys.executable, "-c", PROGRAM]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    number, formula, growth, certified = json.loads(done.stdout)
    assert number == formula == 4_003
    assert growth < 100 * 1024  # KiB; a class takes about one
    assert certified


@pytest.mark.parametrize(
    ("discriminant", "level", "p"), first_quick([(42, 5, 61), (13, 35, 97), (1009, 1, 101)], 1)
)
def test_matrices_from_one_row_are_those_of_neighbours(
    discriminant: int, level: int, p: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At prime discriminant one row is enough; with old forms it is not, and neighbours answer."""
    C = QuaternionAlgebra(discriminant).eichler_order(level).class_set()
    looked_at = []
    one = Classes.neighbours_of
    monkeypatch.setattr(
        Classes, "neighbours_of", lambda *args: looked_at.append(args) or one(*args)
    )
    matrix = C.brandt_matrix(p)
    assert len([args for args in looked_at if args[2] == p]) == (1 if level == 1 else len(C) + 1)
    assert matrix == [[row[j] for j in range(len(C))] for row in C.neighbours(p)]


@pytest.mark.parametrize(
    ("discriminant", "level", "n"), [(1009, 1, 2), (13, 35, 4), (42, 23, 5), (1009, 1, 1009)]
)
def test_the_polynomial_is_that_of_the_matrix(discriminant: int, level: int, n: int) -> None:
    C = QuaternionAlgebra(discriminant).eichler_order(level).class_set()
    assert C.hecke_polynomial(n) == fmpz_mat(C.brandt_matrix(n)).charpoly().coeffs()

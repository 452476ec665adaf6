"""Ten thousand classes: enumerated in bounded memory, and certified."""

import json
import subprocess
import sys

import pytest

PROGRAM = """
import json, resource
from hfield import QuaternionAlgebra
A = QuaternionAlgebra.from_ramification("QQ", [120011])
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
before = peak()
C = A.maximal_order().class_set()
after = peak()
print(json.dumps([len(C), A.class_number(), after - before, C.certificate is not None]))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="counts memory in KiB, as Linux does")
def test_ten_thousand_classes():
    words = [sys.executable, "-c", PROGRAM]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    number, formula, grown, certified = json.loads(done.stdout)
    assert number == formula == 10_002
    assert grown < 100 * 1024  # KiB; a class takes about one
    assert certified

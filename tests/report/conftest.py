"""A small ledger of one's own, decided, and the page that is made of it."""

import pytest

from hfield.core.executors import InProcess
from hfield.ledger.document import read_ledger
from hfield.ledger.run import decide_rows
from hfield.ledger.selection import rows_to_decide
from hfield.report import Chapter
from hfield.report.page import Certificates, page

LEDGER = """
schema = "hfield-ledger/1"

[[claims]]
id = "L1"
name = "anti-automorphism"
section = "1"
kind = "lemma"
statement = "The conjugate of a product"
printed = "(pq)‾ = q̄p̄, żółć"
holds = "conj(p*q) == conj(q)*conj(p)"
fields = ["QQ", "GF(2)", "GF(9)", "universal"]

[[claims]]
id = "L2"
name = "commutes"
section = "1.1"
kind = "claim"
statement = "<script>alert('no')</script> & the product commutes"
holds = "p*q == q*p"
corrected = "p*q - q*p == comm(p, q)"
note = "100% wrong_ #1 over QQ {not} $always$."
fields = ["QQ", "GF(2)", "GF(9)", "QQ(sqrt(-7))"]

[[claims]]
id = "L3"
name = "inverse"
section = "2"
kind = "theorem"
statement = "What has an inverse"
holds = "norm(q) != 0 => q*inv(q) == e and q/2 == (1/2)*q"
fields = ["QQ"]

[[claims]]
id = "L4"
name = "story"
section = "2"
kind = "history"
statement = "Hamilton carved it into a bridge in 1843 — so they say…"
fields = ["-"]
"""


@pytest.fixture(scope="session")
def ledger(tmp_path_factory):
    path = tmp_path_factory.mktemp("ledger") / "sheet.toml"
    path.write_text(LEDGER, encoding="utf-8")
    return path


@pytest.fixture(scope="session")
def rows(ledger):
    return decide_rows(rows_to_decide(read_ledger(ledger), []), InProcess())


@pytest.fixture(scope="session")
def certificates(rows):
    return Certificates(rows)


@pytest.fixture(scope="session")
def html(rows, certificates):
    extra = Chapter("9", "A chapter more", "<p>Its body.</p>")
    return page(rows, certificates, "en", [extra], "sheet")

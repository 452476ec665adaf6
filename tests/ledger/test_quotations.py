"""Quotations from the thesis, which is Polish, say so."""

import re

from hfield.ledger.registry import claims

POLISH_LETTERS = re.compile("[ąćęłńóśźżĄĆĘŁŃÓŚŹŻ]")


def test_every_polish_quotation_is_marked():
    assert [
        c.id for c in claims() if POLISH_LETTERS.search(c.printed) and c.language != "Polish"
    ] == []


def test_formulas_are_not_marked():
    marked = [claim.printed for claim in claims() if claim.language]
    assert len(marked) > 90
    assert all(re.search("[a-ząćęłńóśźż]{2}", printed) for printed in marked)

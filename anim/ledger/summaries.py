"""The summary of chapter 3, numbered 3.5 here, and chapter 4."""

from anim.ledger.counting import model_has
from hfield.ledger.document import Propositions

COMPUTED = {
    "C3.5-a": Propositions(
        as_printed=model_has(2001, "points"),
        spoilt=model_has(2002, "points"),
        corrected=model_has(2002, "points"),
    ),
}

CONCLUSION = {
    "C4-a": Propositions(
        as_printed=model_has(6000, "polygons"),
        spoilt=model_has(3000, "polygons"),
        corrected=model_has(3000, "polygons"),
    ),
}

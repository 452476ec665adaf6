"""Words of the vocabulary, systematically: each with parts of all sorts, over all fields and over some.

Every shape of evidence is tried, its insides taken from evidence for whichever part, field and verdict. What
is accepted is judged by the meaning of the words, and nothing may be both true and false.
"""

from itertools import product
from typing import Any

import pytest

from hfield.checker.budget import bounded
from hfield.checker.check_result import CheckResult
from hfield.checker.rejection import Rejected
from hfield.checker.vocabulary.logic import establish_any, meaning
from tests import thorough
from tests.adversary.words import split, truth_everywhere, truth_over
from tests.checker.cases import with_rings
from tests.checker.hand_made import setting
from tests.checker.ring_data import data_of
from tests.subcases import subcases

FIELDS = (None, "RR", "GF(2)", "GF(3)")
VERDICTS = ("proved", "refuted", "vacuous")
PARTS = ("1 == 1", "1 == 2", "2 == 0", "1 == 2 => 2 == 2")  # the last one is of nothing
WORDS = (
    *("every{{{p}; {q}}}", "implies{{{p}; {q}}}", "iff{{{p}; {q}}}", "angles{{{p}; {q}}}"),
    *("angles{{{p}}}", "not-everywhere{{{p}}}", "over{{GF(2); {p}}}"),
    *("citing{{limits; {p}}}", "citing{{induction; {p}}}"),
    *("every{{angles{{1 == 1; {p}}}; 1 == 1}}", "not-everywhere{{angles{{1 == 1; {p}}}}}"),
)
IDENTITY: dict[str, Any] = {"kind": "identity"}
JUDGED = (
    ("proved", IDENTITY),
    ("vacuous", {"kind": "unsatisfiable", "proof": IDENTITY}),
    *(("refuted", {"kind": "witness", "ring": data_of(f), "values": {}}) for f in FIELDS[1:]),
)
SETTINGS = {f: setting(f"(-1,-1|{f or 'F'})", f) for f in FIELDS}


def shapes() -> list[dict[str, Any]]:
    """Return evidence of every kind that a word made of others takes."""
    given = [{"verdict": verdict, "evidence": evidence} for verdict, evidence in JUDGED]
    alone = [evidence for _, evidence in JUDGED]
    part = [{"kind": "part", "part": n, "evidence": e} for n, e in product((0, 1), alone)]
    pairs = thorough.part(list(product(given, repeat=2)), 3)
    both = [{"kind": "both", "left": x, "right": y} for x, y in pairs]
    parts = [{"kind": "parts", "parts": list(pair)} for pair in pairs]
    sides = product(("conclusion", "hypothesis"), alone)
    side = [{"kind": kind, "evidence": e} for kind, e in sides]
    deeper = [{"kind": "part", "part": 0, "evidence": e} for e in part]
    inner = [{"verdict": "proved", "evidence": e} for e in parts]
    deeper += [{"kind": "parts", "parts": [x, given[0]]} for x in inner]
    there = product(FIELDS[1:], [*alone, *part, *thorough.part(both, 3)])
    over = [{"kind": "over", "ring": data_of(f), "evidence": e} for f, e in there]
    return [*alone, *part, *both, *parts, *side, *deeper, *over]


def established(text: str, field: str | None, verdict: str, evidence: object) -> CheckResult | None:
    try:
        with bounded():
            return establish_any(text, SETTINGS[field], verdict, with_rings(text, evidence))
    except Rejected:
        return None


def accepted(word: str) -> dict[tuple[str, str | None], dict[str, list[CheckResult]]]:
    """Return what passes, of all parts, fields, verdicts and evidence."""
    out: dict[tuple[str, str | None], dict[str, list[CheckResult]]] = {}
    evidence = shapes()
    pairs = thorough.pairwise(PARTS, PARTS[1:] + PARTS[:1])  # each on either side
    texts = dict.fromkeys(word.format(p=p, q=q) for p, q in pairs)
    for text, field, verdict in product(texts, FIELDS, VERDICTS):
        found = [established(text, field, verdict, e) for e in evidence]
        if any(found):
            out.setdefault((text, field), {})[verdict] = [x for x in found if x]
    return out


@pytest.mark.slow
@pytest.mark.parametrize("word", WORDS)
def test_what_is_accepted_is_true_and_not_false(word: str) -> None:
    found = accepted(word)
    assert len(found) > 3
    for (text, field), verdicts in found.items():
        truth = truth_everywhere(text) if field is None else truth_over(text, field)
        assert all(truth in (None, v != "refuted") for v in verdicts), (text, field)
        if "refuted" in verdicts:
            assert len(verdicts) == 1, (text, field)
            # what is shown of all fields holds in this one; "not-everywhere" is shown of some
            assert set(found.get((text, None), {})) <= {"refuted"} or "not-" in text, (text, field)
        for verdict, finding in ((v, f) for v, findings in verdicts.items() for f in findings):
            assert finding.left_out == left_out(text, field, verdict), (text, field, verdict)


def left_out(text: str, field: str | None, verdict: str) -> tuple[str, ...]:
    """Return what the checker has to say that it did not look at."""
    word, parts = split(text)
    if word == "implies" and verdict == "proved":
        return (f"{parts[0]} (whether it holds)",)
    inside = [left_out(part, field, "proved") for part in parts if part.startswith("angles{")]
    if verdict == "refuted" or word == "not-everywhere":
        return ()
    if word == "angles" and len(parts) == 2 and field != "RR":
        where = "which is said of RR alone" if field else "everywhere but over RR"
        return (f"{parts[1]} ({where})",)
    return inside[0] if inside else ()


@subcases("letter", "pqruvw")
@subcases("base", ["QQ", "GF(2)", "GF(3)"])
def test_a_variable_called_like_a_quaternion_is_none(letter: str, base: str) -> None:
    """What a word says of all quaternions is not shown by what holds of an element of the field."""
    field = f"{base}({letter})"
    here = setting(f"(-1,-1|{field})", field)
    with bounded():
        if base == "GF(2)":  # there N(q) is the square of the sum of the coordinates
            assert establish_any("modulus-exists", here, "proved", IDENTITY).method == "identity"
        else:
            with pytest.raises(Rejected, match="does not hold by expanding"):
                establish_any("modulus-exists", here, "proved", IDENTITY)


@subcases("blank", ["\u00a0", "\u2003", "\u3000", "\x1c", "\x85"])
@subcases(
    "text",
    [
        "every{{{0}1 == 1}}",
        "every{{1 == 1}}{0}",
        "basis{{1;{0}1}}",
        "associative(i,{0}j, k): 0 == 0 => 0 == 0",
    ],
)
def test_what_looks_like_a_blank_is_one(blank: str, text: str) -> None:
    with bounded():
        assert meaning(text.format(" ")) == meaning(text.format(""))
        with pytest.raises(Rejected):
            meaning(text.format(blank))

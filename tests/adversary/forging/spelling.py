"""Forgeries in how a file is written: names, blanks, look-alikes, JSON that two readers read in two ways."""

import json
import random
from collections.abc import Callable, Sequence

from tests.adversary.forging.targets import (
    NO_FIELDS,
    NO_RINGS,
    TRUE_THERE,
    Certificate,
    Target,
    any_data,
)

LOOK_ALIKES = {
    "p": "ｐр", "q": "ｑ𝐪", "s": "ｓѕ", "e": "ｅеℯ", "i": "ｉі𝒊", "j": "ｊј", "0": "０٠𝟎", "1": "１١𝟏",
    "2": "２٢²", "=": "＝", "*": "＊∗", "+": "＋", "(": "（", ")": "）", "-": "−–﹣",
    " ": "\u00a0\u2003\u200b\ufeff",
    "x": "ｘх", "t": "ｔ", "/": "∕⁄", "|": "｜", "F": "Ｆ", "G": "Ｇ", "Z": "ℤＺ", "Q": "ℚ",
}  # fmt: skip
BREAKS = ("\\ud800", "\\u0000", "\\udfff\\ud800", "\x7f", "\u202e", "\u2028")


def _dumped(data: Certificate) -> str:
    return json.dumps(data, ensure_ascii=False)


def look_alike(target: Target, true: Certificate, rng: random.Random) -> str:
    """Letters and digits that some reader takes for plain ones, anywhere in the file."""
    text = _dumped(rng.choice((true, {**true, "statement": target.statement})))
    places = [n for n, c in enumerate(text) if c in LOOK_ALIKES]
    for n in sorted(rng.sample(places, min(rng.randint(1, 3), len(places))), reverse=True):
        text = text[:n] + rng.choice(LOOK_ALIKES[text[n]]) + text[n + 1 :]
    return text


def same_key_twice(target: Target, true: Certificate, rng: random.Random) -> str:
    """The true statement once, the false one as well under the same key."""
    key = rng.choice(("statement", "field", "ring", "verdict", "algebra", "evidence"))
    false = json.dumps(target.certificate(true["evidence"], true["method"])[key])
    text = _dumped(true)
    if rng.random() < 0.5:
        return "{" + f'"{key}": {false}, ' + text[1:]
    escaped = f"\\u{ord(key[0]):04x}{key[1:]}"
    return text[:-1] + f', "{rng.choice((key, escaped))}": {false}' + "}"


def other_target(target: Target, true: Certificate, rng: random.Random) -> str:
    """A true certificate with the false statement, field, algebra or verdict put in."""
    groups = (("statement",), ("field", "ring"), ("ring",), ("algebra",), ("verdict",))
    keys = [key for group in rng.sample(groups, rng.randint(1, 5)) for key in group]
    wanted = target.certificate(None)
    data = {**true, **{key: wanted[key] for key in keys}}
    return _dumped({**data, "statement": target.statement})


def numbers(target: Target, true: Certificate, rng: random.Random) -> str:
    """Numbers of JSON that are no integers, or look like one."""
    text = _dumped({**true, "statement": target.statement})
    odd = (
        "1e3",
        "1.0",
        "NaN",
        "Infinity",
        "-Infinity",
        "true",
        "null",
        "-0",
        "0x1",
        "01",
        "1_0",
        "9" * 5000,
        "1E400",
    )
    places = [
        n
        for n, c in enumerate(text)
        if c.isdigit() and not (text[n - 1].isdigit() or text[n - 1] == '"')
    ]
    if not places:
        return text.replace("[]", rng.choice(odd), 1)
    n = rng.choice(places)
    return text[:n] + rng.choice(odd) + text[n + 1 :]


def broken(target: Target, true: Certificate, rng: random.Random) -> str:
    """Surrogates, nulls, marks, cut ends, something behind the end, nesting."""
    text = _dumped({**true, "statement": target.statement})
    n = rng.randrange(len(text))
    return rng.choice((
        text[:n] + rng.choice(BREAKS) + text[n:],
        text.replace(target.statement[:1], rng.choice(BREAKS) + target.statement[:1], 1),
        text[:n], text + text, text + "]", "\ufeff" + text, "[" + text + "]", f'{{"certificate": {text}}}',
        text.replace('"evidence": ', '"evidence": ' + "[" * 200, 1),
        text.replace('"evidence": ', '"evidence": ' + '{"kind":' * 130, 1),
        '"' + '\\"' * 50 + text,
    ))  # fmt: skip


def no_ring(target: Target, true: Certificate, rng: random.Random) -> str:
    """A true statement over what is no ring at all."""
    name, ring = rng.choice(NO_RINGS)
    if rng.random() < 0.3:
        name, ring = rng.choice(NO_FIELDS), any_data(rng.choice(("QQ", "GF(3)", "ZZ/6", "QQ(x)")))
    statement, kind = rng.choice(TRUE_THERE), rng.choice(("identity", "exhaustion"))
    evidence = {"kind": kind} | ({"cases": 1} if kind == "exhaustion" else {})
    data = Target(statement, name, algebra=f"(-1,-1|{name})").certificate(evidence, kind, ring=ring)
    return _dumped(data)


def no_algebra(target: Target, true: Certificate, rng: random.Random) -> str:
    """A statement in an algebra that does not exist, or cannot be read."""
    constants = rng.choice(
        (
            *(
                "1/0,-1",
                "-1,1/0",
                "0/0,1",
                "1/(1-1),1",
                "1/2-",
                "q,1",
                "norm(q),1",
                "i,1",
                "1,2,3",
                "1",
                "",
                ",",
            ),
            *(
                "1/(2-2),1",
                "0**-1,1",
                "(1/0)*0,1",
                "1,,1",
                "s t,1",
                "-1;-1",
                "1/0**0,1/0",
                "inv(0),1",
                "sqrt(2),1",
            ),
            *(
                "1.0e5000,1",
                "exists s: s,1",
                "s == s,1",
                "T1,1",
                "F,1",
                "aa,1",
                "1/(s-s),1",
                "1/(a-a),b",
            ),
        )
    )
    field = rng.choice(("QQ", "GF(3)", None, "ZZ/6", "QQ(x)"))
    statement = rng.choice(("1 == 2", "s == s", "i*i == j", "q == 0"))
    opening = rng.choice("([")
    made = Target(statement, field, algebra=f"{opening}{constants}|{field or 'F'})")
    verdict = rng.choice(("proved", "proved", "vacuous", "refuted"))
    kind = rng.choice(("identity", "exhaustion", "witness", "implication"))
    more = {"exhaustion": {"cases": 1}, "witness": {"ring": any_data(field or "QQ"), "values": {}},
            "implication": {"facts": [], "items": []}}.get(kind, {})  # fmt: skip
    return _dumped(made.certificate({"kind": kind, **more}, "identity", verdict=verdict))


SPELLINGS: Sequence[Callable[[Target, Certificate, random.Random], str]] = (
    *(look_alike, same_key_twice, other_target, other_target, numbers, broken, no_ring, no_algebra),
)

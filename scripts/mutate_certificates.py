"""Mutate certificates, and see that no mutant passes that is not a valid proof of the same thing.

    python scripts/mutate_certificates.py [--count 10000] [--seed 0] [--claims 40]

Certificates come from the ledger and from the prover. Each mutant changes a number, a sign, a word, a
field, an entry of a list, the verdict or the target of one of them, and is checked with the
statement and the field of the original pinned. What passes is judged by other means (judge_certificates.py).
"""

import argparse
import copy
import json
import random
import re
import sys
import time
from collections import Counter
from collections.abc import Iterator
from typing import Any

from judge_certificates import judge

from hfield.certificates.check import Pin, check_text
from hfield.certificates.rejection import Rejected
from hfield.errors import HFieldError
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import decide
from hfield.ledger.registry import claims
from hfield.proving.prove import prove

FIELDS = (None, "QQ", "GF(2)", "GF(3)", "GF(4)", "GF(9)", "QQ(sqrt(-7))", "QQ(x)", "GF(2)(t)", "RR")
STATEMENTS = (
    "(p*q)*r == p*(q*r)",
    "p*q == q*p",
    "norm(q) != 0 => q*inv(q) == e",
    "p*q == 0 => p == 0 or q == 0",
    "norm(p) == 0 => norm(p*q) == 0",
    "p*q == e => q*p == e",
    "q**4 == q**2",
    "s**2 == norm(p) => (s*s)**2 == norm(p*p)",
    "exists q: q != 0 and norm(q) == 0",
    "norm(p) != 0 => (exists q: p*q == e)",
    "q**2 == q => q == 0 or q == e",
    "q**2 == -e => trace(q) == 0",
    "2 == 0 => p*q == q*p",
    "exists q: p*q == e",
    "norm(q) == 1 and norm(q) == 2 => p == q",
)
Certificate = dict[str, Any]


def originals(number_of_claims: int, rng: random.Random) -> list[Certificate]:
    """Return certificates of the prover and of some rows of the ledger."""
    out = []
    for statement in STATEMENTS:
        for field in FIELDS:
            data = prove(statement, field, timeout=10.0).certificate
            if data is not None:
                out.append(data)
    checkable = [claim for claim in claims() if claim.checkable and claim.id.startswith("C1")]
    for claim in rng.sample(checkable, min(number_of_claims, len(checkable))):
        for field in claim.fields:
            row = decide(claim, field)
            for p, d in ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected)):
                data = certificate(p, d, field)
                if data is not None:
                    out.append(data)
    return out


def places(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Run through the paths to everything in some JSON data."""
    if path:
        yield path
    entries = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in entries:
        if isinstance(value, dict | list):
            yield from places(value, (*path, key))
        else:
            yield (*path, key)


def mutate(data: Certificate, others: list[Certificate], rng: random.Random) -> Certificate:
    """Return a copy with one to three changes."""
    out = copy.deepcopy(data)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        if rng.random() < 0.1:  # swap a key with another certificate's
            key = rng.choice(list(data))
            out[key] = copy.deepcopy(rng.choice(others)[key])
            continue
        if not isinstance(out.get("evidence"), dict):
            return out
        weighted = [p for p in places(out) if p[0] == "evidence" or rng.random() < 0.3]
        if weighted:
            _change(out, rng.choice(weighted), rng)
    return out


def _change(data: Any, path: tuple[Any, ...], rng: random.Random) -> None:
    parent = data
    for key in path[:-1]:
        parent = parent[key]
    key, value = path[-1], parent[path[-1]]
    kind = rng.random()
    if kind < 0.12:
        if isinstance(parent, list):
            parent.pop(key)
        else:
            del parent[key]
    elif kind < 0.18 and isinstance(parent, list):
        parent.insert(key, copy.deepcopy(rng.choice(parent)))
    elif kind < 0.24 and isinstance(parent, list):
        other = rng.randrange(len(parent))
        parent[key], parent[other] = parent[other], parent[key]
    elif isinstance(value, bool) or value is None:
        parent[key] = rng.choice((True, False, None, 0, "QQ"))
    elif isinstance(value, int):
        parent[key] = rng.choice((value + 1, value - 1, -value, 0, 2 * value, str(value)))
    elif isinstance(value, str):
        parent[key] = _text(value, rng)
    elif isinstance(value, list):
        parent[key] = value[: rng.randrange(len(value) + 1)]
    else:
        parent[f"{key}x" if isinstance(parent, dict) else key] = {}


def _text(text: str, rng: random.Random) -> str:
    choice = rng.randrange(7)
    if choice == 0:
        return text[: rng.randrange(len(text) + 1)]
    if choice == 1:
        return rng.choice(
            ("QQ", "GF(2)", "GF(3)", "GF(9)", "", "0", "1", "-1", "p", "proved", "refuted")
        )
    numbers = list(re.finditer(r"\d+", text))
    if choice in (2, 3) and numbers:
        m = rng.choice(numbers)
        return text[: m.start()] + str(int(m[0][:20]) + rng.choice((-1, 1, 2))) + text[m.end() :]
    signs = list(re.finditer(r"[-+]", text))
    if choice == 4 and signs:
        m = rng.choice(signs)
        return text[: m.start()] + ("+" if m[0] == "-" else "-") + text[m.end() :]
    if not text:
        return "0"
    at = rng.randrange(len(text))
    return text[:at] + rng.choice("pqrsijke0123()[]*+-=!,; ") + text[at + rng.randrange(2) :]


def survey(count: int, seed: int, number_of_claims: int) -> tuple[Counter[str], list[Any], float]:
    """Check ``count`` mutants; return what became of them, those without reason, the slowest time."""
    rng = random.Random(seed)
    files = originals(number_of_claims, rng)
    outcomes: Counter[str] = Counter(originals=len(files))
    bad: list[Any] = []
    slowest = 0.0
    for _ in range(count):
        original = rng.choice(files)
        mutant = mutate(original, files, rng)
        text = json.dumps(mutant)
        if rng.random() < 0.03:
            text = text[: rng.randrange(len(text))]
        if mutant == original:
            outcomes["unchanged"] += 1
            continue
        start = time.monotonic()
        try:
            pin = Pin((original["statement"],), original["field"], original["algebra"])
            check_text(text, pin)
        except Rejected:
            outcomes["rejected"] += 1
            slowest = max(slowest, time.monotonic() - start)
            continue
        slowest = max(slowest, time.monotonic() - start)
        try:
            reason = judge(mutant, original)
        except (HFieldError, KeyError, ValueError, IndexError, TypeError):
            reason = ""
        outcomes[f"accepted: {reason}"] += 1
        if reason != "same evidence":
            bad.append((reason, original, mutant))
    return outcomes, bad, slowest


def main() -> int:
    """Run and report; exit status 1 when a mutant passed without a reason."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--claims", type=int, default=40)
    parser.add_argument("--show", type=int, default=0, help="show so many that passed")
    args = parser.parse_args()
    outcomes, passed, slowest = survey(args.count, args.seed, args.claims)
    for outcome, number in outcomes.most_common():
        print(f"{number:8} {outcome}")
    print(f"{slowest:8.2f} seconds for the slowest")
    for reason, original, mutant in passed[: args.show]:
        print(f"--- {reason}: {original['statement']} over {original['field']}")
        for path in places(original):
            x, y = original, mutant
            try:
                for key in path:
                    x, y = x[key], y[key]
            except (KeyError, IndexError, TypeError):
                y = "missing"
            if x != y and not isinstance(x, dict | list):
                print("   ", path, "\n       ", str(x)[:150], "\n       ", str(y)[:150])
    return int(any(not reason for reason, _, _ in passed))


if __name__ == "__main__":
    sys.exit(main())

"""Genuine certificates, and copies of them with one to three changes."""

import copy
import random
import re
from collections.abc import Iterator, Sequence
from typing import Any

from hfield.prover.prove import prove
from tests.adversary.forging.targets import Certificate

FIELDS = (
    None,
    "QQ",
    "GF(2)",
    "GF(3)",
    "GF(4)",
    "GF(9)",
    "QQ(sqrt(-7))",
    "QQ(x)",
    "GF(2)(t)",
    "RR",
    "ZZ",
    "ZZ/6",
)
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
    "s*y == 0 => s == 0 or y == 0",
    "2*s == 0 => s == 0",
    "s**2 != 2",
    "s != 0 => (exists y: s*y == 3)",
    "norm(q) == 0 => q == 0",
)
QUICK = STATEMENTS[1:3] + STATEMENTS[4:6] + STATEMENTS[8:10] + STATEMENTS[15:20]


def genuine(statements: Sequence[str], fields: Sequence[str | None]) -> list[Certificate]:
    """Return certificates of the prover; what it does not decide soon is left out."""
    out = []
    for statement in statements:
        for field in fields:
            found = prove(statement, field, timeout=5.0).certificate
            if found is not None:
                out.append(found)
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


def mutated(data: Certificate, others: Sequence[Certificate], rng: random.Random) -> Certificate:
    """Return a copy with one to three changes."""
    out = copy.deepcopy(data)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        if rng.random() < 0.1:  # swap a key with another certificate's
            key, other = rng.choice(list(data)), rng.choice(others)
            for own in ("field", "ring") if key == "field" else (key,):
                out[own] = copy.deepcopy(other[own])
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
        parent[key] = rng.choice(
            (value + 1, value - 1, -value, 0, 2 * value, str(value), bool(value))
        )
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

"""Forged evidence of the other kinds: witnesses, terms, counts, lists, and what was proved of others."""

import copy
import random
from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

from tests.adversary.forging.cofactors import implication
from tests.adversary.forging.targets import Certificate, Target, any_data

Pool = Sequence[Certificate]
ODD_NUMBERS = (
    *(
        "0",
        "1",
        "-1",
        "2",
        "1/2",
        "1/0",
        "0/0",
        "+1",
        " 1",
        "1 ",
        "1_000",
        "٣",
        "１",
        "1e3",
        "1.0",
        ".5",
    ),
    *(
        "0x10",
        "x",
        "t",
        "I",
        "sqrt(2)",
        "sqrt(-1)",
        "sqrt(4)",
        "root(2,3)",
        "pi",
        "inf",
        "nan",
        "1-1",
    ),
    *(
        "2**10000",
        "2**99999",
        "(1)",
        "--1",
        "e",
        "i",
        "s",
        "q[0]",
        "",
        "1;2",
        "1,2",
        "9" * 4001,
        "x**9999",
    ),
    *(
        "1 0",
        "1\t2",
        "1\u00a02",
        "1\u20092",
        "²",
        "1²",
        "x^2",
        "-0",
        "1/-1",
        "sqrt(2)**2",
        "\u22121",
    ),
)
UNITS = "eijk"


def unknowns(statement: str) -> tuple[str, ...]:
    """Return the names of a statement that can be unknowns, roughly."""
    text = "".join(c if c.isalnum() else " " for c in statement)
    return tuple(sorted({w for w in text.split() if len(w) == 1 and w in "pqruvwstxyzab"}))


def bound(target: Target) -> list[str]:
    """Return the names that ``exists`` binds."""
    return target.statement.partition("exists")[2].partition(":")[0].replace(",", " ").split()


def _values(target: Target, rng: random.Random, odd: bool) -> dict[str, list[str]]:
    found = {}
    for name in unknowns(f"{target.statement} {(target.algebra or '').partition('|')[0]}"):
        size = 4 if name in "pqruvw" else 1
        numbers = ODD_NUMBERS if odd and rng.random() < 0.7 else ODD_NUMBERS[:5]
        found[name] = [rng.choice(numbers) for _ in range(size if rng.random() < 0.95 else 3)]
    if rng.random() < 0.05:
        found["z"] = ["0"]
    return found


def witness(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Values that do not show it, in the field named or in another."""
    field = target.field
    if field is None or rng.random() < 0.2:
        field = rng.choice(
            ("QQ", "GF(2)", "GF(3)", "GF(4)", "ZZ/6", "ZZ/4", "QQ(x)", "RDF", "CC", "GF(6)")
        )
    return {"kind": "witness", "ring": any_data(field), "values": _values(target, rng, True)}


def terms(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Terms that are undefined, bound themselves, of the wrong sort, or proved by something else."""
    names = bound(target)
    texts = (
        "1/0",
        "inv(0*e)",
        "1/s",
        "s**-1",
        "y",
        "z + 1",
        "q",
        "inv(p)",
        "conj(p)/norm(p)",
        "0",
        "1",
        "-s",
    )
    texts += ("s - s", "x", "a", "1/a", "0.5", "p", "sqrt(-1)", "u", "e")
    chosen = {name: rng.choice(texts) for name in names or ["y"]}
    proof = any_evidence(target, rng, pool) if rng.random() < 0.5 else {"kind": "identity"}
    return {"kind": "terms", "terms": chosen, "proof": proof}


def exhaustion(target: Target, rng: random.Random, pool: Pool) -> Any:
    """A count of cases, faithful or not."""
    return {
        "kind": "exhaustion",
        "cases": rng.choice((1, 0, -1, 2, 3, 4, 5, 6, 9, 16, 81, 256, True, 1.0, "1", 10**6)),
    }


def none_exists(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Nothing exists, in a field where the names mean something else, or at places outside."""
    proof = any_evidence(target, rng, pool) if rng.random() < 0.4 else {"kind": "identity"}
    inner: dict[str, Any] = {"kind": "none exists", "proof": proof}
    fields = (
        "QQ(x)",
        "GF(2)(t)",
        "QQ(t)",
        "QQ(s)",
        "QQ(y)",
        "GF(4)",
        "GF(9)",
        "QQ",
        "GF(2)",
        "GF(3)",
        "ZZ/6",
        "QQ(q)",
    )
    if rng.random() < 0.6:
        values = _values(target, rng, False)
        for name in bound(target):
            values.pop(name, None)
        inner = {"kind": "place", "values": values, "proof": inner}
    if target.field is None or rng.random() < 0.1:
        inner["ring"] = any_data(rng.choice(fields))
    return inner


def unsatisfiable(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Hypotheses are never true: by a proof of something else."""
    return {"kind": "unsatisfiable", "proof": any_evidence(target, rng, pool)}


def identity(target: Target, rng: random.Random, pool: Pool) -> Any:
    """It expands to 0, says the file."""
    return {"kind": "identity"}


def multilinear(target: Target, rng: random.Random, pool: Pool) -> Any:
    """A list of tuples: incomplete, of other values, of other unknowns."""
    names = list(unknowns(target.statement))
    rng.shuffle(names)
    words = ["".join(w) for w in product(UNITS, repeat=min(len(names), 3))]
    value = lambda: [rng.choice((0, 0, 1, -1, 2, 3)) for _ in range(4)]  # noqa: E731
    tuples = [[w, value()] for w in words]
    if rng.random() < 0.5:
        tuples = [[w, [0, 0, 0, 0]] for w in words]
    return {
        "kind": "multilinear",
        "unknowns": names,
        "tuples": tuples[: rng.choice((len(tuples), 1, 15, 16))],
    }


def reused(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Evidence of another statement that is as it says."""
    return copy.deepcopy(rng.choice(pool)["evidence"])


def reused_part(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Items of several proofs, put together."""
    proofs = [c["evidence"] for c in pool if c["evidence"].get("kind") == "implication"]
    chosen = rng.sample(proofs, min(3, len(proofs)))
    items = [i for c in chosen for i in c["items"]]
    facts = {f["form"]: f for c in chosen for f in c["facts"]}
    return {
        "kind": "implication",
        "facts": list(facts.values()) if rng.random() < 0.7 else [],
        "items": rng.sample(items, min(len(items), rng.randint(1, 6))),
    }


def wrapped(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Evidence inside of evidence of a kind that belongs to words of the vocabulary."""
    inner = any_evidence(target, rng, pool)
    part = {"verdict": rng.choice(("proved", "vacuous", "refuted")), "evidence": inner}
    return rng.choice(
        (
            {"kind": "parts", "parts": [part]},
            {"kind": "both", "left": part, "right": part},
            {"kind": "conclusion", "evidence": inner},
            {"kind": "hypothesis", "evidence": inner},
            {"kind": "over", "ring": any_data("QQ(x)"), "evidence": inner},
            {"kind": "over", "ring": any_data("GF(2)"), "evidence": inner},
            {"kind": "part", "part": 0, "evidence": inner},
            {"kind": "lemmas", "proofs": [inner]},
            {"kind": "cases", "cases": [], "cover": inner},
            {
                "kind": "cases",
                "cases": [{"when": "1 == 1", "terms": {"y": "0", "s": "0"}, "proof": inner}],
                "cover": {"kind": "identity"},
            },
            {
                "kind": "cases",
                "cases": [{"when": "s == 0", "terms": {"y": "1/s"}, "proof": {"kind": "identity"}}],
                "cover": inner,
            },
            {"kind": "unsatisfiable", "proof": {"kind": "unsatisfiable", "proof": inner}},
            {"kind": "anisotropic", "by": "ordering"},
            {"kind": "zero norm", "value": ["0", "0", "0", "0"]},
            {"kind": "trust"},
            {},
            [],
            None,
            "identity",
            1,
            {"kind": ["identity"]},
            {"kind": "identity", "note": ""},
        )
    )


def lie(target: Target, rng: random.Random, pool: Pool) -> Any:
    """An implication with a lie in it."""
    return implication(target, rng)[1]


KINDS: tuple[Callable[[Target, random.Random, Pool], Any], ...] = (
    *(
        lie,
        lie,
        lie,
        lie,
        lie,
        lie,
        lie,
        lie,
        witness,
        witness,
        terms,
        exhaustion,
        none_exists,
        none_exists,
    ),
    *(identity, multilinear, reused, reused, reused_part, reused_part, unsatisfiable, wrapped),
)
FITTING: dict[tuple[str, bool], tuple[Callable[[Target, random.Random, Pool], Any], ...]] = {
    ("proved", False): (
        *(lie, lie, lie, lie, lie, lie, exhaustion, identity, multilinear),
        *(reused, reused_part, wrapped),
    ),
    ("proved", True): (terms, terms, witness, exhaustion, wrapped, reused),
    ("refuted", False): (witness, witness, witness, wrapped, reused),
    ("refuted", True): (none_exists, none_exists, none_exists, wrapped, reused),
    ("vacuous", False): (unsatisfiable, unsatisfiable, unsatisfiable, wrapped, reused),
}


def any_evidence(target: Target, rng: random.Random, pool: Pool) -> Any:
    """Return evidence of some kind."""
    return rng.choice((lie, lie, identity, reused, reused_part, exhaustion))(target, rng, pool)


def forged(target: Target, rng: random.Random, pool: Pool) -> tuple[str, Certificate]:
    """Return the name of the forgery, and the certificate."""
    choices = KINDS
    if rng.random() < 0.8:
        choices = FITTING.get((target.verdict, "exists" in target.statement), KINDS)
    kind = rng.choice(choices)
    if kind is lie:
        name, evidence = implication(target, rng)
    else:
        name, evidence = kind.__name__, kind(target, rng, pool)
    method = rng.choice(("implication", "identity", "exhaustion", "witness", "counterexample"))
    return name, target.certificate(evidence, method)

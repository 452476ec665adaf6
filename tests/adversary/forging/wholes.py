"""Forgeries of statements about the field as a whole, and of logic between closed statements."""

import random
from typing import Any

from tests.adversary.forging.cofactors import HALF, UNIT_I, UNIT_J, ZERO
from tests.adversary.forging.targets import Certificate, Target, any_data
from tests.checker.ring_data import INFINITY, number, prime, split

FIELDS = (
    *(
        "QQ",
        "RR",
        "CC",
        "GF(2)",
        "GF(3)",
        "GF(4)",
        "GF(5)",
        "GF(7)",
        "GF(9)",
        "QQ(sqrt(2))",
        "QQ(I)",
        "QQ(x)",
    ),
    *(
        "QQ(sqrt(-7))",
        "QQ(sqrt(-2))",
        "QQ(sqrt(-3))",
        "GF(2)(t)",
        "GF(3)(t)",
        "GF(5)(t)",
        "ZZ",
        "ZZ/6",
        "RDF",
    ),
)
ATOMS = (
    *(
        "division",
        "level-above{0}",
        "level-above{1}",
        "level-above{2}",
        "level-above{3}",
        "level-above{4}",
    ),
    *(
        "formally-real",
        "norm-criterion{>}",
        "norm-criterion{<}",
        "modulus-exists",
        "modulus-law{*}",
    ),
    *(
        "modulus-law{+}",
        "centre{2}",
        "centre{3}",
        "centre{5}",
        "basis{2; 1,0; 0,2}",
        "basis{2; 1,1; 1,1}",
    ),
    *("basis{1; 3}", "basis{2; 1,0}", "basis{3; 1,0,0; 0,1,0; 1,1,0}", "basis{2; 1,2; 3,4}"),
    *("determined-by{all; 1,2}", "determined-by{constant; 2}", "determined-by{short; 1,2}"),
    *(
        "determined-by{all-but-one; 2}",
        "determined-by{constant; 1}",
        "curried-linear{1}",
        "curried-linear{2}",
    ),
    *("last-argument{3; 1}", "last-argument{4; 1,2}", "last-argument{5; 1,2}"),
    *(
        "p*q == q*p",
        "s == 0",
        "q*conj(q) == norm(q)",
        "1 == 2",
        "1 == 1",
        "s == 1 => s == 0",
        "1 == 2 => s == 0",
    ),
    *(
        "exists s: s**2 == -1",
        "exists q: q != 0 and norm(q) == 0",
        "2 == 0",
        "s**2 == s",
        "s != s => s == 0",
    ),
)


PLAIN = (
    *("identity", "level", "ordering", "closed", "count", "determinant", "unique roots"),
    *("square roots", "pure subgroup"),
)
PLACES = (number(2), number(3), prime(0, 1), INFINITY, split(2, 1))
PAIRS = [a + b for a in "eijk" for b in "eijk"]


def statement(rng: random.Random, depth: int = 0) -> str:
    """Return a statement of the vocabulary, or inside of one."""
    if depth > 1 or rng.random() < 0.55:
        return rng.choice(ATOMS)

    def part() -> str:
        return statement(rng, depth + 1)

    return rng.choice(
        (
            f"every{{{part()}; {part()}}}",
            f"every{{{part()}}}",
            f"implies{{{part()}; {part()}}}",
            f"iff{{{part()}; {part()}}}",
            f"not-everywhere{{{part()}}}",
            f"over{{{rng.choice(FIELDS)}; {part()}}}",
            f"angles{{{part()}}}",
            f"angles{{{part()}; {part()}}}",
            f"citing{{{rng.choice(('limits', 'odd-degree'))}; {part()}}}",
        )
    )


def evidence(rng: random.Random, depth: int = 0) -> Any:
    """Return evidence of a kind that some word takes."""

    def four() -> list[str]:
        numbers = ("0", "1", "-1", "2", "1/2", "x", "sqrt(2)", "I", "t")
        return [rng.choice(numbers) for _ in range(4)]

    def inner() -> Any:
        return evidence(rng, depth + 1) if depth < 3 else {"kind": "identity"}

    def judged() -> dict[str, Any]:
        return {"verdict": rng.choice(("proved", "refuted", "vacuous")), "evidence": inner()}

    field = rng.choice(FIELDS)
    values = {n: four()[: 4 if n in "pq" else 1] for n in rng.choice(("", "s", "q", "pq", "ps"))}
    plain = [
        *({"kind": kind} for kind in PLAIN),
        {"kind": "anisotropic", "by": rng.choice(("ordering", "level"))},
        {"kind": "anisotropic", "by": "place", "place": rng.choice(PLACES),
         "u": rng.choice((UNIT_I, HALF, ZERO)), "j": rng.choice((UNIT_J, ["1", "1", "0", "0"], ZERO))},
        {"kind": "anisotropic", "by": "specialisation", "at": "0", "proof": {"by": "ordering"}},
        {"kind": "zero norm", "value": four()}, {"kind": "squares", "values": four()[: rng.randint(1, 4)]},
        {"kind": "witness", "value": four(), "norm": rng.choice((1, -1, 4, 0, 2))},
        {"kind": "no root", "value": four()},
        {"kind": "all choices", "elements": [four(), ["1", "0", "0", "0"]],
         "roots": ["1", rng.choice(("1", "-1", "0"))]},
        {"kind": "all choices", "elements": [["1", "0", "0", "0"]], "roots": ["1"]},
        {"kind": "minor", "rows": rng.sample(range(8), 3), "columns": rng.sample(range(4), 3)},
        {"kind": "left out", "tuple": "".join(rng.choices("eijk", k=rng.randint(1, 3)))},
        {"kind": "basis tuples", "tuples": [list("eijk"), PAIRS][: rng.randint(0, 2)]},
        {"kind": "exhaustion", "cases": rng.choice((1, 2, 3, 4, 5, 9, 16, 81))},
        {"kind": "witness", "ring": any_data(field), "values": values},
        {"kind": "implication", "facts": [], "items": []},
        {"kind": "unsatisfiable", "proof": {"kind": rng.choice(("identity", "exhaustion")), "cases": 2}},
        {"kind": "unsatisfiable", "proof": {"kind": "identity"}},
    ]  # fmt: skip
    if rng.random() < 0.45 and depth < 2:
        return rng.choice(
            (
                {"kind": "parts", "parts": [judged() for _ in range(rng.choice((1, 2, 2, 3, 0)))]},
                {"kind": "part", "part": rng.choice((0, 1, -1, 2)), "evidence": inner()},
                {"kind": "both", "left": judged(), "right": judged()},
                {"kind": "conclusion", "evidence": inner()},
                {"kind": "hypothesis", "evidence": inner()},
                {"kind": "over", "ring": any_data(field), "evidence": inner()},
                {"kind": "lemmas", "proofs": [inner() for _ in range(rng.randint(0, 7))]},
                {"kind": "none exists", "proof": inner()},
            )
        )
    return rng.choice(plain)


# The kinds of evidence that a word takes; a statement of no word takes others.
FITTING = {
    "division": ("anisotropic", "zero norm"),
    "level-above": ("level", "squares"),
    "formally-real": ("level", "squares"),
    "norm-criterion": ("ordering", "witness"),
    "modulus-exists": ("closed", "identity", "no root"),
    "modulus-law": ("unique roots", "ordering", "square roots", "pure subgroup", "all choices"),
    "centre": ("minor",),
    "basis": ("determinant", "count"),
    "determined-by": ("basis tuples", "left out"),
    "curried-linear": ("identity",),
    "last-argument": ("identity",),
    "every": ("parts", "part"),
    "angles": ("parts", "part", "identity", "exhaustion", "witness"),
    "implies": ("conclusion", "hypothesis", "both", "lemmas", "over"),
    "iff": ("both", "lemmas", "over"),
    "not-everywhere": ("over",),
    "": ("identity", "exhaustion", "witness", "implication", "unsatisfiable", "none exists"),
}


def fitting(text: str, rng: random.Random) -> Any:
    """Return evidence that is more often than not of a kind that the statement takes."""
    while text.startswith(("over{", "citing{")):
        text = text.partition(";")[2].strip()
    word = text.partition("{")[0].strip("} ")
    kinds = FITTING[word if word in FITTING else ""]
    found = evidence(rng)
    while found["kind"] not in kinds and rng.random() < 0.99:
        found = evidence(rng)
    return found


METHODS = (
    *(
        "level",
        "ordering",
        "identity",
        "anisotropic norm",
        "zero norm",
        "sum of squares",
        "closed field",
    ),
    *(
        "linear algebra",
        "Smith form",
        "basis tuples",
        "determinant",
        "count",
        "all choices of roots",
        "implication",
    ),
)


def forged(rng: random.Random) -> Certificate:
    """Return a certificate about a whole, true or false as it happens."""
    field = rng.choice((None, *FIELDS))
    made = Target(statement(rng), field)
    verdict = rng.choice(("proved", "proved", "refuted", "vacuous"))
    data = made.certificate(fitting(made.statement, rng), rng.choice(METHODS), verdict=verdict)
    if rng.random() < 0.1:  # rings that are not those that the statement names
        said = [any_data(rng.choice(FIELDS)) for _ in range(rng.randint(0, 2))]
        data["evidence"] = {"kind": "rings", "rings": said, "evidence": data["evidence"]}
    return data

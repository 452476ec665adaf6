"""How rings describe themselves; ``python -m tests.fields.descriptions`` writes the expected texts anew.

The facts in these texts are tested elsewhere; here only the words are compared.
"""

import json
import random
from collections.abc import Callable
from fractions import Fraction
from itertools import islice
from pathlib import Path
from typing import Any

import flint
import numpy as np
import sympy

from hfield.errors import HFieldError
from hfield.fields.names import ring

FILE = Path(__file__).with_name("descriptions.json")
RINGS = (
    *("ZZ", "QQ", "RR", "CC", "RDF", "ZZ/6", "ZZ/7", "ZZ/2", "ZZ/100003", "GF(2)", "GF(7)", "GF(9)"),
    *("GF(9, x^2+1)", "GF(13)", "QQ(sqrt(2))", "QQ(sqrt(-7))", "QQ(sqrt(-3))", "QQ(sqrt(-5))", "QQ(I)"),
    *("QQ(sqrt(13))", "QQ(x)", "GF(4)(t)", "GF(3)(t)", "GF(5)(t)", "QQ(x,y)", "GF(3)(s,t)", "GF(4)(s,t)"),
    *("ZZ[a,b,c]", "ZZ[a]", "QQ[x,y]", "QQ[x]", "GF(5)[x]", "QQ[s]/(s^3-2)", "QQ(zeta5)", "QQ(zeta7)+"),
    *("QQ(sqrt(2),sqrt(3))", "QQ(root(2,3))", "GF(3)(t)[u]/(u^2-t^3+t)", "QQ(x)[u]/(u^3-x)", "Qp(5)"),
    *("GF(9)((t))", "GF(5)(t)[u]/(u^2-t)", "QQ[s]/(s^4+7*s^2+4*s+2)", "QQ(zeta8)", "QQ(I,root(2,3))"),
    *("QQ[s]/(s^4+s+2)", "QQ(sqrt(2),I)"),
)  # fmt: skip
ENTER = ("QQ(I)", "QQ(sqrt(2))", "QQ(x)", "GF(7)", "GF(9)", "ZZ[a]", "QQ[s]/(s^3-2)")


def values() -> list[Any]:
    """Return what may or may not enter a ring."""
    plain = [0.5, 1j, None, Fraction(1, 2), Fraction(6, 3), np.True_, np.int64(-3), np.array(5)]
    others = [
        sympy.sqrt(2),
        sympy.I,
        sympy.Rational(1, 7),
        sympy.Symbol("z"),
        sympy.pi,
        flint.fmpz(4),
    ]
    return [
        *plain,
        *others,
        flint.fmpq(1, 5),
        *(ring(name).gen if name != "GF(7)" else ring(name)(3) for name in ENTER),
    ]


STYLES = ("plain", "unicode", "latex")


def said(work: Callable[[], Any]) -> str:
    """Return the text of a result, or the words of the error."""
    try:
        return str(work())
    except HFieldError as error:
        return f"{type(error).__name__}: {error}"


def description(name: str) -> dict[str, str]:
    """Return how a ring describes itself, question by question."""
    R = ring(name)
    two, four = R(2), R(4)
    drawn = [R.random(random.Random(seed)) for seed in range(3)]
    questions: dict[str, Callable[[], Any]] = {
        "name": lambda: (R.name, R.latex_name, R.characteristic, R.order, R.gen_name, R.closure),
        "words": R.in_words,
        "names": lambda: (sorted(R.names()), sorted(R.functions())),
        "kind": lambda: (R.is_field, R.is_domain, R.is_exact, R.fractions, R.residues_of),
        "level": lambda: R.level,
        "orderings": lambda: R.orderings,
        "squares": lambda: [R.text(x) for x in R.minus_one_as_squares()],
        "gen": lambda: [R.text(R.gen, style) for style in STYLES],
        "places": lambda: list(islice(R.places(), 8)),
        "sqrt": lambda: [R.sqrt(x) for x in (four, R.zero)],
        "roots": lambda: sorted(map(str, R.roots([R(-1), R(0), R(1)]))),
        "euclid": lambda: R.euclid(R(7), two),
        "elements": lambda: list(islice(R.elements(), 5)),
        "signs": lambda: [R.sign(x) for x in (two, -two, R.zero)],
        "ordering": lambda: R.sign(two, 7),
        "no ordering": lambda: R.sign(two, -1),
        "inverse of 0": lambda: R.inverse(R.zero),
        "inverse of 2": lambda: R.inverse(two),
        "division": lambda: R.divide(R(6), two),
        "third": lambda: R("1/3"),
        "completion": lambda: R.completion(2),
        "at infinity": lambda: R.completion("inf"),
        "lift": lambda: R.lift(R.one),
        "modulo": lambda: R.modulo(3),
        "annihilators": lambda: [R.annihilator(x) for x in (R.zero, R.one, two)],
        "negative power": lambda: R.text(R.power(drawn[0] + 1, -2)),
        "powers of 0": lambda: [R.power(R.zero, n) for n in (0, 1, 3)],
        "a negative power of 0": lambda: R.power(R.zero, -1),
        "powers of 2": lambda: [R.text(R.power(two, n)) for n in (0, 1, 5)],
        "state": lambda: R.state(drawn[0]),
        "refused": lambda: R(object),
        "no text": lambda: R("1+"),
        "a name": lambda: R("nobody"),
    }
    for k, x in enumerate(values()):
        questions[f"enters {k}"] = lambda x=x: R.text(R(x))
    questions |= {
        f"random {k}": (lambda x=x: [R.text(x, s) for s in STYLES]) for k, x in enumerate(drawn)
    }
    return {question: said(work) for question, work in questions.items()}


if __name__ == "__main__":
    found = {name: description(name) for name in RINGS}
    FILE.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")

"""Evidence, multiplied out again by sympy, which has no part in finding it."""

import json
import math
import re

import sympy

from hfield.prover.prove import prove
from tests.prover.statements import FIELDS, UNIVERSAL
from tests.subcases import subcases

IMPLICATIONS = [
    *((s, None) for s in [*UNIVERSAL, *FIELDS] if "=>" in s),
    ("p*q == 0 => p == 0 or q == 0", "QQ"),
    ("p*q == 0 => p == 0 or q == 0", "QQ(sqrt(-7))"),
    ("norm(p)*norm(q) == 0 => p == 0 or q == 0", "QQ"),
    ("q**2 == 1 => q == 1 or q == -1", "QQ"),
    ("norm(p) + norm(q) == 0 => p == 0", "RR"),
    ("s**2 == 4 => s == 2 or s == -2", "GF(5)"),
    ("s**3 == 8 => s == 2", "QQ"),
    ("s**2 == 2 => s == sqrt(2) or s == -sqrt(2)", "QQ(sqrt(2))"),
    ("s**2 + y**2 == 0 => s == 0", "GF(3)"),
    ("comm(p,i) == 0 and comm(p,j) == 0 => vector(p) == 0", "GF(3)"),
    ("2*q == 0 => q == 0", "QQ"),
]


class Reader:
    """Reads polynomials of evidence into one of sympy's rings; brackets and roots are spelt out."""

    def __init__(self, item):
        names = sorted(set(re.findall(r"[A-Za-z_]\w*", self.spelt(json.dumps(item)) + " T1 T2 T3")))
        self.names = dict(zip(names, sympy.ring(names, sympy.ZZ)[1:], strict=True))
        self.zero = 0 * next(iter(self.names.values()))

    @staticmethod
    def spelt(text):
        return re.sub(r"\[(\d)\]", r"_\1", text).replace("sqrt(2)", "root")

    def __call__(self, text):
        return self.zero + eval(self.spelt(text), {}, self.names)


def shows(reader, step, target, zeros, p):
    """Check denominator·target = Σ cofactor·zero."""
    assert len(step["cofactors"]) == len(zeros)
    assert step["denominator"] != 0
    total = reader.zero - step["denominator"] * target
    for c, z in zip(step["cofactors"], zeros, strict=True):
        total += reader(c) * z
    assert all(c % p == 0 if p else c == 0 for c in total.values())


def follow(reader, steps, zeros, p):
    for step in steps:
        kind = step["step"]
        if kind == "contradiction":
            shows(reader, step, 1, zeros, p)
            return
        if kind == "no root":
            f = reader(step["polynomial"])
            _, factors = f.factor_list()
            assert all(sum(g.degrees()) > 1 for g, _ in factors)
            shows(reader, step, f, zeros, p)
            return
        if kind == "cases":
            factors = [reader(f) for f in step["factors"]]
            product = math.prod(f**n for f, n in zip(factors, step["powers"], strict=True))
            shows(reader, step, product, zeros, p)
            for f, branch in zip(factors, step["branches"], strict=True):
                follow(reader, branch, [*zeros, f], p)
            return
        terms = [reader(t) for t in step["terms"]]
        weights = step.get("coefficients", [1] * len(terms))
        assert all(c > 0 for c in weights)
        form = sum((c * t * t for c, t in zip(weights, terms, strict=True)), reader.zero)
        shows(reader, step, form, zeros, p)
        zeros = [*zeros, *terms]
    raise AssertionError("the steps end without a contradiction")


@subcases(("statement", "field"), IMPLICATIONS)
def test_cofactors_multiply_out(statement, field):
    certificate = prove(statement, field).certificate
    assert certificate["verdict"] == "proved"
    evidence = certificate["evidence"]
    while "proof" in evidence:
        evidence = evidence["proof"]
    for item in evidence.get("items", []):
        reader, p = Reader(item), item["characteristic"]
        zeros = [reader(z) for z in [*item["zero"], *item["relations"]]]
        if "member" in item:
            shows(reader, item, reader(item["member"]), zeros, p)
            continue
        for n, g in enumerate(item["nonzero"], 1):
            zeros.append(1 - reader(f"T{n}") * reader(g))
        follow(reader, item["steps"], zeros, p)


def test_facts_are_named_where_rules_are_used():
    evidence = prove("norm(q) == 0 => q == 0", "QQ(sqrt(-7))").certificate["evidence"]
    assert [(f["form"], f["by"]) for f in evidence["facts"]] == [("norm", "level")]
    evidence = prove("norm(q) == 0 => q == 0", algebra="(2,3|QQ)").certificate["evidence"]
    fact = evidence["facts"][0]
    assert (fact["by"], fact["place"]) == ("place", {"kind": "number", "n": 2})


def test_kinds_of_evidence():
    def kind(*arguments, **options):
        return prove(*arguments, **options).certificate["evidence"]["kind"]

    assert kind("(p*q)*r == p*(q*r)") == "identity"
    assert kind("p*q == q*p") == "witness"
    assert kind("p*q == 1 => q*p == 1") == "implication"
    assert kind("s*(s+1)*(s+2) == 0 or s == 5", "GF(3)") == "identity"
    assert kind("exists q: q*q == -1", "QQ") == "witness"
    assert kind("exists s: s**2 == -1", "QQ") == "none exists"
    assert kind("norm(p) != 0 => (exists q: p*q == e)") == "terms"
    assert kind("exists q: p*q == e", "GF(3)") == "place"
    assert kind("2 == 0 => p == q", "QQ") == "unsatisfiable"
    assert kind("s*s == s or s*s == y*y*s*s + s or y == 1", "GF(3)") == "witness"
    assert kind("s**2 == y**2 and s*y == 1 => s == y", "GF(3)") == "implication"
    assert kind("s**2 == 0 => s == 0", "ZZ/6") == "exhaustion"
    assert kind("x != 0 or z != 0 => (exists s, y: s*x + y*z == 1)") == "cases"
    assert kind("norm(q) == 0 => q == 0", "ZZ") == "fractions"
    assert kind("2*s + 4*y != 1", "ZZ") == "reduction"
    assert kind("exists s: s**3 == y", "RR") == "real root"
    assert kind("exists s: s**3 == y", "CC") == "complex root"
    assert kind("s**2 == 2*y**2 => s == 0", "QQ") == "implication"
    assert kind("s**2 + y**2 == 3*z**2 => z == 0", "QQ") == "implication"

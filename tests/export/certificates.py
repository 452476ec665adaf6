"""Certificates for Coq to judge: true ones of every kind, and forged ones made from them.

A forgery is a certificate whose evidence does not show what it says: of a false statement by the
evidence of a true one, of a true statement by evidence that was changed, of another field, another
algebra, another verdict.
"""

import copy
import json
from functools import cache
from itertools import product

from hfield import H
from hfield.fields.names import ring
from hfield.ledger.certificate import certificate
from hfield.ledger.claim import UNIVERSAL
from hfield.ledger.registry import find
from hfield.prover.prove import prove
from tests.checker.cases import about_field, certified

# Statements, fields, algebras: one of every kind that is translated.
TRUE = {
    "associative": ("(p*q)*r == p*(q*r)", None, None),
    "conjugate": ("conj(p*q) == conj(q)*conj(p)", None, "[a,b|F)"),
    "hall": ("comm(comm(p,q)*comm(p,q), r) == 0", None, None),
    "characteristic 2": ("2 == 0 => p*q == q*p", None, None),
    "inverse": ("norm(q) != 0 => q*inv(q) == e and inv(q)*q == e", None, "(a,b|F)"),
    "inverse of a product": (
        "norm(p) != 0 and norm(q) != 0 => inv(p*q) == inv(q)*inv(p)",
        None,
        None,
    ),
    "two or three": ("3*s == 0 and 2*s == 0 => s == 0", None, None),
    "two and three": ("6*s == 0 and 2 != 0 and 3 != 0 => s == 0", None, None),
    "no zero divisors": ("s*y == 0 => s == 0 or y == 0", None, None),
    "nilpotent": ("s*s == 0 => s == 0", None, None),
    "norms": ("p*q == 0 => norm(p) == 0 or norm(q) == 0", None, None),
    "half": ("2 != 0 => 0.5*q + 0.5*q == q", None, None),
    "equivalent": ("p*q == q*p <=> 2 == 0 or p*q == q*p", None, None),
    "either way": ("s*x == 1 => (s*y == 0 <=> y == 0)", None, None),
    "rotation": ("norm(q) == 1 => norm(q*p*conj(q)) == norm(p)", None, None),
    "commute": ("p*q == q*p", None, None),
    "commute over QQ": ("p*q == q*p", "QQ", None),
    "a square": ("q*q == -1 => q == i", "GF(5)", None),
    "a divisor": ("q*inv(q) == e", "GF(3)", None),
    "definite": ("norm(q) == 0 => q == 0", "QQ", None),
    "definite algebra": ("norm(q) == 0 => q == 0", "QQ", "(-2,-3|QQ)"),
    "squares": ("s**2 + 2*y**2 == 0 => s == 0 and y == 0", "QQ", None),
    "division algebra": ("p*q == 0 => p == 0 or q == 0", "QQ", None),
    "integers": ("2*s == 0 => s == 0", "ZZ", None),
    "integers commute": ("p*q == q*p", "ZZ", None),
    "ring of integers": ("norm(p*q) == norm(p)*norm(q)", "ZZ", None),
    "residues": ("(p + q)*(p - q) == p*p - p*q + q*p - q*q", "ZZ/6", None),
    "residues divide": ("s*y == 0 => s == 0 or y == 0", "ZZ/6", None),
    "a field of residues": ("s*y == 0 => s == 0 or y == 0", "ZZ/101", None),
    "Fermat for residues": ("s**3 == s", "ZZ/3", None),
    "a large field of residues": ("s*s == s => s == 0 or s == 1", "ZZ/1009", None),
    "Fermat": ("s**3 == s", "GF(3)", None),
    "Fermat and more": ("(s*y)**5 == s*y", "GF(5)", None),
    "all cases": ("s*s == 2 => s == 3 or s == 4", "GF(7)", None),
    "many cases": ("2*s == 0 => s == 0", "ZZ/501", None),
    "small ring": ("s**3 == s", "ZZ/6", None),
    "prime": ("p**3 == p => p == 0 or norm(p) != 7", "GF(1000003)", None),
    "large prime": ("7*s == 0 => s == 0", "GF(1000003)", None),
    "zero norm": ("exists q: q != 0 and norm(q) == 0", "GF(3)", None),
    "inverse exists": ("norm(p) != 0 => (exists q: p*q == e)", None, None),
    "square exists": ("exists q: q != 0 and q*q == -1", None, None),
    "root": ("exists s: s*s == 2", "GF(7)", None),
    "root of a rational": ("exists s: s*s == 9/4", "QQ", None),
    "solvable": ("exists u: u + s == 0", "QQ", None),
    "one of two solves": ("s != 0 or t != 0 => (exists x, y: s*x + t*y == 1)", None, None),
    "definite over ZZ": ("norm(q) == 0 => q == 0", "ZZ", None),
    "constants that divide": ("a != 0 => i*i != 0", None, "(1/a,-1|F)"),
    "never": ("s == 1 and s == 2 => p*q == q*p", "QQ", None),
    "never in general": ("s == y and s != y => p == q", None, None),
    "no root": ("exists s: s != 0 and s*s == 0", "GF(5)", None),
    "not all inverses": ("exists y: s*y == 1", "QQ", None),
    "not all halves": ("exists y: 2*y == s", None, None),
    "coordinates": ("q[1] == 0 and q[2] == 0 and q[3] == 0 => p*q == q*p", None, None),
    "trace": ("q**2 - trace(q)*q + norm(q) == 0", None, "[a,b,t|F)"),
    "not": ("not (s == 0 and y == 0) => s != 0 or y != 0", None, None),
}
# Propositions of the ledger that are no statements of the language, over a field or over all.
LEDGER = {
    "relations": ("C1.2-c", "as_printed", None),
    "relations over GF(5)": ("C1.2-c", "as_printed", "GF(5)"),
    "a table and a statement": ("C1.2-a", "corrected", None),
    "a table over GF(3)": ("C1.2-a", "corrected", "GF(3)"),
    "both or none": ("C1.1.2-b", "as_printed", "GF(13)"),
    "points of a circle": ("C2.1.1-e", "as_printed", None),
    "points and more": ("C2.2.4-j", "as_printed", "QQ"),
}


def _of_ledger(claim, which, field):
    proposition = getattr(find(claim), which)
    decision = proposition.decide(None if field is None else ring(field))
    return certificate(proposition, decision, field or UNIVERSAL)


def multilinear(text, unknowns, field, value):
    """Return the certificate by tuples of basis vectors; ``value`` computes one side from one of them."""
    basis = dict(zip("eijk", H("QQ").basis, strict=True))
    tuples = []
    for word in map("".join, product("eijk", repeat=len(unknowns))):
        found = value(*(basis[letter] for letter in word))
        tuples.append([word, [int(c) for c in found.coordinates]])
    evidence = {"kind": "multilinear", "unknowns": [*unknowns], "tuples": tuples}
    return certified(text, field, "multilinear", evidence)


_VACUOUS_PART = {
    "schema": "hfield-cert/1",
    "statement": "every{e*q == q; implies{norm(i) == 2; p*q == q*p}}",
    "algebra": "(-1,-1|QQ)",
    "field": "QQ",
    "verdict": "proved",
    "method": "identity",
    "assumes": [],
    "evidence": {
        "kind": "parts",
        "parts": [
            {"verdict": "proved", "evidence": {"kind": "identity"}},
            {
                "verdict": "vacuous",
                "evidence": {
                    "kind": "hypothesis",
                    "evidence": {"kind": "witness", "field": "QQ", "values": {}},
                },
            },
        ],
    },
}


@cache
def _true():
    found = {name: json.dumps(_of_ledger(*where)) for name, where in LEDGER.items()}
    own = [
        multilinear("conj(p*q) == conj(q)*conj(p)", "pq", None, lambda p, q: (p * q).conjugate()),
        multilinear(
            "trace(p*q) == trace(q*p)", "pq", "GF(3)", lambda p, q: 0 * p + (p * q).trace()
        ),
    ]
    found["tuples"], found["tuples over GF(3)"] = map(json.dumps, own)
    found["a vacuous part"] = json.dumps(_VACUOUS_PART)
    for name, (statement, field, algebra) in TRUE.items():
        certificate = prove(statement, field, algebra=algebra).certificate
        if certificate is not None:
            found[name] = json.dumps(certificate)
    return found


def true_certificates():
    """Return true certificates by names."""
    return {name: json.loads(text) for name, text in _true().items()}


def forged_certificates():
    """Return forged certificates by names; each comes from a true one, or is made by hand."""
    true, out = true_certificates(), {}

    def forge(name, of, **changes):
        data = copy.deepcopy(true[of])
        if "field" in changes:
            data = about_field(data, changes.pop("field"))
        for key, value in changes.items():
            if callable(value):
                value(data["evidence"])
            else:
                data[key] = value
        assert data != true[of]
        out[name] = data

    # Another statement than the evidence is for.
    forge("anticommute", "associative", statement="(p*q)*r == p*(r*q)")
    forge("conjugate in order", "conjugate", statement="conj(p*q) == conj(p)*conj(q)")
    forge("commute by nothing", "associative", statement="p*q == q*p")
    forge("more than Hall", "hall", statement="comm(comm(p,q), r) == 0")
    forge("characteristic 3", "characteristic 2", statement="3 == 0 => p*q == q*p")
    forge("no hypothesis", "inverse", statement="q*inv(q) == e and inv(q)*q == e")
    forge(
        "inverse in order",
        "inverse of a product",
        statement="norm(p) != 0 and norm(q) != 0 => inv(p*q) == inv(p)*inv(q)",
    )
    forge("four", "two or three", statement="4*s == 0 and 2*s == 0 => s == 0")
    forge("six", "two and three", statement="6*s == 0 and 2 != 0 => s == 0")
    forge("one of them", "no zero divisors", statement="s*y == 0 => s == 0")
    forge("square", "nilpotent", statement="s*s == s => s == 0")
    forge("left factor", "norms", statement="p*q == 0 => norm(p) == 0")
    forge("third", "half", statement="2 != 0 => 0.5*q + 0.25*q == q")
    forge("not half", "half", statement="0.5*q + 0.5*q == q")
    forge("one way", "either way", statement="s*x == 1 => (s*y == 0 <=> x == 0)")
    forge("not a unit", "rotation", statement="norm(q) == 2 => norm(q*p*conj(q)) == norm(p)")
    forge("residues commute", "residues", statement="(p + q)*(p - q) == p*p - q*q")
    forge("no field of residues", "a field of residues", field="ZZ/6", algebra="(-1,-1|ZZ/6)")
    forge("not Fermat", "Fermat", statement="s**2 == s")
    forge("not Fermat either", "Fermat and more", statement="(s*y)**4 == s*y")
    forge("wrong roots", "all cases", statement="s*s == 2 => s == 3 or s == 5")
    forge("not all cases", "many cases", statement="3*s == 0 => s == 0")
    forge("cube", "small ring", statement="s**2 == s")
    forge("no trace", "trace", statement="q**2 + trace(q)*q + norm(q) == 0")
    forge("inverse of anything", "inverse exists", statement="exists q: p*q == e")
    forge("indefinite", "definite", statement="norm(q) == 0 => q == 1")
    forge("difference of squares", "squares", statement="s**2 - 2*y**2 == 0 => s == 0 and y == 0")
    forge(
        "other relations",
        "relations",
        statement=true["relations"]["statement"].replace("i*i == -e", "i*i == e"),
    )
    forge(
        "other goals",
        "a table over GF(3)",
        statement=true["a table over GF(3)"]["statement"].replace("j*i == -k", "j*i == k"),
    )
    forge(
        "all of it",
        "a table and a statement",
        statement=true["a table and a statement"]["statement"].replace(
            "every{", "every{p*q == q*p; "
        ),
    )
    forge(
        "a part that is not vacuous",
        "a vacuous part",
        statement="every{e*q == q; implies{norm(i) == 1; p*q == q*p}}",
    )
    forge("neither", "both or none", statement="iff{p*q == q*p; 2 == 2}")
    forge(
        "a harmless circle",
        "points of a circle",
        statement=true["points of a circle"]["statement"].replace("== 1", "== 2"),
    )
    forge("tuples in order", "tuples", statement="conj(p*q) == conj(p)*conj(q)")
    # Another field, another algebra.
    forge("Fermat everywhere", "Fermat", field=None)
    forge("Fermat elsewhere", "Fermat", field="GF(5)")
    forge("definite over GF(5)", "definite", field="GF(5)")
    forge("definite everywhere", "definite", field=None)
    forge("a split algebra", "definite", algebra="(1,-1|QQ)")
    forge("an indefinite algebra", "definite algebra", algebra="(2,-3|QQ)")
    forge("no field", "residues divide", verdict="proved", evidence={"kind": "identity"})
    forge("characteristic 7", "large prime", field="GF(7)")
    forge("integers divide", "integers", statement="2*s == y => s == 0")
    # Another verdict.
    forge("commute indeed", "commute over QQ", verdict="proved", evidence={"kind": "identity"})
    forge(
        "vacuous",
        "characteristic 2",
        verdict="vacuous",
        evidence={"kind": "unsatisfiable", "proof": {"kind": "identity"}},
    )
    forge("exhausted", "a square", verdict="proved", evidence={"kind": "exhaustion", "cases": 625})
    # Evidence that was changed.
    forge("a cofactor", "characteristic 2", evidence=_first(["items", 0, "cofactors", 0], "1"))
    forge("a member", "characteristic 2", evidence=_first(["items", 0, "member"], "p[0]"))
    forge(
        "no items", "characteristic 2", evidence={"kind": "implication", "facts": [], "items": []}
    )
    forge("a denominator", "two or three", evidence=_first(["items", 0, "denominator"], 5))
    forge("its denominator 0", "two or three", evidence=_first(["items", 0, "denominator"], 0))
    forge("another zero", "characteristic 2", evidence=_first(["items", 0, "zero", 0], "3"))
    forge(
        "a harmless witness",
        "commute over QQ",
        evidence=_first(["values", "p"], ["1", "0", "0", "0"]),
    )
    forge("a witness elsewhere", "a square", evidence=_first(["values", "q"], ["0", "1", "0", "0"]))
    forge(
        "a witness to nothing", "a divisor", evidence=_first(["values", "q"], ["1", "0", "0", "0"])
    )
    forge("no zero norm", "zero norm", evidence=_first(["values", "q"], ["1", "0", "0", "0"]))
    forge("a wrong root", "root", evidence=_first(["values", "s"], ["2"]))
    forge("a wrong rational root", "root of a rational", evidence=_first(["values", "s"], ["1/2"]))
    forge("wrong terms", "solvable", evidence=_first(["terms", "u"], "s"))
    forge("a case left out", "one of two solves", evidence=lambda e: e["cases"].pop())
    forge(
        "the wrong case",
        "one of two solves",
        evidence=lambda e: e["cases"][0].__setitem__("when", e["cases"][-1]["when"]),
    )
    forge("constants that vanish", "constants that divide", statement="i*i == 1")
    forge("the wrong inverse", "inverse exists", evidence=_first(["terms", "q"], "conj(p)"))
    forge("a wrong step", "norms", evidence=_step("cofactors"))
    forge("a tuple", "tuples", evidence=_first(["tuples", 5, 1, 0], 1))
    forge("a word", "tuples over GF(3)", evidence=_first(["tuples", 7, 0], "ee"))
    forge("a relation", "relations", evidence=lambda e: e["proofs"][0]["cofactors"].pop())
    forge("a number", "relations over GF(5)", evidence=_first(["proofs", 1, "cofactors", 0, 0], 2))
    forge("a missing goal", "relations", evidence=lambda e: e["proofs"].pop())
    forge(
        "a part refuted",
        "a table and a statement",
        evidence=_first(["parts", 0, "verdict"], "refuted"),
    )
    forge(
        "a part of another",
        "a table over GF(3)",
        evidence=lambda e: e["parts"].__setitem__(1, e["parts"][0]),
    )
    forge("one side", "both or none", evidence=_first(["left", "verdict"], "proved"))
    forge("a step without the fact", "squares", statement="s**2 + 2*y**3 == 0 => s == 0 and y == 0")
    return out


def _first(path, value):
    """Return a change: put a value at a place of the evidence."""

    def change(evidence):
        place = evidence
        for key in path[:-1]:
            place = place[key]
        assert path[-1] in place if isinstance(place, dict) else len(place) > path[-1]
        place[path[-1]] = value

    return change


def _step(key):
    """Return a change: spoil the first step of the first item that has steps."""

    def change(evidence):
        item = next(i for i in evidence["items"] if "steps" in i)
        step = item["steps"][0]
        step[key] = ["7 + " + c for c in step[key]]

    return change

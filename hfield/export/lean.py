"""Write identities and implications as Lean 4 theorems, proved by ``grind``.

Only Lean's core is used (``Lean.Grind.CommRing`` and its solver), not Mathlib. The theorem is written from
the statement of the certificate. The cofactors of the certificate are not used, because the solver finds its
own.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from hfield.checker.first_schema import current
from hfield.checker.glossary import SCHEMA
from hfield.errors import HFieldError, TooLargeError
from hfield.evidence import Kind
from hfield.export.coq.base_rings import RINGS
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.sentences import Sentence
from hfield.export.coq.terms import NotCoveredError
from hfield.notation import UNNAMED, split_algebra
from hfield.prover.statements.language import Sort, Statement, read_statement
from hfield.prover.statements.setting import read_setting
from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Number,
    Power,
    parse,
)

FIELDS = ("re", "im", "jm", "km")
MAX_SIZE = 4_000  # leaves of a coordinate, beyond which the solver takes long
HEADER = """\
/- Quaternion algebras over every commutative ring: theorems for Lean 4, written by `hfield export --lean`.
   Check them with `lean FILE.lean`; nothing but Lean's core is used. -/

-- Errors in proofs are reported before Lean ends, also where it runs without threads.
set_option Elab.async false

/-- Coordinates over 1, i, j, k. -/
@[ext] structure Quaternion (R : Type) where
  re : R
  im : R
  jm : R
  km : R

section Definitions
variable {R : Type} [Lean.Grind.CommRing R]
def embed (s : R) : Quaternion R := ⟨s, 0, 0, 0⟩
def unitE : Quaternion R := ⟨1, 0, 0, 0⟩
def unitI : Quaternion R := ⟨0, 1, 0, 0⟩
def unitJ : Quaternion R := ⟨0, 0, 1, 0⟩
def unitK : Quaternion R := ⟨0, 0, 0, 1⟩
def qadd (p q : Quaternion R) : Quaternion R := ⟨p.re + q.re, p.im + q.im, p.jm + q.jm, p.km + q.km⟩
def qsub (p q : Quaternion R) : Quaternion R := ⟨p.re - q.re, p.im - q.im, p.jm - q.jm, p.km - q.km⟩
def qneg (q : Quaternion R) : Quaternion R := ⟨-q.re, -q.im, -q.jm, -q.km⟩
def qscale (s : R) (q : Quaternion R) : Quaternion R := ⟨s * q.re, s * q.im, s * q.jm, s * q.km⟩
/-- The product with i*i = a + t*i, j*j = b, i*j = k, j*i = t*j - k. -/
def qmul (a t b : R) (p q : Quaternion R) : Quaternion R :=
  ⟨p.re * q.re + a * (p.im * q.im) + b * (p.jm * q.jm + t * (p.jm * q.km) - a * (p.km * q.km)),
   p.re * q.im + p.im * q.re + t * (p.im * q.im) + b * (p.km * q.jm - p.jm * q.km),
   p.re * q.jm + p.jm * q.re + t * (p.jm * q.im) + a * (p.im * q.km - p.km * q.im),
   p.re * q.km + p.km * q.re + p.im * q.jm - p.jm * q.im + t * (p.im * q.km)⟩
def qpow (a t b : R) (q : Quaternion R) : Nat → Quaternion R
  | 0 => unitE
  | n + 1 => qmul a t b (qpow a t b q n) q
def conj (t : R) (q : Quaternion R) : Quaternion R := ⟨q.re + t * q.im, -q.im, -q.jm, -q.km⟩
def norm (a t b : R) (q : Quaternion R) : R :=
  q.re * q.re + t * (q.re * q.im) - a * (q.im * q.im)
    - b * (q.jm * q.jm + t * (q.jm * q.km) - a * (q.km * q.km))
def trace (t : R) (q : Quaternion R) : R := q.re + q.re + t * q.im
def vector (q : Quaternion R) : Quaternion R := ⟨0, q.im, q.jm, q.km⟩
end Definitions

macro "coordinates" : tactic => `(tactic| (
  simp only [Quaternion.ext_iff, embed, unitE, unitI, unitJ, unitK, qadd, qsub, qneg, qscale, qmul,
    qpow, conj, norm, trace, vector] at * <;> grind))
"""


@dataclass(frozen=True)
class LeanTheorem:
    """A Lean 4 theorem; its proof is one tactic."""

    name: str
    comment: str
    text: str

    def __str__(self) -> str:
        return f"/- {self.comment} -/\ntheorem {self.name} {self.text} := by\n  coordinates"


def lean_file(theorems: Iterable[LeanTheorem]) -> str:
    """Return the whole file."""
    return "\n".join([HEADER, *(f"{t}\n" for t in theorems)])


def lean_theorem(name: str, data: object) -> LeanTheorem:
    """Translate a certificate over all fields whose proof does not use division.

    Raises :class:`NotCoveredError` for other certificates, and :class:`MismatchError` for anything but a
    certificate.
    """
    data = current(data)
    if not isinstance(data, Mapping) or not isinstance(data.get("statement"), str):
        raise MismatchError(f"this is not a certificate {SCHEMA}")
    if data.get("verdict") != "proved" or data.get("field") is not None:
        raise NotCoveredError("Lean export covers only what is proved for all fields")
    kind = data["evidence"].get("kind") if isinstance(data.get("evidence"), Mapping) else None
    if kind not in (Kind.IDENTITY, Kind.IMPLICATION):
        raise NotCoveredError(
            f"Lean export covers identities and implications, and this proof is of the kind {kind!r}"
        )
    items = data["evidence"].get("items", [])
    if any("member" not in i or i["denominator"] not in (1, -1) for i in items):
        raise NotCoveredError("the proof needs a field")
    a, t, b, inside = split_algebra(str(data["algebra"]))
    if inside != UNNAMED:
        raise MismatchError("the algebra and the field do not agree")
    setting = read_setting(None, str(data["algebra"]))
    statement = read_statement(data["statement"], None, (), setting.letters, setting.constants)
    if statement.ordered is not None:
        raise NotCoveredError("moduli and comparisons over ordered fields")
    if statement.exists or statement.divides or statement.compares_unequal:
        raise NotCoveredError("Lean export covers equations joined by and, or and =>")
    size = _size(Sentence(statement, setting, RINGS))
    if size > MAX_SIZE:
        raise TooLargeError(
            f"a coordinate has {size} leaves, more than the {MAX_SIZE} that are exported to Lean"
        )
    comment = f"{data['statement']}, in {data['algebra']}".replace("-/", "- /").replace("/-", "/ -")
    return LeanTheorem(name, comment, _Lean(statement, (a, t, b)).text)


def lean_theorems(certificates: Mapping[str, object]) -> tuple[list[LeanTheorem], dict[str, str]]:
    """Translate certificates; return the theorems, and the reasons why others are left out."""
    found, left = [], {}
    for name, data in certificates.items():
        try:
            found.append(lean_theorem(name, data))
        except HFieldError as error:
            left[name] = str(error)
    return found, left


def _size(sentence: Sentence) -> int:
    terms = sentence.terms
    nodes = [sentence.statement.conclusion, *sentence.statement.hypotheses]
    sizes = [0]
    while nodes:
        node = nodes.pop()
        if isinstance(node, Compare):
            sizes += [terms.term(node.left).size, terms.term(node.right).size]
        elif isinstance(node, Logic):
            nodes += [node.left, node.right]
    return max(sizes)


class _Lean:
    """Writes one statement in Lean's notation."""

    def __init__(self, statement: Statement, constants: tuple[str, str, str]) -> None:
        self.sorts = dict(statement.unknowns)
        self.a, self.t, self.b = (self._scalar(parse(text)) for text in constants)
        parts = [self._formula(h) for h in (*statement.hypotheses, statement.conclusion)]
        binders = ""
        for sort, kind in ((Sort.QUATERNION, "Quaternion R"), (Sort.SCALAR, "R")):
            names = [n for n, s in statement.unknowns if s is sort]
            if names:
                binders += f" ({' '.join(names)} : {kind})"
        self.text = (
            "{R : Type} [Lean.Grind.CommRing R]" + binders + " :\n    " + " →\n    ".join(parts)
        )

    def _formula(self, node: Node) -> str:
        match node:
            case Compare("==", x, y):
                if self._is_scalar(x) and self._is_scalar(y):
                    return f"(({self._scalar(x)} : R) = {self._scalar(y)})"
                return f"(({self._quaternion(x)} : Quaternion R) = {self._quaternion(y)})"
            case Logic("and" | "or" | "=>" as op, x, y):
                sign = {"and": "∧", "or": "∨", "=>": "→"}[op]
                return f"({self._formula(x)} {sign} {self._formula(y)})"
        raise NotCoveredError("Lean export covers equations joined by and, or and =>")

    def _is_scalar(self, node: Node) -> bool:
        match node:
            case Number() | Index() | Call("norm" | "trace" | "scalar", _):
                return True
            case Name(name):
                return name not in "eijk" and self.sorts.get(name) is not Sort.QUATERNION
            case Negate(x) | Power(x, _):
                return self._is_scalar(x)
            case Binary(_, x, y):
                return self._is_scalar(x) and self._is_scalar(y)
        return False

    def _scalar(self, node: Node) -> str:
        match node:
            case Number(value) if not isinstance(value, Fraction):
                return str(value)
            case Name(name):
                return name
            case Negate(x):
                return f"(-{self._scalar(x)})"
            case Binary("+" | "-" | "*" as op, x, y):
                return f"({self._scalar(x)} {op} {self._scalar(y)})"
            case Power(x, n) if n >= 0:
                return f"({self._scalar(x)} ^ {n})"
            case Index(x, n):
                return f"({self._quaternion(x)}).{FIELDS[n]}"
            case Call("scalar", (x,)):
                return f"({self._quaternion(x)}).re"
            case Call("norm", (x,)):
                return f"(norm {self.a} {self.t} {self.b} {self._quaternion(x)})"
            case Call("trace", (x,)):
                return f"(trace {self.t} {self._quaternion(x)})"
        raise NotCoveredError("Lean export covers statements without division")

    def _quaternion(self, node: Node) -> str:
        if self._is_scalar(node):
            return f"(embed {self._scalar(node)})"
        algebra = f"{self.a} {self.t} {self.b}"
        match node:
            case Name(name):
                return {"e": "unitE", "i": "unitI", "j": "unitJ", "k": "unitK"}.get(name, name)
            case Negate(x):
                return f"(qneg {self._quaternion(x)})"
            case Binary("+" | "-" as op, x, y):
                word = "qadd" if op == "+" else "qsub"
                return f"({word} {self._quaternion(x)} {self._quaternion(y)})"
            case Binary("*", x, y) if self._is_scalar(x) or self._is_scalar(y):
                s, q = (x, y) if self._is_scalar(x) else (y, x)
                return f"(qscale {self._scalar(s)} {self._quaternion(q)})"
            case Binary("*", x, y):
                return f"(qmul {algebra} {self._quaternion(x)} {self._quaternion(y)})"
            case Power(x, n) if n >= 0:
                return f"(qpow {algebra} {self._quaternion(x)} {n})"
            case Call("conj", (x,)):
                return f"(conj {self.t} {self._quaternion(x)})"
            case Call("vector", (x,)):
                return f"(vector {self._quaternion(x)})"
            case Call("comm", (x, y)):
                left, right = self._quaternion(x), self._quaternion(y)
                return f"(qsub (qmul {algebra} {left} {right}) (qmul {algebra} {right} {left}))"
        raise NotCoveredError("Lean export covers statements without division")

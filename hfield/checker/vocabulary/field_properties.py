"""Check evidence for statements about the field: division, level, orderings, moduli."""

from collections.abc import Mapping
from itertools import product
from typing import NoReturn

from hfield.checker.anisotropy import anisotropic
from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.clauses import expand
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.glossary import (
    ALL_CHOICES_OF_ROOTS,
    ANISOTROPIC_NORM,
    CHOICE_OF_ROOTS,
    CLOSED_FIELD,
    COMPLEX_ROOTS,
    EXHAUSTION,
    FIELD,
    IDENTITY,
    KULIKOV,
    LEVEL,
    ORDERING,
    REAL_ROOTS,
    SUM_OF_SQUARES,
    UNIQUE_ROOTS,
    WITNESS,
    ZERO_NORM,
)
from hfield.checker.over_field import EvaluationContext
from hfield.checker.rejection import (
    a_list,
    an_integer,
    an_object,
    keyed,
    kind_of,
    reject,
    shown,
    texts,
)
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Ring
from hfield.checker.statement import HAMILTON, QUATERNIONS, Setting, read_statement

CLOSED = {"RR": REAL_ROOTS, "CC": COMPLEX_ROOTS}
MAX_ROOTS = 8
MAX_TRIED = 256  # the largest field whose pairs of roots are all multiplied


def _field(setting: Setting) -> AnyRing:
    field = setting.field
    if field is None or not field.is_field:
        reject("this speaks of one exact field at a time")
    return field


def _evaluator(field: Ring[E]) -> Evaluator[E, bool]:
    return Evaluator(RingScalars(field), HAMILTON, {})


def _quaternion(field: Ring[E], value: object) -> Quaternion[E]:
    found = [field.read(text) for text in texts(value, "coordinates", 4)]
    if len(found) != 4:
        reject("a quaternion has four coordinates")
    return Quaternion(found)


def _unfit(kind: str, verdict: str) -> NoReturn:
    reject(f"evidence of the kind {shown(kind)!r} does not show that this is {verdict}")


def division(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that every nonzero element of H(F) is invertible, because the norm is anisotropic."""
    field, kind = _field(setting), kind_of(evidence)
    if verdict == "proved" and kind == "anisotropic":
        minus_one = field.number(-1)
        constants = (minus_one, field.zero, minus_one)
        reason = {key: x for key, x in keyed(evidence).items() if key != "kind"}
        cited = anisotropic(field, constants, reason, setting.algebra)
        return CheckResult(FIELD, ANISOTROPIC_NORM).citing(*cited)
    if verdict == "refuted" and kind == "zero norm":
        q = _quaternion(field, an_object(evidence, "kind value", "the evidence")["value"])
        if all(map(field.is_zero, q)) or not field.is_zero(_evaluator(field).norm(q)):
            reject("the element is 0, or its norm is not")
        return CheckResult(FIELD, ZERO_NORM)
    _unfit(kind, verdict)


def level(parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object) -> CheckResult:
    """Check that −1 is not a sum of a given number of squares, or of any number."""
    bound = int(parts[0]) if parts else None
    field, kind = _field(setting), kind_of(evidence)
    if verdict == "proved" and kind == "level":
        an_object(evidence, "kind", "the evidence")
        if not (field.is_ordered if bound is None else field.level_above(bound)):
            reject(f"that −1 is no sum of squares in {field.name} cannot be verified")
        return CheckResult(FIELD, LEVEL)
    if verdict == "refuted" and kind == "squares":
        data = an_object(evidence, "kind values", "the evidence")
        values = [field.read(text) for text in texts(data["values"], "values", 1)]
        total = field.zero
        for x in values:
            total = field.add(total, field.mul(x, x))
        if (bound is not None and len(values) > bound) or not field.equal(total, field.number(-1)):
            reject("the squares are too many, or do not add up to −1")
        return CheckResult(FIELD, SUM_OF_SQUARES)
    _unfit(kind, verdict)


def norm_criterion(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that q is invertible if and only if N(q) > 0 (or < 0) in the orderings of the field."""
    field, kind = _field(setting), kind_of(evidence)
    if verdict == "proved" and kind == "ordering" and parts == (">",):
        an_object(evidence, "kind", "the evidence")
        if not field.is_ordered:
            reject(f"{field.name} is not known to have an ordering")
        return CheckResult(
            FIELD, ORDERING
        )  # N(q) is a sum of squares, so it is positive wherever it is not 0
    if verdict == "refuted" and kind == "witness":
        data = an_object(evidence, "kind value norm", "the evidence")
        n = an_integer(data["norm"], "the norm")
        q = _quaternion(field, data["value"])
        if field.characteristic or not field.equal(_evaluator(field).norm(q), field.number(n)):
            reject("the norm is not that number")
        if not (n < 0 if parts == (">",) else n > 0):
            reject("the norm does not contradict the criterion")
        return CheckResult(FIELD, WITNESS)
    _unfit(kind, verdict)


def modulus_exists(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that every norm is a square in the field."""
    field, kind = _field(setting), kind_of(evidence)
    if verdict == "proved" and kind == "closed" and field.name in CLOSED:
        an_object(evidence, "kind", "the evidence")
        # In RR a sum of squares is not negative.
        return CheckResult(FIELD, CLOSED_FIELD).citing(CLOSED[field.name])
    if verdict == "proved" and kind == "identity":
        an_object(evidence, "kind", "the evidence")
        _identity("norm({q}) == ({q}[0] + {q}[1] + {q}[2] + {q}[3])**2", setting)
        return CheckResult(FIELD, IDENTITY)
    if verdict == "refuted" and kind == "no root":
        data = an_object(evidence, "kind value", "the evidence")
        if field.is_square(_evaluator(field).norm(_quaternion(field, data["value"]))):
            reject("the norm of the element is a square")
        return CheckResult(FIELD, WITNESS)
    _unfit(kind, verdict)


def _identity(form: str, setting: Setting) -> None:
    """Expand an identity in p and q, using letters that are not names of elements of the field."""
    field = _field(setting)
    free = [x for x in QUATERNIONS if field.constant(("name", x)) is None]
    if len(free) < 2:
        reject(f"too many letters name elements of {field.name}")
    text = form.format(q=free[0], p=free[1])
    expansion = expand(read_statement(text, setting), setting)
    if not all(map(EvaluationContext(expansion, setting.field).is_trivial, expansion.clauses)):
        reject(f"{text} does not hold by expanding")


def modulus_law(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that some choice of roots √n for the squares n makes √N(pq) = √N(p)·√N(q) (or the sum) hold."""
    field, kind = _field(setting), kind_of(evidence)
    if verdict == "refuted" and kind == "all choices":
        _no_choice(field, parts[0], an_object(evidence, "kind elements roots", "the evidence"))
        return CheckResult(FIELD, ALL_CHOICES_OF_ROOTS)
    if verdict != "proved" or parts != ("*",):
        _unfit(kind, verdict)
    an_object(evidence, "kind", "the evidence")
    _identity("norm({p}*{q}) == norm({p})*norm({q})", setting)
    p = field.characteristic
    if kind == "unique roots" and p == 2:
        # y² = z² means (y − z)² = 0, so the product of the roots is the root
        return CheckResult(FIELD, UNIQUE_ROOTS)
    if kind == "ordering" and field.is_ordered:
        # the roots that are not negative: their products are not negative
        return CheckResult(FIELD, ORDERING)
    if kind == "square roots" and field.order is not None and field.order % 4 == 3:
        # −1 is not a square, and the squares have index 2 in F*: one of r, −r is a square. Choose
        # that one.
        if field.order > MAX_TRIED:
            return CheckResult(FIELD, CHOICE_OF_ROOTS)
        _try_squares(field)
        return CheckResult(FIELD, EXHAUSTION)
    if kind == "pure subgroup" and field.order is None and not field.is_square(field.number(-1)):
        # {1, −1} is pure, so a complement of it contains one root of each.
        return CheckResult(FIELD, CHOICE_OF_ROOTS).citing(KULIKOV)
    _unfit(kind, verdict)


def _try_squares(field: Ring[E]) -> None:
    """Check over a finite field that each square has a square root that is itself a square, and that products
    of such roots are such roots.
    """
    spend(20 * (field.order or 0) ** 2)
    squares = {field.mul(x, x) for x in field.elements()}
    root = {field.mul(x, x): x for x in squares}
    for x, y in product(root.values(), repeat=2):
        xy = field.mul(x, y)
        if root.keys() != squares or root[field.mul(xy, xy)] != xy:
            reject("the roots that are squares do not multiply to such roots")


def _no_choice(field: Ring[E], operation: str, data: Mapping[str, object]) -> None:
    """Check that every choice of roots for the norms of certain elements violates the law."""
    evaluator = _evaluator(field)
    elements = [_quaternion(field, value) for value in a_list(data["elements"], "elements", 1)]
    roots = [field.read(text) for text in texts(data["roots"], "roots")]
    if len(roots) != len(elements) or len(roots) > MAX_ROOTS:
        reject("there is not one root for each element, or there are too many")
    known: list[tuple[E, E]] = []
    for q, root in zip(elements, roots, strict=True):
        n = evaluator.norm(q)
        if not field.equal(field.mul(root, root), n):
            reject("a root is none of the norm")
        if not any(field.equal(n, m) for m, _ in known):
            known.append((n, root))

    def place(n: E) -> int | None:
        return next((k for k, (m, _) in enumerate(known) if field.equal(n, m)), None)

    for signs in product((1, -1), repeat=len(known)):
        chosen = [r if s > 0 else field.neg(r) for s, (_, r) in zip(signs, known, strict=True)]
        for p, q in product(elements, repeat=2):
            at = [place(evaluator.norm(x)) for x in (evaluator.product(p, q), p, q)]
            if at[0] is None or at[1] is None or at[2] is None:
                continue
            x, y = chosen[at[1]], chosen[at[2]]
            other = field.mul(x, y) if operation == "*" else field.add(x, y)
            if not field.equal(chosen[at[0]], other):
                break
        else:
            reject("a choice of the roots satisfies the law for these elements")


CHECKS = {
    "division": division,
    "level-above": level,
    "formally-real": level,
    "norm-criterion": norm_criterion,
    "modulus-exists": modulus_exists,
    "modulus-law": modulus_law,
}
# What stands between the braces of each word.
FORMS = {
    "division": "",
    "level-above": "[0-9]{1,5}",
    "formally-real": "",
    "norm-criterion": "[<>]",
    "modulus-exists": "",
    "modulus-law": "[*+]",
}

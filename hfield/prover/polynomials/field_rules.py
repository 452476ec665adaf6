"""Rules: properties of a field that help to prove implications over it.

Each rule says that a quadratic form is anisotropic, so that all its arguments are 0 if its value is 0. The
reasons come from the ring and from ``zero_norms``; the evidence contains them with the rule.
"""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as a_field
from functools import lru_cache

from hfield.core.product import Constants
from hfield.errors import HFieldError, UndecidedError
from hfield.fields.base.powers import power
from hfield.fields.base.ring import INFINITY, Ring, WithIntegers
from hfield.prover.statements.setting import Setting, read_setting
from hfield.prover.steps import say
from hfield.syntax import Call, Number, parse

NORM, SQUARES, ROOTS = "norm", "squares", "roots"
MAX_ROOT = 12
EXHAUSTED = 1_000  # elements of a field in which all cases are tried rather


@dataclass(frozen=True)
class Rule:
    """An anisotropic form: the norm, or any sum of up to ``most`` squares.

    With the form ``roots`` the rule says instead that factoring finds all roots in the field. ``positive``
    means that the squares may have positive rational coefficients, as in an ordered field. ``reason`` is an
    explanation in words, ``by`` its kind as one word, ``assumes`` the theorems it cites, and ``data`` the
    proof data of a norm form.
    """

    form: str
    reason: str
    most: float = INFINITY
    positive: bool = False
    assumes: tuple[str, ...] = ()
    by: str = ""
    algebra: str = ""  # the algebra of the norm, if it is not the algebra of the statement
    data: Mapping[str, object] | None = a_field(default=None, compare=False)

    @property
    def fact(self) -> str:
        """The fact that the rule states, in words."""
        if self.form == ROOTS:
            return self.reason
        name = "norm-zero-of" if self.algebra else f"{self.form}-zero"
        return say(name, A=self.algebra, reason=self.reason)

    @property
    def evidence(self) -> Mapping[str, object]:
        """The rule as JSON data."""
        if self.data is not None:
            own = {"algebra": self.algebra} if self.algebra else {}
            return {"form": self.form, **own, **self.data}
        out: dict[str, object] = {"form": self.form, "by": self.by}
        if self.form == SQUARES:
            out["most"] = None if self.most == INFINITY else int(self.most)
            out["positive"] = self.positive
        return out


@lru_cache(maxsize=256)
def rules(setting: Setting) -> tuple[Rule, ...]:
    """Return the rules that hold over the field, for the algebra if its constants are known."""
    field = setting.field
    if field is None or not field.is_field or not field.is_exact:
        return ()
    out = []
    if not setting.letters:
        with suppress(UndecidedError):
            found = _norm_rule(setting, field, structure_constants(setting))
            if found is not None:
                out.append(found)
    roots = _roots_rule(field)
    if roots is not None:
        out.append(roots)
    level = field.level
    if field.characteristic == 2 or level.value is None or level.value < 2:
        return tuple(out)
    if level.value == INFINITY:
        positive = field.characteristic == 0
        reason = say("ordered", reason=level.reason)
        out.append(Rule(SQUARES, reason, positive=positive, by="ordering"))
    else:
        reason = say("level", F=field.name, n=level.value, reason=level.reason)
        out.append(Rule(SQUARES, reason, most=level.value, by="level"))
    return tuple(out)


def _roots_rule(field: Ring) -> Rule | None:
    if isinstance(field, WithIntegers) and field.degree == 1:
        reason = say("rational-root")
        return Rule(ROOTS, reason, by="factors")
    if field.characteristic == 2 or (field.order is not None and field.order <= EXHAUSTED):
        return None
    try:
        field.sqrt(field(2))
    except UndecidedError:
        return None
    reason = say("quadratic-root", F=field.name)
    return Rule(ROOTS, reason, most=2, by="squares")


@lru_cache(maxsize=256)
def norm_rule_of(field: Ring, a: str, b: str) -> Rule | None:
    """Return the rule that the norm of (a, b) over the field is anisotropic, if that is known."""
    setting = read_setting(field, f"({a},{b}|{field.name})")
    try:
        found = _norm_rule(setting, field, structure_constants(setting))
    except HFieldError:
        return None
    return None if found is None else replace(found, algebra=setting.symbol)


def unused_norm(setting: Setting) -> str | None:
    """Return why there is no rule about the norm, although it is or may be anisotropic."""
    field = setting.field
    if field is None or setting.letters or not (field.is_field and field.is_exact):
        return None
    try:
        _norm_rule(setting, field, structure_constants(setting))
    except UndecidedError as error:
        return str(error)
    return None


def _norm_rule(setting: Setting, field: Ring, c: Constants) -> Rule | None:
    """Return the rule, or None if the norm has a nontrivial zero. Raises :class:`UndecidedError`."""
    from hfield.checker.anisotropy import is_readable
    from hfield.fields.quadratic_forms.norm_forms.zero_norms import norm_evidence, zero_norm

    if field.order is not None:  # over a finite field every norm form has zeros
        return None
    answer = zero_norm(field, c)
    if answer.element is not None:
        return None
    data = norm_evidence(setting.symbol, field, c, answer)
    if data is None and not is_readable(setting.symbol, field.data):
        data = {"by": answer.method}  # the answer is kept, but has no certificate
    if data is None:
        raise UndecidedError(
            f"the norm of {setting.symbol} is 0 only at 0 ({answer.reason}), but not by a reason that a "
            "certificate can carry"
        )
    return Rule(NORM, answer.reason, by=answer.method, data=data)


@lru_cache(maxsize=256)
def structure_constants(setting: Setting) -> Constants:
    """Return ``(a, t, b)`` as elements of the field; they must not contain letters."""
    assert setting.field is not None
    return Constants(*(setting.field(text) for text in setting.constants))


@lru_cache(maxsize=256)
def relation(field: Ring, text: str) -> tuple[int, ...] | None:
    """Return integers ``(c0, c1, …)`` with Σ cₙ·gⁿ = 0 for the constant g with that text, if known.

    For the generator of a finite field this is the modulus; for a root of a rational number, the power.
    """
    modulus = getattr(field, "coefficients", None)
    if field.order is not None and modulus is not None and text == field.gen_name:
        return tuple(int(c) for c in modulus)
    if field.characteristic == 0:
        degree = _root_degree(text)
        try:
            top, _, bottom = field.text(power(field.one, field(text), degree)).partition("/")
            return (-int(top), *[0] * (degree - 1), int(bottom or 1))
        except (HFieldError, ValueError):
            return None
    return None


def _root_degree(text: str) -> int:
    """Return n for the text of an n-th root, and 2 for other constants, which may be square roots."""
    match parse(text):
        case Call("cbrt", _):
            return 3
        case Call("root", (_, Number(int(n)))) if 1 <= n <= MAX_ROOT:
            return n
    return 2

"""F(cos(t), sin(t), …) by half-angle tangents τ: cos(t) = (1 − τ²)/(1 + τ²), sin(t) = 2τ/(1 + τ²).

Several angles, and other variables, are function fields over function fields, one variable after another.
"""

import re
from collections.abc import Hashable, Mapping
from fractions import Fraction

from hfield.checker.language import Tree
from hfield.checker.rejection import a_list, a_text, an_integer, reject, shown
from hfield.checker.scalars.functions import Fraction as Quotient
from hfield.checker.scalars.functions import Functions, need_constants
from hfield.checker.scalars.names import blackboard, plain, variables
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing

MAX_ANGLES = 4
MAX_MULTIPLE = 40


Element = Quotient[Hashable]


class Circles(Functions[Hashable]):
    """The rational functions in ``names`` and in the half-angle tangents of t/n, for pairs (t, n)."""

    def __init__(
        self, base: AnyRing, angles: list[tuple[str, int]], names: tuple[str, ...]
    ) -> None:
        tangents = [f"tan({_angle_text(t, 2 * n)})" for t, n in angles]
        field = base
        *first, last = (*names, *tangents)
        for name in first:
            field = Functions(field, name)
        super().__init__(field, last)
        pairs = [f"{f}({_angle_text(*a)})" for a in angles for f in ("cos", "sin")]
        self.name = f"{base.name}({','.join((*names, *pairs))})"
        *most, end = (*names, *pairs)
        self.words = (
            f"rational functions in {', '.join(most)} and {end} over {blackboard(base.name)}"
        )
        variables = {
            t: super(Circles, self).constant(("name", name))
            for (t, _), name in zip(angles, tangents, strict=True)
        }
        self.tangents = {t: x for t, x in variables.items() if x is not None}
        self.angles = dict(angles)

    def constant(self, tree: Tree) -> Element | None:
        """Return a variable, or cos, sin or tan of a sum of multiples of angles and of right angles."""
        if tree[0] == "name":
            return super().constant(tree) if "tan(" not in tree[1] else None
        if tree[0] != "call" or tree[1] not in ("cos", "sin", "tan") or len(tree[2]) != 1:
            return super().constant(tree)
        angle = _angle(tree[2][0])
        if angle is None or any(t not in self.angles and t != "pi" for t in angle):
            return None
        turn = angle.pop("pi", Fraction(0)) * 2
        double = 2 if tree[1] != "tan" or turn else 1
        counts = {t: c * self.angles[t] * 2 / double for t, c in angle.items()}
        if any(c.denominator != 1 for c in (*counts.values(), turn)):
            return None
        if sum(map(abs, counts.values())) > MAX_MULTIPLE:
            reject(f"an angle has more than {MAX_MULTIPLE} times the angles of {self.name}")
        x, y = self._turned(counts)
        if double == 1:
            return self._quotient(y, x)
        scale = self.need_inverse(self.add(self.mul(x, x), self.mul(y, y)))
        cosine = self.mul(self.add(self.mul(x, x), self.neg(self.mul(y, y))), scale)
        sine = self.mul(self.mul(self.number(2), self.mul(x, y)), scale)
        for _ in range(int(turn) % 4):
            cosine, sine = self.neg(sine), cosine
        if tree[1] == "tan":
            return self._quotient(sine, cosine)
        return cosine if tree[1] == "cos" else sine

    def _turned(self, counts: Mapping[str, Fraction]) -> tuple[Element, Element]:
        """Return the real and imaginary parts of the product of (1 ± τ·I) to the powers in ``counts``."""
        x, y = self.one, self.zero
        for t, count in counts.items():
            tangent = self.tangents[t]
            step = tangent if count > 0 else self.neg(tangent)
            for _ in range(abs(int(count))):
                x, y = (
                    self.add(x, self.neg(self.mul(y, step))),
                    self.add(self.mul(x, step), y),
                )
        return x, y

    def _quotient(self, x: Element, y: Element) -> Element | None:
        below = self.inverse(y)
        return None if below is None else self.mul(x, below)


def _angle(tree: Tree) -> dict[str, Fraction] | None:
    """Return the coefficients in a linear combination of names, or None for anything else."""
    if tree[0] == "name":
        return {tree[1]: Fraction(1)}
    if tree[0] == "neg":
        return _scaled(_angle(tree[1]), Fraction(-1))
    if tree[0] in ("+", "-"):
        x, y = _angle(tree[1]), _scaled(_angle(tree[2]), Fraction(1 if tree[0] == "+" else -1))
        if x is None or y is None:
            return None
        return {t: x.get(t, Fraction(0)) + y.get(t, Fraction(0)) for t in {**x, **y}}
    if tree[0] == "*":
        for factor, rest in ((tree[1], tree[2]), (tree[2], tree[1])):
            if (c := _number(factor)) is not None:
                return _scaled(_angle(rest), c)
    if tree[0] == "/":
        c = _number(tree[2])
        return _scaled(_angle(tree[1]), 1 / c) if c else None
    return None


def _number(tree: Tree) -> Fraction | None:
    """Return a rational number, as a quotient of literals, or None."""
    if tree[0] == "num":
        return Fraction(tree[1])
    if tree[0] == "/" and tree[1][0] == tree[2][0] == "num" and tree[2][1]:
        return Fraction(tree[1][1]) / Fraction(tree[2][1])
    return None


def _scaled(x: dict[str, Fraction] | None, c: Fraction) -> dict[str, Fraction] | None:
    return None if x is None else {t: c * y for t, y in x.items()}


def _angle_text(t: str, parts: int) -> str:
    return t if parts == 1 else f"{t}/{parts}"


def _circles(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    own = plain(data, "base angles variables")
    base = ring(own["base"])
    need_constants(base)
    if base.characteristic == 2:
        reject(f"functions on circles are not over {shown(base.name)}")
    angles = []
    for pair in a_list(own["angles"], "angles", 1):
        t, n = a_list(pair, "an angle", 2)
        angles.append((a_text(t, "an angle", 100), an_integer(n, "what an angle is divided by", 1)))
    names = a_list(own["variables"], "variables", 0)
    found = variables([*names, *(t for t, _ in angles)], base)
    if any(re.fullmatch("pi", t) for t, _ in angles) or len(found) > MAX_ANGLES + len(names):
        reject(f"at most {MAX_ANGLES} angles are known here, none of them pi")
    return Circles(base, angles, found[: len(names)])


KINDS: dict[str, Kind] = {"circle functions": _circles}

"""Section 3.3: the shape of the top.

Points of space are the coordinates 1, 2, 3 of quaternions. The polygons of :class:`anim.model.Model` are
counted.
"""

from collections import Counter
from dataclasses import dataclass
from itertools import pairwise

from anim.ledger.counting import model_has
from hfield.checker.glossary import CIRCLE, NO_MEANING
from hfield.fields.base.ring import Ring
from hfield.ledger.claim import Computed, ComputedResult, Proposition
from hfield.ledger.document import Propositions
from hfield.ledger.propositions import Assertion, Every
from hfield.ledger.real_geometry import REAL
from hfield.ledger.scopes import OnlyOver
from hfield.prover.decision import NOT_APPLICABLE, Decision


def cone(apex: str, radius2: str, height: str, base: str = "", name: str = "") -> Every:
    """Return the claim that the lines from (0, 0, apex) to a circle about the z axis form a cone about it.

    ``radius2`` is the square of the circle's radius, and ``height`` its z; ``base`` replaces ``radius2`` in
    the equation if given; ``name`` is the name of the circle. The cone is (height − apex)²·(x² + y²) =
    radius2·(z − apex)²: it contains the circle, and for each point of the circle the line to the apex.
    """

    def on_cone(x: str, y: str, z: str) -> str:
        return f"({height} - {apex})**2*(({x})**2 + ({y})**2) == {radius2}*({z})**2"

    here = on_cone("p[1]", "p[2]", f"p[3] - {apex}")
    line = on_cone("s*p[1]", "s*p[2]", f"s*(p[3] - {apex})")
    circle = f"p[1]**2 + p[2]**2 == {base or radius2}"
    through = f"p[3] == {height} => not ({circle}) or {here}"
    words = f"the lines from (0, 0, {apex}) to {name} lie on a cone about the z axis"
    return Every((Assertion(through), Assertion(f"{here} => {line}")), words if name else "")


@dataclass(frozen=True)
class Dividing:
    """A proposition with numbers that are defined only if the ``primes`` are nonzero."""

    proposition: Proposition
    primes: tuple[int, ...]
    reason: str

    @property
    def text(self) -> str:
        """The proposition itself."""
        return self.proposition.text

    @property
    def statement(self) -> str:
        """The proposition in the vocabulary of certificates."""
        return self.proposition.statement

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition where the numbers are defined."""
        if field is not None and field.characteristic in self.primes:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(self.reason,))
        return self.proposition.decide(field)


def second_cone(base: str = "") -> Dividing:
    """The same claim for P2, whose height and radius are fractions."""
    whole = cone("3", "(1/3)**3", "11/10", base, "" if base else "P2")
    return Dividing(whole, (2, 3, 5), "Where 2, 3 or 5 is 0, there are no 1/3 and 11/10.")


# cos(π/n) = y is the distance from the axis to the middle of a side of the polygon in P₁, and z is
# this distance for twice as many points. y and 1 − y are squares, and 1 − y is not 0, because n is
# at least 2.
HALVED = ("2*z**2 == 1 + y", "y == q[0]**2", "1 - y == q[1]**2")
GAP = "(q[1]**2 + 2*(q[0]*q[1])**2)"
POLYGONS = "Inscribed polygons of the real circle are meant."


def nearer(sign: str) -> OnlyOver:
    """Return the claim that z² − y² is GAP/2, and that no norm is GAP (or −GAP, with ``sign`` "-"), so that
    this number is negative.
    """
    parts = (
        Assertion(f"2*(z**2 - y**2) == {GAP}", HALVED),
        Assertion(f"norm(p) != {sign}{GAP}", ("q[1] != 0",)),
    )
    return OnlyOver(Every(parts), (REAL,), POLYGONS, (CIRCLE,))


def closed(band: bool) -> Computed:
    """Return the claim that the two cones, with or without the connecting band, form one closed surface.

    A surface is closed if each edge of a polygon is an edge of exactly one other polygon, in the opposite
    direction.
    """

    def check_claim() -> ComputedResult:
        from anim.model import Model

        model = Model()
        parts = (model.lower, model.upper, *((model.sides,) if band else ()))
        polygons = [tuple(p) for part in parts for p in part.tolist()]
        sides = Counter(side for p in polygons for side in pairwise((*p, p[0])))
        alone = [(a, b) for a, b in sides if sides[a, b] != 1 or sides[b, a] != 1]
        bulge = len(model.points) - len(sides) // 2 + len(polygons)
        steps = (
            f"{len(polygons)} polygons, {len(alone)} of their sides without a partner",
            f"corners − edges + polygons = {bulge}",
        )
        return ComputedResult(not alone and bulge == 2, steps, {"sides": [str(len(alone))]})

    joined = "with their bases joined point by point" if band else "not joined"
    return Computed(f"the two cones, {joined}, make one closed surface", check_claim)


def corners(allowed: tuple[int, ...]) -> Computed:
    """Return the claim that every polygon has one of these numbers of corners, and each number occurs."""

    def check_claim() -> ComputedResult:
        from anim.model import Model

        found = Counter(map(len, Model(ring=10).polygons))
        steps = tuple(f"{n} polygons with {size} corners" for size, n in sorted(found.items()))
        return ComputedResult(
            set(found) == set(allowed), steps, {"corners": [*map(str, sorted(found))]}
        )

    return Computed(f"the polygons have {' and '.join(map(str, allowed))} corners", check_claim)


COMPUTED = {
    "C3.3-b": Propositions(as_printed=second_cone(), spoilt=second_cone("(1/3)**2")),
    "C3.3-c": Propositions(as_printed=nearer("-"), spoilt=nearer("")),
    "C3.3-d": Propositions(as_printed=closed(band=True), spoilt=closed(band=False)),
    "C3.3-e": Propositions(
        as_printed=model_has(30, "polygons", ring=10), spoilt=model_has(30, "polygons", ring=5)
    ),
    "C3.3-g": Propositions(as_printed=corners((3, 4)), spoilt=corners((3,))),
    "C3.3-j": Propositions(
        as_printed=model_has(2002, "points", ring=500),
        spoilt=model_has(2002, "points"),
        corrected=model_has(2002, "points"),
    ),
    "C3.3-k": Propositions(
        as_printed=model_has(6000, "polygons"),
        spoilt=model_has(3000, "polygons"),
        corrected=model_has(3000, "polygons"),
    ),
}

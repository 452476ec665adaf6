"""What the items of one implication share: the statement expanded, the field, the rules that hold there."""

from hfield.certificates.clauses import Expansion, freeze
from hfield.certificates.over_field import Place
from hfield.certificates.polynomials import Poly, variables
from hfield.certificates.rules import Rules
from hfield.certificates.statement import Setting


class Context:
    """The expansion, the field (None: all of them) and its rules, verified."""

    def __init__(self, expansion: Expansion, setting: Setting, facts: object) -> None:
        self.names, self.ring = expansion.names, setting.field
        self.unknowns = expansion.unknowns
        self.place = Place(expansion, self.ring)
        self.rules = Rules(expansion, setting, self.place, facts)

    @property
    def characteristic(self) -> int:
        """The characteristic of the field named; 0 for all fields."""
        return 0 if self.ring is None else self.ring.characteristic

    def vanishes_by_constants(self, f: Poly) -> bool:
        """Tell whether f is a polynomial in the constants of the field, and 0 there."""
        return self._is_in_constants(f) and self.place.vanishes(f)

    def is_nonzero_constant(self, f: Poly) -> bool:
        """Tell whether f is a polynomial in the constants of the field, and not 0 there."""
        return self._is_in_constants(f) and self.place.is_nonzero(freeze(f))

    def _is_in_constants(self, f: Poly) -> bool:
        return self.ring is not None and all(v >= self.unknowns for v in variables(f))

"""Claims of linear algebra: the centre, over one field and over all; whether vectors are a basis."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

from hfield.algebra import structure
from hfield.checker.glossary import (
    COUNT,
    DETERMINANT,
    LINEAR_ALGEBRA,
    PROVED,
    REFUTED,
    SMITH_FORM,
)
from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Coordinates, multiply
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.ledger.base_field import hamilton, texts
from hfield.ledger.claim import TemplateProposition
from hfield.notation import element_text
from hfield.prover.decision import FIELDS, Decision
from hfield.prover.steps import say


@dataclass(frozen=True)
class Centre(TemplateProposition):
    """The claim that the centre of H(F) is H(F) in characteristic ``special``, and F·e in every other."""

    special: int = 2

    in_words = "the centre of H(F) is H(F) if char F = {special}, and F·e if not"
    in_certificates = "centre{{{special}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Solve q·i = i·q, q·j = j·q by linear algebra in the field; over ℤ, by the Smith form."""
        if field is None:
            return self._everywhere()
        basis = structure.centre(field, hamilton(field))
        names = ", ".join(element_text(field, q, "unicode", "e") for q in basis)
        whole = field.characteristic == self.special
        right = len(basis) == 4 if whole else len(basis) == 1 and field.is_unit(basis[0][0])
        steps = (say("centre-solved", F=field, n=len(basis), basis=names),)
        witness = None if right else {f"c{n}": texts(field, q) for n, q in enumerate(basis, 1)}
        return Decision(
            PROVED if right else REFUTED,
            LINEAR_ALGEBRA,
            witness=witness,
            steps=steps,
            evidence=_minor(centre_equations()) if right else None,
        )

    def _everywhere(self) -> Decision:
        from flint import fmpz_mat

        rows = centre_equations()
        smith = fmpz_mat(rows).snf()
        divisors = [int(smith[n, n]) for n in range(4) if smith[n, n] != 0]
        special = sorted({p for d in divisors for p in factorise(abs(d))})
        dimension = {p: 4 - sum(1 for d in divisors if d % p) for p in special}
        dimensions = [say("centre-dimension", p=p, n=n) for p, n in dimension.items()]
        steps = (
            say("centre-divisors", list=", ".join(map(str, divisors))),
            say(
                "centre-is",
                list=", ".join(map(str, special)),
                rest=dimensions[0] if len(dimensions) == 1 else ", ".join(dimensions),
            ),
        )
        right = len(divisors) == 3 and special == [self.special] and dimension[self.special] == 4
        witness = None if right else {"F": [f"GF({special[0] if special else 2})"]}
        return Decision(
            PROVED if right else REFUTED,
            SMITH_FORM,
            witness=witness,
            steps=steps,
            scope=FIELDS,
            evidence=_minor(rows) if right else None,
        )


def centre_equations() -> list[list[int]]:
    """Return the coefficients of q·i = i·q and q·j = j·q over ℤ: eight rows, one column per coordinate."""
    c = Constants(-1, 0, -1)
    units: list[Coordinates] = [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)]
    rows = []
    for g in units[1:3]:
        images = [
            [x - y for x, y in zip(multiply(c, q, g), multiply(c, g, q), strict=True)]
            for q in units
        ]
        rows += [list(column) for column in zip(*images, strict=True)]
    return rows


def _minor(rows: list[list[int]]) -> Evidence:
    """Return, as evidence, three rows whose minor in the columns of i, j, k is nonzero."""
    from flint import fmpz_mat

    columns = [1, 2, 3]
    for chosen in combinations(range(len(rows)), 3):
        if fmpz_mat([[rows[r][c] for c in columns] for r in chosen]).det() != 0:
            return Evidence(Kind.MINOR, rows=list(chosen), columns=columns)
    raise AssertionError("the equations for the centre have rank 3 over the rationals")


@dataclass(frozen=True)
class IsBasis:
    """The claim that the listed vectors are a basis of the free module of rank ``dimension``."""

    vectors: tuple[tuple[int, ...], ...]
    dimension: int
    words: str

    @property
    def text(self) -> str:
        """The claim in words."""
        return f"{self.words} is a basis"

    @property
    def statement(self) -> str:
        """The claim in the vocabulary of certificates."""
        return f"basis{{{'; '.join((str(self.dimension), *(','.join(map(str, v)) for v in self.vectors)))}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Count the vectors and their coordinates, then take the determinant over ℤ."""
        lengths = {len(v) for v in self.vectors}
        if lengths != {self.dimension} or len(self.vectors) != self.dimension:
            listed = ", ".join(map(str, sorted(lengths)))
            step = say("not-enough", n=len(self.vectors), m=listed, d=self.dimension)
            last = [str(int(n == self.dimension - 1)) for n in range(self.dimension)]
            return Decision(
                REFUTED,
                COUNT,
                witness={"missing": last},
                steps=(step,),
                evidence=Evidence(Kind.COUNT),
            )
        from flint import fmpz_mat

        det = int(fmpz_mat([list(v) for v in self.vectors]).det())
        unit = abs(det) == 1 if field is None else field.is_unit(field(det))
        step = say("determinant-unit" if unit else "determinant-none", d=det)
        return Decision(
            PROVED if unit else REFUTED,
            DETERMINANT,
            steps=(step,),
            evidence=Evidence(Kind.DETERMINANT),
        )

"""Whether some vectors are a basis: how many they are, and their determinant."""

from dataclasses import dataclass

from hfield.certificates.glossary import COUNT, DETERMINANT, PROVED, REFUTED
from hfield.evidence import Evidence, Kind
from hfield.proving.decision import Decision
from hfield.proving.steps import say
from hfield.rings.base import Ring


@dataclass(frozen=True)
class IsBasis:
    """The vectors listed are a basis of the free module of rank ``dimension``."""

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

"""The errors of hfield. Each message says what was wrong, what was expected and how to fix it."""

MAX_MESSAGE = 1000  # characters of a message that are shown


class HFieldError(Exception):
    """The base class of all errors of this package; the command line prints them on one line.

    A message that quotes a very long input is shortened.

    >>> from hfield import GF, errors
    >>> try:
    ...     GF(6)
    ... except errors.HFieldError as error:
    ...     print(type(error).__name__)
    RingError
    """

    def __str__(self) -> str:
        return shorten(super().__str__(), MAX_MESSAGE)


class NotationError(HFieldError, ValueError):
    """A text cannot be read; ``position`` is the offset of the first wrong character.

    ``reason`` is the message without the position.

    >>> from hfield import prove
    >>> try:
    ...     prove("p*(q == q")
    ... except NotationError as error:
    ...     print(error.position)
    9
    """

    def __init__(self, message: str, text: str = "", position: int | None = None) -> None:
        self.reason, self.text, self.position = message, text, position
        where = "" if position is None else f" (at character {position + 1} of {shorten(text)!r})"
        super().__init__(message + where)


class RingError(HFieldError, ValueError):
    """A base ring that does not exist or cannot be built, such as GF(6).

    >>> from hfield import GF
    >>> try:
    ...     GF(6)
    ... except RingError:
    ...     print("no field of 6 elements")
    no field of 6 elements
    """


class CoercionError(HFieldError, TypeError):
    """A value that is not an element of the expected ring or algebra.

    >>> from hfield import H
    >>> try:
    ...     H("QQ")(0.5j)
    ... except CoercionError:
    ...     print("no rational number")
    no rational number
    """


class MixedParentsError(HFieldError, TypeError):
    """Two elements of different algebras in one operation.

    >>> from hfield import GF, H
    >>> try:
    ...     H("QQ")(1) + H(GF(3))(1)
    ... except MixedParentsError:
    ...     print("two algebras")
    two algebras
    """


class NotInvertibleError(HFieldError, ZeroDivisionError):
    """A division by zero, by a zero divisor or by another non-unit.

    >>> from hfield import GF, H
    >>> try:
    ...     1 / H(GF(2))(1, 1, 0, 0)
    ... except NotInvertibleError:
    ...     print("no inverse")
    no inverse
    """


class NotFiniteError(HFieldError, TypeError):
    """An enumeration of an infinite ring or algebra.

    >>> from hfield import H
    >>> try:
    ...     H("QQ").count()
    ... except NotFiniteError:
    ...     print("infinite")
    infinite
    """


class LatticeError(HFieldError, ValueError):
    """A value that is not a lattice, order or ideal, or not one of the required kind.

    >>> issubclass(LatticeError, ValueError)
    True
    """


class IndefiniteError(LatticeError, NotFiniteError):
    """The algebra is indefinite, and the method is for definite algebras.

    >>> issubclass(IndefiniteError, LatticeError)
    True
    """


class UndecidedError(HFieldError, ArithmeticError):
    """No decision procedure applies; the message lists the methods that were tried.

    >>> issubclass(UndecidedError, ArithmeticError)
    True
    """


class AbsentError(UndecidedError, AttributeError):
    """An attribute that other objects of the class have but this one lacks, such as a generator.

    It is an AttributeError, so that ``getattr`` with a default and ``hasattr`` work.

    >>> from hfield import QQ
    >>> getattr(QQ, "gen", None), hasattr(QQ, "gen")
    (None, False)
    """


class NoSolutionError(HFieldError, ValueError):
    """A question that is proved to have no solution.

    For linear equations ``witness`` is a vector that proves it.

    >>> NoSolutionError("none", (1,)).witness
    (1,)
    """

    def __init__(self, message: str, witness: tuple[object, ...] = ()) -> None:
        super().__init__(message)
        self.witness = witness


class NoEquivalentIdealError(NoSolutionError, UndecidedError):
    """No equivalent ideal has an allowed norm: all elements that could give one were tried.

    It is a subclass of :class:`UndecidedError`, which is raised if not all elements were tried, so that
    ``except UndecidedError`` catches both.

    >>> from hfield import QuaternionAlgebra
    >>> I = QuaternionAlgebra(419).extremal_order().random_ideal(1009, seed=1)
    >>> try:
    ...     I.equivalent_of_norm_dividing(7)
    ... except NoEquivalentIdealError:
    ...     print("proved: none")
    proved: none
    """


class TableError(HFieldError, ValueError):
    """A file that is not a table of numbers; the message names the file and the line.

    >>> issubclass(TableError, ValueError)
    True
    """


class TooLargeError(HFieldError, ValueError):
    """A computation refused in advance, because it would take too much time or memory.

    >>> issubclass(TooLargeError, ValueError)
    True
    """


def shorten(text: object, limit: int = 60) -> str:
    """Return ``str(text)``, with its middle omitted if it is longer than ``limit`` characters."""
    if isinstance(text, int) and text.bit_length() > 10_000:  # Python refuses to write it
        return f"a number of {text.bit_length()} bits"
    s = str(text)
    half = (limit - 1) // 2
    return s if len(s) <= limit else f"{s[:half]}…{s[-half:]}"

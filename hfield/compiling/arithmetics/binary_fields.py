"""GF(2^k), k ≤ 64: sums are exclusive ors; products are carry-less and reduced once at the end.

A number is the polynomial over GF(2) with the bits of its label. Small fields multiply bit by bit, for many
numbers at a time. Large fields use the processor's carry-less multiplication if available. Otherwise they use
integer products of words in which three of four bits are 0, so that no carry reaches the next used bit (as in
T. Pornin's BearSSL). They reduce by two more products (Barrett).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import NamedTuple

from hfield.compiling.arithmetic import Arithmetic, unsigned
from hfield.compiling.instructions import Code, raw_type, vector

BITWISE_UP_TO = 8  # beyond, a product in one instruction is quicker
HOLES = 0x1111111111111111
_PAIR = vector("i64", 2)


class BinaryPolynomial(NamedTuple):
    """A value of the loop, with an upper bound for its degree."""

    name: str
    degree: int


@dataclass(frozen=True)
class _BinaryField(Arithmetic[BinaryPolynomial]):
    """The field GF(2^k), given by the irreducible polynomial with the bits of ``modulus``."""

    modulus: int

    @property
    def degree(self) -> int:
        """The degree k of the field."""
        return self.modulus.bit_length() - 1

    @property
    def dtype(self) -> str:
        """The smallest unsigned integer type with k bits."""
        return unsigned((1 << self.degree) - 1)

    def negate(self, code: Code, x: BinaryPolynomial) -> BinaryPolynomial:
        """Return −x = x."""
        return x

    def _sum(
        self, code: Code, kind: str, x: BinaryPolynomial, y: BinaryPolynomial
    ) -> BinaryPolynomial:
        return BinaryPolynomial(
            code.value(f"xor {kind} {x.name}, {y.name}"), max(x.degree, y.degree)
        )


@dataclass(frozen=True)
class SmallBinaryField(_BinaryField):
    """GF(2^k), k ≤ 32, computed bit by bit in words of at least 2k bits."""

    @property
    def word(self) -> str:
        """LLVM's name of the integer type for unreduced products."""
        return f"i{max(16, 2 * 8 * int(self.dtype[1]))}"

    def load(self, code: Code, raw: str) -> BinaryPolynomial:
        """Read a label."""
        kind = raw_type(self.dtype)
        return BinaryPolynomial(code.value(f"zext {kind} {raw} to {self.word}"), self.degree - 1)

    def store(self, code: Code, x: BinaryPolynomial) -> str:
        """Reduce and write."""
        name = self._reduced(code, x).name
        return code.value(f"trunc {self.word} {name} to {raw_type(self.dtype)}")

    def constant(self, code: Code, value: int) -> BinaryPolynomial:
        """Return the element with a label."""
        return BinaryPolynomial(str(value), max(0, value.bit_length() - 1))

    def add(self, code: Code, x: BinaryPolynomial, y: BinaryPolynomial) -> BinaryPolynomial:
        """Return x + y."""
        return self._sum(code, self.word, x, y)

    subtract = add

    def multiply(self, code: Code, x: BinaryPolynomial, y: BinaryPolynomial) -> BinaryPolynomial:
        """Return x·y unreduced: the sum of x·t^n over the bits n of y."""
        x, y = self._reduced(code, x), self._reduced(code, y)
        parts = []
        for n in range(y.degree + 1):
            shifted = code.value(f"shl {self.word} {x.name}, {n}") if n else x.name
            parts.append(code.value(f"and {self.word} {shifted}, {self._spread(code, y, n)}"))
        total = reduce(lambda s, part: code.value(f"xor {self.word} {s}, {part}"), parts)
        return BinaryPolynomial(total, x.degree + y.degree)

    def _spread(self, code: Code, x: BinaryPolynomial, n: int) -> str:
        """Return a word with bit n of x in every bit."""
        bits = int(self.word[1:])
        top = code.value(f"shl {self.word} {x.name}, {bits - 1 - n}")
        return code.value(f"ashr {self.word} {top}, {bits - 1}")

    def _reduced(self, code: Code, x: BinaryPolynomial) -> BinaryPolynomial:
        while x.degree >= self.degree:
            multiple = self.modulus << (x.degree - self.degree)
            taken = code.value(f"and {self.word} {self._spread(code, x, x.degree)}, {multiple}")
            x = BinaryPolynomial(code.value(f"xor {self.word} {x.name}, {taken}"), x.degree - 1)
        return x


@dataclass(frozen=True)
class LargeBinaryField(_BinaryField):
    """GF(2^k), k ≤ 64, by carry-less products of words; an unreduced number is a pair of words."""

    instruction: bool  # whether the processor multiplies without carry

    vectorise = False

    def load(self, code: Code, raw: str) -> BinaryPolynomial:
        """Read a label."""
        kind = raw_type(self.dtype)
        wide = raw if kind == "i64" else code.value(f"zext {kind} {raw} to i64")
        pair = code.value(f"insertelement {_PAIR} zeroinitializer, i64 {wide}, i32 0")
        return BinaryPolynomial(pair, self.degree - 1)

    def store(self, code: Code, x: BinaryPolynomial) -> str:
        """Reduce and write."""
        low = self._low(code, self._reduced(code, x).name)
        kind = raw_type(self.dtype)
        return low if kind == "i64" else code.value(f"trunc i64 {low} to {kind}")

    def constant(self, code: Code, value: int) -> BinaryPolynomial:
        """Return the element with a label."""
        return BinaryPolynomial(self._pair(value), max(0, value.bit_length() - 1))

    def add(self, code: Code, x: BinaryPolynomial, y: BinaryPolynomial) -> BinaryPolynomial:
        """Return x + y."""
        return self._sum(code, _PAIR, x, y)

    subtract = add

    def multiply(self, code: Code, x: BinaryPolynomial, y: BinaryPolynomial) -> BinaryPolynomial:
        """Return x·y unreduced."""
        x, y = self._reduced(code, x), self._reduced(code, y)
        return BinaryPolynomial(self._carryless(code, x.name, y.name), x.degree + y.degree)

    def _reduced(self, code: Code, x: BinaryPolynomial) -> BinaryPolynomial:
        """Subtract the modulus f times ⌊⌊x/t^k⌋·⌊t^2k/f⌋/t^k⌋, the quotient of x by f."""
        if x.degree < self.degree:
            return x
        k, f = self.degree, self.modulus
        top = self._shifted(code, x.name)
        inverse = _quotient(1 << 2 * k, f)
        if (
            k == 64
        ):  # the leading bits of both, which do not fit into a word, represent a known product
            quotient = self._shifted(
                code, self._carryless(code, top, self._pair(inverse - (1 << 64)))
            )
            quotient = code.value(f"xor {_PAIR} {quotient}, {top}")
            taken = self._carryless(code, quotient, self._pair(f - (1 << 64)))
        else:
            quotient = self._shifted(code, self._carryless(code, top, self._pair(inverse)))
            taken = self._carryless(code, quotient, self._pair(f))
        return BinaryPolynomial(code.value(f"xor {_PAIR} {x.name}, {taken}"), k - 1)

    def _shifted(self, code: Code, x: str) -> str:
        """Return ⌊x/t^k⌋."""
        v, k = code.value, self.degree
        if k == 64:
            return v(
                f"shufflevector {_PAIR} {x}, {_PAIR} zeroinitializer, <2 x i32> <i32 1, i32 2>"
            )
        if k <= 32:  # the upper word is 0
            return v(f"lshr {_PAIR} {x}, <i64 {k}, i64 {k}>")
        whole = v(f"bitcast {_PAIR} {x} to i128")
        whole = v(f"lshr i128 {whole}, {k}")
        return v(f"bitcast i128 {whole} to {_PAIR}")

    @staticmethod
    def _pair(value: int) -> str:
        return f"<i64 {value}, i64 0>"

    @staticmethod
    def _low(code: Code, x: str) -> str:
        return code.value(f"extractelement {_PAIR} {x}, i32 0")

    def _carryless(self, code: Code, x: str, y: str) -> str:
        """Return the product of the lower words."""
        if self.instruction:
            factors = (_PAIR, x), (_PAIR, y)
            return code.call(_PAIR, "llvm.x86.pclmulqdq", *factors, ("i8", "0"))
        v = code.value
        low, high = ([self._half(code, z, n) for z in (x, y)] for n in (0, 1))
        corner, middle, other, end = (
            self._with_holes(code, a, b)
            for a, b in ((low[0], low[1]), (low[0], high[1]), (high[0], low[1]), (high[0], high[1]))
        )
        middle = v(f"xor i64 {middle}, {other}")
        up, down = v(f"shl i64 {middle}, 32"), v(f"lshr i64 {middle}, 32")
        corner, end = v(f"xor i64 {corner}, {up}"), v(f"xor i64 {end}, {down}")
        pair = v(f"insertelement {_PAIR} poison, i64 {corner}, i32 0")
        return v(f"insertelement {_PAIR} {pair}, i64 {end}, i32 1")

    def _half(self, code: Code, x: str, n: int) -> str:
        low = self._low(code, x)
        return code.value(f"lshr i64 {low}, 32" if n else f"and i64 {low}, {(1 << 32) - 1}")

    @staticmethod
    def _with_holes(code: Code, x: str, y: str) -> str:
        """Return the carry-less product of two half words; at most 8 ones are added at each bit position."""
        v = code.value
        xs, ys = (
            [v(f"and i64 {z}, {HOLES << n & (1 << 64) - 1}") for n in range(4)] for z in (x, y)
        )
        parts = []
        for n in range(4):
            products = [v(f"mul i64 {xs[m]}, {ys[(n - m) % 4]}") for m in range(4)]
            mixed = reduce(lambda s, product: v(f"xor i64 {s}, {product}"), products)
            parts.append(v(f"and i64 {mixed}, {HOLES << n & (1 << 64) - 1}"))
        return reduce(lambda s, part: v(f"or i64 {s}, {part}"), parts)


def binary_field(modulus: int, instruction: bool) -> SmallBinaryField | LargeBinaryField:
    """Return the arithmetic of GF(2)[t] modulo a polynomial of degree at most 64."""
    if modulus.bit_length() - 1 <= BITWISE_UP_TO:
        return SmallBinaryField(modulus)
    return LargeBinaryField(modulus, instruction)


def _quotient(x: int, f: int) -> int:
    """Return the quotient of polynomials over GF(2)."""
    found, k = 0, f.bit_length()
    while x.bit_length() >= k:
        shift = x.bit_length() - k
        found |= 1 << shift
        x ^= f << shift
    return found

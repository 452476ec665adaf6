"""Read elements, lattices, orders and ideals in the notation of Sage, Magma or PARI, and rows of coordinates.

The reader accepts the output of ``text_for``, Sage's output for orders and fractional ideals, lists of
elements as Magma prints a basis, PARI's columns, and rows of coordinates as lists or as a printed matrix. A
text that names its algebra is read in that algebra only.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn, TypeAlias, TypeVar

from hfield.algebra.quaternion import Quaternion
from hfield.errors import HFieldError, LatticeError, MixedParentsError, NotationError, shorten
from hfield.fields.names import ring
from hfield.notation import BASIS
from hfield.orders.lattice import Ideal, Lattice, Order
from hfield.syntax.other_systems import RATIONALS, SIDES, pari_scale
from hfield.syntax.parts import SourceSpan
from hfield.syntax.products import MAX_DEPTH

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.orders.base_values import BaseNumber

_SAGE_ALGEBRA = (
    r"Quaternion Algebra \((?P<constants>.*?)\) with base ring (?:Rational Field|"
    r"Number Field in (?P<letter>\w+) with defining polynomial (?P<f>.*?)(?: with \w+ = \S+)?)"
)
_SAGE_ORDER = re.compile(
    rf"Order of (?P<algebra>{_SAGE_ALGEBRA}) with basis \((?P<basis>.*)\)".replace(" ", r"\s+"),
    re.DOTALL,
)
_SAGE_IDEAL = re.compile(r"Fractional ideal \((?P<basis>.*)\)", re.DOTALL)
_DEFINITION = re.compile(
    r"(?P<name>\w+)(?:\.?<(?P<letters>[^>]*)>)?\s*:?=\s*(?P<value>.*)", re.DOTALL
)
_WHERE = re.compile(r"\s+where\s+(\w+)\s+is\s+")
_FIELD = re.compile(
    r"NumberField\(\s*(?:Polynomial\(|QQ\['\w+'\]\()\[(?P<c>[^]]*)\]\)\s*\)|NumberField\((?P<f>[^,]*)\)"
)
_MAGMA_IDEAL = re.compile(
    rf"(?P<kind>{'|'.join(SIDES.values())})\s*<(?P<order>.*)\|(?P<elements>[^|]*)>", re.DOTALL
)
_COERCED = re.compile(r"(?P<algebra>\w+|QuaternionAlgebra\s*<.*>)\s*!\s*\[(?P<row>.*)\]", re.DOTALL)
_RATIONAL = re.compile(r"-?[0-9]{1,4000}(?:/[1-9][0-9]{0,3000})?")
_NUMBERS = re.compile(r"[-0-9/,\s]+")
_MATRIX = re.compile(r"(?:\[[^][,;]*\]\s*)+")
_ORDERS = ("QuaternionOrder", "Order")
T = TypeVar("T")
Value: TypeAlias = "Quaternion | Lattice | list[Value]"
"""An element, a lattice, an order or an ideal, or a list of lattices."""
_MAGMA_NAME = re.compile(r"(?<![\w.])([A-Za-z]\w*)\.([1-9])(?![\w.])")


def read(algebra: QuaternionAlgebra, text: object) -> Value:
    """Read an element, a lattice, an order, an ideal, or a list of these, in an algebra.

    Raises :class:`NotationError` with the position of the unreadable part, and :class:`MixedParentsError` for
    a text about another algebra.
    """
    if not isinstance(text, str):
        raise NotationError(f"expected a text to read, found {shorten(repr(text))}")
    return _ForeignTextReader(algebra).read(SourceSpan.of(text))


class _ForeignTextReader:
    def __init__(self, algebra: QuaternionAlgebra) -> None:
        self.algebra = algebra
        self.base_is_extended = hasattr(algebra.ring, "polynomial")
        self.fields: set[str] = set()
        self.definitions: dict[str, SourceSpan] = {}
        self.names: dict[str, Quaternion] = {}
        if self.base_is_extended:
            self.names["s"] = algebra(algebra.ring.gen)  # as text_for names it for Sage
        self._orders: dict[str, Order] = {}
        self._depth = 0

    def read(self, whole: SourceSpan) -> Value:
        if not whole.text:
            whole.fail("an empty text: expected an element, a lattice, an order or an ideal")
        *statements, body = [part for part in whole.split(";") if part.text] or [whole]
        for statement in statements:
            self._define(statement)
        last = body.match(_DEFINITION)  # its value is what is read
        return self.value(self._without_definitions(last["value"] if last else body))

    # --- definitions -------------------------------------------------------------------------------

    def _define(self, statement: SourceSpan) -> None:
        """Read a statement, ``K.<s> = NumberField(x^2 - 2)`` or ``B = QuaternionAlgebra(K, -1, -1)``."""
        found = statement.match(_DEFINITION)
        if found is None:
            statement.fail("expected a definition before ';', such as K.<s> = NumberField(x^2 - 2)")
        letters = found["letters"].split(",") if "letters" in found else []
        self._name(found["name"], found["value"], letters)

    def _without_definitions(self, body: SourceSpan) -> SourceSpan:
        """Read Magma's ``… where A is … where K is …``, and return the text before it."""
        places = list(_WHERE.finditer(body.text))
        if not places:
            return body
        ends = [*(place.start() for place in places[1:]), len(body.text)]
        for place, end in reversed(list(zip(places, ends, strict=True))):
            value = body[place.end() : end].strip()
            self._name(body[place.start(1) : place.end(1)], value, [])
        return body[: places[0].start()].strip()

    def _name(self, name: SourceSpan, value: SourceSpan, letters: Sequence[SourceSpan]) -> None:
        """Store a definition; check that a field or an algebra agrees with the given algebra."""
        field = value.match(_FIELD)
        if field is not None:
            self.fields.add(name.text)
            self._check_field(value, self._polynomial(field))
            for letter in letters:
                self._call_generator(letter)
            return
        self.definitions[name.text] = value
        found = value.call() or value.call("<")
        if found is not None and found[0].text == "QuaternionAlgebra":
            self._check_algebra(value)
            named = [x.text for x in letters]
            if len(set(named)) < len(named) or len(named) > 3:
                letters[0].fail(f"expected three different names here, found {', '.join(named)}")
            self.names.update(zip(named, self.algebra.basis[1:], strict=False))

    def _polynomial(self, field: dict[str, SourceSpan]) -> str:
        """Return the polynomial of a number field in s."""
        if "c" in field:
            return "+".join(f"({x.text})*s^{n}" for n, x in enumerate(field["c"].split(",")))
        return re.sub(r"(?<!\w)[a-zA-Z]\w*(?!\w)", "s", field["f"].text)

    def _check_field(self, part: SourceSpan, polynomial: str) -> None:
        """Raise :class:`MixedParentsError` unless the field of the algebra is that of a polynomial in s."""
        try:
            theirs = ring(f"QQ[s]/({polynomial})")
        except HFieldError as error:
            part.fail(f"{part} is not a number field: {error}")
        own = getattr(self.algebra.ring, "polynomial", None)
        if own is None or own != getattr(theirs, "polynomial", None):
            self._foreign(part, f"the field {theirs.name}")

    def _call_generator(self, letter: SourceSpan) -> None:
        if letter.text in BASIS:
            letter.fail(f"{letter} is an element of the algebra here: name the generator otherwise")
        self.names[letter.text] = self.algebra(self.algebra.ring.gen)

    def _foreign(self, part: SourceSpan, what: str) -> NoReturn:
        raise MixedParentsError(
            f"this text is about {what}, and not about {shorten(self.algebra)}: read it in the algebra that "
            f"it names (at character {part.start + 1} of {shorten(part.source)!r})"
        )

    def _check_algebra(self, part: SourceSpan) -> None:
        """Raise :class:`MixedParentsError` if a text names another algebra than this one."""
        value = self.definitions.get(part.text, part)
        found, constants = value.call("<"), list[SourceSpan]()
        if found is not None and found[0].text == "QuaternionAlgebra":
            field, *rest = found[1].split("|")
            constants = rest[0].split(",") if len(rest) == 1 else []
        else:
            found = value.call()
            if found is None or found[0].text != "QuaternionAlgebra":
                part.fail(
                    f"expected a quaternion algebra here, found {part}"
                    + " without a definition such as 'where A is QuaternionAlgebra<Rationals() | -1, -1>'"
                    * part.text.isidentifier()
                )
            parts = found[1].split(",")
            field = parts[0] if len(parts) == 3 else value[:0]
            constants = parts[-2:] if len(parts) in (2, 3) else []
        if len(constants) != 2:
            part.fail(
                f"expected a field and the constants a and b of a quaternion algebra, found {part}"
            )
        self._check_constants(part, field, constants)

    def _check_constants(
        self, part: SourceSpan, field: SourceSpan, constants: Sequence[SourceSpan]
    ) -> None:
        A = self.algebra
        name = field.text.replace("FiniteField", "GF")
        if name in RATIONALS or (not name and not self.fields):
            name = "QQ"
        if name not in self.fields:
            try:
                same = ring(name) == A.ring
            except HFieldError as error:
                field.fail(f"{field} is not a field here: {error}")
            if not same:
                self._foreign(part, f"an algebra over {name}")
        a, b = map(self._scalar, constants)
        if a != A.constants.a or b != A.constants.b or not A.ring.is_zero(A.constants.t):
            first, second = constants
            self._foreign(part, f"({first},{second}|{name or 'K'})")

    # --- values ------------------------------------------------------------------------------------

    def value(self, part: SourceSpan) -> Value:
        """Read a value of any kind."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            part.fail(f"the text nests deeper than {MAX_DEPTH} levels")
        found = self._value(part)
        self._depth -= 1
        return found

    def _value(self, part: SourceSpan) -> Value:
        defined = self.definitions.pop(part.text, None)  # not by itself
        if defined is not None:
            value = self.value(defined)
            self.definitions[part.text] = defined
            return value
        for read_one in (
            self._printed_by_sage,
            self._pari_column,
            self._matrix,
            self._list,
            self._of_magma,
            self._call,
        ):
            found = read_one(part)
            if found is not None:
                return found
        return self._element(part)

    def _printed_by_sage(self, part: SourceSpan) -> Order | Ideal | None:
        found = part.match(_SAGE_ORDER)
        if found is not None:
            field = found["constants"][:0]
            if "f" in found:
                self._check_field(found["f"], self._polynomial(found))
                self._call_generator(found["letter"])
                self.fields.add("")
            self._check_constants(found["algebra"], field, found["constants"].split(","))
            return self._order_of(found["basis"], found["basis"].split(","))
        found = part.match(_SAGE_IDEAL)
        if found is None:
            return None
        lattice = self._lattice(part, map(self._element, found["basis"].split(",")))
        return Ideal.of(lattice, "left")

    def _pari_column(self, part: SourceSpan) -> Quaternion | None:
        inside = part[:-1].strip().inside() if part.text.endswith("~") else None
        if inside is None:
            return None
        entries = inside.split(",")
        if len(entries) != 2:
            part.fail(
                f"expected two entries over the field of x in PARI's column, found {len(entries)}"
            )
        F, A = self.algebra.ring, self.algebra
        i, j = (
            q * pari_scale(F, x)
            for q, x in zip(A.basis[1:], (A.constants.a, A.constants.b), strict=False)
        )
        names = {"x": i} | ({"y": A(F.gen)} if self.base_is_extended else {"y": A.zero})
        u, v = (self._element(entry, names) for entry in entries)
        found: Quaternion = u + j * v
        return found

    def _matrix(self, part: SourceSpan) -> Lattice | None:
        """Read rows of coordinates, one per line with or without brackets, or a PARI matrix."""
        inside, text = part.inside(), part.text
        if inside is not None and len(rows := inside.split(";")) > 1:
            return self._lattice(part, (self._coordinates(row, row.split(",")) for row in rows))
        if _MATRIX.fullmatch(text) and re.search(r"[^\s[]\s+[^\s\]]", text):
            lines = [part[m.start(1) : m.end(1)] for m in re.finditer(r"\[([^]]*)\]", text)]
        elif _NUMBERS.fullmatch(text) and "\n" in text:
            lines = [part[m.start() : m.end()] for m in re.finditer(r"[^\n]+", text)]
        else:
            return None
        return self._lattice(part, (self._coordinates(line, _entries(line)) for line in lines))

    def _list(self, part: SourceSpan) -> Value | None:
        """Read a list: four coordinates, elements that span a lattice, or lattices."""
        inside = part.inside() or part.inside("(")
        if inside is None:
            return None
        parts = inside.split(",")
        if part.text.startswith("(") and len(parts) == 1:
            return None  # parentheses of an expression
        if not inside.text:
            part.fail("an empty list: expected coordinates, elements or lattices")
        values: list[Value] = [self._kept_order(x) or self.value(x) for x in parts]
        elements = [x for x in values if isinstance(x, Quaternion)]
        if not elements:
            return values
        if len(elements) < len(values):
            parts[values.index(elements[0])].fail("an element in a list of lattices")
        if all(q.vector_part.is_zero() for q in elements):
            return self._coordinates(part, parts)
        return self._lattice(part, elements)

    def _of_magma(self, part: SourceSpan) -> Value | None:
        found = part.match(_COERCED)
        if found is not None:
            self._check_algebra(found["algebra"])
            return self._coordinates(found["row"], found["row"].split(","))
        found = part.match(_MAGMA_IDEAL)
        if found is None:
            return None
        order = self._order(found["order"])
        elements = [self._expect_element(x) for x in found["elements"].split(",")]
        side = next(side for side, kind in SIDES.items() if kind == found["kind"].text)
        make = {
            "left": order.left_ideal,
            "right": order.right_ideal,
            "two-sided": order.two_sided_ideal,
        }
        return self._made(part, lambda: make[side](elements))

    def _call(self, part: SourceSpan) -> Value | None:
        found = part.call()
        if found is None:
            return None
        head, inside = found
        prefix, _, name = head.text.rpartition(".")
        before = head[: len(prefix)].strip()
        arguments = inside.split(",")
        if head.text in _ORDERS:
            given = next((x for x in arguments if x.inside() is not None), inside)
            return self._made(part, lambda: self.algebra.order(self._elements(given)))
        if name == "quaternion_order":
            self._check_algebra(before)
            return self._order_of(arguments[0], self._listed(arguments[0]))
        if name in ("left_ideal", "right_ideal"):
            order = self._order(before)
            make = order.left_ideal if name == "left_ideal" else order.right_ideal
            return self._made(part, lambda: make(self._elements(arguments[0])))
        if prefix and name == "ideal":
            self._check_algebra(before)
            return self._fractional_ideal(part, arguments)
        if head.text == "QuaternionAlgebra":
            part.fail("this text names an algebra: QuaternionAlgebra(text) reads it")
        if prefix.startswith("QuaternionAlgebra(") or prefix in self.definitions:
            part.fail(
                f"{name} is not read here: expected quaternion_order, ideal, left_ideal or right_ideal"
            )
        if head.text.startswith("QuaternionAlgebra") or head.text in self.definitions:
            self._check_algebra(head)
            return self._expect_element(inside)
        return None

    def _fractional_ideal(
        self, part: SourceSpan, arguments: Sequence[SourceSpan]
    ) -> Ideal | Lattice:
        lattice = self._lattice(part, self._elements(arguments[0]))
        orders = {}
        for argument in arguments[1:]:
            key, _, text = argument.text.partition("=")
            if key.strip() in ("left_order", "right_order"):
                orders[key.strip()] = self._order(
                    argument[len(argument.text) - len(text) :].strip()
                )
        if not orders:
            return lattice
        side = "two-sided" if len(orders) == 2 else next(iter(orders)).removesuffix("_order")
        order = next(iter(orders.values()))
        return self._made(part, lambda: Ideal.like(lattice, order, side))

    # --- orders, lattices and elements -------------------------------------------------------------

    def _kept_order(self, part: SourceSpan) -> Order | None:
        return self._orders.get(part.text)

    def _order(self, part: SourceSpan) -> Order:
        """Read an order; an order that occurs again is built only once."""
        kept = self._kept_order(part)
        if kept is None:
            found = self.value(self.definitions.get(part.text, part))
            if not isinstance(found, Order):
                part.fail(f"expected an order here, found {part}")
            kept = self._orders[part.text] = found
        return kept

    def _order_of(self, part: SourceSpan, basis: Sequence[SourceSpan]) -> Order:
        elements = [self._expect_element(x) for x in basis]
        return self._made(part, lambda: Order.from_basis(self.algebra, elements))

    def _lattice(self, part: SourceSpan, elements: Iterable[Quaternion]) -> Lattice:
        spanning = list(elements)
        return self._made(part, lambda: Lattice.spanned(self.algebra, spanning))

    def _made(self, part: SourceSpan, make: Callable[[], T]) -> T:
        """Build an object from elements already read; errors name the part of the text."""
        try:
            return make()
        except LatticeError as error:
            part.fail(str(error))

    def _listed(self, part: SourceSpan) -> list[SourceSpan]:
        inside = part.inside()
        if inside is None:
            part.fail(f"expected a list of elements in brackets, found {part}")
        return inside.split(",")

    def _elements(self, part: SourceSpan) -> list[Quaternion]:
        return [self._expect_element(x) for x in self._listed(part)]

    def _expect_element(self, part: SourceSpan) -> Quaternion:
        found = self.value(part)
        if not isinstance(found, Quaternion):
            part.fail(f"expected an element here, found {part}")
        return found

    def _coordinates(self, part: SourceSpan, entries: Sequence[SourceSpan]) -> Quaternion:
        if len(entries) != 4:
            part.fail(f"expected four coordinates here, found {len(entries)}")
        found: Quaternion = self.algebra(*map(self._scalar, entries))
        return found

    def _scalar(self, part: SourceSpan) -> BaseNumber:
        if _RATIONAL.fullmatch(part.text) and self.algebra.ring.characteristic == 0:
            number: BaseNumber = self.algebra.ring(Fraction(part.text))
            return number  # faster than as an expression
        q = self._element(part)
        if not q.vector_part.is_zero():
            part.fail(f"expected a number of {self.algebra.ring.name}, found {part}")
        found: BaseNumber = q.scalar_part
        return found

    def _element(self, part: SourceSpan, names: dict[str, Quaternion] | None = None) -> Quaternion:
        """Read an expression in i, j, k and the generator of the field."""
        known = self.names | (names or {})
        for found in _MAGMA_NAME.finditer(part.text):
            known[f"{found[1]}_{found[2]}"] = self._generator(
                found[1], int(found[2]), part[found.start() :]
            )
        text = _MAGMA_NAME.sub(r"\1_\2", part.text)  # of the same length
        try:
            q: Quaternion = self.algebra.parse(
                text, names=known, functions={"Mod": self._residue} if "Mod(" in text else {}
            )
        except MixedParentsError:
            raise
        except NotationError as error:
            part[error.position or 0 :].fail(error.reason)
        except HFieldError as error:
            part.fail(str(error))
        return q

    def _residue(self, x: Quaternion, modulus: Quaternion) -> Quaternion:
        """Return x of PARI's ``Mod(x, f)``; f must be the polynomial of a generator, so that its
        value is 0.
        """
        if not modulus.is_zero():
            raise MixedParentsError(
                f"this text has a residue modulo a polynomial that is not 0 in {shorten(self.algebra)} but "
                f"{shorten(modulus)}: read it in the algebra that it is about"
            )
        return x

    def _generator(self, prefix: str, number: int, part: SourceSpan) -> Quaternion:
        """Return the generator K.1 of the field, or A.1, A.2, A.3 in Magma's notation."""
        if self.base_is_extended and prefix in self.fields | {"K"} and number == 1:
            q: Quaternion = self.algebra(self.algebra.ring.gen)
            return q
        defined = self.definitions.get(prefix)
        if defined is None or not defined.text.startswith("QuaternionAlgebra") or number > 3:
            part.fail(f"{prefix}.{number} is not a generator that the text defines")
        return self.algebra.basis[number]


def _entries(line: SourceSpan) -> list[SourceSpan]:
    """Split a line at commas, or at blanks if there are none."""
    if "," in line.text:
        return line.split(",")
    return [line[m.start() : m.end()] for m in re.finditer(r"\S+", line.text)]

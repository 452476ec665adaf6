"""Evidence for statements of linear algebra: bases, the centre, Lemma 1 on multilinear maps."""

from itertools import permutations, product

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.evaluate import Evaluator, RingScalars
from hfield.checker.glossary import (
    BASIS_TUPLES,
    COMMUTATIVE_RINGS,
    COUNT,
    DETERMINANT,
    FIELD,
    FIELDS,
    IDENTITY,
    LINEAR_ALGEBRA,
    SMITH_FORM,
)
from hfield.checker.polynomials import Names, Poly, accumulate, add, constant, multiply
from hfield.checker.rejection import a_list, an_integer, an_object, kind_of, reject, shown
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.rationals import ZZ
from hfield.checker.statement import HAMILTON, Setting

N = 4

Matrix = list[list[int]]
Tuple = tuple[int, ...]


def _integers(text: str) -> Tuple:
    return tuple(map(int, text.split(",")))


def _determinant(m: Matrix) -> int:
    """Return the determinant by Leibniz's sum; the matrices are small."""
    size, total = len(m), 0
    for order in permutations(range(size)):
        spend(20)
        term = -1 if sum(a > b for n, a in enumerate(order) for b in order[n + 1 :]) % 2 else 1
        for row, column in enumerate(order):
            term *= m[row][column]
        total += term
    return total


def _plain(evidence: object, *kinds: str) -> str:
    an_object(evidence, "kind", "the evidence")
    if kind_of(evidence) not in kinds:
        reject(f"evidence of the kind {shown(kind_of(evidence))!r} does not show this")
    return kind_of(evidence)


def basis(parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object) -> CheckResult:
    """Check that the vectors are a basis of the free module with the given dimension."""
    (dimension,), *vectors = (_integers(part) for part in parts)
    fits = len(vectors) == dimension and all(len(v) == dimension for v in vectors)
    kind = _plain(evidence, "count", "determinant")
    scope = COMMUTATIVE_RINGS if setting.field is None and verdict == "proved" else FIELD
    if kind == "count":
        if verdict != "refuted" or fits:
            reject("the vectors are as many and as long as they should be")
        return CheckResult(scope, COUNT)
    if not fits:
        reject("the vectors are not as many or as long as they should be")
    det, field = _determinant([list(v) for v in vectors]), setting.field
    unit = abs(det) == 1 if field is None else field.inverse(field.number(det)) is not None
    if verdict != ("proved" if unit else "refuted"):
        reject(f"the determinant {det} does not show this {verdict}")
    return CheckResult(scope, DETERMINANT)


def centre(parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object) -> CheckResult:
    """Check that the centre is the whole algebra in the given characteristic, and F·e in every other."""
    special = int(parts[0])
    data = an_object(evidence, "kind rows columns", "the evidence")
    if verdict != "proved" or data["kind"] != "minor" or not is_prime(special):
        reject("that the centre is so is shown by a minor of the linear equations for it")
    field = setting.field
    if field is not None and not field.is_field:
        reject("this is about fields")
    matrix = _commutators()
    rows, columns = (
        [an_integer(n, "a row or column", 0) for n in a_list(data[key], key)]
        for key in ("rows", "columns")
    )
    chosen = ((rows, len(matrix)), (columns, N))
    if any(len(set(x)) != 3 or len(x) != 3 or max(x) >= most for x, most in chosen):
        reject("expected three rows of the eight and three columns of the four")
    minor = _determinant([[matrix[r][c] for c in columns] for r in rows])
    if any(row[0] for row in matrix):
        reject("e does not commute with i and j")
    whole = not any(x % special for row in matrix for x in row)
    if field is not None:
        p = field.characteristic
        right = whole if p == special else bool(minor % p if p else minor)
        if not right:
            reject(f"over {field.name} the centre is not as stated, or the minor is 0")
        other = (f"not {special}", "F·e") if p == special else (str(special), "H(F)")
        left_out = "in characteristic {} the centre is {}".format(*other)
        return CheckResult(FIELD, LINEAR_ALGEBRA).without(left_out)
    while minor and minor % special == 0:
        minor //= special
    if not whole or abs(minor) != 1:
        reject("the minor vanishes in another characteristic, or an equation does not vanish")
    return CheckResult(FIELDS, SMITH_FORM)


def _commutators() -> Matrix:
    """Return the coefficients of the coordinates of q·i − i·q and q·j − j·q, as eight rows of four."""
    evaluator = Evaluator(RingScalars(ZZ), HAMILTON, {})
    units = [evaluator.quaternion(evaluator.value(("name", u))) for u in "eijk"]
    rows = []
    for g in units[1:3]:
        pairs = [(evaluator.product(q, g), evaluator.product(g, q)) for q in units]
        rows += [[int(x[n] - y[n]) for x, y in pairs] for n in range(N)]
    return rows


CHOICES = ("all", "constant", "short", "all-but-one")


def _choice(word: str, k: int) -> set[Tuple]:
    """Return the tuples of basis vectors that a word describes."""
    spend(N**k)
    if word == "constant":
        return {(n,) * k for n in range(N)}
    if word == "short":
        return {(*t, 0) for t in product(range(N), repeat=k - 1)}
    every = set(product(range(N), repeat=k))
    return every - {(N - 1,) * k} if word == "all-but-one" else every


def _arities(text: str) -> Tuple:
    found = _integers(text)
    if len(set(found)) < len(found):
        reject("expected different numbers of arguments, such as 1,2,3")
    return found


def determined_by(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that k-linear maps on F⁴ that agree on the chosen tuples of basis vectors are equal.

    f − g is Σ h_t·a₁[t₁]⋯aₖ[tₖ], where h_t is its value at the tuple t. So agreement on all tuples suffices;
    if a tuple is left out, f may be 1 there while g = 0.
    """
    choice, arities = parts[0], _arities(parts[1])
    kind = kind_of(evidence)
    if verdict == "refuted" and kind == "left out":
        data = an_object(evidence, "kind tuple", "the evidence")
        word = data["tuple"]
        if not isinstance(word, str) or not set(word) <= set("eijk") or len(word) not in arities:
            reject("expected a word in e, i, j, k with as many letters as there are arguments")
        if tuple("eijk".index(u) for u in word) in _choice(choice, len(word)):
            reject("the tuple is not left out")
        return CheckResult(FIELD, BASIS_TUPLES)
    data = an_object(evidence, "kind tuples", "the evidence")
    lists = a_list(data["tuples"], "tuples")
    if verdict != "proved" or kind != "basis tuples" or len(lists) != len(arities):
        reject("that maps are determined is shown by a list of tuples for each number of arguments")
    for k, raw in zip(arities, lists, strict=True):
        words = a_list(raw, "a list of tuples")
        wanted = ["".join(t) for t in product("eijk", repeat=k)]
        if words != wanted or len(_choice(choice, k)) != len(wanted):
            reject(f"the list of tuples of {k} basis vectors is not complete")
    return CheckResult(COMMUTATIVE_RINGS if setting.field is None else FIELD, BASIS_TUPLES)


class _Form:
    """The k-linear form with unknown values h_t at the tuples t, and further unknowns."""

    def __init__(self, k: int, extra: tuple[str, ...]) -> None:
        self.k = k
        self.tuples = list(product(range(N), repeat=k))
        arguments = [f"a{m}_{n}" for m in range(k) for n in range(N)]
        entries = ["h" + "".join(map(str, t)) for t in self.tuples]
        self.names = Names([("name", name) for name in (*entries, *arguments, *extra)])
        self.arguments = [[self.unknown(f"a{m}_{n}") for n in range(N)] for m in range(k)]

    def unknown(self, name: str) -> Poly:
        """Return an unknown."""
        return self.names.variable(("name", name))

    def __call__(self, *arguments: list[Poly]) -> Poly:
        """Return the value."""
        total: Poly = {}
        for t in self.tuples:
            term = self.unknown("h" + "".join(map(str, t)))
            for a, n in zip(arguments, t, strict=True):
                term = multiply(term, a[n])
            accumulate(total, term)
        return total


def _unit(n: int) -> list[Poly]:
    return [constant(int(m == n)) for m in range(N)]


def _settle(difference: Poly, verdict: str, setting: Setting) -> bool:
    """Return whether a difference of two sides proves the verdict.

    Either it is 0; or it is linear in each unknown and has a coefficient ±1, so that it is not the zero
    function over any field.
    """
    if verdict == "proved":
        return not difference
    linear = all(e == 1 for m in difference for _, e in m)
    return linear and any(abs(c) == 1 for c in difference.values())


def curried_linear(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that fixing the last argument at a basis vector leaves a map that is linear in every other
    argument.

    This is proved for maps of two and three arguments: f(…, s·a + y·b, …) = s^power·f(…, a, …) + y·f(…, b,
    …).
    """
    _plain(evidence, "identity")
    if verdict != "proved":
        reject("this holds")
    for k in (2, 3):
        form = _Form(k, ("s", "y", *(f"b{n}" for n in range(N))))
        s, y = form.unknown("s"), form.unknown("y")
        b = [form.unknown(f"b{n}") for n in range(N)]
        for last, slot in product(range(N), range(k - 1)):

            def at(
                vector: list[Poly], form: _Form = form, last: int = last, slot: int = slot
            ) -> Poly:
                arguments = [*form.arguments[:-1], _unit(last)]
                arguments[slot] = vector
                return form(*arguments)

            a = form.arguments[slot]
            mixed = [add(multiply(s, u), multiply(y, v)) for u, v in zip(a, b, strict=True)]
            right = add(multiply(s, at(a)), multiply(y, at(b)))
            if add(at(mixed), right, -1):
                reject("the two sides do not expand to the same")
    return CheckResult(COMMUTATIVE_RINGS if setting.field is None else FIELD, IDENTITY)


def last_argument(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check Σ_{i≤n} αᵢ·f(…, eᵢ) = f(…, Σ_{i≤upper} αᵢ·eᵢ) with n = 4, where e₅ is an arbitrary vector."""
    upper, shows = int(parts[0]), []
    _plain(evidence, "identity")
    for k in _arities(parts[1]):
        names = (*(f"x{n}" for n in range(N + 1)), *(f"b{n}" for n in range(N)))
        form = _Form(k, names)
        x = [form.unknown(f"x{n}") for n in range(N + 1)]
        vectors = [*map(_unit, range(N)), [form.unknown(f"b{n}") for n in range(N)]]
        fixed, left, total = form.arguments[:-1], {}, [{} for _ in range(N)]  # type: ignore[var-annotated]
        for n in range(N):
            left = add(left, multiply(x[n], form(*fixed, vectors[n])))
        for n in range(upper):
            total = [add(u, multiply(x[n], v)) for u, v in zip(total, vectors[n], strict=True)]
        shows.append(_settle(add(left, form(*fixed, total), -1), verdict, setting))
    if not (all(shows) if verdict == "proved" else verdict == "refuted" and any(shows)):
        reject("the two sides do not expand to what would show this")
    everywhere = setting.field is None and verdict == "proved"
    return CheckResult(COMMUTATIVE_RINGS if everywhere else FIELD, IDENTITY)


CHECKS = {
    "basis": basis,
    "centre": centre,
    "determined-by": determined_by,
    "curried-linear": curried_linear,
    "last-argument": last_argument,
}
ARGUMENTS = "[1-4](?:,[1-4]){0,3}"
NUMBERS = "-?[0-9]{1,8}(?:,-?[0-9]{1,8}){0,5}"
# What stands between the braces of each word.
FORMS = {
    "basis": f"[0-9]{{1,8}}(?:;{NUMBERS}){{1,6}}",
    "centre": "[0-9]{1,8}",
    "determined-by": f"(?:{'|'.join(CHOICES)});{ARGUMENTS}",
    "curried-linear": "1",
    "last-argument": f"[345];{ARGUMENTS}",
}

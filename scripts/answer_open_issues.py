"""Answer questions from the issue trackers of other systems.

Each answer is computed when the script runs. ``python -m scripts.answer_open_issues`` prints the table
of docs/explanation/open-issues.md, one line for each issue: its number, the question, and the answer.
"""

from collections.abc import Callable, Iterator

from hfield import H, QuaternionAlgebra, ring

QUESTIONS: dict[str, tuple[str, Callable[[], str]]] = {}
"""For each issue the question and the function that answers it."""


def answers(issue: str, question: str) -> Callable[[Callable[[], str]], Callable[[], str]]:
    """Register a function as the answer to an issue."""

    def register(function: Callable[[], str]) -> Callable[[], str]:
        QUESTIONS[issue] = question, function
        return function

    return register


@answers("Magma #48", "embed ℤ[√−210] in an Eichler order of level 35, discriminant 6")
def _embedding_in_eichler_order() -> str:
    answer = QuaternionAlgebra(6).eichler_order(35).embeddings(-840)
    return f"√−210 ↦ {answer.element + 420}"


@answers("Magma #59", "embed ℤ[√−390] in an order of (39,2|ℚ) (the search does not end)")
def _embedding_in_given_order() -> str:
    basis = ["1", "1/2+2*i+5/4*j+7/4*k", "1+i+j", "5/2*i+5/4*j+5/4*k"]
    answer = QuaternionAlgebra("QQ", 39, 2).order_from_basis(basis).embeddings(-1560)
    return f"√−390 ↦ {answer.element + 780}"


@answers("Magma #12", "a fundamental domain of discriminant 46 around a CM point of ℤ[√−2]")
def _domain_around_cm_point() -> str:
    group = QuaternionAlgebra(46).maximal_order().norm_one_group()
    (point, *_) = group.cm_points(-8)
    return f"{len(group.domain(center=point).sides)} sides, genus {group.signature.genus}"


@answers("Magma #47, #83", "does ℤ_F[√−1] embed in a given maximal order, F = ℚ(√97)")
def _no_embedding() -> str:
    F = ring("QQ[a]/(a^2-a-24)")
    generators = [
        *("1", "a", "i", "a*i"),
        "19/2*a - 103/2 + (-7/4*a + 19/2)*i + (-7/4*a + 19/2)*j",
        "-42*a + 228 + (31/4*a - 42)*i + (31/4*a - 42)*j",
        "5/2*a + 11 + (7/4*a + 31/4)*i + (-1/3*a - 3/2)*j + (1/6*a + 3/4)*k",
        "27/2*a + 60 + (19/2*a + 42)*i + (-11/6*a - 8)*j + (11/12*a + 4)*k",
    ]
    order = QuaternionAlgebra(F, "-2", "-a-5").order(generators).maximal_overorder()
    answer = order.embeddings(F(-4))
    return "yes" if answer else f"no: {answer.reason}"


@answers("Magma #46", "Hecke operators over ℚ(√2,√5) where P² divides the level")
def _level_with_square() -> str:
    K = ring("QQ[w]/(w^4-14*w^2+9)")
    A = QuaternionAlgebra.from_ramification(K, K.real_places())
    (two,), three, at_31 = (K.primes_above(p) for p in (2, 3, 31))
    C = A.eichler_order([(two, 1), (three[0], 2)]).class_set()
    trace = -C.hecke_polynomial(at_31[0])[-2] - 32  # without the Eisenstein part
    return f"dimension {C.cusp_dimension()}, trace {trace} at a prime of norm 31"


@answers("Magma #68", "the reduced norm of the 5 × 5 matrix of 1, …, 25 over (−1,−1|ℚ)")
def _reduced_norm() -> str:
    matrix = H("QQ").matrix([[5 * row + column + 1 for column in range(5)] for row in range(5)])
    return f"{matrix.reduced_norm()}, the rank is {matrix.rank()}"


@answers("Sage #41531", "an element of norm n, or a proof that there is none")
def _norm_equation() -> str:
    order = QuaternionAlgebra(1009).maximal_order()
    missing = [n for n in range(1, 20) if not order.elements_of_norm(n)]
    return f"discriminant 1009: no element of norm {', '.join(map(str, missing))}"


@answers("Sage #37217, #37417", "maximal orders of (−292,−732|ℚ) and (−4,−28|ℚ)")
def _maximal_orders() -> str:
    algebras = (QuaternionAlgebra("QQ", -292, -732), QuaternionAlgebra("QQ", -4, -28))
    found = [A.maximal_order().discriminant() for A in algebras]
    return f"of discriminant {found[0]} and {found[1]}"


@answers("Sage #38422", "the image of a prime above 3 of ℚ(√−35) in the Hurwitz order")
def _image_of_ideal() -> str:
    A = H("QQ")
    root = A("5*i + j + 3*k")
    image = A.maximal_order().left_ideal([3, (1 - root) / 2])
    return f"norm {image.norm()}, basis {', '.join(map(str, image.basis))}"


@answers("Sage #34684", "ideal classes over the integers of ℚ(√10), class number 2")
def _classes_over_number_field() -> str:
    K = ring("QQ(sqrt(10))")
    C = QuaternionAlgebra.from_ramification(K, K.real_places()).maximal_order().class_set()
    return f"{len(C)} classes, {C.type_number} types, mass {C.mass}"


@answers("hilbertmodularforms #470", "cusp forms of weight 2 and level 1 over ℚ(√241)")
def _cusp_forms() -> str:
    K = ring("QQ(sqrt(241))")
    A = QuaternionAlgebra.from_ramification(K, K.real_places())
    return f"dimension {A.maximal_order().class_set().cusp_dimension()}"


def rows() -> Iterator[str]:
    """Yield the rows of the table."""
    yield "| issue | question | answer |"
    yield "|---|---|---|"
    for issue, (question, answer) in QUESTIONS.items():
        yield f"| {issue} | {question.replace('|', chr(92) + '|')} | {answer()} |"


if __name__ == "__main__":
    for row in rows():
        print(row)

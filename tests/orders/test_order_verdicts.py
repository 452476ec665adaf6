"""Answers about orders and ternary forms are verdicts, and keep their own names for value and witness."""

from hfield import QuaternionAlgebra, ternary_form
from hfield.verdicts import Verdict


def test_maximal_orders_are_explained():
    A = QuaternionAlgebra(6)
    yes, no = A.maximal_order().is_maximal(), A.eichler_order(5).is_maximal()
    assert all(isinstance(x, Verdict) for x in (yes, no))
    assert [yes, no] == [True, False]
    assert no == A.eichler_order(7).is_maximal()  # only the value counts
    assert (repr(yes), repr(no)) == ("True", "False")
    assert no.holds is no.value is False
    assert no.reason.endswith("times 5")


def test_equivalences_of_forms_have_the_matrix_as_witness():
    f, g = ternary_form([1, 1, 3, 0, 0, 0]), ternary_form([3, 2, 1, 0, 0, 2])
    no, yes = f.equivalence(g), f.equivalence(f)
    assert all(isinstance(x, Verdict) for x in (yes, no))
    assert [yes, no, yes.holds, no.holds] == [True, False, True, False]
    assert no.matrix is None
    assert yes.matrix is yes.witness is not None
    assert repr(yes).startswith("FormEquivalence(holds=True, reason=")


def test_embeddings_have_an_element_as_witness():
    O = QuaternionAlgebra(6).maximal_order()
    yes, no = O.embeddings(-24), O.embeddings(-7)
    assert all(isinstance(x, Verdict) for x in (yes, no))
    assert [yes, no] == [True, False]
    assert yes.element is yes.witness
    assert yes.element.norm() * 4 - yes.element.trace() ** 2 == 24
    assert no.element is None
    assert "ramifies at 2" in no.reason
    assert yes != O.embeddings(-40)  # the discriminants differ

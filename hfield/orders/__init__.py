"""Lattices, orders and ideals in quaternion algebras over ℚ and over number fields, and their classes.

``base`` says what is asked of ℤ and of the integers of a field; ``basis`` has the multiplication of an
algebra as integer matrices. A lattice is a value, a Hermite form over its least denominator over such a basis
(``lattice_values``); an order over ℤ is one that is a ring (``z_order``). Where ℤ has a quicker way it is a
function in ``kernels``; algorithms that differ as a whole are chosen in ``order_functions``. What takes an
algorithm is a function that is given such values and returns values, elements, or what answers a question
(``certificates``). Above them stand what a user holds, thin:
``lattice``, whose methods hand over to the functions, and ``hurwitz_order``. ``standard_orders`` are those
that an algebra has names for. ``over_integers`` has what is still written a second time, over the integers of
number fields. Each module says which theorem it stands on; ``docs/orders.md`` shows what can be asked.
"""

"""Lattices, orders and ideals in quaternion algebras over ℚ: their arithmetic and their classes.

A lattice is a value: a Hermite form over its least denominator, in an algebra (``z_lattice``); an order is
one that is a ring (``z_order``). What takes an algorithm is a function that is given such values and returns
values, elements, or what answers a question (``certificates``). Above them stand what a user holds, thin:
``lattice``, whose methods hand over to the functions, and ``hurwitz_order``. ``named_orders`` are those that
an algebra has names for, ``over_integers`` those over the integers of number fields. Each module says which
theorem it stands on; ``docs/orders.md`` shows what can be asked.
"""

"""Lattices, orders and ideals in quaternion algebras over ℚ: their arithmetic and their classes.

A ``lattice``, an ``order`` and an ``ideal`` make one another. What takes an algorithm is a function in a
module below them: it is given such objects and returns lattices, elements, rows or what answers a question
(``answers``, ``classes``), and their methods hand over to it. On top stand the orders that an algebra names
(``named_orders``, ``hurwitz_order``, ``extremal_orders``); those over number fields are ``over_integers``.
Each module says which theorem it stands on; ``docs/orders.md`` shows what can be asked.
"""

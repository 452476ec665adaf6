"""Lattices, orders and ideals in quaternion algebras over ℚ: their arithmetic and their classes.

What one holds is a ``lattice``, an ``order``, an ``ideal`` or their ``classes``; these make one another. What
takes an algorithm is a function in a module below them: it is given such objects and returns lattices,
elements or rows, and their methods hand over to it. On top stand the orders that an algebra names
(``named_orders``, ``hurwitz_order``, ``extremal_orders``); those over number fields are ``over_integers``.
Each module says which theorem it stands on; ``docs/orders.md`` shows what can be asked.
"""

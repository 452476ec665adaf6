"""Lattices, orders and ideals in quaternion algebras over ℚ and over number fields, and their classes.

``base`` is the interface of ℤ and of the integers of a number field. ``basis`` has the multiplication of an
algebra as integer matrices. ``lattice_values`` has lattices as values: a Hermite form over its least
denominator. ``z_order`` has the values that are orders over ℤ. ``kernels`` has functions with a quicker
variant over ℤ; ``order_functions`` chooses between algorithms that differ as a whole. Algorithms are
functions of such values in modules of their own: ``equivalence``, ``isomorphisms`` and ``units`` serve every
base. ``certificates`` makes certificates of their results. The public classes are in ``lattice`` and
``hurwitz_order``; their methods call these functions.
``standard_orders`` has the named orders of an algebra. ``over_integers`` has the code for number fields that
is not yet shared with ℤ. Each module cites the theorems that it uses; ``docs/orders.md`` has examples.
"""

"""Lattices, orders and ideals in quaternion algebras over ℚ and over number fields, and their classes.

``base`` is the interface of ℤ and of the integers of a number field. ``basis`` has the multiplication of an
algebra as integer matrices. ``lattice_values`` has lattices as values: a Hermite form over its least
denominator. ``kernels`` has functions with a quicker variant over ℤ. Algorithms are functions of such values
in modules of their own: ``equivalence``, ``isomorphisms`` and ``units`` serve every base. ``classes`` lists
ideal classes, by ``neighbours`` and their ``class_keys``. ``certificates`` makes certificates of results. The
public classes are in ``lattice`` and ``hurwitz_order``; their methods call these functions.
``standard_orders`` has the named orders of an algebra. Each module cites the theorems that it uses;
``docs/reference/orders.md`` has examples.
"""

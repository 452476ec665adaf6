"""Lattices, orders and ideals in quaternion algebras over ℚ and over number fields, and their classes.

``base`` is the interface of ℤ and of the integers of a number field. ``basis`` represents the multiplication
of an algebra by integer matrices. ``lattice_values`` represents a lattice by its Hermite form over the least
denominator. ``kernels`` has functions with a faster variant over ℤ. Algorithms are functions of such values
in separate modules: ``equivalence``, ``isomorphisms`` and ``units`` work over every base. ``classes`` lists
ideal classes, using ``neighbours`` and ``class_keys``. ``certificates`` makes certificates of results. The
public classes are in ``lattice`` and ``hurwitz_order``; their methods call these functions.
``standard_orders`` has the named orders of an algebra. Each module cites the theorems that it uses;
``docs/reference/orders.md`` has examples.
"""

"""Brandt matrices over ℤ by theta series, which no neighbour and no relation enters."""

from hfield.orders.lattice import ClassSet


def by_theta_series(C: ClassSet, n: int) -> list[list[int]]:
    """The Brandt matrix by counting vectors of norm n between all pairs of classes."""
    h = range(len(C))
    return [[C.theta_series(i, j, n)[n] // C.unit_counts[j] for j in h] for i in h]

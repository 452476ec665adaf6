"""Explore an algebra: collections of elements, groups, ideals, subalgebras, graphs, pictures."""

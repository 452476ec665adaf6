"""Exploring an algebra: collections of its elements, its groups, ideals, subalgebras, graphs and pictures."""

"""Decide whether an algebra has nonzero elements of norm 0, with evidence."""

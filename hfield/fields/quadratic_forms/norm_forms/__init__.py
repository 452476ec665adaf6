"""Whether an algebra has nonzero elements of norm 0, and the evidence that it has none."""

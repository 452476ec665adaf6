"""Storage of arrays of quaternions: rows of small integers, which compiled loops run over."""

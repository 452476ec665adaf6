"""Storage of arrays of quaternions: rows of small integers, processed by compiled loops."""

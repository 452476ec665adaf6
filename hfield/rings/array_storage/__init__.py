"""How arrays of quaternions are held compactly: rows of small integers, which compiled loops run over."""

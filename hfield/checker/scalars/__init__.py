"""The base rings of the checker, on plain, hashable values: one module a kind, which ``fields`` lists."""

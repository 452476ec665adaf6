"""The base rings of the checker, on plain, hashable values; each kind is a module listed in ``fields``."""

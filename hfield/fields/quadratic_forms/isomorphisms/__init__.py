"""When two algebras are isomorphic, with the map; splittings."""

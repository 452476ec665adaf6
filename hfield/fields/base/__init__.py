"""The base of all rings: protocol, registry, coercion, printing, and storage of elements and arrays."""

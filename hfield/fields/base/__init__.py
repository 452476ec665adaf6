"""What all rings share: protocol, registry, coercion, printing, and storage of elements and arrays."""

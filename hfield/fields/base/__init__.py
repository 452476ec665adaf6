"""What all rings share: the protocol, the registry, coercion, printing, and storage of elements and arrays."""

"""The centre and the radical of an algebra, by linear algebra over the base ring."""

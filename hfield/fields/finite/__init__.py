"""Finite fields: the ring, the texts that name one, arrays by galois."""

"""Properties, multiplicative orders and square roots of elements."""

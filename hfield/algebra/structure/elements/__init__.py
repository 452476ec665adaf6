"""What an element is: properties, multiplicative order, square roots."""

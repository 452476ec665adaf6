"""The spinning top: its shape, its motion, and its pictures."""

"""Number fields of any degree: Hilbert symbols, conics, algebras from their ramification."""

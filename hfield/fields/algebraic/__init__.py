"""The real and the complex algebraic numbers, and closed forms: numbers with radicals, cosines and π."""

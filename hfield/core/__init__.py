"""Basic tools that every package uses: the formula of the product, primes, files, locks, progress."""

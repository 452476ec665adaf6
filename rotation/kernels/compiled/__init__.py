"""What numba compiles: a file a kernel, and the parts they share. Importing one imports numba."""

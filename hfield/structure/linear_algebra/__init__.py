"""What linear algebra over the base ring decides: the centre, the radical, kernels."""

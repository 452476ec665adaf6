"""Fields of rational functions in cosines and sines of angles."""

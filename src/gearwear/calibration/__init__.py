"""Search for values of the parameters that the reference paper does not give."""

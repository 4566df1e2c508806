"""Statements of the reference paper and how the results agree with them."""

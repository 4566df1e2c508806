"""Exact integrator of the piecewise-linear oscillator: one affine map for each cell of the forcing period."""

"""Periodic orbits of the oscillator, stable or not: their multipliers, branches and bifurcations."""

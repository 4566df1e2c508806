"""Adaptive Runge-Kutta integrator of order 5(4)."""

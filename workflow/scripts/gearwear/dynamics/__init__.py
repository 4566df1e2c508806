"""Nonlinear oscillator of a gear pair with backlash: its forcing, its integrator and its attractors."""

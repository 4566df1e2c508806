"""Nonlinear oscillator of a gear pair with backlash: its forcing, its integrators and its motion."""

"""Integrators of the equation of motion."""

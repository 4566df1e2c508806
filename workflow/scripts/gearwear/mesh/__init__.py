"""Mesh stiffness, load sharing, static transmission error and backlash."""

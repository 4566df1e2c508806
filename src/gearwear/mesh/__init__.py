"""Mesh stiffness, load sharing, transmission error, backlash."""

"""Attractors: what a motion settles to, its class and the evidence for it."""

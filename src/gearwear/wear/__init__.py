"""Wear of the flanks."""

"""Comparison with standards, closed forms and other programs."""

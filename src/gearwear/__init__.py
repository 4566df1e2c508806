"""Nonlinear dynamics of worn, hot spur gear pairs."""

__version__ = "0.2.0"

"""Nonlinear dynamics of worn, hot spur gears: the physics behind the workflow."""

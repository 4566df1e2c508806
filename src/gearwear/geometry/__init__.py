"""Geometry and kinematics of the gear pair."""

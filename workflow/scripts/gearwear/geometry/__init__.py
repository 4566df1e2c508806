"""Tooth profile, contact path and inertia of the gear pair."""

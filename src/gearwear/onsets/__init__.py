"""Onsets of period doublings and of chaos."""

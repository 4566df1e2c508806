"""Onsets of period doublings and of chaos: where they lie, how sure that is, and how far they shift."""

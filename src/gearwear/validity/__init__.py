"""Ranges within which the laws of the model hold."""

"""Ranges within which the laws of the model are known to hold."""

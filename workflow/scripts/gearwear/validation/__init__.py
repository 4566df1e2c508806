"""Checks of the program against published, independent and closed-form numbers, and their verdicts."""

"""Verdicts on what the reference paper says in words, from the results of a run."""

"""Stages of the wear history: from settings and datasets to a dataset."""

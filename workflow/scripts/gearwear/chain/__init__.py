"""The stages of the chain as functions from settings and datasets to a dataset; the scripts hold the files."""

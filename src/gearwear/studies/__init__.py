"""Studies: grids of configurations."""

"""Settled motions: classes, sweeps, basins of attraction, maps."""

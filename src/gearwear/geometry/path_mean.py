"""Mean of a field over the path of contact."""

import numpy as np
import xarray as xr


def path_mean(field: xr.DataArray) -> float:
    """Return the mean of a field over the length of its path."""
    path = field["path"].values
    return float(np.trapezoid(field.values, path) / (path[-1] - path[0]))

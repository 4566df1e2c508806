"""Branches, sweeps and tables of onsets made by hand."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.branch_codes import NONE
from gearwear.codes.onset_codes import EVENTS


@pytest.fixture
def make_branches():
    """Return a function that makes a dataset of branches from (period, [(value, stable, special), ...])."""

    def make(*branches):
        nodes = [(i, *node) for i, (_, own) in enumerate(branches) for node in own]
        values = np.array([node[1] for node in nodes])
        section = np.stack([values, -values], axis=1)
        return xr.Dataset(
            {
                "branch_index": ("node", [node[0] for node in nodes]),
                "stable": ("node", [int(node[2]) for node in nodes]),
                "special_point": ("node", [node[3] if len(node) > 3 else NONE for node in nodes]),
                "branch_displacement": (("node", "iterate"), section[:, :1]),
                "branch_velocity": (("node", "iterate"), section[:, 1:]),
                "branch_period": ("branch", [period for period, _ in branches]),
            },
            {"mesh_frequency": ("node", values)},
        )

    return make


@pytest.fixture
def make_onsets():
    """Return a function that makes the dataset of one case from the places of its events; nan is absent."""

    def make(places, how=None, resolution=0.0, seen=None):
        places = np.array(places, dtype=float)
        codes = np.where(np.isnan(places), 0, 1) if how is None else np.array(how)
        words = np.array([f"remark {code}" for code in codes], dtype=object)
        return xr.Dataset(
            {
                "onset": ("event", places),
                "onset_seen": ("event", places if seen is None else np.array(seen)),
                "onset_how": ("event", codes),
                "onset_resolution": ("event", np.full(places.shape, resolution)),
                "onset_remark": ("event", words),
            },
            {"event": np.array(EVENTS, dtype=object)},
        )

    return make

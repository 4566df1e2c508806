"""How far the events of one case shift to those of another: numerical error and spread over an ensemble."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.onset_codes import ERRORS, EVENTS, LOCATED, RESOLUTION, TOTAL, VARIANTS, VARIED

CASES = ("without", "with")
FEWEST = 2  # members for a quantile


def shifts(
    onsets: dict[str, xr.Dataset],
    variants: dict[str, xr.Dataset],
    members: dict[str, dict[str, xr.Dataset]],
    order: str,
    factors: dict[str, dict[str, float]],
) -> xr.Dataset:
    """Return the shift of every event from the first to the second case, its errors and those of the members.

    A shift is taken between two cases computed in the same way. A contribution to its numerical error is how far the
    ways that vary one thing lead from the usual sweep; nan where this or all of them miss the event. The total is how
    far any way leads from the shift itself, which goes by the place on the branch also where the usual sweep passes
    it; what the resolution of either onset leaves open is added.

    Parameters
    ----------
    onsets, variants : by case of CASES; the events as record.columns has them.
    members : by case and name, as `onsets`.
    order : of the sweep that `onsets` goes by.
    factors : on the parameters, by member.
    """
    where = {case: _located(onsets[case]) for case in CASES}
    seen = [variants[case]["onset_seen"].sel(variant=list(VARIANTS)).values for case in CASES]
    by_variant = seen[1] - seen[0]
    resolution = sum(np.nan_to_num(onsets[case]["onset_resolution"].values) for case in CASES) / 2
    usual = by_variant[VARIANTS.index(order)]
    errors = {RESOLUTION: resolution}
    for name, varied in VARIED.items():
        errors[name] = _farthest(by_variant[[VARIANTS.index(variant) for variant in varied]], usual)
    shift = where["with"] - where["without"]
    errors[TOTAL] = _farthest(by_variant, shift) + resolution
    parameters = list(next(iter(factors.values()), {}))
    scale = np.array([[factors[member][name] for name in parameters] for member in factors], dtype=float)
    table: dict[str, Any] = {
        "event": ("event", np.array(EVENTS, dtype=object)),
        "variant": ("variant", np.array(VARIANTS, dtype=object)),
        "error": ("error", np.array(ERRORS, dtype=object)),
        "member": ("member", np.array(list(factors), dtype=object)),
        "parameter": ("parameter", np.array(parameters, dtype=object)),
        "onset_shift": ("event", shift),
        "variant_shift": (("variant", "event"), by_variant),
        "shift_error": (("error", "event"), np.array([errors[name] for name in ERRORS])),
        "factor": (("member", "parameter"), scale.reshape(len(factors), len(parameters))),
    }
    for case in CASES:
        own = [members[case][name] for name in factors]
        table[f"onset_{case}"] = ("event", where[case])
        known = np.array([_located(one) for one in own]).reshape(len(own), len(EVENTS))
        table[f"member_onset_{case}"] = (("member", "event"), known)
        table[f"member_how_{case}"] = (("member", "event"), _stack(own, "onset_how", np.int32))
        table[f"member_remark_{case}"] = (("member", "event"), _stack(own, "onset_remark", object))
    of_members = table["member_onset_with"][1] - table["member_onset_without"][1]
    table["member_shift"] = (("member", "event"), of_members)
    return xr.Dataset(table).set_coords(["event", "variant", "error", "member", "parameter"])


def span(table: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Return between what the shift lies over all ways of computing and its resolution, each (events,)."""
    shift, ways = table["onset_shift"].values, table["variant_shift"].values
    resolution = table["shift_error"].sel(error=RESOLUTION).values
    return np.fmin(shift, np.fmin.reduce(ways)) - resolution, np.fmax(shift, np.fmax.reduce(ways)) + resolution


def drawn(table: xr.Dataset) -> np.ndarray:
    """Return which members are drawn from the box, (members,) bool; the others lie at its faces."""
    return np.array([str(name).startswith("box_") for name in table["member"].values], dtype=bool)


def spread(table: xr.Dataset) -> dict[str, np.ndarray]:
    """Return the statistics of the members drawn from the box, each (events,); nan where too few have the event.

    exists : number of members where both cases have the event; median, low, high : 50, 5 and 95 % quantiles of the
    shift, with linear interpolation; earlier : share of the members that have it where the second case comes first.
    """
    values = table["member_shift"].values[drawn(table)]
    known = [column[np.isfinite(column)] for column in values.T]
    quantiles = [
        np.quantile(column, (0.5, 0.05, 0.95)) if len(column) >= FEWEST else np.full(3, np.nan) for column in known
    ]
    median, low, high = np.transpose(quantiles)
    return {
        "exists": np.array([len(column) for column in known]),
        "median": median,
        "low": low,
        "high": high,
        "earlier": np.array([np.mean(column < 0) if len(column) else np.nan for column in known]),
    }


def _located(onsets: xr.Dataset) -> np.ndarray:
    return np.where(np.isin(onsets["onset_how"].values, LOCATED), onsets["onset"].values, np.nan)


def _farthest(ways: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Return the largest distance of the rows of `ways` that are known from `place`; nan where none is."""
    distance = abs(ways - place)
    return np.where(np.isfinite(distance).any(axis=0), np.nan_to_num(distance).max(axis=0), np.nan)


def _stack(datasets: Any, name: str, kind: Any) -> np.ndarray:
    return np.array([dataset[name].values for dataset in datasets], dtype=kind).reshape(len(datasets), len(EVENTS))

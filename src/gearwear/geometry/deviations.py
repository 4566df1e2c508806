"""Deviations of the flanks as made: tip relief of both gears and the spacing of successive pairs."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.contact_path import ContactPath


def tip_relief(contact: ContactPath, relief: dict[str, Any]) -> np.ndarray:
    """Return the depth relieved from the flanks of pinion and gear (m, normal to the flank), shape (2, n).

    C(s) = C_a (l/L)^n, l being how far the contact is past the start of the relief, L the length of the relief along
    the path of contact. Relief over the whole double contact is long, over half of it short
    (Munro, Morrish and Palmer 1999). The gear's tip enters the contact, the pinion's leaves it.

    Parameters
    ----------
    contact : the path of contact.
    relief : by gear: `amount` C_a at the tip (m), `length` L over that of a double contact, `exponent` n.
    """
    double = contact.lowest_single_contact - contact.start_of_contact
    depth = []
    for name, from_tip in (
        ("pinion", contact.end_of_contact - contact.path),
        ("gear", contact.path - contact.start_of_contact),
    ):
        one = relief[name]
        past = np.maximum(1 - from_tip / (one["length"] * double), 0.0)
        depth.append(one["amount"] * past ** one["exponent"])
    return np.stack(depth)


def spacing(contact: ContactPath, base_pitch: float, spacing_error: float, base_pitch_difference: float) -> np.ndarray:
    """Return the material that a pair lacks by the spacing of successive pairs (m), shape (n,), of either sign.

    Either way the leaving pair lacks that much against the pair that has entered after it.

    Parameters
    ----------
    contact : the path of contact.
    base_pitch : m.
    spacing_error : E_s (m), what a pair lacks while it leaves, and not before (Chen and Shao 2013).
    base_pitch_difference : m, what a pair lacks more with every base pitch along its path; nothing at the pitch point.
    """
    leaving = (contact.partner >= 0) & (contact.partner < np.arange(len(contact.path)))
    ramp = (contact.path - contact.pitch_point) / base_pitch
    return np.where(leaving, spacing_error, 0.0) + base_pitch_difference * ramp


def lacking(geometry: xr.Dataset) -> np.ndarray:
    """Return the material that a new pair lacks along its path, by relief and spacing (m), shape (n,)."""
    return geometry["tip_relief"].values.sum(axis=0) + geometry["spacing"].values

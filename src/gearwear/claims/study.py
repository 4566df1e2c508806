"""The results of a run as the claims read them, with one way to say that they do not suffice."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

NODE_TOLERANCE = 1e-6
"""Distance, in base pitches, within which a path node stands at a named point of the path."""


class Undecided(Exception):
    """The results do not allow a verdict; the message says why and becomes the text of what was found."""


@dataclass(frozen=True)
class Study:
    """Datasets of one run and the states that the figures draw.

    Parameters
    ----------
    results
        Datasets under ``"geometry"``, ``("temperature" | "deformation" | "flash_growth", case)``,
        ``("wear" | "mesh_stiffness" | "transmission_error" | "backlash", case, cycle)`` and
        ``("sweep", case, name)``. Values may be opened on access; only the keys are iterated.
    diagonal
        Drawn states (case, last wear cycle), from the cold unworn one to the hottest, most worn one.
    """

    results: Mapping[Any, Any]
    diagonal: tuple[tuple[str, int], ...]

    def field(self, name: str, *key: Any) -> xr.DataArray:
        """Return variable `name` of the dataset `key`, loaded.

        Raises
        ------
        Undecided
            If the dataset, the variable or one of its coordinates is missing, or a value is not finite.
        """
        label = describe(key)
        try:
            dataset = self.results[key if len(key) > 1 else key[0]]
        except KeyError:
            raise Undecided(f"no result {label}") from None
        if name not in dataset.variables:
            raise Undecided(f"no variable {name} in {label}")
        field = dataset[name].load()
        for dimension in ("path", "mesh_phase", "gear", "influence"):
            if dimension in field.dims and dimension not in field.coords:
                raise Undecided(f"no coordinate {dimension} in {label}")
        if field.size == 0 or not np.all(np.isfinite(field.values)):
            raise Undecided(f"{name} in {label} is empty or not finite")
        return field

    def scalar(self, name: str) -> float:
        """Return a scalar of the geometry."""
        return self.field(name, "geometry").item()

    def cycles(self, case: str) -> list[int]:
        """Return the wear cycles of `case` that are among the results, ascending; never empty."""
        cycles = sorted(key[2] for key in self.results if isinstance(key, tuple) and key[:2] == ("wear", case))
        if not cycles:
            raise Undecided(f"no wear cycle of case {case}")
        return cycles

    def bulk_temperature(self, case: str) -> float:
        """Return the bulk temperature, in the unit of the contact temperature, rounded to 1e-6.

        It is the contact temperature at the pitch point, where nothing slides.
        """
        contact = self.field("contact_temperature", "temperature", case)
        return round(float(contact.values[self.pitch_node(contact)]), 6)

    def worn_states(self) -> list[tuple[str, int]]:
        """Return the drawn states (case, cycle) after at least one wear cycle; never empty."""
        worn = [(case, cycle) for case, cycle in self.diagonal if cycle > 0]
        if not worn:
            raise Undecided("no worn state is drawn")
        return worn

    def heated_states(self) -> list[tuple[str, int]]:
        """Return the drawn states (case, cycle) warmer than the coldest drawn one; never empty."""
        bulk = [self.bulk_temperature(case) for case, _ in self.diagonal]
        heated = [state for state, value in zip(self.diagonal, bulk, strict=True) if value > min(bulk)]
        if not heated:
            raise Undecided("no drawn state is warmer than the coldest one")
        return heated

    def cases_by_temperature(self) -> list[str]:
        """Return the drawn cases in order of bulk temperature: one of each temperature, at least two."""
        by_temperature: dict[float, str] = {}
        for case, _ in self.diagonal:
            by_temperature.setdefault(self.bulk_temperature(case), case)
        if len(by_temperature) < 2:
            raise Undecided("all drawn states have one bulk temperature")
        return [by_temperature[value] for value in sorted(by_temperature)]

    def pitch_node(self, field: xr.DataArray) -> int:
        """Return the index of the pitch point on the path of `field`."""
        return int(self.nodes_at(field, "pitch_point")[0])

    def nodes_at(self, field: xr.DataArray, point: str) -> np.ndarray:
        """Return the indices, at least one, of the path nodes of `field` at a named point."""
        place = self.scalar(point)
        distance = np.abs(field["path"].values - place)
        nodes = np.flatnonzero(distance <= NODE_TOLERANCE * self.scalar("base_pitch"))
        if nodes.size == 0:
            raise Undecided(f"the path has no node at {point} = {1e3 * place:.4f} mm")
        return nodes


def describe(key: tuple[Any, ...]) -> str:
    """Return a result's key as words, such as ``wear/with/q021``."""
    return "/".join(f"q{part:03d}" if isinstance(part, int) else part for part in key)

"""The oscillator with backlash for use in programs: settled motions, sweeps, branches, basins."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.onset_codes import ORDERS
from gearwear.errors import GearwearError
from gearwear.io.store import attributes_of
from gearwear.motions.basin_variables import basins_along
from gearwear.motions.basins import cell_centres
from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import sweep
from gearwear.motions.trace import portraits
from gearwear.orbits.branch_variables import columns as branch_columns
from gearwear.orbits.continuation import Limits
from gearwear.orbits.seeds import branches_of_sweeps
from gearwear.oscillator.excitation import Excitation, SweptOscillator, excitation
from gearwear.oscillator.periodic import Harmonics
from gearwear.oscillator.prescribed import given_excitation

SETTLING = Settling(
    transient_periods=400,
    longest_transient=6400,
    sampled_periods=240,
    largest_period=60,
    recurrence_tolerance=1e-7,
    chaos_threshold=3e-3,
)
QUANTITIES = ("mesh_frequency", "ste", "backlash")
READINGS = ("rescale", "clearance")
STARTS = ("stiffest_mesh", "pair_entry")


class Oscillator:
    """Gear pair as an oscillator with backlash, in dimensionless form (Kahraman and Singh, 1990).

    ``X'' + 2 zeta X' + k(tau) f(X; b) = F - e''`` with ``tau = frac(w t / 2 pi)``, and ``f = X - b`` above b, 0 within
    -b and b, ``X + b`` below -b. Lengths are over the initial half backlash b0, the stiffness over its mean, and times
    are in units of the inverse natural frequency.

    `from_harmonics` and `from_arrays` make one, and `gearwear.GearPair.oscillator` that of a gear pair.

    Parameters
    ----------
    excitation : gearwear.oscillator.excitation.Excitation
        Mean force, stiffness, error and clearance over the mesh period.
    damping_ratio : float
        zeta, above 0.
    torque_amplitudes, torque_phases : sequences of float
        Harmonics of an external torque, over the mean force, and their phases (rad).
    torque_frequency_ratio : float
        Frequency of the first of them over the mesh frequency.
    start : {"stiffest_mesh", "pair_entry"}
        Instant at which the initial state is given: where the first harmonic of the stiffness is largest, or mesh
        phase 0.
    displacement, velocity : float
        The initial state, over b0 and over b0 times the natural frequency.
    tolerance : float
        Relative tolerance of the integrator, used with a torque that does not repeat within 64 mesh periods.

    Raises
    ------
    GearwearError
        An argument is outside its range; the message names it. It is a ValueError.

    Examples
    --------
    >>> import gearwear
    >>> oscillator = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], error=[0.01], damping_ratio=0.05)
    >>> sweep = oscillator.sweep([0.5, 0.9, 1.0])
    >>> sweep.period.values
    array([1, 1, 1], dtype=int32)
    """

    def __init__(
        self,
        excitation: Excitation,
        damping_ratio: float,
        *,
        torque_amplitudes: Sequence[float] = (),
        torque_phases: Sequence[float] = (),
        torque_frequency_ratio: float = 1.0,
        start: str = "stiffest_mesh",
        displacement: float = 0.0,
        velocity: float = 0.0,
        tolerance: float = 1e-10,
    ) -> None:
        one_of("start", start, STARTS)
        self.excitation = excitation
        self._dynamics: dict[str, Any] = {
            "damping_ratio": damping_ratio,
            "torque_fluctuation": {
                "frequency_ratio": torque_frequency_ratio,
                "amplitudes": tuple(torque_amplitudes),
                "phases": tuple(torque_phases),
            },
            "start": {"at": start, "displacement": float(displacement), "velocity": float(velocity)},
            "tolerance": _positive("tolerance", tolerance),
        }
        self._swept("mesh_frequency").at(1.0)  # refuses what cannot be

    @classmethod
    def from_harmonics(
        cls,
        mean_force: float,
        *,
        stiffness: Sequence[float] = (),
        stiffness_phases: Sequence[float] | None = None,
        error: Sequence[float] = (),
        error_phases: Sequence[float] | None = None,
        clearance: float = 1.0,
        damping_ratio: float,
        **options: Any,
    ) -> Oscillator:
        """Return an oscillator by its dimensionless equation.

        Parameters
        ----------
        mean_force : float
            F, mean force over mean stiffness times b0.
        stiffness, stiffness_phases : sequences of float
            Amplitudes of the harmonics 1, 2, ... of the stiffness over its mean, and their phases (rad); 0 by default.
        error, error_phases : sequences of float
            The same of the static transmission error over b0.
        clearance : float
            Half backlash over b0.
        damping_ratio, **options
            As in the class.

        Returns
        -------
        Oscillator

        Raises
        ------
        GearwearError
            An argument is outside its range.

        Examples
        --------
        >>> import gearwear
        >>> ks_1991 = gearwear.Oscillator.from_harmonics(
        ...     0.1, stiffness=[-0.2, -0.1, -0.05], error=[0.01, 0.004, 0.002], damping_ratio=0.05)
        >>> ks_1991.settle(0.5).period.item()
        1
        """
        if any(error) and not error[0]:
            raise GearwearError(
                "error: the first amplitude is 0 and another is not; all are scaled by the first, so give it a value, "
                "however small"
            )
        waves = {}
        for name, amplitudes, phases in (
            ("stiffness", stiffness, stiffness_phases),
            ("error", error, error_phases),
        ):
            given = [0.0] * len(amplitudes) if phases is None else list(phases)
            if len(given) != len(amplitudes):
                raise GearwearError(f"{name}_phases: {len(given)} for {len(amplitudes)} amplitudes; give one for each")
            waves[name] = {"amplitudes": list(amplitudes), "phases": given}
        source = given_excitation({"mean_force": float(mean_force), **waves})
        return cls(source._replace(clearance=Harmonics(float(clearance))), damping_ratio, **options)

    @classmethod
    def from_arrays(
        cls,
        stiffness: Any,
        error: Any,
        force: float,
        *,
        damping_ratio: float,
        clearance: Any = None,
        half_backlash: float | None = None,
        mass: float | None = None,
        width: Any = None,
        harmonics: int | str = 1,
        double_contact: Any = None,
        **options: Any,
    ) -> Oscillator:
        """Return an oscillator from arrays over one mesh period, in any coherent units.

        Parameters
        ----------
        stiffness : array_like, shape (m,)
            Mesh stiffness (N/m) in the cells of the mesh period, the first of which begins where a pair enters.
        error : array_like, shape (m,)
            Static transmission error (m) there.
        force : float
            Mean mesh force (N).
        damping_ratio : float
            Of the mesh.
        clearance : array_like, shape (m,), optional
            Half backlash (m); its mean and its harmonics enter. `half_backlash` everywhere by default.
        half_backlash : float, optional
            Unit of length (m); the mean of `clearance` by default.
        mass : float, optional
            Equivalent mass (kg), for the natural frequency alone.
        width : array_like, shape (m,), optional
            Widths of the cells in parts of the mesh period, with sum 1; equal by default.
        harmonics : int or "full"
            Harmonics kept of stiffness, error and clearance; "full" takes stiffness and error piecewise linear.
        double_contact : array_like of bool, shape (m,)
            Needed for "full": the cells with two pairs in contact. Stiffness and error jump where this changes.
        **options
            As in the class.

        Returns
        -------
        Oscillator

        Raises
        ------
        GearwearError
            An argument is outside its range, or an array has another length.

        Examples
        --------
        >>> import numpy as np
        >>> import gearwear
        >>> phase = (np.arange(64) + 0.5) / 64
        >>> oscillator = gearwear.Oscillator.from_arrays(
        ...     4e8 * (1 + 0.2 * np.cos(2 * np.pi * phase)), 5e-6 * np.cos(2 * np.pi * phase), 2000.0,
        ...     damping_ratio=0.07, half_backlash=50e-6)
        >>> oscillator.sweep([0.4, 0.6]).period.values
        array([1, 1], dtype=int32)
        """
        if clearance is None and half_backlash is None:
            raise GearwearError("clearance: give it over the mesh period, or half_backlash, in m")
        given = {"stiffness": stiffness, "error": error, "width": width, "clearance": clearance}
        cells, double = _cells(given, half_backlash, harmonics, double_contact)
        unit = float(cells["clearance"] @ cells["width"]) if half_backlash is None else float(half_backlash)
        for name, value in (("half_backlash", unit), ("mass", 1.0 if mass is None else mass)):
            _positive(name, value)
        mesh = {
            "mesh_phase": np.cumsum(cells["width"]) - cells["width"] / 2,
            "mesh_phase_width": cells["width"],
            "leaving": np.where(double, 0, -1),
        }
        geometry = xr.Dataset({name: ("mesh_phase", values) for name, values in mesh.items()})
        geometry = geometry.assign(base_radius=("gear", [1.0, 1.0]), equivalent_mass=np.nan if mass is None else mass)
        state = xr.Dataset(
            {
                "mesh_stiffness": ("mesh_phase", cells["stiffness"]),
                "transmission_error": ("mesh_phase", cells["error"]),
                "backlash": ("mesh_phase", cells["clearance"]),
                "initial_half_backlash": unit,
            }
        )
        settings = {
            "stiffness": "nominal",
            "harmonics": harmonics,
            "ste_amplitude": "harmonic",
            "clearance": "mean" if clearance is None else "varying",
            "model": "torsional",
        }
        source = excitation(geometry, state, state, float(force), settings)
        return cls(source, damping_ratio, **options)

    def settle(self, mesh_frequency: float, state: Sequence[float] | None = None, **settling: Any) -> xr.Dataset:
        """Return the motion that the oscillator settles to.

        Parameters
        ----------
        mesh_frequency : float
            Over the natural frequency.
        state : (float, float), optional
            Displacement and velocity at mesh phase 0, over b0; the start of the oscillator by default.
        **settling
            As in `sweep`.

        Returns
        -------
        xarray.Dataset
            The variables of `sweep` without the dimension of the swept quantity.

        Examples
        --------
        >>> import gearwear
        >>> motion = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], damping_ratio=0.05).settle(0.7)
        >>> int(motion.period), round(float(motion.section_displacement[-1]), 2)
        (1, 1.06)
        """
        wanted = _settling(settling)
        oscillator = self._swept("mesh_frequency").at(_positive("mesh_frequency", mesh_frequency))
        begin = rest_state(self.excitation, oscillator, self._dynamics) if state is None else tuple(map(float, state))
        motion = settle(oscillator, begin, wanted, self._dynamics["tolerance"])
        table = xr.Dataset(columns([motion], wanted.sampled_periods, self.excitation.force_parameter))
        return described(table.assign(mesh_frequency=("point", [float(mesh_frequency)]))).isel(point=0)

    def sweep(
        self,
        mesh_frequency: Any,
        *,
        ste: Any = None,
        backlash: Any = None,
        order: str = "restart",
        reading: str = "rescale",
        **settling: Any,
    ) -> xr.Dataset:
        """Return the settled motions over a swept quantity: classes, sections, exponents.

        Parameters
        ----------
        mesh_frequency : array_like or float
            Mesh frequencies over the natural frequency, ascending; the one mesh frequency if another quantity is swept.
        ste : array_like, optional
            Mean static transmission errors over that of the reference (of the oscillator as given), ascending.
        backlash : array_like, optional
            Mean half backlashes over the initial one, ascending.
        order : {"restart", "up", "down"}
            Every motion from the start of the oscillator, or with continuation from its neighbour.
        reading : {"rescale", "clearance"}
            What the backlash changes: the unit of length, hence the relative excitation, or the clearance alone.
        **settling
            `transient_periods` (400), `longest_transient` (6400), `sampled_periods` (240) and `largest_period` (60), in
            mesh periods; `recurrence_tolerance` (1e-7, over b0); `chaos_threshold` (3e-3, exponent per unit of
            dimensionless time).

        Returns
        -------
        xarray.Dataset
            Along the swept quantity: `motion_class`, `period`, `section_displacement` and `section_velocity` (with
            `sample`), `lyapunov_exponent`, extremes, share of contact loss and the evidence for the class.

        Examples
        --------
        >>> import gearwear
        >>> oscillator = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], damping_ratio=0.05)
        >>> sweep = oscillator.sweep([0.6, 0.7, 0.8], order="up")
        >>> sweep.sel(mesh_frequency=0.7).lyapunov_exponent.item() < 0
        True
        """
        one_of("order", order, ORDERS)
        swept, values = self._sweep(mesh_frequency, ste, backlash, reading)
        if (np.diff(values) <= 0).any():
            raise GearwearError(f"{swept.quantity}: the values must ascend")
        found = described(sweep(swept, values, _settling(settling), order)).set_coords(swept.quantity)
        attributes = {"swept": swept.quantity, "order": order, **swept.settings}
        return found.swap_dims(point=swept.quantity).assign_attrs(attributes)

    def branches(
        self,
        sweeps: xr.Dataset | Iterable[xr.Dataset],
        *,
        largest_period: int = 4,
        largest_step: float = 0.02,
        most_nodes: int = 4000,
    ) -> xr.Dataset:
        """Return the branches of periodic orbits, stable and unstable, on which the motions of sweeps lie.

        Parameters
        ----------
        sweeps : xarray.Dataset or several
            Results of `sweep` of this oscillator over one quantity; their range is that of the branches.
        largest_period : int
            Longest period of an orbit, in mesh periods.
        largest_step : float
            Along a branch: state over b0, swept quantity over its range.
        most_nodes : int
            Orbits after which a branch is given up.

        Returns
        -------
        xarray.Dataset
            Orbits along `node`, with Floquet multipliers, stability and kind of special point; branches along `branch`.

        Examples
        --------
        >>> import gearwear
        >>> oscillator = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], damping_ratio=0.05)
        >>> branches = oscillator.branches(oscillator.sweep([0.6, 0.7]))
        >>> branches.branch_period.values
        array([1], dtype=int32)
        """
        several = [sweeps] if isinstance(sweeps, xr.Dataset) else list(sweeps)
        swept = [one.attrs.get("swept") for one in several]
        if not several or len(set(swept)) > 1 or swept[0] not in QUANTITIES:
            raise GearwearError("sweeps: give results of Oscillator.sweep over one quantity")
        quantity = swept[0]
        settings = {name: several[0].attrs[name] for name in ("mesh_frequency", "reading") if name in several[0].attrs}
        values = np.concatenate([one[quantity].values for one in several])
        if values.min() == values.max():
            raise GearwearError("sweeps: all at one value; branches need a range")
        limits = Limits(float(values.min()), float(values.max()), largest_step, most_nodes=most_nodes)
        found = branches_of_sweeps(self._swept(quantity, settings), several, limits, largest_period)
        return described(xr.Dataset(branch_columns(found, largest_period, quantity))).set_coords(quantity)

    def basins(
        self,
        mesh_frequency: Any,
        *,
        ste: Any = None,
        backlash: Any = None,
        reading: str = "rescale",
        displacement: tuple[float, float] = (-2.0, 3.0),
        velocity: tuple[float, float] = (-2.0, 3.0),
        resolution: int = 100,
        **settling: Any,
    ) -> xr.Dataset:
        """Return the attractors at values of a quantity, and which initial states lead to which.

        Parameters
        ----------
        mesh_frequency, ste, backlash, reading
            As in `sweep`; the values need not ascend.
        displacement, velocity : (float, float)
            Range of initial states at mesh phase 0, over b0 and over b0 times the natural frequency.
        resolution : int
            Cells each way.
        **settling
            As in `sweep`.

        Returns
        -------
        xarray.Dataset
            `basin` by cell: index of the attractor, -1 if undecided; `share`, and the variables of `sweep`, along
            `attractor`.

        Examples
        --------
        >>> import gearwear
        >>> oscillator = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], damping_ratio=0.05)
        >>> basins = oscillator.basins(0.7, resolution=4)
        >>> basins.attractors.item(), basins.basin.sizes["displacement_cell"]
        (1, 4)
        """
        if resolution < 1:
            raise GearwearError(f"resolution: {resolution} must be at least 1")
        swept, values = self._sweep(mesh_frequency, ste, backlash, reading)
        grid = [cell_centres(*ends, resolution) for ends in (displacement, velocity)]
        return described(basins_along(swept, values, grid[0], grid[1], _settling(settling))).set_coords(swept.quantity)

    def portraits(
        self, mesh_frequency: Any, *, ste: Any = None, backlash: Any = None, reading: str = "rescale", **settling: Any
    ) -> xr.Dataset:
        """Return the settled motions over one period, from the start of the oscillator.

        Parameters
        ----------
        mesh_frequency, ste, backlash, reading, **settling
            As in `sweep`; the values need not ascend.

        Returns
        -------
        xarray.Dataset
            `orbit_displacement` and `orbit_velocity` along `time`, with `orbit_period`, the time in mesh periods; and
            the variables of `sweep`.

        Examples
        --------
        >>> import gearwear
        >>> oscillator = gearwear.Oscillator.from_harmonics(0.1, stiffness=[0.2], damping_ratio=0.05)
        >>> oscillator.portraits(0.7).orbit_displacement.max().item() > 1
        True
        """
        swept, values = self._sweep(mesh_frequency, ste, backlash, reading)
        return described(portraits(swept, values, _settling(settling))).set_coords(swept.quantity)

    def _swept(self, quantity: str, settings: dict[str, Any] | None = None) -> SweptOscillator:
        return SweptOscillator(self.excitation, quantity, self._dynamics, settings or {})

    def _sweep(self, mesh_frequency: Any, ste: Any, backlash: Any, reading: str) -> tuple[SweptOscillator, np.ndarray]:
        """Return the swept oscillator and the values of the swept quantity."""
        one_of("reading", reading, READINGS)
        others = {name: values for name, values in (("ste", ste), ("backlash", backlash)) if values is not None}
        if len(others) > 1:
            raise GearwearError("ste and backlash: one of them can be swept at a time")
        if not others:
            return self._swept("mesh_frequency"), _values("mesh_frequency", mesh_frequency)
        ((quantity, values),) = others.items()
        if np.ndim(mesh_frequency):
            raise GearwearError(f"mesh_frequency: several values; give one for a sweep over {quantity}")
        settings: dict[str, Any] = {"mesh_frequency": _positive("mesh_frequency", mesh_frequency)}
        settings |= {"reading": reading} if quantity == "backlash" else {}
        return self._swept(quantity, settings), _values(quantity, values)


def described(dataset: xr.Dataset) -> xr.Dataset:
    """Return a dataset whose variables have the units, names and flags of the result files."""
    found = dataset.copy()
    for name, values in found.variables.items():
        found[name].attrs = attributes_of(str(name), tuple(map(str, values.dims)), values.dtype)
    return found


def one_of(name: str, value: Any, allowed: Sequence[str]) -> None:
    """Refuse an argument that is not one of the words allowed.

    Raises
    ------
    GearwearError
    """
    if value not in allowed:
        raise GearwearError(f"{name}: {value!r}; give {', '.join(allowed[:-1])} or {allowed[-1]}")


def _cells(
    given: dict[str, Any], half_backlash: float | None, harmonics: int | str, double_contact: Any
) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Return stiffness, error, width and clearance in the cells of the mesh period, and which have two pairs."""
    k = np.asarray(given["stiffness"], dtype=float)
    usual = {"width": 1 / max(k.size, 1), "clearance": half_backlash}
    cells = {
        name: np.full(k.shape, usual[name]) if values is None else np.asarray(values, dtype=float)
        for name, values in given.items()
    }
    for name, values in cells.items():
        if values.shape != k.shape or values.ndim != 1 or values.size < 2 or not np.isfinite(values).all():
            raise GearwearError(
                f"{name}: shape {values.shape}; give finite numbers, one for each cell of the mesh period, as many as "
                "in stiffness and at least 2"
            )
    if not np.isclose(cells["width"].sum(), 1, rtol=0, atol=1e-9) or cells["width"].min() <= 0:
        raise GearwearError(f"width: above 0 with sum 1, not {cells['width'].sum():g}")
    if harmonics != "full" and not (isinstance(harmonics, int) and 1 <= harmonics < k.size):
        raise GearwearError(f'harmonics: {harmonics!r}; give a whole number from 1 to below {k.size}, or "full"')
    double = np.zeros(k.shape, dtype=bool) if double_contact is None else np.asarray(double_contact, dtype=bool)
    if harmonics == "full" and (double.shape != k.shape or double.all() or not double.any()):
        raise GearwearError('double_contact: harmonics "full" needs cells with two pairs and cells with one')
    return cells, double


def _settling(changed: dict[str, Any]) -> Settling:
    names = Settling._fields
    for name in changed:
        if name not in names:
            raise GearwearError(f"{name}: unknown argument; settling takes {', '.join(names)}")
    return SETTLING._replace(**changed)


def _positive(name: str, value: Any) -> float:
    number = float(value)
    if not (np.isfinite(number) and number > 0):
        raise GearwearError(f"{name}: {number:g}; give finite numbers above 0")
    return number


def _values(name: str, values: Any) -> np.ndarray:
    array = np.atleast_1d(np.asarray(values, dtype=float))
    if array.ndim > 1 or not array.size:
        raise GearwearError(f"{name}: shape {array.shape}; give one number or a list of them")
    least = 0.0 if name == "ste" else np.nextafter(0, 1)
    if not np.isfinite(array).all() or array.min() < least:
        raise GearwearError(f"{name}: give finite numbers {'from' if name == 'ste' else 'above'} 0")
    return array

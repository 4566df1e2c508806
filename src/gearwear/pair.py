"""The gear pair for use in programs: stiffness, transmission error, load sharing, temperature, growth and wear."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from pydantic import ValidationError
from pydantic.fields import FieldInfo

from gearwear.chain import deformation as growth_stage
from gearwear.chain import geometry as geometry_stage
from gearwear.chain import mesh as mesh_stages
from gearwear.chain import response as response_stage
from gearwear.chain import temperature as temperature_stage
from gearwear.chain import wear as wear_stage
from gearwear.config import pair as sections
from gearwear.config import study
from gearwear.config.derived import RULES
from gearwear.config.messages import Place, problems_of
from gearwear.config.types import Section
from gearwear.dynamics import SETTLING, Oscillator, described
from gearwear.errors import GearwearError
from gearwear.geometry.involute import GEARS
from gearwear.geometry.kinematics import mesh_force
from gearwear.heat import bulk
from gearwear.io.store import together
from gearwear.oscillator.excitation import excitation

_COLD = 20.0  # degC, of the pristine pair that scales the excitation


class Material(NamedTuple):
    """Material of a gear at 20 degC; the values are those of case-hardening steel.

    Pa, 1, kg/m3, J/(kg K), W/(m K), 1/K.
    """

    youngs_modulus: float = 206e9
    poisson_ratio: float = 0.3
    density: float = 7850.0
    specific_heat: float = 470.0
    thermal_conductivity: float = 46.0
    thermal_expansion: float = 1.16e-5


class Lubricant(NamedTuple):
    """Oil and roughness; the values are those of an ISO VG 100 mineral oil on ground flanks.

    dynamic_viscosity : Pa s, at 100 degC.
    viscosity_law : `fixed`, that viscosity at every temperature; `vogel`, through the values at 40 and 100 degC.
    dynamic_viscosity_40 : Pa s, at 40 degC.
    pressure_viscosity : 1/Pa.
    composite_roughness : rms of both flanks, m.
    """

    dynamic_viscosity: float = 0.0094
    viscosity_law: str = "fixed"
    dynamic_viscosity_40: float = 0.0885
    pressure_viscosity: float = 2.0e-8
    composite_roughness: float = 0.5e-6


class TipRelief(NamedTuple):
    """Tip relief of a gear: depth at the tip (m), length over that of a double contact, exponent."""

    amount: float = 0.0
    length: float = 1.0
    exponent: float = 1.0


class HeatBalance(NamedTuple):
    """How the heat leaves the gears.

    surroundings : degC.
    heat_transfer : W/(m2 K).
    area : m2; None for faces and tip cylinders of both gears.
    immersion : of pinion and gear in the oil, m.
    oil_volume : m3; oil_density : kg/m3.
    """

    surroundings: float = 40.0
    heat_transfer: float = 100.0
    area: float | None = None
    immersion: tuple[float, float] = (0.0, 6.0e-3)
    oil_volume: float = 1.0e-3
    oil_density: float = 870.0


STEEL, MINERAL_OIL, UNRELIEVED, IN_AIR = Material(), Lubricant(), TipRelief(), HeatBalance()


class GearPair:
    """External spur gear pair: its geometry, material and oil, and how the models read them.

    An argument that belongs to one gear is a pair (pinion, gear), or one value for both. Results are datasets along
    `path`, the position of a contact on the line of action (m), `mesh_phase`, and `gear`; every variable has its unit
    in the attribute `units`. The defaults are those of the default study; see the documentation of the model.

    Parameters
    ----------
    teeth : (int, int)
        Numbers of teeth of pinion and gear.
    module, face_width : float
        m.
    bore_radius : float or (float, float), optional
        Radius at which the body is held (m); 0.45 of the root radius by default.
    pressure_angle : float
        Of the basic rack, degrees.
    addendum_coefficient, profile_shift : float or (float, float)
        Over the module.
    clearance_coefficient : float
        Tip clearance over the module.
    centre_distance : float, optional
        m; the distance without backlash by default.
    inertia : float or (float, float), optional
        Polar moment of inertia (kg m2); that of a disc by default.
    tip_relief : TipRelief or two
        As made.
    spacing_error, base_pitch_difference : float
        Material that a pair lacks (m): while it leaves, and more with every base pitch along its path.
    half_backlash : float
        Half the initial backlash along the line of action (m).
    backlash_projection : {"shi", "exact"}
        Projection of wear, growth and deflection on the back side.
    centre_distance_change : float
        By mounting (m); seen by the backlash alone.
    housing_expansion, housing_temperature_rise : float
        Thermal expansion of the housing (1/K), and its temperature rise over that of the gears.
    material : Material or two
    modulus_law : {"li", "linear", "table", "constant"}
        Young's modulus over the temperature.
    modulus_calibration : float
        Factor on the heat term of law "li".
    lubricant : Lubricant
    cantilever : {"base", "root"}
        Circle on which the tooth is clamped.
    fillet_angle : {"rack", "straight", "generated"}
        Half angle of the tooth at the root circle.
    hertz : {"linear", "weber"}
        Contact stiffness: one value, or dependent on the load.
    profile_changes : {"paper", "exact", "off"}
        Effect of wear and growth on the tooth section.
    pairs : {"plain", "coupled"}
        Two pairs in contact: springs in parallel, or joined by the common foundation.
    foundation_coupling : float
        Part of the foundation compliance that the other pair feels, with `pairs` "coupled".
    error_mode : {"loaded", "no_load"}
        Transmission error with or without elastic deflection.
    error_heat : {"relative", "none", "full_removed", "full_added"}
        Thermal growth as a profile error.
    heat_in_load_sharing : bool
        Whether thermal growth shifts load between the pairs.
    initial_temperature : float
        Temperature without thermal growth, degC.
    mesh_cells : int
        Cells of one mesh period.

    Attributes
    ----------
    geometry : xarray.Dataset
        Dimensions, masses, the marks of the path of contact and the grids.

    Raises
    ------
    GearwearError
        An argument is outside its range, or the gears cannot be made or mesh; the message names value and limit. It is
        a ValueError.

    Examples
    --------
    >>> import gearwear
    >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
    >>> round(float(pair.geometry.contact_ratio), 2)
    1.72
    """

    def __init__(
        self,
        teeth: tuple[int, int],
        module: float,
        face_width: float,
        bore_radius: float | tuple[float, float] | None = None,
        *,
        pressure_angle: float = 20.0,
        addendum_coefficient: float | tuple[float, float] = 1.0,
        clearance_coefficient: float = 0.25,
        profile_shift: float | tuple[float, float] = 0.0,
        centre_distance: float | None = None,
        inertia: float | tuple[float, float] | None = None,
        tip_relief: TipRelief | tuple[TipRelief, TipRelief] = UNRELIEVED,
        spacing_error: float = 0.0,
        base_pitch_difference: float = 0.0,
        half_backlash: float = 65e-6,
        backlash_projection: str = "shi",
        centre_distance_change: float = 0.0,
        housing_expansion: float = 2.3e-5,
        housing_temperature_rise: float = 0.0,
        material: Material | tuple[Material, Material] = STEEL,
        modulus_law: str = "li",
        modulus_calibration: float = 5.3,
        lubricant: Lubricant = MINERAL_OIL,
        cantilever: str = "base",
        fillet_angle: str = "rack",
        hertz: str = "linear",
        profile_changes: str = "paper",
        pairs: str = "plain",
        foundation_coupling: float = 0.3,
        error_mode: str = "loaded",
        error_heat: str = "relative",
        heat_in_load_sharing: bool = False,
        initial_temperature: float = 20.0,
        mesh_cells: int = 240,
    ) -> None:
        given = {name: value for name, value in locals().items() if name != "self"}
        self._cfg = _sections(given)
        self._initial_temperature = float(initial_temperature)
        self.geometry = described(geometry_stage.geometry(self._cfg))

    def __repr__(self) -> str:
        z, radii = self.geometry["teeth"].values, self._cfg["gear_pair"]
        return f"<GearPair {z[0]:g}/{z[1]:g}, module {1e3 * radii['module']:g} mm>"

    def mesh_stiffness(
        self,
        torque: float | None = None,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
    ) -> xr.Dataset:
        """Return the stiffness of the mesh and of one tooth pair.

        Parameters
        ----------
        torque : float, optional
            On the pinion, N m; needed for `hertz` "weber", and without effect otherwise.
        bulk_temperature : float
            Of both gears, degC.
        wear : xarray.Dataset or array_like, shape (2, n), optional
            Depth on the flanks of pinion and gear along the path (m), or a dataset with `wear_depth`; none by default.
        growth : xarray.Dataset or array_like, shape (2, n), optional
            Thermal growth of the flanks (m), or a dataset with `thermal_growth`; by default that of `thermal_growth` at
            the bulk temperature.

        Returns
        -------
        xarray.Dataset
            `mesh_stiffness` along `mesh_phase`, `pair_stiffness` along `path` (N/m), and the compliances (m/N).

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> mesh = pair.mesh_stiffness()
        >>> mesh.mesh_stiffness.units, f"{mesh.mesh_stiffness.mean().item():.1e}"
        ('N m-1', '3.0e+08')
        """
        if torque is None and self._cfg["mesh_stiffness"]["hertz"] == "weber":
            raise GearwearError('torque: missing; the contact stiffness of hertz "weber" depends on it')
        cfg = self._at(bulk_temperature) | (self._under(torque) if torque is not None else _NO_LOAD)
        flanks = self._flanks(bulk_temperature, wear, growth)
        return described(mesh_stages.mesh_stiffness(cfg, self.geometry, *flanks))

    def transmission_error(
        self,
        torque: float,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
    ) -> xr.Dataset:
        """Return the static transmission error and the load sharing of the worn, hot pair.

        Parameters
        ----------
        torque : float
            On the pinion, N m.
        bulk_temperature, wear, growth
            As in `mesh_stiffness`.

        Returns
        -------
        xarray.Dataset
            `transmission_error` (m) and `effective_stiffness` (N/m) along `mesh_phase`; `load_sharing_factor` of the
            entering and the leaving pair; `load_share_path` and `elastic_deflection` along `path`.

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> error = pair.transmission_error(torque=135.0, bulk_temperature=80.0).transmission_error
        >>> f"{1e6 * error.mean().item():.0f} um"
        '13 um'
        """
        return described(self._state(torque, bulk_temperature, wear, growth)["transmission_error"])

    def load_sharing(
        self,
        torque: float,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
    ) -> xr.Dataset:
        """Return how the tooth pairs share the mesh force.

        Parameters
        ----------
        torque, bulk_temperature, wear, growth
            As in `transmission_error`.

        Returns
        -------
        xarray.Dataset
            `load_sharing_factor`, `load_share_path` (parts of the mesh force) and `elastic_deflection` (m).

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> pair.load_sharing(torque=135.0).load_share_path.max().item()
        1.0
        """
        shared = self.transmission_error(torque, bulk_temperature=bulk_temperature, wear=wear, growth=growth)
        return shared[["load_sharing_factor", "load_share_path", "elastic_deflection"]]

    def backlash(
        self,
        torque: float,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
    ) -> xr.Dataset:
        """Return the half backlash of the worn, hot, loaded pair.

        Parameters
        ----------
        torque, bulk_temperature, wear, growth
            As in `transmission_error`.

        Returns
        -------
        xarray.Dataset
            `backlash` along `mesh_phase` and `backlash_path` along `path` (m).

        Raises
        ------
        Infeasible
            The teeth jam.

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> hot, cold = (pair.backlash(torque=135.0, bulk_temperature=at).backlash.mean() for at in (100.0, 20.0))
        >>> (hot < cold).item()
        True
        """
        return described(self._state(torque, bulk_temperature, wear, growth)["backlash"])

    def bulk_temperature(self, torque: float, speed: float, heat_balance: HeatBalance = IN_AIR) -> float:
        """Return the bulk temperature (degC) at which losses and convection are equal.

        Parameters
        ----------
        torque, speed : float
            Of the pinion, N m and rpm.
        heat_balance : HeatBalance

        Raises
        ------
        Infeasible
            There is none within -40 to 250 degC.

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> pair.bulk_temperature(torque=135.0, speed=3400.0) > 40.0
        True
        """
        return bulk.bulk_temperature(self._cfg | self._under(torque, speed) | _heat_balance(heat_balance))

    def contact_temperature(
        self,
        torque: float,
        speed: float,
        bulk_temperature: float,
        *,
        flash: bool = True,
        flash_coefficient: float = 0.83,
        friction_law: str = "load_sharing",
        dry_friction: float = 0.2,
        boundary_friction: float = 0.1,
        heat_balance: HeatBalance = IN_AIR,
    ) -> xr.Dataset:
        """Return contact and flash temperature, friction and film of the unworn pair under the static load.

        Parameters
        ----------
        torque, speed : float
            Of the pinion, N m and rpm.
        bulk_temperature : float
            degC.
        flash : bool
            Whether the contact is hotter than the bulk.
        flash_coefficient : float
            Factor of the flash temperature.
        friction_law : {"load_sharing", "thresholds"}
            Friction over the film ratio.
        dry_friction, boundary_friction : float
            Coefficients of friction.
        heat_balance : HeatBalance
            For the heat flows at the bulk temperature.

        Returns
        -------
        xarray.Dataset
            `contact_temperature` (degC), `flash_temperature` (K), `friction_coefficient` and `film_ratio` along `path`,
            and the heat flows (W).

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> heat = pair.contact_temperature(torque=135.0, speed=3400.0, bulk_temperature=80.0)
        >>> heat.contact_temperature.units, round(heat.contact_temperature.min().item(), 6)
        ('degC', 80.0)
        """
        friction = {"law": friction_law, "dry": dry_friction, "boundary": boundary_friction}
        renamed = {"law": "friction_law", "dry": "dry_friction", "boundary": "boundary_friction"}
        cfg = self._at(bulk_temperature, flash) | self._under(torque, speed) | _heat_balance(heat_balance)
        cfg["friction"] = _checked(sections.Friction, friction, **renamed)
        cfg["heat"] = self._heat(flash_coefficient=flash_coefficient)
        return described(temperature_stage.temperature(cfg, self.geometry))

    def thermal_growth(
        self,
        bulk_temperature: float,
        *,
        contact: xr.Dataset | None = None,
        shaft_temperature_drop: float = 20.0,
        hub: str = "free_bore",
        growth: str = "paper",
    ) -> xr.Dataset:
        """Return the thermal growth of the flanks and of the base circles.

        Parameters
        ----------
        bulk_temperature : float
            degC.
        contact : xarray.Dataset, optional
            Result of `contact_temperature`, for flanks that grow with the contact temperature instead of the bulk's.
        shaft_temperature_drop : float
            Shaft below base circle, K; the shaft is never below the initial temperature.
        hub : {"free_bore", "solid_shaft"}
            Restraint of the gear body.
        growth : {"paper", "consistent", "eulerian"}
            Law of the growth of a flank.

        Returns
        -------
        xarray.Dataset
            `thermal_growth` along (`gear`, `path`) and `base_circle_growth` (m).

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> f"{1e6 * pair.thermal_growth(bulk_temperature=100.0).thermal_growth.max().item():.1f} um"
        '5.6 um'
        """
        rise = "bulk" if contact is None else "contact"
        cfg = self._at(bulk_temperature)
        cfg["heat"] = self._heat(
            temperature_rise=rise, shaft_temperature_drop=shaft_temperature_drop, hub=hub, growth=growth
        )
        return described(growth_stage.deformation(cfg, self.geometry, contact))

    def wear(
        self,
        torque: float,
        speed: float,
        cycles: float,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
        cycles_per_update: float = 1e8,
        law: str = "janakiraman",
        coefficient: float = 1e-20,
        force: str = "dynamic",
        pressure: str = "mean",
        gear_cycles: str = "tooth_ratio",
        **dynamics: Any,
    ) -> xr.Dataset:
        """Return the wear of the flanks over running cycles, and the mesh that follows from it.

        Parameters
        ----------
        torque, speed : float
            Of the pinion, N m and rpm.
        cycles : float
            Revolutions of the pinion, a whole multiple of `cycles_per_update`.
        bulk_temperature, wear, growth
            As in `mesh_stiffness`; `wear` is that before the first cycle.
        cycles_per_update : float
            Revolutions between two updates of the flanks.
        law : {"janakiraman", "constant"}
            Wear coefficient: by load, film and roughness, or `coefficient` (m2/N).
        coefficient : float
            m2/N.
        force : {"dynamic", "quasi_static"}
            Force in the wear law: that of the steady vibration at this speed, or the mean one.
        pressure : {"mean", "peak"}
            Hertz pressure in the wear law.
        gear_cycles : {"tooth_ratio", "pinion"}
            Cycles of a gear tooth: fewer by the tooth ratio, or those of the pinion.
        **dynamics
            With `force` "dynamic": `damping_ratio`, ..., and the options, as in `oscillator`.

        Returns
        -------
        xarray.Dataset
            Along `wear_cycle`, the first before wear: `wear_depth` (m), `running_cycles`, and the variables of
            `mesh_stiffness`, `transmission_error` and `backlash`.

        Raises
        ------
        Infeasible
            An update takes off too much for the steps to be stable, the teeth jam or are worn through.

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> worn = pair.wear(torque=135.0, speed=3400.0, cycles=2e8, force="quasi_static")
        >>> f"{1e6 * worn.wear_depth.isel(wear_cycle=-1).max().item():.1f} um"
        '0.2 um'
        >>> error = pair.transmission_error(torque=135.0, wear=worn.isel(wear_cycle=-1))
        """
        cfg = self._at(bulk_temperature) | self._under(torque, speed)
        cfg["wear"] = _checked(
            sections.Wear,
            {
                "cycles_per_update": cycles_per_update,
                "law": law,
                "coefficient": coefficient,
                "force": force,
                "pressure": pressure,
                "gear_cycles": gear_cycles,
            },
        )
        updates = cycles / cycles_per_update
        if not (updates >= 0 and float(updates).is_integer()):
            raise GearwearError(
                f"cycles: {cycles:g} is not a whole multiple of cycles_per_update, {cycles_per_update:g}"
            )
        cfg |= {"dynamics": _dynamics(**dynamics), "settling": SETTLING._asdict()}
        grown, flanks = self._flanks(bulk_temperature, wear, growth)
        reference = self._reference(torque)
        state = self._state(torque, bulk_temperature, flanks, grown)
        steady = np.full((1, self.geometry.sizes["path"]), mesh_force(self.geometry, torque))
        static = xr.Dataset({"mesh_force_path": (("response_period", "path"), steady)})
        found = [together([flanks, *state.values()])]
        for _ in range(int(updates)):
            motion = static
            if force == "dynamic":
                motion = response_stage.response(cfg, self.geometry, **state, **reference)
            flanks = wear_stage.wear(
                cfg, self.geometry, flanks, state["mesh_stiffness"], state["transmission_error"], motion
            )
            state = self._state(torque, bulk_temperature, flanks, grown)
            found.append(together([flanks, *state.values()]))
        whole = xr.concat(found, "wear_cycle", data_vars="all", coords="minimal", compat="override")
        return described(whole.assign_coords(wear_cycle=np.arange(len(found), dtype=np.int32)))

    def oscillator(
        self,
        torque: float,
        *,
        bulk_temperature: float = 20.0,
        wear: xr.Dataset | np.ndarray | None = None,
        growth: xr.Dataset | np.ndarray | None = None,
        damping_ratio: float = 0.072,
        stiffness: str = "nominal",
        harmonics: int | str = 1,
        ste_amplitude: str = "nominal",
        clearance: str = "mean",
        **options: Any,
    ) -> Oscillator:
        """Return the oscillator with backlash that the pair is.

        Parameters
        ----------
        torque, bulk_temperature, wear, growth
            As in `transmission_error`.
        damping_ratio : float
            Of the mesh.
        stiffness : {"nominal", "effective"}
            Sum of the pairs, or force over deflection.
        harmonics : int or "full"
            Harmonics kept of stiffness and transmission error; "full" takes them piecewise linear.
        ste_amplitude : {"nominal", "mean", "harmonic"}
            Amplitude of the error excitation: static deflection of the unworn pair at 20 degC times the relative mean
            transmission error; the mean transmission error; or its first harmonic.
        clearance : {"mean", "varying"}
            Backlash in the equation of motion.
        **options
            As in `gearwear.Oscillator`.

        Returns
        -------
        Oscillator

        Examples
        --------
        >>> import gearwear
        >>> pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))
        >>> motion = pair.oscillator(torque=135.0, bulk_temperature=100.0).settle(mesh_frequency=0.7)
        >>> motion.period.item()
        1
        """
        settings = _dynamics(
            damping_ratio=damping_ratio,
            stiffness=stiffness,
            harmonics=harmonics,
            ste_amplitude=ste_amplitude,
            clearance=clearance,
        )
        state = together(self._state(torque, bulk_temperature, wear, growth).values())
        reference = together(self._reference(torque).values())
        return Oscillator(
            excitation(self.geometry, state, reference, float(torque), settings), damping_ratio, **options
        )

    def _state(
        self,
        torque: float,
        bulk_temperature: float,
        wear: xr.Dataset | np.ndarray | None,
        growth: xr.Dataset | np.ndarray | None,
    ) -> dict[str, xr.Dataset]:
        """Return mesh stiffness, transmission error and backlash, by these names."""
        cfg = self._at(bulk_temperature) | self._under(torque)
        return mesh_stages.mesh_excitation(cfg, self.geometry, *self._flanks(bulk_temperature, wear, growth))

    def _reference(self, torque: float) -> dict[str, xr.Dataset]:
        """Return stiffness and transmission error of the cold, unworn pair, which scale the excitation."""
        state = self._state(torque, _COLD, None, None)
        return {"reference_stiffness": state["mesh_stiffness"], "reference_error": state["transmission_error"]}

    def _flanks(
        self, bulk_temperature: float, wear: xr.Dataset | np.ndarray | None, growth: xr.Dataset | np.ndarray | None
    ) -> tuple[xr.Dataset, xr.Dataset]:
        """Return the datasets of growth and wear that the stages take."""
        grown = self.thermal_growth(bulk_temperature) if growth is None else growth
        worn = wear_stage.unworn(self.geometry) if wear is None else wear
        return self._on_flanks("growth", grown, "thermal_growth"), self._on_flanks("wear", worn, "wear_depth")

    def _on_flanks(self, argument: str, given: Any, variable: str) -> xr.Dataset:
        known = isinstance(given, xr.Dataset) and variable in given
        if isinstance(given, xr.Dataset) and not known:
            raise GearwearError(f"{argument}: the dataset has no {variable}")
        values = np.asarray(given[variable] if known else given, dtype=float)
        shape = 2, self.geometry.sizes["path"]
        if values.ndim == 0:
            values = np.full(shape, values)
        if values.shape != shape or not np.isfinite(values).all():
            raise GearwearError(
                f"{argument}: shape {values.shape}; give finite numbers (m) of shape {shape}, pinion and gear along "
                "the path, or a dataset at one wear cycle"
            )
        if argument == "wear" and values.min() < 0:
            raise GearwearError(f"wear: {values.min():g} m; a depth is from 0")
        if argument == "growth":
            return xr.Dataset({variable: (("gear", "path"), values)})
        cycles = float(given.get("running_cycles", 0.0)) if known else 0.0
        return wear_stage.unworn(self.geometry).assign({variable: (("gear", "path"), values), "running_cycles": cycles})

    def _at(self, bulk_temperature: float, flash: bool = True) -> dict[str, Any]:
        case = {"bulk_temperature": bulk_temperature, "running_cycles": 0, "flash": flash}
        checked = _checked(study.Case, case)
        if isinstance(checked["bulk_temperature"], str):
            raise GearwearError("bulk_temperature: give degC; GearPair.bulk_temperature returns that of the balance")
        return self._cfg | {"case": checked, "heat": self._heat()}

    def _heat(self, **changed: Any) -> dict[str, Any]:
        usual = {
            "initial_temperature": self._initial_temperature,
            "flash_coefficient": 0.83,
            "temperature_rise": "bulk",
            "shaft_temperature_drop": 20.0,
            "hub": "free_bore",
            "growth": "paper",
        }
        return _checked(sections.Heat, usual | changed)

    @staticmethod
    def _under(torque: float, speed: float = 1.0) -> dict[str, Any]:
        operation = {"pinion_torque": torque, "pinion_speed": speed}
        renamed = {"pinion_torque": "torque", "pinion_speed": "speed"}
        return {"operation": _checked(sections.Operation, operation, **renamed)}


def _same(*names: str) -> dict[str, str]:
    return {name: name for name in names}


# Sections of the configuration that describe a pair: model, and the argument of GearPair behind every key.
_SECTIONS: dict[str, tuple[type[Section], dict[str, str]]] = {
    "gear_pair": (
        sections.GearPair,
        _same(
            "teeth",
            "module",
            "face_width",
            "pressure_angle",
            "addendum_coefficient",
            "clearance_coefficient",
            "profile_shift",
            "centre_distance",
            "bore_radius",
            "inertia",
        ),
    ),
    "micro_geometry": (sections.MicroGeometry, _same("tip_relief", "spacing_error", "base_pitch_difference")),
    "grid": (sections.Grid, _same("mesh_cells")),
    "material": (sections.Material, _same(*GEARS)),
    "elasticity": (sections.Elasticity, {"law": "modulus_law", "calibration": "modulus_calibration"}),
    "lubricant": (sections.Lubricant, _same(*Lubricant._fields)),
    "mesh_stiffness": (
        sections.MeshStiffness,
        _same("cantilever", "fillet_angle", "hertz", "profile_changes", "pairs", "foundation_coupling"),
    ),
    "transmission_error": (
        sections.TransmissionError,
        {"mode": "error_mode", "heat": "error_heat", "heat_in_load_sharing": "heat_in_load_sharing"},
    ),
    "backlash": (
        sections.Backlash,
        {"projection": "backlash_projection", **_same("half_backlash", "centre_distance_change", "housing")},
    ),
}
_HOUSING = {"thermal_expansion": "housing_expansion", "temperature_rise": "housing_temperature_rise"}
_NO_LOAD = {"operation": {"pinion_torque": 0.0}}


def _dynamics(
    *,
    damping_ratio: float = 0.072,
    stiffness: str = "nominal",
    harmonics: int | str = 1,
    ste_amplitude: str = "nominal",
    clearance: str = "mean",
    torque_amplitudes: Sequence[float] = (),
    torque_phases: Sequence[float] = (),
    torque_frequency_ratio: float = 1.0,
    start: str = "stiffest_mesh",
    displacement: float = 0.0,
    velocity: float = 0.0,
    tolerance: float = 1e-10,
) -> dict[str, Any]:
    """Return the section `dynamics` for the options of GearPair.oscillator and of Oscillator."""
    bearing = {"mass": None, "stiffness_along": 3e8, "stiffness_across": 3e8, "damping_ratio": 0.02}
    values = {
        "model": "torsional",
        "reference_case": "",
        "bearings": dict.fromkeys(GEARS, bearing),  # of the other model, unused
        "damping_ratio": damping_ratio,
        "stiffness": stiffness,
        "harmonics": harmonics,
        "ste_amplitude": ste_amplitude,
        "clearance": clearance,
        "torque_fluctuation": {
            "amplitudes": list(torque_amplitudes),
            "phases": list(torque_phases),
            "frequency_ratio": torque_frequency_ratio,
        },
        "start": {"at": start, "displacement": displacement, "velocity": velocity},
        "tolerance": tolerance,
    }
    return _checked(study.Dynamics, values, at="start")


def _heat_balance(given: HeatBalance) -> dict[str, Any]:
    values = given._asdict() | {"immersion": _both("immersion", given.immersion)}
    return {"heat_balance": _checked(sections.HeatBalance, values)}


def _sections(given: dict[str, Any]) -> dict[str, Any]:
    """Return the sections of the configuration for the arguments of GearPair."""
    if not isinstance(given["lubricant"], Lubricant):
        raise GearwearError(f"lubricant: {given['lubricant']!r}; give a Lubricant")
    values = given | given["lubricant"]._asdict()
    for name in ("teeth", "addendum_coefficient", "profile_shift", "bore_radius", "inertia"):
        values[name] = _both(name, given[name])
    relief = _both("tip_relief", given["tip_relief"], TipRelief)
    values["tip_relief"] = {gear: one._asdict() for gear, one in relief.items()}
    values |= {gear: one._asdict() for gear, one in _both("material", given["material"], Material).items()}
    values["housing"] = {key: given[argument] for key, argument in _HOUSING.items()}
    cfg = {}
    for name, (section, keys) in _SECTIONS.items():
        renamed = {key: argument for key, argument in keys.items() if key != argument}
        renamed |= _HOUSING if "housing" in keys else {}
        cfg[name] = _checked(section, {key: values[argument] for key, argument in keys.items()}, **renamed)
    radii = cfg["gear_pair"]["bore_radius"]
    for gear in GEARS:
        if radii[gear] is None:
            radii[gear] = float(f"{RULES[f'gear_pair.bore_radius.{gear}'].value(cfg):.4g}")
    return cfg


def _both(name: str, value: Any, one: type = str) -> dict[str, Any]:
    """Return the values of pinion and gear by name, from two or from one for both.

    Parameters
    ----------
    one : type of one value, if it is one of this module.
    """
    single = isinstance(value, one) or not isinstance(value, Sequence | np.ndarray)
    both = [value] * len(GEARS) if single else list(value)
    if len(both) != len(GEARS):
        raise GearwearError(f"{name}: {len(both)} values; give (pinion, gear), or one value for both")
    if one is not str and not all(isinstance(each, one) for each in both):
        raise GearwearError(f"{name}: {value!r}; give a {one.__name__}, or two, of pinion and gear")
    return dict(zip(GEARS, both, strict=True))


def _plain(value: Any) -> Any:
    """Return numbers of numpy, in dicts too, as builtin ones."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value.item() if isinstance(value, np.generic) else value


def _checked(section: type[Section], values: dict[str, Any], **arguments: str) -> dict[str, Any]:
    """Return the values as a section of the configuration holds them.

    Parameters
    ----------
    arguments : names of arguments that are called otherwise in the section.

    Raises
    ------
    GearwearError : a value is not allowed; the message names argument, value and what is allowed.
    """
    try:
        return section.model_validate(_plain(values)).model_dump()
    except ValidationError as refused:
        path, words = problems_of(refused, Place((), section, FieldInfo(), values))[0]
    name = arguments.get(path[-1], ".".join(part for part in path if part not in GEARS))
    gear = "".join(f" of the {part}" for part in path if part in GEARS)
    raise GearwearError(f"{name}{gear}: {words}")

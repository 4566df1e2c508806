"""The gear pair as an oscillator with backlash, periodic stiffness and static transmission error."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from gearwear.errors import Infeasible
from gearwear.oscillator.periodic import Harmonics, PeriodicTable, finite_floats


@dataclass(frozen=True)
class ExternalTorque:
    """Fluctuation of the external torque as a dimensionless force: a sum of harmonics of a frequency of its own.

        sum over j = 1, 2, ... of amplitudes[j-1] cos(j rho w t + phases[j-1])

    Parameters
    ----------
    frequency_ratio : float
        rho, the frequency of the first harmonic over that of the mesh, w.
    amplitudes, phases : sequences of equal length
        Amplitude and phase (rad) of the harmonics 1, 2, ...

    Raises
    ------
    Infeasible
        For a number that is not finite, a ratio that is not positive, or lists of unequal length.
    """

    frequency_ratio: float = 1.0
    amplitudes: tuple[float, ...] = ()
    phases: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        ratio = finite_floats((self.frequency_ratio,), "external torque")[0]
        if ratio <= 0.0:
            raise Infeasible(f"external torque: frequency_ratio {ratio} (of the mesh frequency) must be above 0")
        object.__setattr__(self, "frequency_ratio", ratio)
        for name in ("amplitudes", "phases"):
            object.__setattr__(self, name, finite_floats(getattr(self, name), f"external torque {name}"))
        if len(self.amplitudes) != len(self.phases):
            raise Infeasible(
                f"external torque: {len(self.amplitudes)} amplitudes but {len(self.phases)} phases; give one phase "
                "(rad) for every amplitude"
            )

    def repeats_after(self, periods: int) -> bool:
        """Whether every harmonic goes through whole turns in this many mesh periods."""
        turns = [order * self.frequency_ratio * periods for order, a in enumerate(self.amplitudes, start=1) if a]
        return all(float(number).is_integer() for number in turns)

    def mesh_periods(self, most: int) -> int:
        """Least number of mesh periods after which it repeats, 0 if that is more than `most`."""
        return next((periods for periods in range(1, most + 1) if self.repeats_after(periods)), 0)

    def seen_from(self, turns: float) -> "ExternalTorque":
        """The same function of time with its zero moved on by this many turns of the first harmonic."""
        shifts = 2 * np.pi * turns * np.arange(1, len(self.phases) + 1)
        return replace(self, phases=tuple(np.add(self.phases, shifts)))

    def scaled(self, factor: float) -> "ExternalTorque":
        """All amplitudes multiplied by a factor."""
        return ExternalTorque(self.frequency_ratio, tuple(factor * a for a in self.amplitudes), self.phases)


class Coefficients(NamedTuple):
    """What the compiled kernels read: one oscillator, written out in time t over one forcing period.

    constants : (frequency, 2 zeta, mean force, mean clearance, frequency ratio rho of the torque)
    harmonics : one row per harmonic, the cosine and sine coefficients of stiffness, force and clearance, harmonics of
        w, and of the torque, harmonics of rho w
    cells : one row per cell, its start and end (mesh phase), stiffness at the start, slope of the stiffness
        (per unit of t), and the jumps of displacement and velocity at its end
    """

    constants: tuple[float, ...] | np.ndarray
    harmonics: np.ndarray
    cells: np.ndarray


@dataclass(frozen=True)
class Oscillator:
    """Single-degree-of-freedom model of a spur gear pair (Kahraman and Singh, 1990, dimensionless form).

        X'' + 2 zeta X' + k(tau) f(X; b(tau)) = F - e'' + T(rho w t),    tau = frac(w t / 2 pi)
        f(X; b) = X - b (X > b),  0 (|X| <= b),  X + b (X < -b)

    Parameters
    ----------
    frequency : float
        Forcing frequency w in units of the natural frequency.
    damping_ratio, mean_force : float
        zeta and F.
    stiffness : Harmonics or PeriodicTable
        k in units of its mean: mean 1 for harmonics.
    error : Harmonics or PeriodicTable
        Static transmission error e in units of the length b0. A table enters exactly: as e'' = 0 inside its cells,
        the state jumps by -D_e and -(D_e' - 2 zeta D_e) at a break where e jumps by D_e and de/dt by D_e'.
    clearance : Harmonics
        Half the backlash, b, in units of b0.
    torque : ExternalTorque

    Raises
    ------
    Infeasible
        For numbers that are not finite, w, zeta, k or b not positive, or two tables with unlike breaks.
    """

    frequency: float
    damping_ratio: float
    mean_force: float
    stiffness: Harmonics | PeriodicTable = Harmonics(1.0)
    error: Harmonics | PeriodicTable = Harmonics(0.0)
    clearance: Harmonics = Harmonics(1.0)
    torque: ExternalTorque = ExternalTorque()

    def __post_init__(self) -> None:
        for name in ("frequency", "damping_ratio", "mean_force"):
            object.__setattr__(self, name, finite_floats((getattr(self, name),), name)[0])
        for name in ("frequency", "damping_ratio"):
            if getattr(self, name) <= 0.0:
                raise Infeasible(f"{name}: {getattr(self, name)} (dimensionless) must be above 0")
        for name in ("stiffness", "clearance"):
            least = getattr(self, name).minimum
            if least <= 0.0:
                raise Infeasible(
                    f"{name}: least value over the mesh period {least:.6g} (dimensionless) must be above 0; "
                    "reduce its fluctuation or raise its mean"
                )
        tables = [t for t in (self.stiffness, self.error) if isinstance(t, PeriodicTable)]
        if len(tables) == 2 and tables[0].breaks != tables[1].breaks:
            raise Infeasible("stiffness and error: their tables have unlike breaks; tabulate both on the same breaks")

    @property
    def period(self) -> float:
        """Dimensionless forcing period 2 pi / w."""
        return 2 * np.pi / self.frequency

    @property
    def size(self) -> int:
        """Number of state variables: displacement and velocity."""
        return 2

    @property
    def contraction(self) -> float:
        """Determinant of the derivative of the one-period map (Liouville)."""
        return float(np.exp(-2 * self.damping_ratio * self.period))

    @property
    def has_second_frequency(self) -> bool:
        """True if the external torque fluctuates at another frequency than harmonics of the mesh."""
        return not self.torque.repeats_after(1)

    def at_frequency(self, frequency: float) -> "Oscillator":
        """The same oscillator forced at another frequency."""
        return replace(self, frequency=frequency)

    def seen_from(self, phase: float) -> "Oscillator":
        """The same oscillator in a time that begins at a mesh phase (0 to 1) of the period before period 0."""
        return replace(
            self,
            stiffness=self.stiffness.seen_from(phase),
            error=self.error.seen_from(phase),
            clearance=self.clearance.seen_from(phase),
            torque=self.torque.seen_from(-self.torque.frequency_ratio * (1.0 - phase)),
        )

    def with_error_scaled(self, factor: float) -> "Oscillator":
        """Static transmission error multiplied by a factor."""
        return replace(self, error=self.error.scaled(factor))

    def with_clearance_scaled(self, factor: float) -> "Oscillator":
        """Clearance multiplied by a factor."""
        return replace(self, clearance=self.clearance.scaled(factor))

    def in_length_unit(self, unit: float) -> "Oscillator":
        """The same motion measured in another unit of length (given in units of the present one)."""
        if not (np.isfinite(unit) and unit > 0.0):
            raise Infeasible(f"length unit: {unit} must be a finite number above 0")
        return replace(
            self,
            mean_force=self.mean_force / unit,
            error=self.error.scaled(1 / unit),
            clearance=self.clearance.scaled(1 / unit),
            torque=self.torque.scaled(1 / unit),
        )

    @cached_property
    def coefficients(self) -> Coefficients:
        """The oscillator as the kernels read it."""
        breaks: tuple[float, ...] = (0.0, 1.0)
        for quantity in (self.stiffness, self.error):
            breaks = quantity.breaks if isinstance(quantity, PeriodicTable) else breaks
        cells = len(breaks) - 1
        if isinstance(self.stiffness, PeriodicTable):
            level, slope = np.array(self.stiffness.start), self.stiffness.slopes() / self.period
            stiffness_waves = Harmonics()
        else:
            level, slope = np.full(cells, self.stiffness.mean), np.zeros(cells)
            stiffness_waves = self.stiffness
        if isinstance(self.error, PeriodicTable):
            kicks, error_waves = self._kicks(self.error), Harmonics()
        else:
            kicks, error_waves = np.zeros((cells, self.size)), self.error
        waves: tuple[Harmonics | ExternalTorque, ...] = (stiffness_waves, error_waves, self.clearance, self.torque)
        harmonics = np.zeros((max(len(wave.amplitudes) for wave in waves), 8))
        for column, wave in enumerate(waves):
            count = len(wave.amplitudes)
            if not count:
                continue
            order = np.arange(1, count + 1)
            scale = (order * self.frequency) ** 2 if wave is error_waves else 1.0
            harmonics[:count, 2 * column] = scale * np.multiply(wave.amplitudes, np.cos(wave.phases))
            harmonics[:count, 2 * column + 1] = -scale * np.multiply(wave.amplitudes, np.sin(wave.phases))
        ratio = self.torque.frequency_ratio
        constants = (self.frequency, 2 * self.damping_ratio, self.mean_force, self.clearance.mean, ratio)
        table = np.empty((cells, 4 + self.size))
        table[:, 0], table[:, 1], table[:, 2], table[:, 3], table[:, 4:] = breaks[:-1], breaks[1:], level, slope, kicks
        return Coefficients(constants, harmonics, table)

    def _kicks(self, table: PeriodicTable) -> np.ndarray:
        """Jumps of (X, X') at the end of every cell: y = X + e is continuous in y'' + 2 zeta (y' - e') + k f = F."""
        jump = np.roll(table.start, -1) - np.array(table.end)
        slope = table.slopes() / self.period
        slope_jump = np.roll(slope, -1) - slope
        return np.column_stack([-jump, -(slope_jump - 2 * self.damping_ratio * jump)])

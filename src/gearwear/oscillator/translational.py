"""The gear pair on bearings: both gears turn and move sideways, friction off."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from gearwear.errors import Infeasible
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import PeriodicTable, finite_floats

MESH, PINION_ALONG, PINION_ACROSS, GEAR_ALONG, GEAR_ACROSS = range(5)
DEGREES = 5  # of freedom that are left of six: the free turning of the pair is taken out


@dataclass(frozen=True)
class Bearing:
    """Bearing of one gear, dimensionless.

    Parameters
    ----------
    mass : of the gear and what moves with it, over the equivalent mass of the pair.
    stiffness : towards the other gear's centre and across, over the mean mesh stiffness.
    damping_ratio : of the mass on the bearing alone, the same in both directions.

    Raises
    ------
    Infeasible
        For numbers that are not finite, or not positive (the damping ratio: negative).
    """

    mass: float
    stiffness: tuple[float, float]
    damping_ratio: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "stiffness", finite_floats(self.stiffness, "bearing stiffness"))
        for name in ("mass", "damping_ratio"):
            object.__setattr__(self, name, finite_floats((getattr(self, name),), f"bearing {name}")[0])
        if len(self.stiffness) != 2 or min(self.mass, *self.stiffness) <= 0.0 or self.damping_ratio < 0.0:
            raise Infeasible(
                f"bearing: mass {self.mass} and the two stiffnesses {self.stiffness} must be above 0, damping_ratio "
                f"{self.damping_ratio} must not be below"
            )

    def matrices(self, pressure_angle: float) -> tuple[np.ndarray, np.ndarray]:
        """Return stiffness and damping, (2, 2) each, along and across a line of action at this angle (rad)."""
        sine, cosine = np.sin(pressure_angle), np.cos(pressure_angle)
        turn = np.array([[sine, cosine], [cosine, -sine]])  # rows: along, across; columns: to the other centre, across
        damping = 2 * self.damping_ratio * np.sqrt(self.mass * np.array(self.stiffness))
        return turn @ np.diag(self.stiffness) @ turn.T, turn @ np.diag(damping) @ turn.T


class LinearPart(NamedTuple):
    """What does not change with time in q'' + C q' + K q + g k f(q_0) = (F + T - e'') (1, 0, ...).

    damping, stiffness : C and K, (n, n); C holds the damping of the mesh, K the bearings alone
    pull : g, (n,), the accelerations under a unit mesh force, with the sign turned
    """

    damping: np.ndarray
    stiffness: np.ndarray
    pull: np.ndarray


@dataclass(frozen=True)
class TranslationalOscillator(Oscillator):
    """Translational-torsional model of a spur gear pair on bearings (after Kahraman and Singh, 1991).

    With the displacements y of both centres along the line of action, x across it, the relative turn
    u = r_p theta_p - r_g theta_g and X = u + y_p - y_g - e,

        X'' = F + T - e'' - N + y_p'' - y_g'',        N = k f(X; b) + 2 zeta X'
        m_p (y_p'', x_p'') = (-N, 0) - bearing,       m_g (y_g'', x_g'') = (N, 0) - bearing

    The state is (X, X', y_p, y_p', x_p, x_p', y_g, y_g', x_g, x_g'); a state given as (X, X') has both gears at rest
    on unloaded bearings.

    Parameters
    ----------
    pinion, gear : Bearing
    pressure_angle : working pressure angle, rad, between the line of action and the normal to the line of centres.
    """

    pinion: Bearing = Bearing(1.0, (1.0, 1.0), 0.0)
    gear: Bearing = Bearing(1.0, (1.0, 1.0), 0.0)
    pressure_angle: float = 0.0

    @property
    def size(self) -> int:
        """Number of state variables."""
        return 2 * DEGREES

    @property
    def contraction(self) -> float:
        """Determinant of the derivative of the one-period map."""
        return float(np.exp(-np.trace(self.linear_part.damping) * self.period))

    @cached_property
    def linear_part(self) -> LinearPart:
        """The linear part of the equations, for q = (X, y_p, x_p, y_g, x_g)."""
        damping, stiffness = np.zeros((2, DEGREES, DEGREES))
        for bearing, along in ((self.pinion, PINION_ALONG), (self.gear, GEAR_ALONG)):
            own = slice(along, along + 2)
            for whole, part in zip((stiffness, damping), bearing.matrices(self.pressure_angle), strict=True):
                whole[own, own] = part / bearing.mass
        for whole in (damping, stiffness):
            whole[MESH] = whole[PINION_ALONG] - whole[GEAR_ALONG]
        pull = np.zeros(DEGREES)
        pull[PINION_ALONG], pull[GEAR_ALONG] = 1 / self.pinion.mass, -1 / self.gear.mass
        pull[MESH] = 1.0 + pull[PINION_ALONG] - pull[GEAR_ALONG]
        damping[:, MESH] += 2 * self.damping_ratio * pull
        return LinearPart(damping, stiffness, pull)

    def _kicks(self, table: PeriodicTable) -> np.ndarray:
        """Jumps of the state at the end of every cell: where e jumps by D, the mesh force has an impulse -2 zeta D."""
        kicks = np.zeros((len(table.start), self.size))
        kicks[:, :2] = super()._kicks(table)
        jump = -kicks[:, :1]
        kicks[:, 1::2] += 2 * self.damping_ratio * jump * (self.linear_part.pull - np.eye(DEGREES)[MESH])
        return kicks

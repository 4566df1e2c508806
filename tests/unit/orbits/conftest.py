"""Maps with closed forms, as families of the form that orbits are looked for in."""

import numpy as np
import pytest

from gearwear.orbits.return_map import Passage
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics


@pytest.fixture(scope="session")
def iterated():
    """Return a function that makes a family from one step (value, state) -> (state, derivative) of a map."""

    def make(step):
        def family(value, period):
            def run(state):
                section, matrix = [np.array(state, dtype=float)], np.eye(2)
                for _ in range(period):
                    state, derivative = step(value, section[-1])
                    section.append(np.array(state))
                    matrix = np.array(derivative) @ matrix
                return Passage(np.array(section), matrix)

            return run

        return family

    return make


@pytest.fixture(scope="session")
def henon(iterated):
    """The map of Henon with b = 0.3, parameter a."""
    return iterated(lambda a, s: ((1 - a * s[0] ** 2 + s[1], 0.3 * s[0]), ((-2 * a * s[0], 1.0), (0.3, 0.0))))


@pytest.fixture(scope="session")
def delayed_logistic(iterated):
    """x' = a x (1 - y), y' = x: its fixed point 1 - 1/a has multipliers of product a - 1."""
    return iterated(lambda a, s: ((a * s[0] * (1 - s[1]), s[0]), ((a * (1 - s[1]), -a * s[0]), (1.0, 0.0))))


@pytest.fixture(scope="session")
def large_fluctuation():
    """Return the oscillator of a large stiffness fluctuation, the route to chaos, at a mesh frequency."""
    stiffness, error = Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,))
    return lambda frequency: Oscillator(frequency, 0.1, 0.1, stiffness, error)

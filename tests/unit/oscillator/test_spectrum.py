import numpy as np
import pytest

from gearwear.oscillator.spectrum import spectrum

WIDTH = np.concatenate([np.full(48, 0.6 / 48), np.full(32, 0.4 / 32)])
PHASE = np.cumsum(WIDTH) - WIDTH / 2


def history(periods, lines):
    """Return a force of the given (order, amplitude, phase) about a mean, (periods, m)."""
    time = np.arange(periods)[:, None] + PHASE
    return 4000 + sum(a * np.cos(2 * np.pi * order * time + phase) for order, a, phase in lines)


@pytest.mark.parametrize("periods", [1, 2, 3, 5])
def test_lines_stand_at_their_orders_with_their_amplitudes(periods):
    given = {1.0: 700.0, 2.0: 90.0, 1 - 1 / periods: 40.0, 2 + 1 / periods: 20.0}
    given.pop(0.0, None)
    values = history(periods, [(order, size, 0.7 * order) for order, size in given.items()])
    orders, amplitudes = spectrum(values, PHASE, WIDTH, 6)
    assert orders == pytest.approx(np.arange(1, 6 * periods + 1) / periods)
    found = dict(zip(orders.round(9), amplitudes, strict=True))
    for order, amplitude in found.items():
        expected = next((size for one, size in given.items() if np.isclose(one, order)), 0.0)
        assert amplitude == pytest.approx(expected, abs=0.8)


def test_a_doubled_period_adds_sidebands_and_leaves_the_mesh_harmonics():
    mesh, doubled = [(1, 700.0, 0.2), (3, 150.0, 1.0)], [(0.5, 60.0, 0.0), (1.5, 30.0, 0.4)]
    _, alone = spectrum(history(1, mesh), PHASE, WIDTH, 4)
    orders, amplitudes = spectrum(history(2, mesh + doubled), PHASE, WIDTH, 4)
    assert amplitudes[orders % 1 == 0] == pytest.approx(alone, abs=0.8)
    assert amplitudes[[0, 2]] == pytest.approx([60.0, 30.0], abs=0.8)


def test_the_power_of_the_lines_is_that_of_the_force():
    values = history(2, [(0.5, 60.0, 0.0), (1, 700.0, 0.3), (2.5, 20.0, 0.1)])
    _, amplitudes = spectrum(values, PHASE, WIDTH, 10)
    power = ((values - 4000) ** 2 * WIDTH / 2).sum()
    assert (amplitudes**2).sum() / 2 == pytest.approx(power, rel=1e-3)

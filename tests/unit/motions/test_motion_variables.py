import numpy as np

from gearwear.integrate.strobe import strobe
from gearwear.io.variables import variable_of
from gearwear.motions.motion_variables import columns, end_of
from gearwear.motions.settling import Attractor, Settling, settle
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(60, 240, 64, 8, 1e-7, 3e-3)


def motion() -> tuple[Oscillator, Attractor]:
    oscillator = Oscillator(0.6, 0.1, 0.2, Harmonics(1.0, (0.2,), (0.0,)), Harmonics(0.0, (0.1,), (3.1,)))
    return oscillator, settle(oscillator, (0.0, 0.0), SETTLING)


def test_every_column_has_its_entry_in_the_table_of_fields():
    table = columns([motion()[1]] * 3, 64, 0.2)
    for name, (dims, values) in table.items():
        assert variable_of(name, dims if isinstance(dims, tuple) else (dims,))
        assert len(values) == 3


def test_a_part_without_points_keeps_its_columns():
    for _dims, values in columns([], 64, 0.2).values():
        assert len(values) == 0


def test_largest_force_is_given_over_the_mean_force():
    _, settled = motion()
    assert columns([settled], 64, 0.2)["force_max"][1][0] == settled.force_max / 0.2


def test_the_end_of_a_motion_continues_it():
    oscillator, settled = motion()
    after = strobe(oscillator, end_of(settled), settled.period, settled.transient_periods + 64)
    np.testing.assert_allclose(after.states[-1], end_of(settled), atol=1e-7)

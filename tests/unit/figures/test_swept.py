"""Names of the swept quantities."""

import pytest

from gearwear.figures import swept

PAIR = {"case": "with", "bulk_temperature": 100.0, "running_cycles": 2.1e9}
GIVEN = {"case": "mine"}


@pytest.mark.parametrize("sweep", ["ste", "backlash"])
def test_a_given_oscillator_has_no_reference_case_and_no_initial_backlash(sweep):
    assert swept.label(sweep, PAIR) == swept.LABELS[sweep]
    assert "over the one given" in swept.label(sweep, GIVEN)


def test_the_mesh_frequency_has_one_name():
    assert swept.label("mesh_frequency", PAIR) == swept.label("mesh_frequency", GIVEN)

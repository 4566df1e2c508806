"""Names of the states of the pair and of the swept quantities."""

import pytest

from gearwear.figures import labels

PAIR = {"case": "with", "bulk_temperature": 100.0, "running_cycles": 2.1e9}
GIVEN = {"case": "mine"}


@pytest.mark.parametrize(
    ("count", "label"),
    [(0, "unworn"), (2.1e9, "2.1 × 10⁹ cycles"), (1e8, "0.1 × 10⁹ cycles")],
)
def test_running_cycles(count, label):
    assert labels.cycles({"running_cycles": count}) == label


def test_six_states_differ_in_colour_and_dashes():
    state = {"bulk_temperature": 20.0, "running_cycles": 0}
    lines = [labels.line(place, state) for place in range(6)]
    assert len({line["color"] for line in lines}) == 6
    assert len({line["dashes"] for line in lines}) == 6


@pytest.mark.parametrize("sweep", ["ste", "backlash"])
def test_a_given_oscillator_has_no_reference_case_and_no_initial_backlash(sweep):
    assert labels.sweep(sweep, PAIR) == labels.SWEEPS[sweep]
    assert "over the one given" in labels.sweep(sweep, GIVEN)


def test_the_mesh_frequency_has_one_name():
    assert labels.sweep("mesh_frequency", PAIR) == labels.sweep("mesh_frequency", GIVEN)

"""Names of the states of the pair."""

import pytest

from gearwear.figures import states


@pytest.mark.parametrize(
    ("count", "label"),
    [(0, "unworn"), (2.1e9, "2.1 × 10⁹ cycles"), (1e8, "0.1 × 10⁹ cycles")],
)
def test_running_cycles(count, label):
    assert states.cycles({"running_cycles": count}) == label


def test_six_states_differ_in_colour_and_dashes():
    state = {"bulk_temperature": 20.0, "running_cycles": 0}
    lines = [states.line(place, state) for place in range(6)]
    assert len({line["color"] for line in lines}) == 6
    assert len({line["dashes"] for line in lines}) == 6

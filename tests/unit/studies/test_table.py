"""The table of a study and the sentences on the lives of its pairs."""

import numpy as np
import pytest

from gearwear.codes.motion_class import CHAOTIC
from gearwear.studies import table
from gearwear.studies.gathering import gathered
from gearwear.studies.outcome import impossible
from gearwear.studies.wording import axis, state, valued

HEAT, AGE = "cases.with.bulk_temperature", "cases.with.running_cycles"
UNITS = {HEAT: "degC", AGE: "1"}
ENDS = {"first": 0.5, "last": 1.0, "points": 6}


def outcome(last_safe, natural_speed=10_000.0):
    """Return an outcome that is period 1 up to a point of the sweep and chaotic beyond, without contact there."""
    one = impossible(ENDS, "").copy()
    safe = np.arange(6) <= last_safe
    one["motion_class"][:] = np.where(safe, 1, CHAOTIC)
    one["contact_loss_share"][:] = np.where(safe, 0.0, 0.2)
    one["force_max"][:] = np.where(safe, 1.5, 3.0)
    one["pinion_speed"][:] = natural_speed * one["mesh_frequency"].values
    one["deepest_wear"][:] = np.array([1e-6, 2e-7])
    numbers = {"mean_stiffness": 3e8, "relative_mean_error": 1.1, "mean_half_backlash": 6e-5, "running_force": 1.2}
    numbers |= {"natural_speed": natural_speed, "first_doubling": 0.95, "running_speed": 6000.0, "running_ratio": 0.6}
    numbers |= {"running_contact_loss": 0.0}
    one = one.assign(numbers)
    one["running_class"] = np.int32(1)
    return one


@pytest.fixture
def life():
    """Two temperatures, three ages; the hot pair is safe less far, and cannot reach the last age."""
    members = [outcome(4), outcome(4), outcome(3), outcome(3, 9000.0), outcome(2, 9000.0), impossible(ENDS, "it jams")]
    return gathered({HEAT: [60, 100], AGE: [0.0, 1e9, 2e9]}, [f"m{i}" for i in range(6)], members)


def test_a_row_a_member_with_ratios_and_speeds(life):
    rows = table.rows(life, [HEAT, AGE], "restart")
    assert [row["member"] for row in rows] == [f"m{i}" for i in range(6)]
    assert rows[4][HEAT] == "100" and rows[4][AGE] == "1e+09" and rows[4]["hindrance"] == "none"
    assert rows[4]["period_1_up_to"] == "0.7000" and rows[4]["period_1_up_to_rpm"] == "6300"
    assert rows[4]["first_doubling_rpm"] == "8550" and rows[4]["chaos_onset"] == "none"
    assert rows[4]["classes"] == "P1 0.500-0.700; CH 0.800-1.000"
    assert rows[4]["classes_rpm"] == "P1 4500-6300; CH 7200-9000"
    assert rows[4]["deepest_wear_gear_um"] == "0.200"


def test_an_impossible_member_has_its_reason_and_no_numbers(life):
    row = table.rows(life, [HEAT, AGE], "restart")[5]
    assert row["hindrance"] == "it jams"
    known = {key for key, value in row.items() if value != "none"}
    assert known == {"member", HEAT, AGE, "hindrance"}


def test_a_sentence_a_temperature_with_the_limits_of_the_worst_age(life):
    cold, hot = (row["sentence"] for row in table.sentences(life, UNITS))
    assert cold.startswith(
        "bulk temperature 60 °C: up to 0.800 of the natural frequency (8000 rpm) the pair stays period 1 from 0 to "
        "2e+09 revolutions; up to 0.800 of the natural frequency (8000 rpm) it keeps contact. "
        "The mesh force is at most 3.00"
    )
    assert "At the running speed, 6000 rpm, the motion is P1, contact kept, the force at most 1.20" in cold
    assert "up to 0.700 of the natural frequency (6300 rpm)" in hot
    assert "up to 1e+09 revolutions (then it cannot go on: it jams)" in hot


def test_a_life_that_cannot_begin_has_the_reason(life):
    dead = life.isel({HEAT: [1], AGE: [2]})
    (row,) = table.sentences(dead, UNITS)
    assert row["sentence"] == "bulk temperature 100 °C: cannot be: it jams."


def test_a_pair_that_is_safe_everywhere_or_nowhere():
    study = gathered({"wear.law": ["constant", "janakiraman"]}, ["a", "b"], [outcome(5), outcome(-1)])
    everywhere, nowhere = (row["sentence"] for row in table.sentences(study, {"wear.law": ""}))
    assert everywhere.startswith(
        "law constant: at every speed of the sweep, up to 1.000 of the natural frequency (10000 rpm), the pair stays"
    )
    assert nowhere.startswith("law janakiraman: at no speed of the sweep the pair stays period 1;")


def test_words_of_axes():
    assert valued(60.0, "degC") == "60 °C" and valued("weber", "") == "weber" and valued(0.07, "1") == "0.07"
    assert axis(HEAT, "degC") == "Bulk temperature, °C" and axis("dynamics.damping_ratio", "1") == "Damping ratio"
    assert state({HEAT: 60.0, "mesh_stiffness.hertz": "weber"}, UNITS) == "bulk temperature 60 °C, hertz weber"

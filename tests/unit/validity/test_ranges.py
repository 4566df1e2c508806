"""What lies outside the range of a law."""

import numpy as np
import pytest
import xarray as xr

from gearwear.contact.hertz import hertz_half_width, hertz_peak_pressure
from gearwear.mesh.foundation import foundation_factors
from gearwear.validity.ranges import RANGES, of_chain, of_contact, of_pair, rows, sentence

CFG = {
    "cases": {"worn": 3, "new": 0},
    "wear": {"law": "janakiraman"},
    "lubricant": {"pressure_viscosity": 2e-8, "composite_roughness": 0.5e-6},
}
MODULUS = 226e9


def pair(root_over_bore=(2.0, 3.0), angle=(0.1, 0.06)):
    along = "gear"
    return xr.Dataset(
        {
            "root_radius": (along, np.array(root_over_bore) * 10e-3),
            "bore_radius": (along, [10e-3, 10e-3]),
            "rack_root_angle": (along, list(angle)),
            "line_of_action": 40e-3,
        },
        {"path": np.array([10e-3, 20e-3])},
    )


def contact(load, film_ratio=(0.5, 0.6)):
    radius = np.array([7.5e-3, 10e-3])
    load = np.array(load, dtype=float)
    return xr.Dataset(
        {
            "load_per_width": ("path", load),
            "hertz_half_width": ("path", hertz_half_width(load, radius, MODULUS)),
            "film_ratio": ("path", list(film_ratio)),
        }
    )


def test_a_usual_pair_has_no_warning():
    measured = [*of_pair(pair()), *of_contact("worn", pair(), contact([2e5, 4e5]), CFG)]
    assert {name for _, name, _ in measured} >= {"root_angle", "hertz_pressure", "film_ratio", "oil_group"}
    assert rows(measured) == []


def test_bodies_outside_the_fit_are_named_by_gear():
    found = rows(of_pair(pair(root_over_bore=(1.2, 3.0), angle=(0.149, 0.06))))
    assert [row[:4] for row in found] == [
        ("pinion", "root over bore radius", "1.2", "1.4 to 7"),
        ("pinion", "half tooth angle at the root", "0.149 rad", "0.01 to 0.12 rad"),
    ]
    assert "Sainsot" in found[0][4]


def test_the_fit_of_the_foundation_is_positive_within_its_range():
    low, high = RANGES["root_over_bore"].low, RANGES["root_over_bore"].high
    for ratio in np.linspace(low, high, 5):
        for angle in np.linspace(RANGES["root_angle"].low, RANGES["root_angle"].high, 5)[1:]:
            assert (foundation_factors(ratio, angle) > 0).all()


def test_pressure_and_groups_are_those_of_the_contact():
    measured = {name: values for _, name, values in of_contact("worn", pair(), contact([2e5, 4e5]), CFG)}
    radius = np.array([7.5e-3, 10e-3])
    peak = hertz_peak_pressure(np.array([2e5, 4e5]), radius, MODULUS)
    np.testing.assert_allclose(measured["hertz_pressure"], 1e-9 * peak, rtol=1e-12)
    np.testing.assert_allclose(measured["oil_group"], 2e-8 * MODULUS, rtol=1e-12)
    np.testing.assert_allclose(measured["load_group"], 2 * np.pi * (peak / MODULUS) ** 2, rtol=1e-12)
    np.testing.assert_allclose(measured["roughness_group"], 0.5e-6 / radius, rtol=1e-12)


def test_the_regression_counts_only_where_it_is_used():
    constant = CFG | {"wear": {"law": "constant"}}
    for case, cfg in (("new", CFG), ("worn", constant)):
        assert {name for _, name, _ in of_contact(case, pair(), contact([2e5, 4e5]), cfg)} == {
            "hertz_pressure",
            "film_ratio",
        }


def test_a_place_without_load_does_not_count():
    assert rows(of_contact("worn", pair(), contact([0.0, 4e5], film_ratio=(9.0, 0.5)), CFG)) == []


def test_equal_warnings_of_several_cases_are_one():
    heavy = contact([2e6, 2e6])
    found = rows([*of_contact("worn", pair(), heavy, CFG), *of_contact("new", pair(), heavy, CFG)])
    pressure = [row for row in found if row[1].startswith("largest Hertz")]
    assert [row[0] for row in pressure] == ["worn, new"]
    assert sentence(pressure[0]).startswith("warning: worn, new: largest Hertz pressure under the static load 3.")


def test_both_ends_can_be_outside():
    film = contact([2e5, 4e5], film_ratio=(0.01, 5.0))
    assert ("new", "film over roughness", "0.01 and 5", "0.05 to 4") in [
        row[:4] for row in rows(of_contact("new", pair(), film, CFG))
    ]


@pytest.mark.parametrize(("share", "count"), [(0.4, 0), (0.5, 1)])
def test_the_steps_of_the_chain(share, count):
    depth = share * 20e-6 / 1e8
    steps = [
        (
            xr.Dataset({"elastic_deflection": ("path", [20e-6, 30e-6])}),
            xr.Dataset(
                {
                    "wear_per_revolution": (("gear", "path"), [[depth * part, 0.0], [0.0, depth]]),
                    "running_cycles": cycles,
                }
            ),
        )
        for part, cycles in ((1.0, 1e8), (0.5, 2e8))
    ]
    found = rows(of_chain("worn", steps, [1, 1, 1]))
    assert len(found) == count
    if count:
        assert found[0][1:4] == ("depth of one wear step over the elastic deflection", "0.5", "0 to 0.45")


def test_motions_that_did_not_settle_are_counted():
    assert [row[2] for row in rows(of_chain("new", [], [0]))] == ["1"]
    assert rows(of_chain("new", [], [3])) == []

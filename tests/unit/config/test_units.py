"""Values written with their unit."""

import random
from decimal import Decimal

import pytest

from gearwear.config.study import Configuration
from gearwear.config.types import keys, unit_of
from gearwear.config.units import UnitError, example, plain

# unit of the key: prefixed unit and its power of ten
DECIMAL = {
    "m": ("mm", -3),
    "Pa": ("GPa", 9),
    "Pa s": ("mPa s", -3),
    "1/Pa": ("1/GPa", -9),
    "N m": ("kN m", 3),
    "N/m": ("N/mm", 3),
    "kg/m3": ("g/cm3", 3),
    "kg m2": ("g mm2", -9),
}


@pytest.mark.parametrize("unit", DECIMAL)
def test_a_prefix_moves_the_decimal_point_and_changes_no_bit(unit):
    written, power = DECIMAL[unit]
    chance = random.Random(unit)
    for _ in range(1000):
        number = f"{chance.randint(1, 10**6)}e{chance.randint(-8, 4)}"
        assert plain(f"{number} {written}", unit) == float(f"{Decimal(number).scaleb(power)}"), number


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("3.175mm", "m", 3.175e-3),
        ("65 µm", "m", 65e-6),
        ("0.63 in", "m", 0.016002),
        ("373.15 K", "degC", 100.0),
        ("212 degF", "degC", 100.0),
        ("100 °C", "degC", 100.0),
        ("135 Nm", "N m", 135.0),
        ("135 N·m", "N m", 135.0),
        ("20 GPa^-1", "1/Pa", 2e-8),
        ("11.6e-6 1/degC", "1/K", 1.16e-5),
        ("36 delta_degF", "K", 20.0),
        ("100 rad/s", "rpm", 954.929658551372),
        ("0.5 rad", "deg", 28.64788975654116),
        ("3 rev/min", "rpm", 3.0),
        ("100 cP", "Pa s", 0.1),
        ("30 psi", "Pa", 206842.71879505084),
        ("4 lbf ft", "N m", 5.423271793325601),
        ("0.46 kJ/(kg K)", "J/(kg K)", 460.0),
        ("0.284 lb/in3", "kg/m3", 7861.0929376976865),
        ("2 1/(m2 N^-1)", "N/m2", 2.0),
        ("1.5 L", "m3", 1.5e-3),
        ("1/4 m", "m", "1/4 m"),
        ("1e-3", "m", "1e-3"),
        ("3 mm", "1", "3 mm"),
        ("3 mm", None, "3 mm"),
        (3, "m", 3),
        (None, "m", None),
        ("full", "1", "full"),
    ],
)
def test_a_value_in_the_unit_of_its_key(text, unit, value):
    assert plain(text, unit) == value


@pytest.mark.parametrize(
    ("text", "unit", "reason"),
    [
        ("3 kg", "m", "does not convert to m"),
        ("3 mmm", "m", "unknown unit"),
        ("0x1A", "m", "unknown unit"),
        ("50 Hz", "rpm", "does not convert to rpm"),
        ("3400 1/min", "rpm", "does not convert to rpm"),
        ("20 degC", "K", "is a temperature, and this is a difference"),
        ("20 delta_degC", "degC", "is a difference of temperatures, and this is a temperature"),
        ("100 C", "degC", "does not convert to degC"),
        ("20 degC", "m", "does not convert to m"),
        ("3 m//s", "m", "unknown unit"),
        ("3 m/", "m", "unknown unit"),
        ("3 m (s", "m", "unknown unit"),
        ("3 m)", "m", "unknown unit"),
        ("3 kin", "m", "unknown unit"),
        ("1 mm**9**9", "m", "unknown unit"),
        ("1 mm^99999", "m", "unknown unit"),
        ("1e999999999 mm", "m", "no number of a usable size"),
        ("1 m" + " m" * 100, "m", "unknown unit"),
    ],
)
def test_a_unit_that_does_not_fit(text, unit, reason):
    with pytest.raises(UnitError, match=reason):
        plain(text, unit)


def test_the_unit_of_every_key_is_known():
    for path, field in keys(Configuration):
        unit = unit_of(field)
        assert unit in (None, "1") or plain(f"2.5 {unit}", unit) == 2.5, path


def test_every_example_fits_its_unit():
    for unit in ("m", "m/s", "N m", "N/m", "Pa", "Pa s", "1/Pa", "rpm", "deg", "rad", "degC", "K", "kg m2", "kg/m3"):
        for written in example(unit).replace(" or ", ", ").split(", "):
            assert isinstance(plain(written, unit), float)
    assert plain(example("W/(m K)"), "W/(m K)") == 1.5
    assert example("1") == example(None) == ""

"""Values written with their unit, such as `3 mm` or `100 degC`, turned into the unit of their key without round-off."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any

NUMERAL = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_QUANTITY = re.compile(rf"(?!{NUMERAL}$)({NUMERAL})\s*([A-Za-zµμ°].*|(?<=\s)1\s*/.*)", re.ASCII | re.DOTALL)
# Names, one-digit powers, products and quotients: nothing that could take long to work out.
_UNIT = re.compile(r"(?:[^\W\d]+(?:\d|(?:\*\*|\^)-?\d)?(?!\d)|°[CF]?|1(?!\d)|[*/()·²³\s])+")
_LONGEST = 60
_MOST_DIGITS = 40
_LARGEST_EXPONENT = 300
_EXAMPLES = {
    "m": "3 mm, 65 um or 0.63 in",
    "m/s": "36 km/h",
    "N m": "1.2 kN m",
    "N/m": "300 N/mm",
    "Pa": "206 GPa",
    "Pa s": "9.4 mPa s",
    "1/Pa": "20 1/GPa",
    "rpm": "356 rad/s",
    "deg": "0.35 rad",
    "rad": "90 deg",
    "degC": "373.15 K",
    "K": "20 K",
    "kg m2": "350 kg mm2",
    "kg/m3": "7.85 g/cm3",
}


class UnitError(ValueError):
    """A value whose unit is unknown or does not fit its key; the message goes on from the value."""


def example(unit: str | None) -> str:
    """Return a value with a unit for a key whose unit is `unit`, "" for a key without."""
    return "" if unit in (None, "1") else _EXAMPLES.get(unit, f"1.5 {unit}")


def plain(value: Any, unit: str | None) -> Any:
    """Return text such as "3 mm" as the float nearest to it in `unit`; anything else is returned as it is.

    The conversion is that of exact fractions, rounded once: "3 mm" is 3.0e-3 to the last bit.

    Raises
    ------
    UnitError : the unit is unknown or of another kind than `unit`.
    """
    found = _QUANTITY.fullmatch(value.strip()) if isinstance(value, str) and unit not in (None, "1") else None
    if not found:
        return value
    number, written = found.groups()
    if len(value) > _LONGEST or not _UNIT.fullmatch(written):
        raise UnitError("has an unknown unit")
    if len(number) > _MOST_DIGITS or abs(Decimal(number).adjusted()) > _LARGEST_EXPONENT:
        raise UnitError("is no number of a usable size")
    factor, offset = _conversion(written.strip(), unit)
    return float(Fraction(number) * factor + offset)


@cache
def _conversion(written: str, unit: str) -> tuple[Fraction, Fraction]:
    """Return factor and offset from one unit to the other, exact but for the digits of pi."""
    registry = _registry()
    wanted = registry.parse_units(_spelled(unit))
    try:
        given = registry.parse_units(_spelled(written))
    except Exception:  # what cannot be read as a unit fails in the library, its tokenizer or the language itself
        raise UnitError("has an unknown unit") from None
    if _is_scale(registry, given) and not _is_scale(registry, wanted):
        raise UnitError("is a temperature, and this is a difference of temperatures") from None
    if _is_scale(registry, wanted) and "delta" in str(given):
        raise UnitError("is a difference of temperatures, and this is a temperature") from None
    # Angles are numbers to the library, which would take 50 Hz for 50 rad/s.
    if registry.get_root_units(given)[1] != registry.get_root_units(wanted)[1]:
        raise UnitError(f"has a unit that does not convert to {unit}")
    zero, one = (Fraction(registry.Quantity(Fraction(value), given).to(wanted).magnitude) for value in (0, 1))
    return one - zero, zero


def _is_scale(registry: Any, unit: Any) -> bool:
    return registry.Quantity(Fraction(0), unit).to_root_units().magnitude != 0


def _spelled(unit: str) -> str:
    """Return a unit as the library reads it: powers with a sign of their own, newton metre apart."""
    unit = re.sub(r"(?<=[^\W\d_])(?=\d)", "**", unit.replace("²", "2").replace("³", "3").replace("·", "*"))
    return re.sub(r"\b([mkM]?)Nm\b", r"\1N*m", unit)


@cache
def _registry() -> Any:
    # Half a second, which only a configuration with units in its values pays.
    import pint

    return pint.UnitRegistry(non_int_type=Fraction)

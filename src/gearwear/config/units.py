"""Values written with their unit, such as `3 mm` or `100 degC`, converted exactly to the unit of their key."""

from __future__ import annotations

import re
from collections import Counter
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

NUMERAL = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_QUANTITY = re.compile(rf"(?!{NUMERAL}$)({NUMERAL})\s*([A-Za-zµμ°].*|(?<=\s)1\s*/.*)", re.ASCII | re.DOTALL)
# A name with a power of one digit, or an operator; blanks multiply.
_TOKEN = re.compile(r"\s*(?:(°?[^\W\d]+)((?:\*\*|\^)?-?\d(?!\d))?|(1(?!\d)|[*/()]))\s*")
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


_PI = "3.14159265358979323846264338327950288419716939937510"
_BASES = ("m", "kg", "s", "K", "rad", "C")  # C is the coulomb, so that 100 C is not taken for a temperature
_UNITS = dict(
    definition.split(" = ")
    for definition in f"""
g = 0.001 kg; t = 1000 kg; lb = 0.45359237 kg; min = 60 s; h = 60 min; Hz = 1 1/s
micron = 0.000001 m; in = 0.0254 m; inch = 1 in; ft = 12 in; L = 0.001 m3; l = 1 L
N = 1 kg m/s2; Nm = 1 N m; kgf = 9.80665 N; lbf = 4.4482216152605 N; J = 1 N m; W = 1 J/s
Pa = 1 N/m2; bar = 100000 Pa; psi = 1 lbf/in2; ksi = 1000 psi; P = 0.1 Pa s; St = 0.0001 m2/s
deg = {Fraction(_PI) / 180} rad; rev = 360 deg; rpm = 1 rev/min
degC = 1 K; °C = 1 K; delta_degC = 1 K; degF = 5/9 K; °F = 5/9 K; delta_degF = 5/9 K
""".strip()
    .replace("\n", "; ")
    .split("; ")
)
_PREFIXES = {"n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12}
_PREFIXED = ("m", "g", "s", "K", "rad", "C", "Hz", "L", "l", "N", "Nm", "Pa", "bar", "J", "W", "P", "St")
_CELSIUS, _FAHRENHEIT = Fraction("273.15"), Fraction("459.67") * 5 / 9
_ZEROS = {"degC": _CELSIUS, "°C": _CELSIUS, "degF": _FAHRENHEIT, "°F": _FAHRENHEIT}  # kelvin


class _Unit(NamedTuple):
    """Size in base units, and the power of each of them."""

    size: Fraction
    powers: dict[str, int]


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
    if len(value) > _LONGEST:
        raise UnitError("has an unknown unit")
    if len(number) > _MOST_DIGITS or abs(Decimal(number).adjusted()) > _LARGEST_EXPONENT:
        raise UnitError("is no number of a usable size")
    factor, offset = _conversion(written.strip(), unit)
    return float(Fraction(number) * factor + offset)


@cache
def _conversion(written: str, unit: str) -> tuple[Fraction, Fraction]:
    """Return factor and offset from one unit to the other, exact but for the digits of pi."""
    given, wanted = _parsed(written), _parsed(unit)
    if given.powers != wanted.powers:
        raise UnitError(f"has a unit that does not convert to {unit}")
    if written in _ZEROS and unit not in _ZEROS:
        raise UnitError("is a temperature, and this is a difference of temperatures")
    if unit in _ZEROS and "delta" in written:
        raise UnitError("is a difference of temperatures, and this is a temperature")
    offset = _ZEROS.get(written, 0) - _ZEROS.get(unit, 0)
    return given.size / wanted.size, Fraction(offset) / wanted.size


@cache
def _parsed(text: str) -> _Unit:
    """Read products, quotients and powers of units, from left to right; blanks multiply, parentheses group."""
    unknown = UnitError("has an unknown unit")
    text = text.translate({ord("²"): "2", ord("³"): "3", ord("·"): "*"})
    if _TOKEN.sub("", text):
        raise unknown
    size, powers, sign, groups, ended = Fraction(1), Counter[str](), 1, [1], False
    for name, power, operator in _TOKEN.findall(text):
        if name:
            unit, exponent = _named(name), groups[-1] * sign * int(power.lstrip("*^") or 1)
            size *= unit.size**exponent
            powers.update({base: exponent * count for base, count in unit.powers.items()})
        elif operator == "(":
            groups.append(groups[-1] * sign)
        elif (operator in "*/" and not ended) or (operator == ")" and (not ended or len(groups) == 1)):
            raise unknown
        elif operator == ")":
            groups.pop()
        sign = -1 if operator == "/" else 1
        ended = operator not in ("*", "/", "(")
    if not ended or len(groups) > 1:
        raise unknown
    return _Unit(size, {base: count for base, count in powers.items() if count})


@cache
def _named(name: str) -> _Unit:
    if name in _BASES:
        return _Unit(Fraction(1), {name: 1})
    if name in _UNITS:
        number, definition = _UNITS[name].split(" ", 1)
        unit, factor = _parsed(definition), Fraction(number)
    elif name[:1] in _PREFIXES and name[1:] in _PREFIXED:
        unit, factor = _named(name[1:]), Fraction(10) ** _PREFIXES[name[:1]]
    else:
        raise UnitError("has an unknown unit")
    return _Unit(factor * unit.size, unit.powers)

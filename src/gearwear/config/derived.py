"""Values that a configuration leaves open (null) and that follow from the gear pair."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from gearwear.config.parameters import ENDS, PLACES
from gearwear.config.tree import merged, nested, value_at

_BODY_SHARE = 0.45
_SPREADS = {
    "pinion_torque": (0.8, 1.2),
    "pinion_speed": (2 / 3, 4 / 3),
    "pinion_bore_radius": (0.8, 1.25),
    "gear_bore_radius": (0.8, 1.25),
    "half_backlash": (0.5, 1.25),
}


class Rule(NamedTuple):
    """How a key follows from others: the sentence that stands in the results, and the value."""

    text: str
    value: Callable[[dict[str, Any]], float]


def _bore_radius(gear: str) -> Callable[[dict[str, Any]], float]:
    def value(config: dict[str, Any]) -> float:
        pair = config["gear_pair"]
        depth = pair["addendum_coefficient"][gear] + pair["clearance_coefficient"] - pair["profile_shift"][gear]
        return _BODY_SHARE * pair["module"] * (pair["teeth"][gear] / 2 - depth)

    return value


def _half_backlash(config: dict[str, Any]) -> float:
    pair = config["gear_pair"]
    centre = pair["centre_distance"] or pair["module"] * sum(pair["teeth"].values()) / 2
    return (0.06e-3 + 0.0005 * centre + 0.03 * pair["module"]) / 3


def _share(key: str, factor: float) -> Rule:
    return Rule(f"{factor:.3g} times {key} (choice)", lambda config: factor * value_at(config, key))


# In the order in which one follows from the other.
RULES: dict[str, Rule] = {
    **{
        f"gear_pair.bore_radius.{gear}": Rule(f"{_BODY_SHARE} of the root radius (choice)", _bore_radius(gear))
        for gear in ("pinion", "gear")
    },
    "backlash.half_backlash": Rule(
        "half of the least normal backlash (2/3) (0.06 mm + 0.0005 a + 0.03 m) of ISO/TR 10064-2", _half_backlash
    ),
    **{
        f"sensitivity.{name}.{end}": _share(PLACES[name], factor)
        for name, factors in _SPREADS.items()
        for end, factor in zip(ENDS, factors, strict=True)
    },
}


def resolved(config: dict[str, Any]) -> dict[str, Any]:
    """Return a valid configuration with a number for every null that follows from other values.

    They have four digits: no more is known of them. A configuration without such a null is returned as it is.
    """
    for key, rule in RULES.items():
        if value_at(config, key) is None:
            config = merged(config, nested({key: float(f"{rule.value(config):.4g}")}))
    return config

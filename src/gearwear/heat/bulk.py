"""Bulk temperatures that the configuration leaves to the heat balance."""

from __future__ import annotations

from inspect import signature
from typing import TYPE_CHECKING, Any

from gearwear.errors import Infeasible

if TYPE_CHECKING:
    from gearwear.heat.balance import HeatFlows

BALANCE = "balance"
COLDEST, HOTTEST = -40.0, 250.0  # degC


def bulk_temperature(config: dict[str, Any]) -> float:
    """Return the bulk temperature (degC) at which the section `heat_balance` closes.

    Raises
    ------
    Infeasible : there is none within -40 to 250 degC, or the gears cannot be made or mesh.
    """
    # numpy comes with these, and only a configuration that asks for a balance needs it
    from gearwear.geometry.contact_path import contact_path
    from gearwear.geometry.involute import gear_pair
    from gearwear.heat.balance import balanced, heat_flows

    pair = gear_pair(**{name: config["gear_pair"][name] for name in signature(gear_pair).parameters})
    geometry = pair._asdict() | contact_path(pair, 16)._asdict()
    operation, lubricant, settings = (config[name] for name in ("operation", "lubricant", "heat_balance"))

    def flows(temperature: float) -> HeatFlows:
        return heat_flows(geometry, temperature, operation, lubricant, settings)

    found = balanced(flows, settings["surroundings"])
    if not COLDEST <= found <= HOTTEST:
        losses = flows(settings["surroundings"])
        raise Infeasible(
            f"it closes at {found:.1f} degC, outside {COLDEST:g} to {HOTTEST:g} degC, with a mesh loss of "
            f"{losses.mesh_loss:.3g} W and a churning loss of {losses.churning_loss:.3g} W at "
            "heat_balance.surroundings; check heat_balance.heat_transfer, area and immersion, or the load"
        )
    return found


def of_case(values: dict[str, Any], case: dict[str, Any]) -> tuple[float | None, str]:
    """Return the bulk temperature of a case (degC) and why there is none; None and "" if keys for it are missing.

    Parameters
    ----------
    values : nested dict of the values that are valid on their own; others are absent.
    """
    given = case.get("bulk_temperature")
    if given != BALANCE:
        return given, ""
    try:
        return bulk_temperature(values), ""
    except KeyError:
        return None, ""
    except Infeasible as error:
        return None, f"{BALANCE}: {error}"


def resolved(config: dict[str, Any]) -> dict[str, Any]:
    """Return the checked configuration with temperatures in place of `balance`."""
    if all(case["bulk_temperature"] != BALANCE for case in config["cases"].values()):
        return config
    found = bulk_temperature(config)
    cases = {
        name: case | {"bulk_temperature": found} if case["bulk_temperature"] == BALANCE else case
        for name, case in config["cases"].items()
    }
    return config | {"cases": cases}

"""Nonlinear dynamics of worn, hot spur gear pairs."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gearwear.dynamics import Oscillator
    from gearwear.errors import GearwearError, Infeasible
    from gearwear.pair import GearPair, HeatBalance, Lubricant, Material, TipRelief

__version__ = "0.2.0"
__all__ = [
    "GearPair",
    "GearwearError",
    "HeatBalance",
    "Infeasible",
    "Lubricant",
    "Material",
    "Oscillator",
    "TipRelief",
    "__version__",
]

_MODULES = {"Oscillator": "dynamics", "GearwearError": "errors", "Infeasible": "errors"}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used, so that the package itself is light."""
    if name in __all__:
        return getattr(import_module(f"gearwear.{_MODULES.get(name, 'pair')}"), name)
    raise AttributeError(f"module 'gearwear' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__

"""Numbers as the scorecard words them."""


def micrometres(length: float) -> str:
    """Return a length in m as micrometres, three significant digits, with the unit."""
    return f"{1e6 * length:.3g} um"


def millimetres(length: float) -> str:
    """Return a length in m as millimetres, three decimals, with the unit."""
    return f"{1e3 * length:.3f} mm"


def percent(share: float) -> str:
    """Return a share as per cent, four significant digits, with the unit."""
    return f"{100 * share:.4g} %"

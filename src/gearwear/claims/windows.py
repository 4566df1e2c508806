"""Windows: which motion most of a swept interval shows."""

import numpy as np

from gearwear.claims import rules
from gearwear.claims.study import Study, Undecided
from gearwear.claims.sweeps import Sweep, class_code, class_name, read_sweep
from gearwear.codes.motion_class import NOT_CONVERGED


def points_of_window(swept: np.ndarray, low: float, high: float) -> np.ndarray:
    """Return the indices of the swept values in [low, high], or those nearest its centre if none is."""
    tolerance = rules.GRID_TOLERANCE
    inside = np.flatnonzero((swept >= low - tolerance) & (swept <= high + tolerance))
    if inside.size:
        return inside
    distance = np.abs(swept - (low + high) / 2)
    return np.flatnonzero(distance <= distance.min() + tolerance)


def judge_window(sweep: Sweep, low: float, high: float, names: list[str]) -> tuple[bool | None, str]:
    """Return whether at least half of a window shows one of the named classes, and what it shows.

    Points that did not converge show no class. Where they alone could turn the verdict, it is None.
    """
    sweep.require_span(low, high)
    points = sweep.motion_class[points_of_window(sweep.swept, low, high)]
    share = float(np.isin(points, [class_code(name) for name in names]).mean())
    open_share = float((points == NOT_CONVERGED).mean())
    codes, counts = np.unique(points, return_counts=True)
    seen = ", ".join(f"{class_name(int(code))} {count}" for code, count in zip(codes, counts, strict=True))
    found = f"{100 * share:.0f} % of {points.size} points ({seen})"
    if share >= rules.WINDOW_SHARE:
        return True, found
    return (None if share + open_share >= rules.WINDOW_SHARE else False), found


def judge_window_of_cases(
    study: Study, cases: list[str], name: str, window: tuple[float, float], names: list[str]
) -> tuple[bool | None, str]:
    """Return whether the window (low, high) of sweep `name` agrees in every case, and what each shows."""
    (low, high), outcomes, found = window, [], []
    for case in cases:
        try:
            outcome, text = judge_window(read_sweep(study, case, name), low, high, names)
        except Undecided as reason:
            outcome, text = None, str(reason)
        outcomes.append(outcome)
        found.append(f"{case}: {text}")
    if False in outcomes:
        return False, "; ".join(found)
    return (None if None in outcomes else True), "; ".join(found)

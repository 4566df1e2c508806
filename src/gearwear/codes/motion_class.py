"""Names and codes of the classes of motion, as stored in the sweeps (flag variables of the CF conventions)."""

NOT_CONVERGED, QUASI_PERIODIC, CHAOTIC = 0, 100, 101
LARGEST_PERIOD = 64

FLAG_VALUES = (NOT_CONVERGED, *range(1, LARGEST_PERIOD + 1), QUASI_PERIODIC, CHAOTIC)
FLAG_MEANINGS = ("not_converged", *(f"P{n}" for n in range(1, LARGEST_PERIOD + 1)), "QP", "CH")

SETTLED, SLOW_CONVERGENCE, EXPONENT_UNCLEAR, BLOWN_UP, STEPS_EXHAUSTED = range(5)
REASON_VALUES = (SETTLED, SLOW_CONVERGENCE, EXPONENT_UNCLEAR, BLOWN_UP, STEPS_EXHAUSTED)
REASON_MEANINGS = ("settled", "slow_convergence", "exponent_unclear", "blow_up", "too_many_steps")

AGREED, NO_STABLE_ORBIT, OTHER_PERIOD, POSITIVE_EXPONENT = range(4)
CONFLICT_VALUES = (AGREED, NO_STABLE_ORBIT, OTHER_PERIOD, POSITIVE_EXPONENT)
CONFLICT_MEANINGS = ("none", "no_stable_orbit", "other_period", "positive_exponent")

# As the flags of the files.
MOTION_CLASSES = dict(zip(FLAG_MEANINGS, FLAG_VALUES, strict=True))
REASONS = dict(zip(REASON_MEANINGS, REASON_VALUES, strict=True))
CONFLICTS = dict(zip(CONFLICT_MEANINGS, CONFLICT_VALUES, strict=True))


def class_name(value: int) -> str:
    """Name of a class of motion: P1 to P64 for the period in forcing periods, QP, CH or not_converged."""
    if value not in FLAG_VALUES:
        raise ValueError(f"motion class: code {value} is unknown; the codes are {FLAG_VALUES}")
    return FLAG_MEANINGS[FLAG_VALUES.index(value)]

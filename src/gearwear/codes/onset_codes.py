"""Names of the events on the route to chaos, of how they are met, and of the ways to compute them anew."""

DOUBLED = (1, 2, 4)  # mesh periods before each doubling
CHAOS = "chaos"
EVENTS = (*(f"period {period} to {2 * period}" for period in DOUBLED), CHAOS)

ABSENT, MET, PASSED_BY, BELOW_RANGE = range(4)
LOCATED = (MET, PASSED_BY)  # the event has a place
HOW = {"absent": ABSENT, "met": MET, "passed_by": PASSED_BY, "below_range": BELOW_RANGE}

ORDERS = ("restart", "up", "down")
OTHER_START, LONGER, FINER, GENERAL, GENERAL_HALVED = (
    "other start",
    "longer settling",
    "halved step",
    "Dormand-Prince",
    "Dormand-Prince, halved tolerance",
)
VARIANTS = (*ORDERS, OTHER_START, LONGER, FINER, GENERAL, GENERAL_HALVED)

# Contributions to the numerical error: what each of them varies.
RESOLUTION, TOTAL = "resolution", "total"
VARIED = {
    "start": (*ORDERS, OTHER_START),
    "settling": (LONGER,),
    "step": (FINER,),
    "integrator": (GENERAL, GENERAL_HALVED),
}
ERRORS = (RESOLUTION, *VARIED, TOTAL)

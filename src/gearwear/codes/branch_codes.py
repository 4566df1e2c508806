"""Names and codes of special points, ends of branches and stability, as stored (flags of the CF conventions)."""

NONE, FOLD, PERIOD_DOUBLING, TORUS = range(4)
SPECIAL_POINTS = {"none": NONE, "fold": FOLD, "period_doubling": PERIOD_DOUBLING, "torus": TORUS}

RANGE_END, CLOSED, HALVED, STOPPED, NODE_LIMIT = range(5)
BRANCH_ENDS = {
    "range_end": RANGE_END,
    "closed": CLOSED,
    "half_period": HALVED,
    "stopped": STOPPED,
    "node_limit": NODE_LIMIT,
}

STABILITY = {"unstable": 0, "stable": 1}

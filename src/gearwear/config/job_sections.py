"""Section of the configuration that cuts the work into jobs."""

from __future__ import annotations

from gearwear.config.key_types import Section, Whole, cut

MOST_UPDATES = 999


class Jobs(Section):
    """How the work is cut into jobs. The results are the same to the last bit."""

    wear_cycles: Whole = cut(
        "Wear cycles of a case that one job computes, one after another; 1 = a job for each stage of each cycle. "
        "A changed value makes the wear chains anew, and more running cycles their last block.",
        "1",
        ge=1,
        le=MOST_UPDATES,
    )

"""Nonlinear dynamics of worn, hot spur gears: the physics behind the workflow."""

import gc

# A plan, and what libraries make when they are imported, are many small objects that live as long as the process:
# to look for garbage among them takes a sixth of the time of planning and a tenth of a short job.
gc.set_threshold(100_000)

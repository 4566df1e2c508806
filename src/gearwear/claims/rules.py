"""The numbers behind the words of the verdicts; the header of config/paper_claims.yaml repeats them.

They are general: no claim has a limit of its own.
"""

AGREE = "agree"
DIFFERS = "differs"
NOT_DECIDED = "not decided"

WINDOW_SHARE = 0.5
"""Least share of the points of a window that must show one of its motion classes."""

EVENT_TOLERANCE = 0.03
"""Largest distance of a computed event from the stated one, in units of the swept variable."""

PERIOD_RUN = 2
"""Fewest successive points of one class that count as that motion on either side of a change of period."""

CHAOS_RUN = 3
"""Fewest successive chaotic points that count as the onset of chaos."""

AMPLITUDE_JUMP_RANGE = (0.4, 0.75)
"""Range of the swept variable in which the amplitude jump is looked for."""

AMPLITUDE_JUMP_LEAST = 0.2
"""Change of the section above which it jumps, in units of the half clearance."""

FAR_MORE = 2.0
"""Ratio above which one size is "far more" than another."""

SIGNIFICANTLY_LARGER = 1.5
"""Least ratio called "significantly larger"."""

JUMP_OVER_NEIGHBOURS = 5.0
"""Ratio of a one-sided difference to the larger of the neighbouring steps above which it is a jump."""

NO_WEAR = 1e-6
"""Share of the greatest wear depth below which there is no wear."""

GRID_TOLERANCE = 1e-9
"""Tolerance of a swept value at the ends of a range, and relative tolerance of equal field values."""

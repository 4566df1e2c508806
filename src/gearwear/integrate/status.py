"""What all integrators have in common: how a run ended, how much it records, and its limits."""

COMPLETED, BLOW_UP, TOO_MANY_STEPS = range(3)  # status of a run

STATES, GROWTH, MAPS, RECORDS = range(4)  # detail of a run; each holds the ones before it

# Columns of the records of a period: extremes of the displacement, largest magnitude of the mesh force, time out of
# contact, number of entries into contact.
LOWEST, HIGHEST, FORCE, LOST, IMPACTS, COLUMNS = range(6)

LARGEST_DISPLACEMENT = 1e6  # of displacement and velocity at the end of a step or period; beyond, the motion blows up
LARGEST_INSIDE = 1e100  # inside a cell, so that nothing overflows before its end is looked at

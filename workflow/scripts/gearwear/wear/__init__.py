"""Film thickness, wear coefficient and the wear depth of the flanks."""

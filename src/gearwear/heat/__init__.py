"""Heat balance of the gear pair and thermal growth of the flanks."""

"""Flag codes of the result files: motion classes, bifurcations, onsets."""

"""Studies over grids: what comes out for one combination of values, and what all of them say."""

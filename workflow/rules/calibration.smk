def islands():
    """The searches of the calibration, by their numbers."""
    return range(1, config["calibration"]["islands"] + 1)


rule search_parameters:
    input:
        claims=CLAIMS,
    output:
        "results/calibration/searches/{island}.nc",
    log:
        "results/logs/search_parameters/{island}.log",
    benchmark:
        "results/benchmarks/search_parameters/{island}.tsv"
    wildcard_constraints:
        island=r"[1-9]\d?",
    params:
        cfg=cfg("calibration"),
        code=code("search_parameters.py"),
    message:
        "Searching the open parameters, search {wildcards.island}."
    script:
        "../scripts/search_parameters.py"


rule compare_candidates:
    input:
        claims=CLAIMS,
        searches=expand("results/calibration/searches/{island}.nc", island=islands()),
    output:
        dataset="results/calibration/calibration.nc",
        parameters=report(
            "results/calibration/parameters.csv",
            caption=caption("calibration"),
            category="Calibration",
            labels={"figure": "parameters"},
        ),
        claims=report(
            "results/calibration/claims.csv",
            caption=caption("calibration"),
            category="Calibration",
            labels={"figure": "claims"},
        ),
    log:
        "results/logs/compare_candidates.log",
    benchmark:
        "results/benchmarks/compare_candidates.tsv"
    params:
        cfg=cfg("calibration"),
        code=code("compare_candidates.py"),
    message:
        "Computing the best candidates of the calibration in full."
    script:
        "../scripts/compare_candidates.py"

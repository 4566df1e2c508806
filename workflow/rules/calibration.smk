"""Search for values of the parameters that the paper does not give."""


def islands():
    """The searches of the calibration, by their numbers."""
    return range(1, config["calibration"]["islands"] + 1)


rule search:
    input:
        claims=CLAIMS,
    output:
        "results/calibration/searches/{island}.nc",
    log:
        "results/logs/search/{island}.log",
    benchmark:
        "results/benchmarks/search/{island}.tsv"
    wildcard_constraints:
        island=r"[1-9]\d?",
    params:
        cfg=cfg("calibration"),
        code=code("search"),
    message:
        "Searching the open parameters, search {wildcards.island}."
    script:
        "../scripts/stage.py"


rule calibration:
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
        "results/logs/calibration.log",
    benchmark:
        "results/benchmarks/calibration.tsv"
    params:
        cfg=cfg("calibration"),
        code=code("calibration"),
    message:
        "Computing the best candidates of the calibration in full."
    script:
        "../scripts/stage.py"

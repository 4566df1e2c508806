def chain_files(stage, first, behind):
    """The files of a stage over the wear cycles of every case, from `first` to the last but `behind`."""
    return [
        f"results/{case}/{stage}/q{q:03d}.nc"
        for case in config["cases"]
        for q in range(first, int(last(case)) + 1 - behind)
    ]


rule list_warnings:
    input:
        geometry="results/geometry.nc",
        temperature=expand("results/{case}/temperature.nc", case=config["cases"]),
        transmission_error=chain_files("transmission_error", 0, 1),
        wear=chain_files("wear", 1, 0),
        response=states(),
        template=TABLE,
    output:
        csv="results/warnings.csv",
        html=report(
            "results/warnings.html",
            caption=caption("warnings"),
            category="Trust",
            labels={"table": "warnings"},
        ),
    log:
        "results/logs/list_warnings.log",
    benchmark:
        "results/benchmarks/list_warnings.tsv"
    params:
        cfg={
            "cases": {case: int(last(case)) for case in config["cases"]},
            **cfg("warnings")({}),
        },
        code=code("list_warnings.py"),
    message:
        "Listing what lies outside the range of a law."
    script:
        "../scripts/list_warnings.py"

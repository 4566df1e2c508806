from importlib.metadata import version

PACKAGES = (
    "matplotlib",
    "netCDF4",
    "numba",
    "numpy",
    "pint",
    "pydantic",
    "scipy",
    "snakemake",
    "xarray",
)
# The default first, each over the ones before it.
CONFIGURATION_FILES = list(
    dict.fromkeys(
        relpath(file)
        for file in (
            own("config", "config.yaml"),
            *workflow.overwrite_configfiles,
        )
    )
)


def judged():
    """Everything that the claims speak of: the states of figures 6 to 11, the extremes, sweeps, the last responses."""
    files = ["results/geometry.nc"]
    for case in dict.fromkeys(
        [
            *config["figures"]["diagonal"],
            "without",
            "temperature_only",
            "wear_only",
            "with",
        ]
    ):
        files += [
            f"results/{case}/{name}.nc" for name in ("temperature", "deformation")
        ]
        for stage in ("wear", "mesh_stiffness", "transmission_error", "backlash"):
            files += [
                f"results/{case}/{stage}/q{q}.nc"
                for q in dict.fromkeys(["000", last(case)])
            ]
    files += [f"results/with/wear/q{q:03d}.nc" for q in range(1, int(last("with")))]
    files += [f"results/{case}/response/q{last(case)}.nc" for case in config["cases"]]
    return files + main_sweeps()


rule list_parameters:
    input:
        files=CONFIGURATION_FILES,
        template=TABLE,
    output:
        csv="results/parameters.csv",
        html=report(
            "results/parameters.html",
            caption=caption("parameters"),
            category="Study",
            labels={"table": "parameters"},
        ),
    log:
        "results/logs/list_parameters.log",
    benchmark:
        "results/benchmarks/list_parameters.tsv"
    params:
        cfg={
            "configuration": config,
            "command_line": workflow.config_settings.config or {},
        },
        code=code("list_parameters.py"),
    message:
        "Listing the values of the configuration."
    script:
        "../scripts/list_parameters.py"


rule list_versions:
    input:
        template=TABLE,
    output:
        csv="results/versions.csv",
        html=report(
            "results/versions.html",
            caption=caption("versions"),
            category="Study",
            labels={"table": "versions"},
        ),
    log:
        "results/logs/list_versions.log",
    benchmark:
        "results/benchmarks/list_versions.tsv"
    params:
        cfg={name: version(name) for name in PACKAGES},
        code=code("list_versions.py"),
    message:
        "Listing the versions of the packages."
    script:
        "../scripts/list_versions.py"


rule judge_claims:
    input:
        claims=CLAIMS,
        results=judged(),
    output:
        report(
            "results/claims.csv",
            caption=caption("claims"),
            category="Claims of the paper",
            labels={"form": "table, to download"},
        ),
    log:
        "results/logs/judge_claims.log",
    benchmark:
        "results/benchmarks/judge_claims.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("judge_claims.py"),
    message:
        "Holding the claims of the paper against the results."
    script:
        "../scripts/judge_claims.py"


rule show_claims:
    input:
        claims=CLAIMS,
        scorecard="results/claims.csv",
        sweeps=main_sweeps(),
        template=own("workflow", "report", "claims.html.j2"),
    output:
        report(
            "results/claims.html",
            caption=caption("claims"),
            category="Claims of the paper",
            labels={"form": "scorecard"},
        ),
    log:
        "results/logs/show_claims.log",
    benchmark:
        "results/benchmarks/show_claims.tsv"
    params:
        cfg={},
        code=code("show_claims.py"),
    message:
        "Writing the scorecard of the claims as a page."
    script:
        "../scripts/show_claims.py"

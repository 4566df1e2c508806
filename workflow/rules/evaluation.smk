"""What a run used and found: parameters, versions, warnings, claims, the page of the motions."""

from importlib.metadata import version

PACKAGES = (
    "gearwear",
    "matplotlib",
    "netCDF4",
    "numba",
    "numpy",
    "pydantic",
    "scipy",
    "snakemake",
    "xarray",
)


def warned():
    """The table of warnings; a prescribed oscillator has no range of validity."""
    return [] if config["oscillators"] else ["results/warnings.html"]


def scorecard():
    """The claims of the paper, where the pair is that of the paper."""
    judged = config["figures"]["claims"] and not config["oscillators"]
    return ["results/claims.csv", "results/claims.html"] if judged else []


def judged():
    """All that the claims speak of: the states of figures 6 to 11, the extremes, sweeps, the last responses."""
    files = ["results/geometry.nc"]
    four = ("without", "temperature_only", "wear_only", "with")
    for case in dict.fromkeys([*config["figures"]["diagonal"], *four]):
        files += [
            f"results/{case}/{name}.nc" for name in ("temperature", "deformation")
        ]
        for stage in ("wear", "mesh_stiffness", "transmission_error", "backlash"):
            files += [
                f"results/{case}/{stage}/q{q}.nc"
                for q in dict.fromkeys(["000", last(case)])
            ]
    files += ["results/with/flash_growth.nc"]
    files += [f"results/with/wear/q{q}.nc" for q in cycles("with", first=1)[:-1]]
    files += [f"results/{case}/response/q{last(case)}.nc" for case in config["cases"]]
    return files + main_sweeps()


rule parameters:
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
        "results/logs/parameters.log",
    benchmark:
        "results/benchmarks/parameters.tsv"
    params:
        cfg={
            "configuration": config,
            "command_line": workflow.config_settings.config or {},
        },
        code=code("parameters"),
    message:
        "Listing the values of the configuration."
    script:
        "../scripts/stage.py"


rule versions:
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
        "results/logs/versions.log",
    benchmark:
        "results/benchmarks/versions.tsv"
    params:
        cfg={name: version(name) for name in PACKAGES},
        code=code("versions"),
    message:
        "Listing the versions of the packages."
    script:
        "../scripts/stage.py"


rule warnings:
    input:
        geometry="results/geometry.nc",
        temperature=expand("results/{case}/temperature.nc", case=config["cases"]),
        transmission_error=chain_files("transmission_error", behind=1),
        wear=chain_files("wear", first=1),
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
        "results/logs/warnings.log",
    benchmark:
        "results/benchmarks/warnings.tsv"
    params:
        cfg={
            "cases": {case: int(last(case)) for case in config["cases"]},
            **cfg("warnings")({}),
        },
        code=code("warnings"),
    message:
        "Listing what lies outside the range of a law."
    script:
        "../scripts/stage.py"


rule claims:
    input:
        statements=CLAIMS,
        results=judged(),
    output:
        report(
            "results/claims.csv",
            caption=caption("claims"),
            category="Claims of the paper",
            labels={"form": "table, to download"},
        ),
    log:
        "results/logs/claims.log",
    benchmark:
        "results/benchmarks/claims.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("claims"),
    message:
        "Comparing the results with the claims of the paper."
    script:
        "../scripts/stage.py"


rule claims_page:
    input:
        statements=CLAIMS,
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
        "results/logs/claims_page.log",
    benchmark:
        "results/benchmarks/claims_page.tsv"
    params:
        cfg={},
        code=code("claims_page"),
    message:
        "Writing the scorecard of the claims as a page."
    script:
        "../scripts/stage.py"


rule motion_page:
    input:
        geometry=[] if config["oscillators"] else "results/geometry.nc",
        sweeps=main_sweeps(),
        motions=main_sweeps("motions"),
        template=own("workflow", "report", "page.html.j2"),
        program=own("workflow", "report", "page.js"),
    output:
        report(
            "results/page.html",
            caption=caption("page"),
            category="Dynamics",
            labels={"figure": "interactive page"},
        ),
    log:
        "results/logs/motion_page.log",
    benchmark:
        "results/benchmarks/motion_page.tsv"
    params:
        cfg={
            "panels": [
                {"sweep": sweep, "swept": swept(sweep), "state": drawn_state(case)}
                for case, sweep in swept_cases()
            ]
        },
        code=code("motion_page"),
    message:
        "Writing the interactive page of the motions."
    script:
        "../scripts/stage.py"


rule handover_dataset:
    input:
        geometry="results/{root}geometry.nc",
        wear=every("wear"),
        mesh_stiffness=every("mesh_stiffness"),
        transmission_error=every("transmission_error"),
        backlash=every("backlash"),
        response=every("response"),
    output:
        "results/{root}{case}/handover/handover.nc",
    log:
        "results/logs/{root}{case}/handover_dataset.log",
    benchmark:
        "results/benchmarks/{root}{case}/handover_dataset.tsv"
    params:
        cfg=cfg("handover_dataset"),
        code=code("handover_dataset"),
    message:
        "Case {wildcards.root}{wildcards.case}: collecting the gears and every wear cycle for other programs."
    script:
        "../scripts/stage.py"


rule handover_tables:
    input:
        dataset="results/{root}{case}/handover/handover.nc",
    output:
        mesh="results/{root}{case}/handover/mesh.csv",
        wear="results/{root}{case}/handover/wear.csv",
        states="results/{root}{case}/handover/states.csv",
        gears="results/{root}{case}/handover/gears.csv",
        dictionary="results/{root}{case}/handover/dictionary.csv",
    log:
        "results/logs/{root}{case}/handover_tables.log",
    benchmark:
        "results/benchmarks/{root}{case}/handover_tables.tsv"
    params:
        cfg={},
        code=code("handover_tables"),
    message:
        "Case {wildcards.root}{wildcards.case}: writing the same as tables."
    script:
        "../scripts/stage.py"

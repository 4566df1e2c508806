"""Comparison with standards, other programs, closed forms and finer grids, group by group."""

CHECKS = own("config", "validation.yaml")
CHECKED = (
    "geometry",
    "stiffness",
    "iso_6336",
    "sharing",
    "heat",
    "wear",
    "oscillator",
    "bifurcations",
    "convergence",
)


wildcard_constraints:
    group="|".join(CHECKED),


rule validation_group:
    input:
        checks=CHECKS,
    output:
        "results/validation/{group}.csv",
    log:
        "results/logs/validation/{group}.log",
    benchmark:
        "results/benchmarks/validation/{group}.tsv"
    params:
        cfg={},
        code=code("validation_group"),
    message:
        "Checking {wildcards.group} against its sources."
    script:
        "../scripts/stage.py"


rule validation_page:
    input:
        checks=CHECKS,
        found=expand("results/validation/{group}.csv", group=CHECKED),
        figures=expand("results/validation/{group}.svg", group=CHECKED),
        template=own("workflow", "report", "validation.html.j2"),
    output:
        table=report(
            "results/validation/validation.csv",
            caption=caption("validation"),
            category="Validation",
            labels={"figure": "table"},
        ),
        page=report(
            "results/validation/validation.html",
            caption=caption("validation"),
            category="Validation",
            labels={"figure": "page"},
        ),
    log:
        "results/logs/validation/validation_page.log",
    benchmark:
        "results/benchmarks/validation/validation_page.tsv"
    params:
        cfg={},
        code=code("validation_page"),
    message:
        "Writing the table and the page of the validation."
    script:
        "../scripts/stage.py"

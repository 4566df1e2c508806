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


rule check_group:
    input:
        checks=CHECKS,
    output:
        "results/validation/{group}.csv",
    log:
        "results/logs/validation/check_{group}.log",
    benchmark:
        "results/benchmarks/validation/check_{group}.tsv"
    params:
        cfg=lambda wildcards: {"group": wildcards.group},
        code=code("check_group.py"),
    message:
        "Checking {wildcards.group} against its sources."
    script:
        "../scripts/check_group.py"


rule show_validation:
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
        "results/logs/validation/show_validation.log",
    benchmark:
        "results/benchmarks/validation/show_validation.tsv"
    params:
        cfg={},
        code=code("show_validation.py"),
    message:
        "Writing the table and the page of the validation."
    script:
        "../scripts/show_validation.py"

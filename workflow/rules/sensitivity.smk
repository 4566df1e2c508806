from gearwear.config import variations


def varied():
    """Every variation of the sensitivity, and why it is no member where it is none."""
    return [
        {name: value for name, value in one._asdict().items() if name != "overrides"}
        | {
            "hindrance": refused(
                f"studies/{variations.STUDY}/{one.name}/", one.overrides
            )
        }
        for one in variations.variations(config)
    ]


VARIED = varied()


rule measure_member:
    output:
        "results/{root}measures.nc",
    log:
        "results/logs/{root}measure_member.log",
    benchmark:
        "results/benchmarks/{root}measure_member.tsv"
    params:
        cfg=cfg("measures"),
        code=code("measure_member.py"),
    message:
        "Measuring the mesh, the wear and the route to chaos: results/{wildcards.root}measures.nc."
    script:
        "../scripts/measure_member.py"


rule compare_members:
    input:
        study="results/measures.nc",
        members=[
            f"results/studies/{variations.STUDY}/{one['name']}/measures.nc"
            for one in VARIED
            if not one["hindrance"]
        ],
    output:
        measures="results/sensitivity.nc",
        table="results/sensitivity.csv",
    log:
        "results/logs/compare_members.log",
    benchmark:
        "results/benchmarks/compare_members.tsv"
    params:
        cfg=lambda wildcards: cfg("sensitivity")(wildcards) | {"varied": VARIED},
        code=code("compare_members.py"),
    message:
        "Comparing what every option and every open parameter changes."
    script:
        "../scripts/compare_members.py"

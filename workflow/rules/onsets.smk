from gearwear.config import ensemble

SHIFTED = ("without", "with")


def main_sweep(sweep):
    """Input function: the sweep in the order that is shown first and judged."""

    def in_order(wildcards):
        order = member(wildcards.root)["sweeps"]["order"]
        return f"results/{wildcards.root}{wildcards.case}/sweeps/{order}/{sweep}.nc"

    return in_order


def ensemble_onsets():
    """The onsets of every member of the ensemble, in their order."""
    return [
        f"results/studies/{ensemble.STUDY}/{name}/member_onsets.nc"
        for name in ensemble.factors(config["onsets"])
    ]


rule locate_onsets:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweep=main_sweep("mesh_frequency"),
        branches="results/{root}{case}/branches/mesh_frequency.nc",
    output:
        "results/{root}{case}/onsets.nc",
    log:
        "results/logs/{root}{case}/locate_onsets.log",
    benchmark:
        "results/benchmarks/{root}{case}/locate_onsets.tsv"
    params:
        cfg=cfg("onsets"),
        code=code("locate_onsets.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: locating the onsets of period doublings and chaos."
    script:
        "../scripts/locate_onsets.py"


rule vary_onsets:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweeps=expand(
            "results/{{root}}{{case}}/sweeps/{order}/mesh_frequency.nc",
            order=("restart", "up", "down"),
        ),
        branches="results/{root}{case}/branches/mesh_frequency.nc",
    output:
        "results/{root}{case}/onset_variants.nc",
    log:
        "results/logs/{root}{case}/vary_onsets.log",
    benchmark:
        "results/benchmarks/{root}{case}/vary_onsets.tsv"
    params:
        cfg=cfg("onsets"),
        code=code("vary_onsets.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: computing the onsets in other ways."
    script:
        "../scripts/vary_onsets.py"


rule measure_onsets:
    output:
        "results/{root}member_onsets.nc",
    log:
        "results/logs/{root}measure_onsets.log",
    benchmark:
        "results/benchmarks/{root}measure_onsets.tsv"
    params:
        cfg=cfg("member_onsets"),
        code=code("measure_onsets.py"),
    message:
        "Wearing both cases of a member and locating their onsets: results/{wildcards.root}member_onsets.nc."
    script:
        "../scripts/measure_onsets.py"


rule compare_onsets:
    input:
        onsets=expand("results/{case}/onsets.nc", case=SHIFTED),
        variants=expand("results/{case}/onset_variants.nc", case=SHIFTED),
        members=ensemble_onsets(),
    output:
        shifts="results/onset_shifts.nc",
        table="results/onsets.csv",
    log:
        "results/logs/compare_onsets.log",
    benchmark:
        "results/benchmarks/compare_onsets.tsv"
    params:
        cfg=cfg("onset_shifts"),
        code=code("compare_onsets.py"),
    message:
        "Comparing the onsets of the cases without and with, and over the ensemble."
    script:
        "../scripts/compare_onsets.py"

"""Onsets of period doublings and chaos, and how they shift between the cases without and with."""

from gearwear.config import ensemble

SHIFTED = ("without", "with")


def main_sweep(sweep):
    """Input function: the sweep in the direction that is shown first and judged."""

    def in_direction(wildcards):
        order = member(wildcards.root)["sweeps"]["order"]
        return f"results/{wildcards.root}{wildcards.case}/sweeps/{order}/{sweep}.nc"

    return in_direction


rule case_onsets:
    input:
        excitation="results/{root}{case}/excitation.nc",
        main_sweep=main_sweep("mesh_frequency"),
        branches="results/{root}{case}/branches/mesh_frequency.nc",
    output:
        "results/{root}{case}/onsets.nc",
    log:
        "results/logs/{root}{case}/case_onsets.log",
    benchmark:
        "results/benchmarks/{root}{case}/case_onsets.tsv"
    params:
        cfg=cfg("case_onsets"),
        code=code("case_onsets"),
    message:
        "Case {wildcards.root}{wildcards.case}: locating the onsets of period doublings and chaos."
    script:
        "../scripts/stage.py"


rule onset_variants:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweeps=expand(
            "results/{{root}}{{case}}/sweeps/{direction}/mesh_frequency.nc",
            direction=DIRECTIONS,
        ),
        branches="results/{root}{case}/branches/mesh_frequency.nc",
    output:
        "results/{root}{case}/onset_variants.nc",
    log:
        "results/logs/{root}{case}/onset_variants.log",
    benchmark:
        "results/benchmarks/{root}{case}/onset_variants.tsv"
    params:
        cfg=cfg("case_onsets"),
        code=code("onset_variants"),
    message:
        "Case {wildcards.root}{wildcards.case}: computing the onsets in other ways."
    script:
        "../scripts/stage.py"


rule member_onsets:
    output:
        "results/{root}member_onsets.nc",
    log:
        "results/logs/{root}member_onsets.log",
    benchmark:
        "results/benchmarks/{root}member_onsets.tsv"
    params:
        cfg=cfg("member_onsets"),
        code=code("member_onsets"),
    message:
        "Wearing both cases of a member and locating their onsets: results/{wildcards.root}member_onsets.nc."
    script:
        "../scripts/stage.py"


rule onset_shifts:
    input:
        onsets=expand("results/{case}/onsets.nc", case=SHIFTED),
        variants=expand("results/{case}/onset_variants.nc", case=SHIFTED),
        members=[
            f"results/studies/{ensemble.STUDY}/{name}/member_onsets.nc"
            for name in ensemble.factors(config["onsets"])
        ],
    output:
        shifts="results/onset_shifts.nc",
        table="results/onsets.csv",
    log:
        "results/logs/onset_shifts.log",
    benchmark:
        "results/benchmarks/onset_shifts.tsv"
    params:
        cfg=cfg("onset_shifts"),
        code=code("onset_shifts"),
    message:
        "Comparing the onsets of the cases without and with, and over the ensemble."
    script:
        "../scripts/stage.py"

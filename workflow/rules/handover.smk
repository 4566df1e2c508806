def every(stage):
    """Input function: the files of a stage at every wear cycle of the case."""

    def all_cycles(wildcards):
        root, case = wildcards.root, wildcards.case
        return [
            f"results/{root}{case}/{stage}/q{q:03d}.nc"
            for q in range(int(last(case, root)) + 1)
        ]

    return all_cycles


rule gather_handover:
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
        "results/logs/{root}{case}/gather_handover.log",
    benchmark:
        "results/benchmarks/{root}{case}/gather_handover.tsv"
    params:
        cfg=cfg("handover"),
        code=code("gather_handover.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: gathering the gears and every wear cycle for other programs."
    script:
        "../scripts/gather_handover.py"


rule write_handover:
    input:
        dataset="results/{root}{case}/handover/handover.nc",
    output:
        mesh="results/{root}{case}/handover/mesh.csv",
        wear="results/{root}{case}/handover/wear.csv",
        states="results/{root}{case}/handover/states.csv",
        gears="results/{root}{case}/handover/gears.csv",
        dictionary="results/{root}{case}/handover/dictionary.csv",
    log:
        "results/logs/{root}{case}/write_handover.log",
    benchmark:
        "results/benchmarks/{root}{case}/write_handover.tsv"
    params:
        cfg={},
        code=code("write_handover.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: writing what is handed over as tables."
    script:
        "../scripts/write_handover.py"

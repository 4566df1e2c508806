"""The motion of the oscillator: excitation, sweeps, branches, portraits, basins, the traced motions of a page."""


rule excitation:
    input:
        geometry="results/{root}geometry.nc",
        mesh_stiffness=final("mesh_stiffness"),
        transmission_error=final("transmission_error"),
        backlash=final("backlash"),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{root}{case}/excitation.nc",
    log:
        "results/logs/{root}{case}/excitation.log",
    benchmark:
        "results/benchmarks/{root}{case}/excitation.tsv"
    wildcard_constraints:
        case=one_of("cases"),
    params:
        cfg=cfg("excitation"),
        code=code("excitation"),
    message:
        "Case {wildcards.root}{wildcards.case}: building the excitation of the oscillator."
    script:
        "../scripts/stage.py"


rule prescribed_excitation:
    output:
        "results/{root}{case}/excitation.nc",
    log:
        "results/logs/{root}{case}/excitation.log",
    benchmark:
        "results/benchmarks/{root}{case}/excitation.tsv"
    wildcard_constraints:
        case=one_of("oscillators"),
    params:
        cfg=cfg("prescribed_excitation"),
        code=code("prescribed_excitation"),
    message:
        "Oscillator {wildcards.root}{wildcards.case}: taking the excitation from the configuration."
    script:
        "../scripts/stage.py"


rule sweep_part:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/sweeps/parts/{sweep}/{scatteritem}.nc",
    log:
        "results/logs/{root}{case}/sweep_part/{sweep}/{scatteritem}.log",
    benchmark:
        "results/benchmarks/{root}{case}/sweep_part/{sweep}/{scatteritem}.tsv"
    params:
        cfg=cfg("sweep"),
        code=code("sweep_part"),
    message:
        "Case {wildcards.root}{wildcards.case}: sweeping {wildcards.sweep}, part {wildcards.scatteritem}."
    script:
        "../scripts/stage.py"


rule sweep:
    input:
        excitation="results/{root}{case}/excitation.nc",
        parts=(
            gather.sweep(
                "results/{{root}}{{case}}/sweeps/parts/{{sweep}}/{scatteritem}.nc"
            )
            if PARTS > 1
            else []
        ),
    output:
        restart="results/{root}{case}/sweeps/restart/{sweep}.nc",
        up="results/{root}{case}/sweeps/up/{sweep}.nc",
        down="results/{root}{case}/sweeps/down/{sweep}.nc",
    log:
        "results/logs/{root}{case}/sweep/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/sweep/{sweep}.tsv"
    params:
        cfg=cfg("sweep"),
        code=code("sweep"),
    message:
        "Case {wildcards.root}{wildcards.case}: sweeping {wildcards.sweep} from rest, up and down."
    script:
        "../scripts/stage.py"


rule branches:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweeps=expand(
            "results/{{root}}{{case}}/sweeps/{direction}/{{sweep}}.nc",
            direction=DIRECTIONS,
        ),
    output:
        "results/{root}{case}/branches/{sweep}.nc",
    log:
        "results/logs/{root}{case}/branches/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/branches/{sweep}.tsv"
    params:
        cfg=cfg("branches"),
        code=code("branches"),
    message:
        "Case {wildcards.root}{wildcards.case}: following the periodic orbits along {wildcards.sweep}."
    script:
        "../scripts/stage.py"


rule portraits:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/portraits/{sweep}.nc",
    log:
        "results/logs/{root}{case}/portraits/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/portraits/{sweep}.tsv"
    params:
        cfg=cfg("portraits"),
        code=code("portraits"),
    message:
        "Case {wildcards.root}{wildcards.case}: tracing the phase portraits of {wildcards.sweep}."
    script:
        "../scripts/stage.py"


rule motions:
    input:
        excitation="results/{root}{case}/excitation.nc",
        points="results/{root}{case}/sweeps/{order}/{sweep}.nc",
    output:
        "results/{root}{case}/motions/{order}/{sweep}.nc",
    log:
        "results/logs/{root}{case}/motions/{order}/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/motions/{order}/{sweep}.tsv"
    wildcard_constraints:
        order="|".join(DIRECTIONS),
    params:
        cfg=cfg("motions"),
        code=code("motions"),
    message:
        "Case {wildcards.root}{wildcards.case}: tracing the motion at every point of {wildcards.sweep}."
    script:
        "../scripts/stage.py"


rule basins:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/basins/{sweep}.nc",
    log:
        "results/logs/{root}{case}/basins/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/basins/{sweep}.tsv"
    params:
        cfg=cfg("basins"),
        code=code("basins"),
    message:
        "Case {wildcards.root}{wildcards.case}: mapping the basins of attraction over {wildcards.sweep}."
    script:
        "../scripts/stage.py"

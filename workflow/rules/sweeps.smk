rule build_excitation:
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
        "results/logs/{root}{case}/build_excitation.log",
    benchmark:
        "results/benchmarks/{root}{case}/build_excitation.tsv"
    wildcard_constraints:
        case=one_of("cases"),
    params:
        cfg=cfg("excitation"),
        code=code("build_excitation.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: building the excitation of the oscillator."
    script:
        "../scripts/build_excitation.py"


rule give_excitation:
    output:
        "results/{root}{case}/excitation.nc",
    log:
        "results/logs/{root}{case}/give_excitation.log",
    benchmark:
        "results/benchmarks/{root}{case}/give_excitation.tsv"
    wildcard_constraints:
        case=one_of("oscillators"),
    params:
        cfg=cfg("given_excitation"),
        code=code("give_excitation.py"),
    message:
        "Oscillator {wildcards.root}{wildcards.case}: taking the excitation from the configuration."
    script:
        "../scripts/give_excitation.py"


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
        code=code("sweep_part.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: sweeping {wildcards.sweep}, part {wildcards.scatteritem}."
    script:
        "../scripts/sweep_part.py"


rule join_sweep:
    input:
        parts=gather.sweep(
            "results/{{root}}{{case}}/sweeps/parts/{{sweep}}/{scatteritem}.nc"
        ),
    output:
        "results/{root}{case}/sweeps/restart/{sweep}.nc",
    log:
        "results/logs/{root}{case}/join_sweep/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/join_sweep/{sweep}.tsv"
    params:
        cfg=cfg("sweep"),
        code=code("join_sweep.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: joining the parts of the {wildcards.sweep} sweep."
    script:
        "../scripts/join_sweep.py"


rule carry_sweep:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/sweeps/{order}/{sweep}.nc",
    log:
        "results/logs/{root}{case}/carry_sweep/{order}/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/carry_sweep/{order}/{sweep}.tsv"
    wildcard_constraints:
        order="up|down",
    params:
        cfg=cfg("sweep"),
        code=code("carry_sweep.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: sweeping {wildcards.sweep} {wildcards.order}, every point from the one before."
    script:
        "../scripts/carry_sweep.py"


rule continue_orbits:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweeps=expand(
            "results/{{root}}{{case}}/sweeps/{order}/{{sweep}}.nc",
            order=("restart", "up", "down"),
        ),
    output:
        "results/{root}{case}/branches/{sweep}.nc",
    log:
        "results/logs/{root}{case}/continue_orbits/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/continue_orbits/{sweep}.tsv"
    params:
        cfg=cfg("branches"),
        code=code("continue_orbits.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: following the periodic orbits along {wildcards.sweep}."
    script:
        "../scripts/continue_orbits.py"


rule trace_portraits:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/portraits/{sweep}.nc",
    log:
        "results/logs/{root}{case}/trace_portraits/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/trace_portraits/{sweep}.tsv"
    params:
        cfg=cfg("portraits"),
        code=code("trace_portraits.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: tracing the phase portraits of {wildcards.sweep}."
    script:
        "../scripts/trace_portraits.py"


rule map_basins:
    input:
        excitation="results/{root}{case}/excitation.nc",
    output:
        "results/{root}{case}/basins/{sweep}.nc",
    log:
        "results/logs/{root}{case}/map_basins/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/map_basins/{sweep}.tsv"
    params:
        cfg=cfg("basins"),
        code=code("map_basins.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: mapping the basins of attraction over {wildcards.sweep}."
    script:
        "../scripts/map_basins.py"

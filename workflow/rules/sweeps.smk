rule sweep_part:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=final("mesh_stiffness"),
        transmission_error=final("transmission_error"),
        backlash=final("backlash"),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{case}/sweeps/parts/{sweep}/{scatteritem}.nc",
    log:
        "results/logs/{case}/sweep_part/{sweep}/{scatteritem}.log",
    benchmark:
        "results/benchmarks/{case}/sweep_part/{sweep}/{scatteritem}.tsv"
    params:
        cfg=cfg("sweep"),
        code=code("sweep_part.py"),
    message:
        "Case {wildcards.case}: sweeping {wildcards.sweep}, part {wildcards.scatteritem}."
    script:
        "../scripts/sweep_part.py"


rule join_sweep:
    input:
        parts=gather.sweep("results/{{case}}/sweeps/parts/{{sweep}}/{scatteritem}.nc"),
    output:
        "results/{case}/sweeps/restart/{sweep}.nc",
    log:
        "results/logs/{case}/join_sweep/{sweep}.log",
    benchmark:
        "results/benchmarks/{case}/join_sweep/{sweep}.tsv"
    params:
        cfg=cfg("sweep"),
        code=code("join_sweep.py"),
    message:
        "Case {wildcards.case}: joining the parts of the {wildcards.sweep} sweep."
    script:
        "../scripts/join_sweep.py"


rule carry_sweep:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=final("mesh_stiffness"),
        transmission_error=final("transmission_error"),
        backlash=final("backlash"),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{case}/sweeps/{order}/{sweep}.nc",
    log:
        "results/logs/{case}/carry_sweep/{order}/{sweep}.log",
    benchmark:
        "results/benchmarks/{case}/carry_sweep/{order}/{sweep}.tsv"
    wildcard_constraints:
        order="up|down",
    params:
        cfg=cfg("sweep"),
        code=code("carry_sweep.py"),
    message:
        "Case {wildcards.case}: sweeping {wildcards.sweep} {wildcards.order}, every point from the one before."
    script:
        "../scripts/carry_sweep.py"


rule continue_orbits:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=final("mesh_stiffness"),
        transmission_error=final("transmission_error"),
        backlash=final("backlash"),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
        sweeps=expand(
            "results/{{case}}/sweeps/{order}/{{sweep}}.nc",
            order=("restart", "up", "down"),
        ),
    output:
        "results/{case}/branches/{sweep}.nc",
    log:
        "results/logs/{case}/continue_orbits/{sweep}.log",
    benchmark:
        "results/benchmarks/{case}/continue_orbits/{sweep}.tsv"
    params:
        cfg=cfg("branches"),
        code=code("continue_orbits.py"),
    message:
        "Case {wildcards.case}: following the periodic orbits along {wildcards.sweep}."
    script:
        "../scripts/continue_orbits.py"


rule trace_portraits:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=final("mesh_stiffness"),
        transmission_error=final("transmission_error"),
        backlash=final("backlash"),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{case}/portraits/{sweep}.nc",
    log:
        "results/logs/{case}/trace_portraits/{sweep}.log",
    benchmark:
        "results/benchmarks/{case}/trace_portraits/{sweep}.tsv"
    params:
        cfg=cfg("portraits"),
        code=code("trace_portraits.py"),
    message:
        "Case {wildcards.case}: tracing the phase portraits of {wildcards.sweep}."
    script:
        "../scripts/trace_portraits.py"

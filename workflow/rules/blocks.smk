from gearwear.config.histories import blocks

WEAR_CYCLES = config["jobs"]["wear_cycles"]
UPDATES = {case: updates_of(config, case) for case in config["cases"]}
BLOCKS = blocks(UPDATES, WEAR_CYCLES) if WEAR_CYCLES > 1 else {}


def link_cfg(wildcards):
    """The settings that the stages of a link see, by what they make."""
    stages = ("mesh_stiffness", "transmission_error", "backlash", "response")
    return {
        "wear": cfg("advance_wear")(wildcards),
        **{stage: cfg(stage)(wildcards) for stage in stages},
    }


def made(stage, first, last):
    """The files of a stage from one wear cycle to another."""
    return [f"results/{{case}}/{stage}/q{q:03d}.nc" for q in range(first, last + 1)]


for (one, end), cases in BLOCKS.items():

    rule:
        name:
            f"run_block_{one:03d}_{end:03d}"
        input:
            geometry="results/geometry.nc",
            deformation="results/{case}/deformation.nc",
            wear=f"results/{{case}}/wear/q{one - 1:03d}.nc",
            mesh_stiffness=f"results/{{case}}/mesh_stiffness/q{one - 1:03d}.nc",
            transmission_error=f"results/{{case}}/transmission_error/q{one - 1:03d}.nc",
            response=f"results/{{case}}/response/q{one - 1:03d}.nc",
            reference_stiffness=reference("mesh_stiffness"),
            reference_error=reference("transmission_error"),
        output:
            wear=made("wear", one, end),
            mesh_stiffness=made("mesh_stiffness", one, end),
            transmission_error=made("transmission_error", one, end),
            backlash=made("backlash", one, end),
            response=made("response", one, end),
        log:
            f"results/logs/{{case}}/run_block/q{one:03d}-q{end:03d}.log",
        benchmark:
            f"results/benchmarks/{{case}}/run_block/q{one:03d}-q{end:03d}.tsv"
        wildcard_constraints:
            case="|".join(cases),
        priority: 10
        resources:
            runtime=1 + (end - one) // 20,
            mem_mb=1000,
        params:
            cfg=link_cfg,
            code=code("run_block.py"),
        message:
            f"Case {{wildcards.case}}, cycles {one} to {end}: wearing the flanks and finding mesh and response."
        script:
            "../scripts/run_block.py"

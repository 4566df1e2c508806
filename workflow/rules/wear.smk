"""The wear history: geometry, temperature, growth, and three rules a wear cycle, each a link of the chain."""

from gearwear.chain.cycle import CYCLE
from gearwear.run.stages import arguments_of

UPDATES = {case: updates_of(config, case) for case in config["cases"]}
BLOCKS = blocks(UPDATES, config["jobs"]["wear_cycles"])


rule geometry:
    output:
        "results/{root}geometry.nc",
    log:
        "results/logs/{root}geometry.log",
    benchmark:
        "results/benchmarks/{root}geometry.tsv"
    priority: 20
    params:
        cfg=cfg("geometry"),
        code=code("geometry"),
    message:
        "Building the gear pair and its path of contact: results/{wildcards.root}geometry.nc."
    script:
        "../scripts/stage.py"


rule temperature:
    input:
        geometry="results/{root}geometry.nc",
    output:
        "results/{root}{case}/temperature.nc",
    log:
        "results/logs/{root}{case}/temperature.log",
    benchmark:
        "results/benchmarks/{root}{case}/temperature.tsv"
    priority: 20
    params:
        cfg=cfg("temperature"),
        code=code("temperature"),
    message:
        "Case {wildcards.root}{wildcards.case}: computing the contact temperature."
    script:
        "../scripts/stage.py"


rule deformation:
    input:
        geometry="results/{root}geometry.nc",
        temperature=lambda wildcards: (
            "results/{root}{case}/temperature.nc"
            if member(wildcards.root)["heat"]["temperature_rise"] == "contact"
            else []
        ),
    output:
        "results/{root}{case}/deformation.nc",
    log:
        "results/logs/{root}{case}/deformation.log",
    benchmark:
        "results/benchmarks/{root}{case}/deformation.tsv"
    priority: 20
    params:
        cfg=cfg("deformation"),
        code=code("deformation"),
    message:
        "Case {wildcards.root}{wildcards.case}: computing the thermal growth of the flanks."
    script:
        "../scripts/stage.py"


rule flash_growth:
    input:
        geometry="results/{root}geometry.nc",
        temperature="results/{root}{case}/temperature.nc",
    output:
        "results/{root}{case}/flash_growth.nc",
    log:
        "results/logs/{root}{case}/flash_growth.log",
    benchmark:
        "results/benchmarks/{root}{case}/flash_growth.tsv"
    params:
        cfg=cfg("deformation"),
        code=code("flash_growth"),
    message:
        "Case {wildcards.root}{wildcards.case}: computing what the flash temperature would add to the growth."
    script:
        "../scripts/stage.py"


rule unworn:
    input:
        geometry="results/{root}geometry.nc",
    output:
        "results/{root}{case}/wear/q000.nc",
    log:
        "results/logs/{root}{case}/unworn.log",
    benchmark:
        "results/benchmarks/{root}{case}/unworn.tsv"
    priority: 20
    params:
        cfg=cfg("unworn"),
        code=code("unworn"),
    message:
        "Case {wildcards.root}{wildcards.case}: starting from unworn flanks."
    script:
        "../scripts/stage.py"


def input_of(name, cycle="{q}", root="{root}"):
    """The file, or the function that gives it, of an input of a stage of the cycle."""
    fixed = {
        "geometry": f"results/{root}geometry.nc",
        "deformation": f"results/{root}{{case}}/deformation.nc",
        "reference_stiffness": reference("mesh_stiffness"),
        "reference_error": reference("transmission_error"),
    }
    return fixed.get(name, f"results/{root}{{case}}/{name}/q{cycle}.nc")


def earlier(name):
    """Input function: an input of a stage, those of the state from one wear cycle before."""
    if not isinstance(input_of(name), str) or "{q}" not in input_of(name):
        return input_of(name)
    return lambda wildcards: input_of(name, f"{int(wildcards.q) - 1:03d}").format(
        **dict(wildcards.items())
    )


MESSAGES = {
    "wear": "wearing the flanks under the mesh force of the cycle before",
    "mesh_excitation": "computing mesh stiffness, transmission error and backlash",
    "response": "solving the dynamic response at the running speed",
}
# Where blocks make the chain, single links make members and what is unworn.
LINKED = f"({MEMBER})?" if not BLOCKS else f"{MEMBER}|(?=[^/]+/[^/]+/q000)"

for name, made in CYCLE.items():
    inputs = [one for one in arguments_of(name) if one != "cfg"]

    rule:
        name:
            name
        input:
            **{one: (earlier if name == "wear" else input_of)(one) for one in inputs},
        output:
            **{one: f"results/{{root}}{{case}}/{one}/q{{q}}.nc" for one in made},
        log:
            f"results/logs/{{root}}{{case}}/{name}/q{{q}}.log",
        benchmark:
            f"results/benchmarks/{{root}}{{case}}/{name}/q{{q}}.tsv"
        wildcard_constraints:
            root=LINKED,
            q=r"(?!000)\d{3}" if name == "wear" else r"\d{3}",
        priority: 10
        params:
            cfg=cfg(name),
            code=code(name),
        message:
            f"Case {{wildcards.root}}{{wildcards.case}}, cycle {{wildcards.q}}: {MESSAGES[name]}."
        script:
            "../scripts/stage.py"


for (first, end), worn in BLOCKS.items():

    rule:
        name:
            f"wear_block_{first:03d}_{end:03d}"
        input:
            **{
                one: input_of(one, f"{first - 1:03d}", root="")
                for one in dict.fromkeys(
                    name for link in CYCLE for name in arguments_of(link)
                )
                if one not in ("cfg", "backlash")
            },
        output:
            **{
                one: [
                    f"results/{{case}}/{one}/q{q:03d}.nc"
                    for q in range(first, end + 1)
                ]
                for made in CYCLE.values()
                for one in made
            },
        log:
            f"results/logs/{{case}}/wear_block/q{first:03d}_q{end:03d}.log",
        benchmark:
            f"results/benchmarks/{{case}}/wear_block/q{first:03d}_q{end:03d}.tsv"
        wildcard_constraints:
            case="|".join(worn),
        priority: 10
        params:
            cfg=lambda wildcards: {link: cfg(link)(wildcards) for link in CYCLE},
            code=code(*CYCLE),
        message:
            f"Case {{wildcards.case}}: wear cycles {first} to {end} in one job."
        script:
            "../scripts/wear_block.py"


def chain_files(stage, first=0, behind=0):
    """The files of a stage over the wear cycles of every case, from `first` to the last but `behind`."""
    return [
        f"results/{case}/{stage}/q{q}.nc"
        for case in config["cases"]
        for q in cycles(case, first=first)[: -behind or None]
    ]


def states():
    """The dynamic response of every case at every wear cycle; a prescribed oscillator has none."""
    return [] if config["oscillators"] else chain_files("response")

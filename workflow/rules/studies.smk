from gearwear.config.grids import combinations
from gearwear.config.members import overrides_of
from gearwear.config.declared import declared_at


def combined(study):
    """Every member of a study: its name, its folder, and why it cannot be, empty if it can."""
    declared = config["studies"][study]
    if not declared["grid"]:
        found = [(name, "") for name in declared["members"]]
    else:
        found = [
            (
                one.name,
                refused(
                    f"studies/{study}/{one.name}/", overrides_of(declared, one.values)
                ),
            )
            for one in combinations(declared["grid"])
        ]
    return [
        {"name": name, "root": f"studies/{study}/{name}/", "hindrance": reason}
        for name, reason in found
    ]


def chains_wanted():
    """Configuration and case of every wear chain that the members of studies share."""
    case = config["maps"]["case"]
    for value in config["maps"]["temperature"]:
        yield MEMBERS[temperature_root(value)], case
    for study, declared in config["studies"].items():
        for one in combined(study):
            if not one["hindrance"]:
                yield MEMBERS[one["root"]], declared["case"]


CHAINS = chains(chains_wanted())


def case_of_study(root):
    """The case that a study is about, by the folder of a member."""
    return config["studies"][Path(root).parts[1]]["case"]


def units_of(study):
    """The units of the keys of the grid of a study."""
    return {key: declared_at(key).unit for key in config["studies"][study]["grid"]}


def study_cfg(wildcards):
    """The settings that gathering a study sees."""
    declared = config["studies"][wildcards.study]
    members = [
        {key: one[key] for key in ("name", "hindrance")}
        for one in combined(wildcards.study)
    ]
    return cfg("study")(wildcards) | {
        "study": declared,
        "members": members,
        "units": units_of(wildcards.study),
    }


def study_files(study):
    """What is made of a study."""
    files = expand(
        "results/studies/{study}/{file}",
        study=study,
        file=("study.nc", "table.csv", "lives.csv"),
    )
    return [*files, f"results/figures/study_{study}.svg"]


rule run_chain:
    output:
        "results/studies/chains/{chain}.nc",
    log:
        "results/logs/studies/chains/{chain}.log",
    benchmark:
        "results/benchmarks/studies/chains/{chain}.tsv"
    wildcard_constraints:
        chain=r"\w+",
    params:
        cfg=lambda wildcards: CHAINS[wildcards.chain],
        code=code("run_chain.py"),
    message:
        "Wearing the pair cycle by cycle in one process: {output}."
    script:
        "../scripts/run_chain.py"


rule measure_outcome:
    input:
        chain=lambda wildcards: chain_file(
            member(wildcards.root), case_of_study(wildcards.root)
        ),
    output:
        "results/{root}outcome.nc",
    log:
        "results/logs/{root}measure_outcome.log",
    benchmark:
        "results/benchmarks/{root}measure_outcome.tsv"
    wildcard_constraints:
        root="studies/[a-z][a-z0-9_]*/[a-z][a-z0-9_]*/",
    params:
        cfg=lambda wildcards: {
            "outcome": cfg("outcome")(wildcards),
            "update": updates_of(
                member(wildcards.root), case_of_study(wildcards.root)
            ),
        },
        code=code("measure_outcome.py"),
    message:
        "Measuring the motions over the speed: results/{wildcards.root}outcome.nc."
    script:
        "../scripts/measure_outcome.py"


rule gather_study:
    input:
        outcomes=lambda wildcards: [
            f"results/{one['root']}outcome.nc"
            for one in combined(wildcards.study)
            if not one["hindrance"]
        ],
    output:
        data="results/studies/{study}/study.nc",
        table="results/studies/{study}/table.csv",
        lives=report(
            "results/studies/{study}/lives.csv",
            caption=caption("lives"),
            category="Studies",
            labels={"table": "{study}: safe speeds"},
        ),
    log:
        "results/logs/studies/{study}/gather_study.log",
    benchmark:
        "results/benchmarks/studies/{study}/gather_study.tsv"
    params:
        cfg=study_cfg,
        code=code("gather_study.py"),
    message:
        "Gathering the members of study {wildcards.study}."
    script:
        "../scripts/gather_study.py"

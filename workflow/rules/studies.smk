"""Studies: every combination of some values of some keys is a member; the sensitivity is one of them."""

from gearwear.config import variations
from gearwear.config.members import combinations, overrides_of
from gearwear.config.study import declared_at


def refused(root, overrides):
    """Why a member is none of the members, empty if it is one."""
    return "" if root in MEMBERS else refusal(config, overrides)


def combined(study):
    """Every member of a study: its name, its folder, and why it is not feasible, empty if it is."""
    declared = config["studies"][study]
    found = {name: "" for name in declared["members"]}
    if declared["grid"]:
        found = {
            one.name: refused(
                f"studies/{study}/{one.name}/", overrides_of(declared, one.values)
            )
            for one in combinations(declared["grid"])
        }
    return [
        {"name": name, "root": f"studies/{study}/{name}/", "reason": reason}
        for name, reason in found.items()
    ]


def histories_wanted():
    """Configuration and case of every wear history that the members of studies share."""
    case = config["maps"]["case"]
    for value in config["maps"]["temperature"]:
        yield MEMBERS[temperature_root(value)], case
    for study, declared in config["studies"].items():
        for one in combined(study):
            if not one["reason"]:
                yield MEMBERS[one["root"]], declared["case"]


HISTORIES = histories(histories_wanted())


def case_of_study(root):
    """The case that a study is about, by the folder of a member."""
    return config["studies"][Path(root).parts[1]]["case"]


def units_of(study):
    """The units of the keys of the grid of a study."""
    return {key: declared_at(key).unit for key in config["studies"][study]["grid"]}


def study_cfg(wildcards):
    """The settings of the stage that collects a study."""
    declared = config["studies"][wildcards.study]
    return cfg("study")(wildcards) | {
        "study": declared,
        "members": [
            {key: one[key] for key in ("name", "reason")}
            for one in combined(wildcards.study)
        ],
        "units": units_of(wildcards.study),
        "meanings": {key: declared_at(key).meaning for key in declared["grid"]},
    }


def study_files(study):
    """What is made of a study."""
    files = ("study.nc", "table.csv", "lives.csv")
    return [
        *(f"results/studies/{study}/{file}" for file in files),
        f"results/figures/study_{study}.svg",
    ]


VARIED = [
    {name: value for name, value in one._asdict().items() if name != "overrides"}
    | {"hindrance": refused(f"studies/{variations.STUDY}/{one.name}/", one.overrides)}
    for one in variations.variations(config)
]


rule wear_history:
    output:
        "results/studies/chains/{history}.nc",
    log:
        "results/logs/studies/chains/{history}.log",
    benchmark:
        "results/benchmarks/studies/chains/{history}.tsv"
    wildcard_constraints:
        history=r"\w+",
    params:
        cfg=lambda wildcards: HISTORIES[wildcards.history],
        code=code("wear_history"),
    message:
        "Wearing the pair cycle by cycle in one process: {output}."
    script:
        "../scripts/stage.py"


rule outcome:
    input:
        history=lambda wildcards: history_file(
            member(wildcards.root), case_of_study(wildcards.root)
        ),
    output:
        "results/{root}outcome.nc",
    log:
        "results/logs/{root}outcome.log",
    benchmark:
        "results/benchmarks/{root}outcome.tsv"
    wildcard_constraints:
        root=MEMBER,
    params:
        cfg=lambda wildcards: {
            "settings": cfg("outcome")(wildcards),
            "update": updates_of(
                member(wildcards.root), case_of_study(wildcards.root)
            ),
            "member": wildcards.root,
        },
        code=code("outcome"),
    message:
        "Measuring the motions over the speed: results/{wildcards.root}outcome.nc."
    script:
        "../scripts/stage.py"


rule study:
    input:
        outcomes=lambda wildcards: [
            f"results/{one['root']}outcome.nc"
            for one in combined(wildcards.study)
            if not one["reason"]
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
        "results/logs/studies/{study}/study.log",
    benchmark:
        "results/benchmarks/studies/{study}/study.tsv"
    params:
        cfg=study_cfg,
        code=code("study"),
    message:
        "Collecting the members of study {wildcards.study}."
    script:
        "../scripts/stage.py"


rule measures:
    output:
        "results/{root}measures.nc",
    log:
        "results/logs/{root}measures.log",
    benchmark:
        "results/benchmarks/{root}measures.tsv"
    params:
        cfg=cfg("measures"),
        code=code("measures"),
    message:
        "Measuring the mesh, the wear and the route to chaos: results/{wildcards.root}measures.nc."
    script:
        "../scripts/stage.py"


rule sensitivity_comparison:
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
        "results/logs/sensitivity_comparison.log",
    benchmark:
        "results/benchmarks/sensitivity_comparison.tsv"
    params:
        cfg=lambda wildcards: cfg("sensitivity_comparison")(wildcards)
        | {"varied": VARIED},
        code=code("sensitivity_comparison"),
    message:
        "Comparing what every option and every open parameter changes."
    script:
        "../scripts/stage.py"

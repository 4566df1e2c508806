import os
from os.path import relpath

from snakemake.exceptions import WorkflowError

from gearwear.config import check as settings
from gearwear.config.histories import (
    blocks,
    histories,
    history_of,
    updates_of,
)
from gearwear.config.parameters import SWEEPS
from gearwear.config.members import members, refusal, temperature_root
from gearwear.config.slices import slice_of
from gearwear.heat.bulk import resolved
from gearwear.run import digest, lock, orphans, stage, stages, token

DIRECTIONS = ("restart", "up", "down")
MEMBER = "studies/[a-z][a-z0-9_]*/[a-z][a-z0-9_]*/"

orphans.mark()
try:
    config = settings.check(config)
    MEMBERS = {root: resolved(one) for root, one in members(config).items()}
    config = MEMBERS[""]
    # Before any job is planned: a plan made while another run is at work would be out of date when it ends.
    # A job that an executor starts comes by here as well, perhaps on another machine.
    PLAN = token.plan_of(config, ROOT / "workflow", digest.source_key())
    if workflow.is_main_process:
        token.give(PLAN, "" if lock.only_looks(sys.argv[1:]) else lock.hold())
    else:
        token.check_plan(PLAN)
except (
    settings.ConfigError,
    lock.RunningAlready,
    lock.NoLocks,
    token.Outdated,
) as error:
    raise WorkflowError(str(error))
os.environ[stage.SOURCES] = digest.source_key()

MEMORY = digest.memory(dict(os.environ))
CODE = digest.digests(map(stages.target_of, stages.MODULES), MEMORY / "stages")
# Sweeps from rest are cut into parts where --set-scatter asks for it, as for a cluster.
PARTS = workflow.resource_settings.overwrite_scatter.get("sweep", 1)


envvars:
    token.VARIABLE,


def one_of(*sections):
    """The constraint of a wildcard to the names in sections of the configuration and its members."""
    names = [
        name
        for section in sections
        for member in MEMBERS.values()
        for name in member[section]
    ]
    return "|".join(dict.fromkeys(names)) or "(?!)"


wildcard_constraints:
    study="[a-z][a-z0-9_]*",
    root=f"({MEMBER})?",
    case=one_of("cases", "oscillators"),
    q=r"\d{3}",
    sweep="|".join(SWEEPS),
    map="ste|backlash|temperature|wear",


scattergather:
    sweep=1,
    map=16,


def own(*parts):
    """A file of the program, from the working directory: where both are moved, results stay up to date."""
    return relpath(ROOT.joinpath(*parts))


CONFIGURATION_FILES = list(
    dict.fromkeys(
        map(relpath, (ROOT / "config/config.yaml", *workflow.overwrite_configfiles))
    )
)
CLAIMS = own("config", "paper_claims.yaml")
STYLE = own("workflow", "report", "gearwear.mplstyle")
TABLE = own("workflow", "report", "table.html.j2")


def caption(name):
    """The caption of a result in the report."""
    return str(ROOT / "workflow" / "report" / f"{name}.rst")


def code(*names):
    """The digests of the code of stages, by their names."""
    return {name: CODE[stages.target_of(name)] for name in names}


def member(root):
    """The configuration of a member of a study, by its folder; "" is the study itself."""
    if root not in MEMBERS:
        study = Path(root).parts[1]
        known = [
            Path(name).parts[2]
            for name in MEMBERS
            if name.startswith(f"studies/{study}/")
        ]
        raise WorkflowError(
            f"{Path(root)}: no such member; members of study {study}: {', '.join(known) or 'none'}"
        )
    return MEMBERS[root]


def cfg(stage):
    """The settings that a stage reads: one plain dict, a function of the wildcards."""

    def cut(wildcards):
        case, sweep = wildcards.get("case", ""), wildcards.get("sweep", "")
        try:
            return slice_of(member(wildcards.get("root", "")), stage, case, sweep)
        except KeyError as error:
            raise WorkflowError(
                f"config: {stage} finds no {error} for case {case}; see docs/"
            ) from None
        except settings.ConfigError as error:
            raise WorkflowError(str(error)) from None

    return cut


def last(case, root=""):
    """The number of the last wear cycle of a case, as its files write it."""
    return f"{updates_of(member(root), case):03d}"


def cycles(case, root="", first=0):
    """The numbers of the wear cycles of a case, as its files write them."""
    return [f"{q:03d}" for q in range(first, int(last(case, root)) + 1)]


def every(stage):
    """Input function: the files of a stage at every wear cycle of the case."""

    def files(wildcards):
        root, case = wildcards.root, wildcards.case
        return [f"results/{root}{case}/{stage}/q{q}.nc" for q in cycles(case, root)]

    return files


def final(stage):
    """Input function: the file of a stage at the last wear cycle of the case."""
    return lambda wildcards: every(stage)(wildcards)[-1]


def reference(stage):
    """Input function: the file of a stage of the pristine reference case."""

    def pristine(wildcards):
        root = wildcards.get("root", "")
        case = member(root)["dynamics"]["reference_case"]
        return f"results/{root}{case}/{stage}/q000.nc"

    return pristine


def history_file(settings, case):
    """The wear history of a case of a member, which members with the same settings behind it share."""
    return f"results/studies/chains/{history_of(settings, case)}.nc"


def studied():
    """The prescribed oscillators, or else the cases of the gear pair."""
    return config["oscillators"] or config["cases"]


def swept_cases():
    """Case and sweep of every sweep of the configuration."""
    return [
        (case, sweep)
        for sweep in SWEEPS
        for case in config["sweeps"][sweep]["cases"]
        if case in studied()
    ]


def swept_in(sweep):
    """The cases of one sweep."""
    return [case for case, name in swept_cases() if name == sweep]


def main_sweeps(stage="sweeps"):
    """Every sweep in the direction that the claims judge."""
    order = config["sweeps"]["order"]
    return [
        f"results/{case}/{stage}/{order}/{sweep}.nc" for case, sweep in swept_cases()
    ]


def listed(values_of, drawn=()):
    """Case and sweep of the studied cases that a section lists values for, but those already drawn."""
    return [
        (case, sweep)
        for sweep, cases in values_of.items()
        for case, values in cases.items()
        if values and case in studied() and (sweep, case) not in drawn
    ]


def drawn_state(case):
    """Name, temperature and cycles of a case: plain values for legends. A prescribed oscillator has its name."""
    if case in config["oscillators"]:
        return {"case": case}
    return {"case": case, "cycle": int(last(case)), **config["cases"][case]}


def drawn_states():
    """The states of figures 6 to 11."""
    return [drawn_state(case) for case in config["figures"]["diagonal"]]


def swept(sweep):
    """What a figure says of its sweep: the section of the sweep without what decides files only."""
    return {
        key: value
        for key, value in config["sweeps"][sweep].items()
        if key not in ("cases", "points")
    }

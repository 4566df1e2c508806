from os.path import relpath

from snakemake.exceptions import WorkflowError

from gearwear.config import check as settings
from gearwear.run import token as orders
from gearwear.config.histories import chain_of, chains, updates_of
from gearwear.heat.bulk import resolved
from gearwear.run.digest import digest
from gearwear.config.members import hindrance, members, temperature_root
from gearwear.run.orphans import mark
from gearwear.run.lock import NoLocks, RunningAlready, hold, only_looks
from gearwear.config.slices import slice_of

# The wear chain is one path of five jobs a cycle; Snakemake walks it recursively.
sys.setrecursionlimit(20000)
mark()

try:
    config = settings.check(config)
    MEMBERS = {root: resolved(one) for root, one in members(config).items()}
    config = MEMBERS[""]
except settings.ConfigError as error:
    raise WorkflowError(str(error))


# Before any job is planned: a plan made while another run is at work would be out of date when it ends.
# A job that an executor starts comes by here as well, perhaps on another machine.
try:
    PLAN = orders.plan_of(config, Path(workflow.basedir) / "workflow")
    if not workflow.is_main_process:
        orders.check_plan(PLAN)
    else:
        orders.give(PLAN, "" if only_looks(sys.argv[1:]) else hold())
except (RunningAlready, NoLocks, orders.Outdated) as error:
    raise WorkflowError(str(error))


envvars:
    orders.VARIABLE,


def one_of(*sections):
    """The constraint of a wildcard to the names in sections of the configuration and its members."""
    names = [
        name
        for section in sections
        for member in MEMBERS.values()
        for name in member[section]
    ]
    return "|".join(dict.fromkeys(names)) or "(?!)"


MEMBER = "studies/[a-z][a-z0-9_]*/[a-z][a-z0-9_]*/"
# The folders in which single links make the chain: where blocks make it, members, and what is unworn.
LINKED = (
    f"({MEMBER})?"
    if config["jobs"]["wear_cycles"] == 1
    else f"{MEMBER}|(?=[^/]+/[^/]+/q000)"
)


wildcard_constraints:
    study="[a-z][a-z0-9_]*",
    root=f"({MEMBER})?",
    case=one_of("cases", "oscillators"),
    q=r"\d{3}",
    sweep="mesh_frequency|ste|backlash",
    map="ste|backlash|temperature|wear",


scattergather:
    sweep=4,
    map=16,


def own(*parts):
    """A file of the program, from the working directory: where both are moved, results stay up to date."""
    return relpath(Path(workflow.basedir).joinpath(*parts))


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


def refused(root, overrides):
    """Why a member is none of the members, empty if it is one."""
    return "" if root in MEMBERS else hindrance(config, overrides)


def cfg(stage):
    """The settings a stage sees: one plain dict, a function of the wildcards."""

    def cut(wildcards):
        case, sweep = wildcards.get("case", ""), wildcards.get("sweep", "")
        try:
            return slice_of(member(wildcards.get("root", "")), stage, case, sweep)
        except KeyError as error:
            raise WorkflowError(
                f"config: {stage} finds no {error} for case {case}; see config/README.md"
            ) from None
        except settings.ConfigError as error:
            raise WorkflowError(str(error)) from None

    return cut


def code(script):
    """The digest of everything a stage script can run."""
    path = Path(workflow.basedir) / "workflow" / "scripts" / script
    # All at the start of the run; a job that an executor starts needs its own only.
    return digest(path) if workflow.is_main_process else lambda wildcards: digest(path)


def last(case, root=""):
    """The number of the last wear cycle of a case, as its files write it."""
    return f"{updates_of(member(root), case):03d}"


def chain_file(settings, case):
    """The wear chain of a case of a member, which members with the same settings behind it share."""
    return f"results/studies/chains/{chain_of(settings, case)}.nc"


def earlier(pattern):
    """Input function: the file of `pattern` one wear cycle before."""

    def one_before(wildcards):
        q = f"{int(wildcards.q) - 1:03d}"
        return pattern.format(root=wildcards.root, case=wildcards.case, q=q)

    return one_before


def final(stage):
    """Input function: the file of a stage at the last wear cycle of the case."""

    def at_the_end(wildcards):
        root, case = wildcards.root, wildcards.case
        return f"results/{root}{case}/{stage}/q{last(case, root)}.nc"

    return at_the_end


def reference(stage):
    """Input function: the file of a stage of the pristine reference case."""

    def pristine(wildcards):
        root = wildcards.get("root", "")
        case = member(root)["dynamics"]["reference_case"]
        return f"results/{root}{case}/{stage}/q000.nc"

    return pristine


def studied():
    """The given oscillators, or else the cases of the gear pair."""
    return config["oscillators"] or config["cases"]


def states():
    """The dynamic response of every case at every wear cycle; a given oscillator has none."""
    return [
        f"results/{case}/response/q{q:03d}.nc"
        for case in studied()
        if case in config["cases"]
        for q in range(int(last(case)) + 1)
    ]


def swept_cases():
    """Case and sweep of every sweep of the configuration."""
    return [
        (case, sweep)
        for sweep in ("mesh_frequency", "ste", "backlash")
        for case in config["sweeps"][sweep]["cases"]
        if case in studied()
    ]


def swept_in(sweep):
    """The cases of one sweep."""
    return [case for case, name in swept_cases() if name == sweep]

from snakemake.exceptions import WorkflowError

from gearwear.plumbing import settings
from gearwear.plumbing.closure import digest
from gearwear.plumbing.runlock import RunningAlready, hold, only_looks
from gearwear.plumbing.slices import slice_of

# The wear chain is one path of five jobs a cycle; Snakemake walks it recursively.
sys.setrecursionlimit(20000)

try:
    config = settings.check(config)
except settings.ConfigError as error:
    raise WorkflowError(str(error))


# Before any job is planned: a plan made while another run is at work would be out of date when it ends.
if workflow.is_main_process and not only_looks(sys.argv[1:]):
    try:
        hold()
    except RunningAlready as error:
        raise WorkflowError(str(error))


wildcard_constraints:
    case="|".join(config["cases"]),
    q=r"\d{3}",
    sweep="mesh_frequency|ste|backlash",


scattergather:
    sweep=4,


def cfg(stage):
    """The settings a stage sees: one plain dict, a function of the wildcards."""

    def cut(wildcards):
        case, sweep = wildcards.get("case", ""), wildcards.get("sweep", "")
        try:
            return slice_of(config, stage, case, sweep)
        except KeyError as error:
            raise WorkflowError(
                f"config: {stage} finds no {error} for case {case}; see config/README.md"
            ) from None

    return cut


def code(script):
    """The digest of everything a stage script can run."""
    return digest(Path(workflow.basedir) / "workflow" / "scripts" / script)


def last(case):
    """The number of the last wear cycle of a case, as its files write it."""
    return f"{round(config['cases'][case]['running_cycles'] / config['wear']['cycles_per_update']):03d}"


def earlier(pattern):
    """Input function: the file of `pattern` one wear cycle before."""

    def one_before(wildcards):
        return pattern.format(case=wildcards.case, q=f"{int(wildcards.q) - 1:03d}")

    return one_before


def final(stage):
    """Input function: the file of a stage at the last wear cycle of the case."""

    def at_the_end(wildcards):
        return f"results/{wildcards.case}/{stage}/q{last(wildcards.case)}.nc"

    return at_the_end


def reference(stage):
    """The file of a stage of the pristine reference case."""
    return f"results/{config['dynamics']['reference_case']}/{stage}/q000.nc"


def states():
    """The dynamic response of every case at every wear cycle."""
    return [
        f"results/{case}/response/q{q:03d}.nc"
        for case in config["cases"]
        for q in range(int(last(case)) + 1)
    ]


def swept_cases():
    """Case and sweep of every sweep of the configuration."""
    return [
        (case, sweep)
        for sweep in ("mesh_frequency", "ste", "backlash")
        for case in config["sweeps"][sweep]["cases"]
    ]

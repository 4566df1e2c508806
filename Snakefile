"""Nonlinear dynamics of a spur gear pair with tooth contact temperature and dynamic wear."""

import gc
import os
import sys
from pathlib import Path

from snakemake.utils import min_version

min_version("9.0")

# A plan is many small objects that live as long as the process: looking for garbage takes a sixth of its time.
gc.set_threshold(100_000)

from gearwear.run import help as targets

HERE = Path(workflow.current_basedir.get_path_or_uri(secret_free=True))

# Before anything is read or locked: help works beside a run and with a wrong configuration.
if workflow.is_main_process and targets.asked(sys.argv[1:], "help"):
    print(targets.page(HERE / "Snakefile"))
    sys.exit()

# Another configuration in a folder of its own, so that it works beside any other run.
if workflow.is_main_process and targets.asked(sys.argv[1:], "smoke"):
    words = ["all" if word == "smoke" else word for word in sys.argv[1:]]
    own = ["--snakefile", HERE / "Snakefile", "--directory", "smoke"]
    own += ["--configfile", HERE / "config/config.yaml", HERE / "config/smoke.yaml"]
    os.execv(sys.executable, [sys.executable, "-m", "snakemake", *words, *own])


configfile: HERE / "config" / "config.yaml"
configfile: HERE / "config" / "studies" / "life.yaml"


report: "workflow/report/report.rst"


include: "workflow/rules/common.smk"
include: "workflow/rules/wear.smk"
include: "workflow/rules/motion.smk"
include: "workflow/rules/evaluation.smk"
include: "workflow/rules/studies.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/maps.smk"
include: "workflow/rules/onsets.smk"
include: "workflow/rules/validation.smk"
include: "workflow/rules/calibration.smk"


rule all:
    """The study: every case at every wear cycle, the sweeps, figures 6 to 18 and more, the claims of the paper.
    Cost: 427 jobs, 14 minutes of one core."""
    default_target: True
    input:
        states(),
        expand(
            "results/{case}/flash_growth.nc",
            case=[] if config["oscillators"] else config["cases"],
        ),
        figures(),
        portrait_figures(),
        extra_figures(),
        basin_figures(),
        scorecard(),
        "results/parameters.html",
        "results/versions.html",
        warned(),


rule maps:
    """Maps of class and exponent over the mesh frequency and transmission error, backlash, bulk temperature or wear.
    Cost: with all there, 11 minutes of one core.
    """
    input:
        mapped(),


rule onsets:
    """How much earlier period doublings and chaos come in case with than in case without, with error and spread.
    Cost: with all there, 22 jobs, 12 minutes of one core."""
    input:
        "results/onsets.csv",
        "results/figures/onsets.svg",


rule life:
    """How fast the pair may run, how long and how hot: classes of motion, contact and force over the speed.
    Cost: 65 jobs, 12 minutes of one core; needs nothing else."""
    input:
        study_files("life"),


rule studies:
    """Every study that the configuration declares: all combinations of some values of some keys.
    Cost: that of life, and of your own."""
    input:
        [study_files(study) for study in config["studies"]],


rule sensitivity:
    """What every option of the model and every open parameter changes, one at a time.
    Cost: 56 jobs, 11 minutes of one core; needs nothing else."""
    input:
        "results/sensitivity.csv",
        "results/figures/sensitivity.svg",


rule validation:
    """Holds the program against standards, other programs, closed forms and finer grids.
    Cost: 19 jobs, 1 minute of one core; needs nothing else."""
    input:
        "results/validation/validation.csv",
        "results/validation/validation.html",


rule calibrate:
    """Searches values of what the paper leaves open, for most claims.
    Cost: two searches of 1 100 candidates, 15 minutes of a core each; needs nothing else.
    """
    input:
        "results/calibration/parameters.csv",
        "results/calibration/claims.csv",
        "results/figures/calibration.svg",


rule handover:
    """The gears, k(t), e(t), b(t) and wear of every wear cycle for other programs, as netCDF and CSV with a dictionary.
    Cost: with all there, 12 jobs, half a minute of one core."""
    input:
        expand("results/{case}/handover/dictionary.csv", case=config["cases"]),


rule page:
    """One offline page to click through the sweeps: section, portrait, mesh force and spectrum at every point.
    Cost: with all there, 5 jobs, 1 minute of one core."""
    input:
        "results/page.html",


rule smoke:
    """The study with short wear histories, sweeps and grids, in the folder smoke beside any other run: a first look.
    Cost: 107 jobs, 3 minutes of one core."""
    localrule: True


rule help:
    """This list."""
    localrule: True


onsuccess:
    if workflow.is_main_process and Path("results/figures").is_dir():
        print("Figures:", Path("results/figures").resolve())

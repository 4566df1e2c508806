"""Nonlinear dynamics of a spur gear pair with tooth contact temperature and dynamic wear."""

import sys
from pathlib import Path

from snakemake.utils import min_version

min_version("9.0")

sys.path.insert(0, str(Path(workflow.basedir) / "workflow" / "scripts"))


configfile: Path(workflow.basedir) / "config" / "config.yaml"


report: "workflow/report/study.rst"


include: "workflow/rules/common.smk"
include: "workflow/rules/state.smk"
include: "workflow/rules/sweeps.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/extra_figures.smk"
include: "workflow/rules/warnings.smk"
include: "workflow/rules/maps.smk"
include: "workflow/rules/onsets.smk"
include: "workflow/rules/sensitivity.smk"
include: "workflow/rules/validation.smk"
include: "workflow/rules/calibration.smk"


rule all:
    default_target: True
    input:
        states(),
        figures(),
        extra_figures(),
        basin_figures(),
        "results/claims.csv",
        "results/claims.html",
        "results/parameters.html",
        "results/versions.html",
        "results/warnings.html",


rule maps:
    input:
        mapped(),


rule onsets:
    input:
        "results/onsets.csv",
        "results/figures/onsets.svg",


rule sensitivity:
    input:
        "results/sensitivity.csv",
        "results/figures/sensitivity.svg",


rule validation:
    input:
        "results/validation/validation.csv",
        "results/validation/validation.html",


rule calibrate:
    input:
        "results/calibration/parameters.csv",
        "results/calibration/claims.csv",
        "results/figures/calibration.svg",

"""The workflow as a module of a Snakefile elsewhere."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FIGURE = "results/figures/contact_temperature.svg"
CONFIGURED = f'configfile: "{ROOT}/config/config.yaml"\nconfigfile: "{ROOT}/config/smoke.yaml"\n'


def snakemake(folder, config, prefix, *arguments):
    """Run a Snakefile in a folder that imports every rule, and return what it printed."""
    lines = [f'    snakefile: "{ROOT}/workflow/Snakefile"']
    lines += ["    config: config"] * config
    lines += [f'    prefix: "{prefix}"'] * bool(prefix)
    module = "\n".join(["module gearwear:", *lines, "", "use rule * from gearwear as g_*", ""])
    (folder / "Snakefile").write_text(CONFIGURED * config + module)
    command = (sys.executable, "-m", "snakemake", *arguments)
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout + run.stderr


@pytest.mark.parametrize("prefix", ["", "gears"])
def test_a_snakefile_elsewhere_plans_a_figure_of_the_default_study(tmp_path, prefix):
    planned = snakemake(tmp_path, False, prefix, "-n", str(Path(prefix, FIGURE)))
    assert "g_geometry" in planned and "g_plot_contact_temperature" in planned


@pytest.mark.parametrize("prefix", ["", "gears"])
def test_a_snakefile_elsewhere_computes_a_figure_of_its_own_configuration(tmp_path, prefix):
    figure = Path(prefix, FIGURE)
    snakemake(tmp_path, True, prefix, "-j2", str(figure))
    assert (tmp_path / figure).stat().st_size > 10_000
    assert "to be done" in snakemake(tmp_path, True, prefix, "-n", str(figure))

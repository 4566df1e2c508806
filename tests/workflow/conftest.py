"""The rules as Snakemake reads them from the rule files."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
READER = """
import json, sys
from pathlib import Path
from snakemake.api import SnakemakeApi
from snakemake.settings.types import ConfigSettings, OutputSettings, ResourceSettings

with SnakemakeApi(OutputSettings(show_failed_logs=False)) as api:
    resources = ResourceSettings(cores=1)
    read = api.workflow(resources, ConfigSettings(), snakefile=Path(sys.argv[2]), workdir=Path.cwd())
    rules = {}
    for rule in read._workflow.rules:
        rules[rule.name] = {
            "log": list(map(str, rule.log)),
            "benchmark": rule.benchmark and str(rule.benchmark),
            "message": rule.message,
            "script": rule.script,
            "params": sorted(rule.params.keys()),
            "code": rule.params.get("code"),
            "draw": rule.params.get("draw"),
            "input": sorted(rule.input.keys()),
            "output": list(map(str, rule.output)),
            "wildcards": sorted(rule.wildcard_names),
            "captions": sorted({Path(str(one.flags["report"].caption)).name
                                for one in rule.output if "report" in one.flags}),
        }
    print(json.dumps(rules))
"""


@pytest.fixture(scope="session")
def rules(tmp_path_factory):
    """Every rule with its directives by name."""
    command = [sys.executable, "-c", READER, "-n", str(ROOT / "Snakefile")]
    read = subprocess.run(command, cwd=tmp_path_factory.mktemp("rules"), capture_output=True, text=True)
    assert read.returncode == 0, read.stderr
    return json.loads(read.stdout)

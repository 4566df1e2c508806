"""Habits that every rule and every script keeps."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
RULES = "\n".join(path.read_text() for path in sorted((ROOT / "workflow" / "rules").glob("*.smk")))
BLOCKS = dict(re.findall(r"^rule (\w+):\n(.*?)(?=^\S|\Z)", RULES, flags=re.MULTILINE | re.DOTALL))
# Rules made in a loop, one for every number in their name.
LOOPED = re.findall(
    r'^    rule:\n        name:\n            f"([a-z_]+)_{(.*?)(?=^\S|\Z)', RULES, re.MULTILINE | re.DOTALL
)
BLOCKS |= {name: body.replace("\n    ", "\n") for name, body in LOOPED}
SCRIPTS = sorted((ROOT / "workflow" / "scripts").glob("*.py"))


@pytest.mark.parametrize("name", BLOCKS)
def test_every_rule_has_log_benchmark_message_and_two_params(name):
    block = BLOCKS[name]
    for directive in ("log:", "benchmark:", "message:", "script:"):
        assert f"    {directive}" in block
    params = re.search(r"    params:\n((?:        .*\n)+)", block)[1]
    assert re.findall(r"^        (\w+)=", params, flags=re.MULTILINE) == ["cfg", "code"]
    script = re.search(r'"../scripts/(\w+\.py)"', block)[1]
    assert f'code=code("{script}")' in block


def test_rules_and_scripts_belong_together():
    named = set(re.findall(r'"../scripts/(\w+\.py)"', RULES))
    assert named == {path.name for path in SCRIPTS}


def test_no_rule_runs_python_or_touches_the_chain_by_other_means():
    for word in ("run:", "ruleorder", "checkpoint", "temp(", "protected(", "cache:"):
        assert not re.search(rf"^\s*{re.escape(word)}|\b{re.escape(word)}", RULES, flags=re.MULTILINE), word


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_scripts_are_thin_and_see_only_their_own_settings(path):
    text = path.read_text()
    tree = ast.parse(text)
    assert ast.get_docstring(tree)
    assert any(isinstance(node, ast.FunctionDef) and node.name == "main" for node in tree.body)
    assert "snakemake.config" not in text and "job.config" not in text
    assert "with stage.logged(snakemake, __file__):" in text


def test_every_figure_has_a_caption_and_is_explained():
    figures = re.findall(r'svg=report\(\s*"results/figures/([a-z]+(?:_[a-z]+)?)(\d*)', RULES)
    assert len(figures) > 18
    text = (ROOT / "docs" / "figures.md").read_text()
    numbers = {int(n) for listed in re.findall(r"\*\*Figs?\.? ([\d, ]+)", text) for n in re.findall(r"\d+", listed)}
    for name, number in figures:
        assert (ROOT / "workflow" / "report" / f"{name}{number}.rst").read_text()
        assert int(number) in numbers if number else f"**`{name}" in text, name

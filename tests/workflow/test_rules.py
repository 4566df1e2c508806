"""What every rule has, and that rules, stages and figures belong together."""

import re
from importlib import import_module
from inspect import signature
from pathlib import Path

from gearwear.run import stages
from gearwear.run.digest import digest

ROOT = Path(__file__).resolve().parents[2]
TARGETS = set(re.findall(r"^rule (\w+):", (ROOT / "workflow" / "Snakefile").read_text(), flags=re.MULTILINE))


def test_every_rule_with_results_has_log_benchmark_message_settings_and_code(rules):
    for name in rules.keys() - TARGETS:
        rule = rules[name]
        assert all(rule[directive] for directive in ("log", "benchmark", "message", "script", "code")), name
        assert {"cfg", "code"} <= set(rule["params"]) <= {"cfg", "code", "draw"}, name


def test_every_stage_is_a_rule_with_the_digest_of_its_code(rules):
    codes = {name: rule["code"] for name, rule in rules.items() if (rule["script"] or "").endswith("/stage.py")}
    assert {name: list(code) for name, code in codes.items()} == {stage: [stage] for stage in stages.MODULES}
    assert codes["unworn"]["unworn"] == digest(stages.target_of("unworn"))


def test_every_stage_takes_settings_inputs_and_wildcards_of_its_rule(rules):
    for stage in stages.MODULES:
        rule, parameters = rules[stage], set(signature(stages.function_of(stage)).parameters)
        assert set(rule["input"]) <= parameters, stage
        parts = ["part"] if "scatteritem" in rule["wildcards"] else []
        assert parameters <= {"cfg", *rule["input"], *rule["wildcards"], *parts}, stage


def test_every_figure_takes_settings_and_inputs_of_its_rule(rules):
    figures = {name: rule for name, rule in rules.items() if rule["draw"]}
    assert len(figures) > 18
    for name, rule in figures.items():
        module, function = rule["draw"].split(":")
        draw = getattr(import_module(f"gearwear.figures.{module}"), function)
        taken = [*rule["input"], "cfg"]
        taken.remove("style")
        signature(draw.draw).bind(None, **dict.fromkeys(taken))
        assert set(draw.variables) <= set(taken), name


def test_every_figure_has_a_caption_and_is_explained(rules):
    figures = {name.removeprefix("plot_"): rule for name, rule in rules.items() if name.startswith("plot_")}
    assert len(figures) > 18
    text = (ROOT / "docs" / "how-to" / "figures.md").read_text(encoding="utf-8")
    numbers = {int(n) for listed in re.findall(r"\*\*Figs?\.? ([\d, ]+)", text) for n in re.findall(r"\d+", listed)}
    for name, rule in figures.items():
        (written,) = rule["captions"]
        assert (ROOT / "workflow" / "report" / written).stat().st_size, name
        if rule["output"][0].startswith("results/figures/"):
            assert int(name[3:]) in numbers if re.fullmatch(r"fig\d\d", name) else f"**`{name}" in text, name

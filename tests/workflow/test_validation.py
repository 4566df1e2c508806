"""The target `validation`, which asks for no result of the study."""

import csv
import re
from pathlib import Path

import pytest
import yaml

from gearwear.validation.checks import read

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = {"check", "source", "expected", "found", "tolerance", "verdict"}
# Of iso_6336 two checks differ; tests/literature computes the checks of every group.
GROUPS = ("iso_6336", "sharing", "oscillator")


@pytest.fixture(scope="module")
def validated(make_project):
    """A copy of the program with some groups of checks, after the target `validation`."""
    project = make_project("validation")
    rules, file = (project.folder / name for name in ("workflow/rules/validation.smk", "config/validation.yaml"))
    rules.write_text(re.sub(r"(?<=CHECKED = )\(.*?\)", repr(GROUPS), rules.read_text(), flags=re.DOTALL))
    content = yaml.safe_load(file.read_text(encoding="utf-8"))
    kept = {key: {name: content[key][name] for name in GROUPS} for key in ("titles", "groups")}
    file.write_text(yaml.safe_dump(content | kept, sort_keys=False), encoding="utf-8")
    run = project.snakemake("-j2", "validation")
    assert run.returncode == 0, run.stdout[-20000:]
    project.printed = run.stdout
    return project


@pytest.fixture(scope="module")
def checks(validated):
    return read(validated.folder / "config" / "validation.yaml")


def test_table_has_a_verdict_on_every_number(validated, checks):
    with open(validated.folder / "results" / "validation" / "validation.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert set(rows[0]) >= COLUMNS
    names = [(check.group, check.id) for check in checks for _ in check.expected]
    assert sorted(names) == sorted((row["group"], row["check"]) for row in rows)
    differing = {(row["group"], row["check"]) for row in rows if row["verdict"] == "differs"}
    assert differing == {(check.group, check.id) for check in checks if check.differs}
    for row in rows:
        off = abs(float(row["found"]) - float(row["expected"]))
        assert (off <= float(row["tolerance"]) * (1 + 1e-5) + 1e-15) == (row["verdict"] == "agrees"), row


def test_page_and_figures_show_every_group(validated, checks):
    folder = validated.folder / "results" / "validation"
    page = (folder / "validation.html").read_text(encoding="utf-8")
    assert page.count("data:image/svg+xml") == len(GROUPS)
    assert all(f'id="{check.group}.{check.id}"' in page for check in checks)
    for group in GROUPS:
        for kind in ("svg", "png"):
            assert (folder / f"{group}.{kind}").stat().st_size > 2000
    (said,) = re.findall(r"Validation: (.*)\.\n", validated.printed)
    assert f"Validation: {said}</h1>" in page


def test_groups_of_rules_and_file_are_the_same():
    rules = (ROOT / "workflow" / "rules" / "validation.smk").read_text()
    named = re.findall(r'^    "(\w+)",$', rules, flags=re.MULTILINE)
    content = yaml.safe_load((ROOT / "config" / "validation.yaml").read_text(encoding="utf-8"))
    assert named == list(content["titles"]) == list(content["groups"])


def test_a_second_run_has_nothing_to_do_and_other_settings_change_nothing(validated):
    (validated.folder / "other.yaml").write_text("dynamics: {damping_ratio: 0.07}\n")
    run = validated.snakemake("-n", "validation", "--configfile", "config/config.yaml", "other.yaml")
    assert run.returncode == 0 and "Nothing to be done" in run.stdout, run.stdout

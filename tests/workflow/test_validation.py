"""The target `validation`, which asks for no result of the study."""

import csv
import re

import pytest
import yaml

from gearwear.validation.checks import read

COLUMNS = {"check", "source", "expected", "found", "tolerance", "verdict"}


@pytest.fixture(scope="module")
def validated(make_project):
    project = make_project("validation")
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
    groups = list(dict.fromkeys(check.group for check in checks))
    assert page.count("data:image/svg+xml") == len(groups)
    assert all(f'id="{check.group}.{check.id}"' in page for check in checks)
    for group in groups:
        for kind in ("svg", "png"):
            assert (folder / f"{group}.{kind}").stat().st_size > 2000
    (said,) = re.findall(r"Validation: (.*)\.\n", validated.printed)
    assert f"Validation: {said}</h1>" in page


def test_groups_of_rules_and_file_are_the_same(validated, checks):
    rules = (validated.folder / "workflow" / "rules" / "validation.smk").read_text()
    named = re.findall(r'^    "(\w+)",$', rules, flags=re.MULTILINE)
    content = yaml.safe_load((validated.folder / "config" / "validation.yaml").read_text(encoding="utf-8"))
    assert named == list(content["titles"]) == list(content["groups"])


def test_a_second_run_has_nothing_to_do_and_other_settings_change_nothing(validated):
    (validated.folder / "other.yaml").write_text("dynamics: {damping_ratio: 0.07}\n")
    run = validated.snakemake("-n", "validation", "--configfile", "config/config.yaml", "other.yaml")
    assert run.returncode == 0 and "Nothing to be done" in run.stdout, run.stdout

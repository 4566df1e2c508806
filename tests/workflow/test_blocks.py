"""Blocks of links of the wear chain: the files of single links, to the byte, in fewer jobs."""

import re
import shutil

import pytest
import yaml

SMOKE = ("--configfile", "config/config.yaml", "config/smoke.yaml")
STAGES = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")


def jobs_of(printed: str) -> dict[str, int]:
    """Return the number of jobs of every rule, from the table that snakemake prints."""
    table = re.search(r"^Job stats:\n(.*?)\n\n", printed, flags=re.MULTILINE | re.DOTALL)[1]
    return {rule: int(count) for rule, count in re.findall(r"^(\w+) +(\d+)$", table, flags=re.MULTILINE)}


@pytest.fixture(scope="module")
def blocked(make_project, smoke_run):
    """The smoke run, its last case made anew in blocks of two of its three cycles."""
    project = make_project("blocks")
    for name in ("results", ".snakemake"):
        shutil.copytree(smoke_run.folder / name, project.folder / name)
    overlay = project.folder / "blocks.yaml"
    overlay.write_text(yaml.safe_dump({"jobs": {"wear_cycles": 2}}))
    run = project.snakemake("-j2", *SMOKE, overlay.name, "--", "results/with/response/q003.nc")
    assert run.returncode == 0, run.stdout[-5000:]
    project.printed = run.stdout
    return project


def test_blocks_write_the_bytes_of_single_links(blocked, smoke_run):
    assert jobs_of(blocked.printed) == {"run_block_001_002": 1, "run_block_003_003": 1, "total": 2}
    for stage in STAGES:
        for cycle in range(4):
            file = f"results/with/{stage}/q{cycle:03d}.nc"
            made, single = (project.folder / file for project in (blocked, smoke_run))
            assert made.read_bytes() == single.read_bytes(), file
            assert cycle == 0 or made.stat().st_mtime_ns > single.stat().st_mtime_ns


def test_a_block_says_in_its_log_what_every_link_says(blocked, smoke_run):
    told = (blocked.folder / "results/logs/with/run_block/q001-q002.log").read_text()
    for rule, stage in (("advance_wear", "wear"), ("solve_response", "response")):
        single = (smoke_run.folder / f"results/logs/with/{rule}/q002.log").read_text()
        assert single in told, stage


def test_five_hundred_cycles_are_planned_in_blocks_and_members_link_by_link(blocked):
    cases = {"with": {"running_cycles": 510}, "wear_only": {"running_cycles": 60}}
    settings = {"jobs": {"wear_cycles": 25}, "wear": {"cycles_per_update": 1}, "cases": cases}
    for case in ("n0700_t060", "n1400_t080"):
        cases[case] = {"running_cycles": 0}
    (blocked.folder / "long.yaml").write_text(yaml.safe_dump(settings))
    last = [f"results/{case}/response/q{cycle}.nc" for case, cycle in (("with", 510), ("wear_only", "060"))]
    member = "results/studies/temperature/t60/with/response/q002.nc"
    run = blocked.snakemake("-n", *SMOKE, "long.yaml", "--forceall", "--", *last, member)
    assert run.returncode == 0, run.stdout[-5000:]
    planned = jobs_of(run.stdout)
    found = {rule: count for rule, count in planned.items() if rule.startswith("run_block")}
    assert len(found) == 22 and found.pop("run_block_501_510") == found.pop("run_block_051_060") == 1
    assert [rule for rule, count in found.items() if count == 2] == ["run_block_001_025", "run_block_026_050"]
    assert planned["advance_wear"] == 2

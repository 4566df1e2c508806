"""Blocks of links of the wear chain: the files of single links, to the byte, in fewer jobs."""

import shutil

import pytest

MADE = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")


@pytest.fixture(scope="module")
def blocked(make_project, smoke_run):
    """The smoke run, its last case made anew in blocks of two of its three cycles."""
    project = make_project("blocks")
    for name in ("results", ".snakemake"):
        shutil.copytree(smoke_run.folder / name, project.folder / name)
    settings = project.smoke({"jobs": {"wear_cycles": 2}})
    target = "results/with/response/q003.nc"
    assert project.jobs(*settings, "--", target) == {"wear_block_001_002": 1, "wear_block_003_003": 1, "total": 2}
    run = project.snakemake("-j2", *settings, "--", target)
    assert run.returncode == 0, run.stdout[-5000:]
    return project


def test_blocks_write_the_bytes_of_single_links(blocked, smoke_run):
    for name in MADE:
        for cycle in range(4):
            file = f"results/with/{name}/q{cycle:03d}.nc"
            made, single = (project.folder / file for project in (blocked, smoke_run))
            assert made.read_bytes() == single.read_bytes(), file
            assert cycle == 0 or made.stat().st_mtime_ns > single.stat().st_mtime_ns


def test_the_log_of_a_block_has_the_ranges_of_every_link(blocked, smoke_run):
    log = (blocked.folder / "results/logs/with/wear_block/q001_q002.log").read_text()
    for stage in ("wear", "mesh_excitation", "response"):
        for cycle in ("001", "002"):
            _, *ranges = (smoke_run.folder / f"results/logs/with/{stage}/q{cycle}.log").read_text().splitlines()
            assert ranges and all(line in log for line in ranges), (stage, cycle)


def test_five_hundred_cycles_are_planned_in_blocks_and_members_link_by_link(blocked):
    cases = dict.fromkeys(("n0700_t060", "n1400_t080"), {"running_cycles": 0})
    cases |= {"with": {"running_cycles": 510}, "wear_only": {"running_cycles": 60}}
    settings = {"jobs": {"wear_cycles": 25}, "wear": {"cycles_per_update": 1}, "cases": cases}
    last = [f"results/{case}/response/q{cycle}.nc" for case, cycle in (("with", 510), ("wear_only", "060"))]
    member = "results/studies/temperature/t60/with/response/q002.nc"
    planned = blocked.jobs(*blocked.smoke(settings), "--forceall", "--", *last, member)
    found = {rule: count for rule, count in planned.items() if rule.startswith("wear_block")}
    assert len(found) == 22 and found.pop("wear_block_501_510") == found.pop("wear_block_051_060") == 1
    assert [rule for rule, count in found.items() if count == 2] == ["wear_block_001_025", "wear_block_026_050"]
    assert planned["wear"] == 2

"""What a change re-runs; docs/how-to/reruns.md has the same table for users."""

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]

RULE_OF_FOLDER = {
    "wear": "advance_wear",
    "mesh_stiffness": "build_stiffness",
    "transmission_error": "share_load",
    "backlash": "open_backlash",
    "response": "solve_response",
    "parts": "sweep_part",
    "restart": "join_sweep",
    "up": "carry_sweep",
    "down": "carry_sweep",
    "branches": "continue_orbits",
    "portraits": "trace_portraits",
    "basins": "map_basins",
    "figures": "figures",
}
CLAIMS = {"results/claims.csv", "results/claims.html"}
PARAMETERS = {"results/parameters.csv", "results/parameters.html"}  # follow every change
WARNINGS = {"results/warnings.csv", "results/warnings.html"}  # follow every state
SWEPT = (
    "build_excitation sweep_part join_sweep carry_sweep continue_orbits trace_portraits map_basins figures judge_claims"
)
CHANGES = {  # key: a value, and the rules that run again; `*` = only after the first wear cycle
    "gear_pair.face_width": (0.017, "everything"),
    "material.pinion.density": (7800.0, "everything"),
    "friction.boundary": (
        0.11,
        f"heat_contact grow_flanks build_stiffness share_load open_backlash solve_response advance_wear {SWEPT}",
    ),
    "heat.shaft_temperature_drop": (
        10.0,
        f"grow_flanks build_stiffness share_load open_backlash solve_response advance_wear {SWEPT}",
    ),
    "mesh_stiffness.cantilever": (
        "root",
        f"heat_contact grow_flanks build_stiffness share_load open_backlash solve_response advance_wear {SWEPT}",
    ),
    "operation.pinion_speed": (
        5900.0,
        f"heat_contact grow_flanks build_stiffness share_load open_backlash solve_response advance_wear {SWEPT}",
    ),
    "transmission_error.heat": (
        "none",
        f"share_load open_backlash solve_response advance_wear build_stiffness* {SWEPT}",
    ),
    "backlash.half_backlash": (
        66.0e-6,
        f"open_backlash solve_response advance_wear build_stiffness* share_load* {SWEPT}",
    ),
    "wear.pressure": ("peak", f"advance_wear build_stiffness* share_load* open_backlash* solve_response* {SWEPT}"),
    "dynamics.clearance": (
        "varying",
        f"solve_response advance_wear build_stiffness* share_load* open_backlash* {SWEPT}",
    ),
    "dynamics.damping_ratio": (
        0.084,
        f"solve_response advance_wear build_stiffness* share_load* open_backlash* {SWEPT}",
    ),
    "settling.sampled_periods": (
        82,
        f"solve_response advance_wear build_stiffness* share_load* open_backlash* {SWEPT}",
    ),
    "sweeps.ste.points": (13, "sweep_part join_sweep carry_sweep continue_orbits figures judge_claims"),
    "sweeps.order": ("up", "figures judge_claims"),
    "branches.largest_period": (3, "continue_orbits figures"),
    "portraits.backlash.with": ([0.36, 0.8], "trace_portraits figures"),
    "basins.resolution": (13, "map_basins figures"),
    "figures.diagonal": (["without", "n1400_t080", "with"], "figures judge_claims"),
}


def rule_of(path: str) -> str:
    """Return the rule that makes a result file; rules of figures are one."""
    parts = Path(path).parts
    if path == "results/geometry.nc":
        return "build_geometry"
    if path in CLAIMS:
        return "judge_claims"
    if parts[-1] == "excitation.nc":
        return "build_excitation"
    if parts[-1] == "temperature.nc":
        return "heat_contact"
    if parts[-1] == "deformation.nc":
        return "grow_flanks"
    folder = next(part for part in reversed(parts[:-1]) if part in RULE_OF_FOLDER)
    if folder == "wear" and parts[-1] == "q000.nc":
        return "start_wear"
    return RULE_OF_FOLDER["parts" if "parts" in parts else folder]


def overlay(project, key: str, value) -> Path:
    for name in reversed(key.split(".")):
        value = {name: value}
    path = project.folder / "overlay.yaml"
    path.write_text(yaml.safe_dump(value))
    return path


def plan_after(project, key, value) -> set[str]:
    """Return what is made anew, the lists of parameters and warnings left out."""
    changed = overlay(project, key, value).name
    planned = project.planned("--configfile", "config/config.yaml", "config/smoke.yaml", changed)
    assert planned >= PARAMETERS
    return planned - PARAMETERS - WARNINGS


def pictures(*names: str) -> set[str]:
    return {f"results/figures/{name}.{kind}" for name in names for kind in ("svg", "png")}


def test_second_run_plans_nothing_though_the_project_was_moved(smoke_run):
    assert smoke_run.planned() == set()


@pytest.mark.parametrize("key", CHANGES)
def test_changed_value_reruns_what_it_reaches(smoke_run, key):
    value, rules = CHANGES[key]
    planned = plan_after(smoke_run, key, value)
    expected = rules.split()
    if expected == ["everything"]:
        assert "results/geometry.nc" in planned and {rule_of(path) for path in planned} >= set(RULE_OF_FOLDER.values())
        return
    assert sorted({rule_of(path) for path in planned}) == sorted(rule.rstrip("*") for rule in expected)
    for rule in expected:
        first = [path for path in planned if rule_of(path) == rule.rstrip("*") and path.endswith("/q000.nc")]
        if rule in RULE_OF_FOLDER.values() and rule != "advance_wear":
            assert first or rule.endswith("*") or not re.search(r"mesh$|load|backlash|response", rule)
        if rule.endswith("*"):
            assert not first


def test_bulk_temperature_of_a_case_reruns_only_this_case(smoke_run):
    planned = plan_after(smoke_run, "cases.n0700_t060.bulk_temperature", 61.0)
    own = {path for path in planned if path.startswith("results/n0700_t060/")}
    extra = ("wear_history", "contact_temperature", "load_sharing", "mesh_force")
    shared = pictures(*(f"fig{number:02d}" for number in range(6, 12)), *extra)
    assert own and planned - own == shared | CLAIMS
    assert "results/n0700_t060/wear/q000.nc" not in planned


def test_longer_life_adds_only_the_new_cycle_and_what_reads_the_last(smoke_run):
    planned = plan_after(smoke_run, "cases.wear_only.running_cycles", 3.0e8)
    added = {f"results/wear_only/{stage}/q003.nc" for stage in list(RULE_OF_FOLDER)[:5]}
    assert planned == added | pictures("wear_history") | CLAIMS


def test_comment_and_key_order_rerun_no_computation(smoke_run):
    path = smoke_run.folder / "config" / "config.yaml"
    before = path.read_text()
    try:
        turned = {key: value for key, value in reversed(yaml.safe_load(before).items())}
        turned["gear_pair"] = dict(reversed(turned["gear_pair"].items()))
        path.write_text("# another comment\n" + yaml.safe_dump(turned, sort_keys=False))
        assert smoke_run.planned() == PARAMETERS  # which tell the comments
    finally:
        path.write_text(before)


def edited_plan(project, module: str, old: str, new: str) -> set[str]:
    path = project.folder / "workflow" / "scripts" / "gearwear" / module
    before = path.read_text()
    assert old in before
    try:
        path.write_text(before.replace(old, new, 1))
        return project.planned() - WARNINGS
    finally:
        path.write_text(before)


def test_edited_physics_reruns_its_stages(smoke_run):
    planned = edited_plan(
        smoke_run, "mesh/backlash.py", "opening + factor * change / 2", "opening + factor * change / 3"
    )
    rules = {rule_of(path) for path in planned}
    assert "open_backlash" in rules and "solve_response" in rules
    assert not rules & {"build_geometry", "heat_contact", "grow_flanks", "start_wear"}
    assert "results/with/mesh_stiffness/q000.nc" not in planned


def test_edited_comment_and_docstring_rerun_nothing(smoke_run):
    old = '"""Half backlash along the path of one pair."""'
    assert edited_plan(smoke_run, "mesh/backlash.py", old, '"""Gap."""\n# a remark') == set()

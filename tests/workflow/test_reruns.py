"""What a change re-runs; docs/how-to/reruns.md has the same table for users."""

from contextlib import contextmanager
from pathlib import Path

import pytest
import yaml

RULE_OF_FOLDER = {
    "wear": "wear",
    "mesh_stiffness": "mesh_excitation",
    "transmission_error": "mesh_excitation",
    "backlash": "mesh_excitation",
    "response": "response",
    "restart": "sweep",
    "up": "sweep",
    "down": "sweep",
    "branches": "branches",
    "portraits": "portraits",
    "basins": "basins",
    "figures": "figures",
}
CYCLE = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")
CLAIMS = {"results/claims.csv", "results/claims.html"}
PARAMETERS = {"results/parameters.csv", "results/parameters.html"}  # follow every change
WARNINGS = {"results/warnings.csv", "results/warnings.html"}  # follow every state
MOTION = "excitation sweep branches portraits basins figures claims"
CHANGES = {  # key: a value, and the rules that run again; `*` = only after the first wear cycle
    "gear_pair.face_width": (0.017, "everything"),
    "material.pinion.density": (7800.0, "everything"),
    "friction.boundary": (0.11, "temperature flash_growth figures claims"),
    "heat.shaft_temperature_drop": (10.0, f"deformation flash_growth mesh_excitation response wear {MOTION}"),
    "mesh_stiffness.cantilever": ("root", f"temperature flash_growth mesh_excitation response wear {MOTION}"),
    "operation.pinion_speed": (5900.0, f"temperature flash_growth mesh_excitation* response wear {MOTION}"),
    "transmission_error.heat": ("none", f"mesh_excitation response wear {MOTION}"),
    "backlash.half_backlash": (66.0e-6, f"mesh_excitation response wear {MOTION}"),
    "wear.pressure": ("peak", f"mesh_excitation* response* wear {MOTION}"),
    "dynamics.clearance": ("varying", f"mesh_excitation* response wear {MOTION}"),
    "dynamics.damping_ratio": (0.084, f"mesh_excitation* response wear {MOTION}"),
    "settling.sampled_periods": (82, f"mesh_excitation* response wear {MOTION}"),
    "sweeps.ste.points": (13, "sweep branches figures claims"),
    "sweeps.order": ("up", "figures claims"),
    "branches.largest_period": (3, "branches figures"),
    "portraits.backlash.with": ([0.36, 0.80], "portraits figures"),
    "basins.resolution": (13, "basins figures"),
    "figures.diagonal": (["without", "n1400_t080", "with"], "figures claims"),
}


def rule_of(path: str) -> str:
    """Return the rule that makes a result file; rules of figures are one."""
    parts = Path(path).parts
    if path in CLAIMS:
        return "claims"
    if parts[-1] in ("geometry.nc", "excitation.nc", "temperature.nc", "deformation.nc", "flash_growth.nc"):
        return parts[-1].removesuffix(".nc")
    folder = next(part for part in reversed(parts[:-1]) if part in RULE_OF_FOLDER)
    return "unworn" if folder == "wear" and parts[-1] == "q000.nc" else RULE_OF_FOLDER[folder]


def changed(key: str, value) -> dict:
    """Return the settings with one changed value."""
    for name in reversed(key.split(".")):
        value = {name: value}
    return value


def plan_after(project, key, value) -> set[str]:
    """Return what is made anew, the lists of parameters and warnings left out."""
    planned = project.planned(changed(key, value))
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
    for rule in {"mesh_excitation", "response"} & {rule.rstrip("*") for rule in expected}:
        first = any(path.endswith("/q000.nc") and rule_of(path) == rule for path in planned)
        assert first == (rule in expected), rule


def test_boundary_friction_reruns_few_jobs(smoke_run):
    """The default study has the same cases, and of what it reaches the same jobs."""
    assert smoke_run.jobs("all", *smoke_run.smoke(changed("friction.boundary", 0.11)))["total"] <= 25


def test_bulk_temperature_of_a_case_reruns_only_this_case(smoke_run):
    planned = plan_after(smoke_run, "cases.n0700_t060.bulk_temperature", 61.0)
    own = {path for path in planned if path.startswith("results/n0700_t060/")}
    extra = ("wear_history", "contact_temperature", "load_sharing", "mesh_force")
    shared = pictures(*(f"fig{number:02d}" for number in range(6, 12)), *extra)
    assert own and planned - own == shared | CLAIMS
    assert "results/n0700_t060/wear/q000.nc" not in planned


def test_longer_life_adds_only_the_new_cycle_and_what_reads_the_last(smoke_run):
    planned = plan_after(smoke_run, "cases.wear_only.running_cycles", 3.0e8)
    added = {f"results/wear_only/{stage}/q003.nc" for stage in CYCLE}
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


@contextmanager
def edited(project, *edits):
    """Edit files of the program for a while: pairs of an old and a new text, by the paths of the files."""
    before = {project.folder / name: (project.folder / name).read_text() for name, _, _ in edits}
    try:
        for name, old, new in edits:
            text = (project.folder / name).read_text()
            assert old in text, (name, old)
            (project.folder / name).write_text(text.replace(old, new, 1))
        yield
    finally:
        for path, text in before.items():
            path.write_text(text)


def test_edited_physics_reruns_its_stages(smoke_run):
    edit = ("src/gearwear/mesh/backlash.py", "opening + factor * change / 2", "opening + factor * change / 3")
    with edited(smoke_run, edit):
        rules = {rule_of(path) for path in smoke_run.planned() - WARNINGS}
    assert rules >= {"mesh_excitation", "response"}
    assert not rules & {"geometry", "temperature", "deformation", "flash_growth", "unworn"}


def test_edited_basins_rerun_the_basins_and_their_figures_alone(smoke_run):
    with edited(smoke_run, ("src/gearwear/motions/basins.py", "_WATCHED = 16", "_WATCHED = 17")):
        planned = smoke_run.planned()
    figures = {path for path in planned if path.startswith("results/figures/basins_")}
    basins = {path for path in planned if "/basins/" in path}
    assert len(figures) == 2 * len(basins) > 0 and planned == figures | basins


def test_comment_docstring_help_text_and_unused_constant_rerun_nothing(smoke_run):
    docstring = '"""Half backlash along the path of one pair."""'
    edits = (
        ("src/gearwear/mesh/backlash.py", docstring, '"""Gap."""\n# a remark'),
        ("src/gearwear/mesh/backlash.py", "\ndef ", "\nUNUSED = 1\n\n\ndef "),
        ("src/gearwear/config/study.py", "Damping ratio of the mass on", "Damping of the mass on"),
        ("workflow/report/fig12.rst", "", "Another caption. "),
    )
    with edited(smoke_run, *edits):
        assert smoke_run.planned() == set()

"""The configuration files that ship, the files generated from the models, and bad configurations."""

import json
from pathlib import Path

import jsonschema
import pytest
import yaml
from snakemake.utils import update_config

from gearwear.config.check import ConfigError, check
from gearwear.config.documents import SCHEMA_FILE, readers, schema_text, table_text
from gearwear.config.slices import STAGES
from gearwear.config.study import Configuration
from gearwear.config.types import entry_type, is_section, keys, placeholder

ROOT = Path(__file__).resolve().parents[2]
DROP = object()

UNITS = "(or with its unit, such as 3 mm, 65 um or 0.63 in)"


def load(name):
    return yaml.safe_load((ROOT / "config" / name).read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    "changes, line",
    [
        (
            {"dynamics.harmonics": 32},
            "grid.mesh_cells: 240 cells do not resolve dynamics.harmonics, 32; give at least 256",
        ),
        (
            {"transmission_error.mode": "no_load"},
            "dynamics.ste_amplitude: nominal compares with the loaded error of the pristine pair, and "
            "transmission_error.mode no_load has none; give harmonic",
        ),
        (
            {"elasticity.law": "table", "cases.n0700_t060.bulk_temperature": 15.0, "heat.initial_temperature": 10.0},
            "cases.n0700_t060.bulk_temperature: 15.0 is outside the table of elasticity.law table, 20 to 260 degC; "
            "use law li or linear",
        ),
        (
            {"cases.with.bulk_temperature": "balance", "heat_balance.heat_transfer": 1.0},
            "cases.with.bulk_temperature: balance: it closes at 2143.7 degC, outside -40 to 250 degC, with a mesh loss "
            "of 214 W and a churning loss of 18.2 W at heat_balance.surroundings; check heat_balance.heat_transfer, "
            "area and immersion, or the load",
        ),
        (
            {"cases.with.bulk_temperature": "balance", "heat_balance.surroundings": 0, "heat_balance.area": 1e3},
            "cases.with.bulk_temperature: balance, 0.0 degC, is below heat.initial_temperature, 20.0 degC; give at "
            "least that",
        ),
    ],
)
def test_values_that_do_not_go_together(changes, line):
    assert problems(changes) == [line]


def test_the_shipped_studies_are_valid():
    smoke = load("config.yaml")
    update_config(smoke, load("smoke.yaml"))
    assert check(smoke)["cases"]["with"]["running_cycles"] == 300_000_000
    assert check(load("config.yaml"))["cases"]["with"]["running_cycles"] == 2_100_000_000


def test_the_schema_accepts_the_checked_configuration_and_refuses_a_bad_one():
    schema = json.loads(schema_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    values = check(load("config.yaml"))
    jsonschema.validate(values, schema)
    values["gear_pair"]["module"] = -1.0
    with pytest.raises(jsonschema.ValidationError, match="less than the minimum"):
        jsonschema.validate(values, schema)


def test_the_schema_is_up_to_date():
    assert (ROOT / SCHEMA_FILE).read_text(encoding="utf-8") == schema_text(), "run gearwear.config.documents"


def test_the_table_follows_the_stages_given():
    table = table_text(check(load("config.yaml")), {"grinding": ("grid", "case.flash", "sweeps.{sweep}")})
    stages = {line.split(" | ")[0].strip("| `"): line.split(" | ")[-1].strip("| ") for line in table.splitlines()}
    assert stages["grid.mesh_cells"] == stages["cases.<case>.flash"] == stages["sweeps.ste.points"] == "grinding"
    assert stages["dynamics.tolerance"] == stages["wear.law"] == ""


def test_every_key_is_read_by_a_stage_or_decides_only_what_is_made_and_how():
    for path, field in keys(Configuration):
        entry = entry_type(field.annotation)
        if is_section(field.annotation) or is_section(entry):
            continue
        read = readers((*path, "<case>") if entry else path, STAGES)
        if "decides_jobs" in (field.json_schema_extra or {}):
            assert not read, ".".join(path)
        elif "decides_targets" not in (field.json_schema_extra or {}):
            assert read, ".".join(path)


def test_every_key_a_stage_reads_exists():
    known = [
        (*path, placeholder(field)) if entry_type(field.annotation) else path for path, field in keys(Configuration)
    ]
    for stage, wanted in STAGES.items():
        for key in wanted:
            assert any(readers(path, {stage: (key,)}) for path in known), (stage, key)


BAD = [
    # unknown keys
    ("dynamics.dampng_ratio", 0.1, "unknown key (did you mean dynamics.damping_ratio?)"),
    ("gear_pair.teeth.pinon", 19, "unknown key (did you mean gear_pair.teeth.pinion?)"),
    ("cases.with.bulk_temprature", 1, "unknown key (did you mean cases.with.bulk_temperature?)"),
    (
        "wear.damping_ratio",
        0.1,
        "unknown key (the key of that name is dynamics.damping_ratio, dynamics.bearings.pinion.damping_ratio or "
        "dynamics.bearings.gear.damping_ratio)",
    ),
    (
        "half_backlash",
        1e-4,
        "unknown key (did you mean backlash? the key of that name is backlash.half_backlash or "
        "sensitivity.half_backlash)",
    ),
    ("operation.dampng_ratio", 0.1, "unknown key (did you mean dynamics.damping_ratio?)"),
    (
        "settling.tolerance",
        1e-9,
        "unknown key (did you mean settling.recurrence_tolerance? the key of that name is dynamics.tolerance)",
    ),
    ("grid.xyz", 1, "unknown key; the keys here are mesh_cells"),
    # missing keys
    ("gear_pair.module", DROP, "missing; give a number from 1.0e-4 to 0.1 m"),
    ("elasticity.law", DROP, "missing; give li, linear, table or constant"),
    ("grid", DROP, "missing section; give its keys mesh_cells"),
    ("portraits.ste", DROP, "missing section; give names of cases with their values below it"),
    # order of the ends
    (
        "sensitivity.pinion_torque.high",
        100,
        "100.0 is not above sensitivity.pinion_torque.low, 108.0; exchange them or widen the range",
    ),
    # kinds of values
    ("sensitivity.damping_ratio.high", 2, "2.0 is not below 1; give a number from 1.0e-4 to below 1"),
    ("wear.coefficient", "abc", "text 'abc' is not a number; give a number from 0 to 1.0e-9 m2/N"),
    ("friction.dry", "0,2", "text '0,2' is not a number; give a number above 0 up to 2"),
    ("heat.flash_coefficient", True, "true is not a number; give a number from 0 to 2"),
    ("heat.flash_coefficient", None, "null is not a number; give a number from 0 to 2"),
    ("heat.flash_coefficient", float("nan"), "nan is not a finite number; give a number from 0 to 2"),
    (
        "operation.pinion_torque",
        float("inf"),
        "inf is not a finite number; give a number above 0 up to 1.0e+7 N m",
    ),
    ("grid.mesh_cells", 80.5, "80.5 is not a whole number; give a whole number from 16 to 20000"),
    ("grid.mesh_cells", [80], "a list of 1 is not a whole number; give a whole number from 16 to 20000"),
    ("cases.with.flash", 1, "1 is neither true nor false; give true or false"),
    ("wear.law", "janakiram", "text 'janakiram' is not a choice of this key; give janakiraman or constant"),
    ("wear.law", None, "null is not a choice of this key; give janakiraman or constant"),
    (
        "dynamics.harmonics",
        "all",
        "text 'all' is not a whole number; give a whole number from 1 to 64 or full",
    ),
    (
        "gear_pair.centre_distance",
        "auto",
        "text 'auto' is not a number; give a number from 0.001 to 20 m or null",
    ),
    ("dynamics.reference_case", 3, "3 is not text; give a name"),
    ("figures.diagonal", "with", "text 'with' is not a list; give a list of names with 2 to 6 entries"),
    ("figures.diagonal", ["with"], "a list of 1 is too short; give a list of names with 2 to 6 entries"),
    ("sweeps.ste.cases", [], "a list of 0 is too short; give a list of names with at least one entry"),
    ("portraits.ste.with", 1.0, "1.0 is not a list; give a list of numbers"),
    # sections of the wrong kind
    ("elasticity", None, "null is not a section; give the keys law and calibration below it"),
    ("elasticity", 5.3, "5.3 is not a section; give the keys law and calibration below it"),
    ("portraits.ste", [1], "a list of 1 is not a section; give names of cases with their values below it"),
    (
        "cases.with",
        None,
        "null is not a section; give the keys bulk_temperature, running_cycles and flash below it",
    ),
    # ranges
    (
        "gear_pair.module",
        3.175,
        f"3.175 is above the largest allowed value 0.1 m; give a number from 1.0e-4 to 0.1 m {UNITS}",
    ),
    (
        "material.gear.youngs_modulus",
        206,
        "206.0 is below the least allowed value 1.0e+8 Pa; "
        "give a number from 1.0e+8 to 1.0e+12 Pa (or with its unit, such as 206 GPa)",
    ),
    # units in values
    (
        "gear_pair.module",
        "3175 mm",
        f"text '3175 mm' is above the largest allowed value 0.1 m; give a number from 1.0e-4 to 0.1 m {UNITS}",
    ),
    (
        "gear_pair.bore_radius.gear",
        "3 mmm",
        f"text '3 mmm' has an unknown unit; give a number from 1.0e-4 to 5 m or null {UNITS}",
    ),
    (
        "operation.pinion_speed",
        "50 Hz",
        "text '50 Hz' has a unit that does not convert to rpm; give a number above 0 up to 200000 rpm "
        "(or with its unit, such as 356 rad/s)",
    ),
    (
        "heat.shaft_temperature_drop",
        "20 degC",
        "text '20 degC' is a temperature, and this is a difference of temperatures; give a number from 0 to 200 K "
        "(or with its unit, such as 20 K)",
    ),
    ("dynamics.damping_ratio", "7 %", "text '7 %' is not a number; give a number from 1.0e-4 to below 1"),
    ("operation.pinion_speed", 0, "0.0 is not above 0 rpm; give a number above 0 up to 200000 rpm"),
    ("dynamics.damping_ratio", 1, "1.0 is not below 1; give a number from 1.0e-4 to below 1"),
    (
        "dynamics.harmonics",
        65,
        "65 is above the largest allowed value 64; give a whole number from 1 to 64 or full",
    ),
    (
        "gear_pair.inertia.gear",
        -1,
        "-1.0 is not above 0 kg m2; give a number above 0 up to 1.0e+6 kg m2 or null",
    ),
    (
        "cases.with.bulk_temperature",
        300,
        "300.0 is above the largest allowed value 250 degC; give a number from -40 to 250 degC or balance",
    ),
    (
        "micro_geometry.tip_relief.pinion.amount",
        20,
        f"20.0 is above the largest allowed value 0.001 m; give a number from 0 to 0.001 m {UNITS}",
    ),
    (
        "micro_geometry.tip_relief.gear.length",
        3,
        "3.0 is above the largest allowed value 2; give a number from 0.01 to 2",
    ),
    (
        "micro_geometry.spacing_error",
        -5,
        f"-5.0 is below the least allowed value -0.001 m; give a number from -0.001 to 0.001 m {UNITS}",
    ),
    (
        "backlash.centre_distance_change",
        0.02,
        f"0.02 is above the largest allowed value 0.001 m; give a number from -0.001 to 0.001 m {UNITS}",
    ),
    ("heat_balance.area", "none", "text 'none' is not a number; give a number above 0 up to 10000 m2 or null"),
    ("jobs.wear_cycles", 0, "0 is below the least allowed value 1; give a whole number from 1 to 999"),
    ("jobs.wear_cycles", 2.5, "2.5 is not a whole number; give a whole number from 1 to 999"),
    # rules between keys
    (
        "backlash.housing.temperature_rise",
        0.5,
        "0.5 moves the shafts apart, and heat.growth paper leaves out the growth of the gear bodies towards each other "
        "that goes with it; give heat.growth eulerian, or 0",
    ),
    (
        "cases.with.running_cycles",
        2.05e9,
        "2.05e+9 is not a whole multiple of wear.cycles_per_update, 1.0e+8; give 2.0e+9 or 2.1e+9",
    ),
    (
        "cases.with.running_cycles",
        1e11,
        "1.0e+11 is more than 999 times wear.cycles_per_update, 1.0e+8; "
        "give at most 9.99e+10, or raise wear.cycles_per_update to 1.00100101e+8 or more",
    ),
    (
        "cases.with.bulk_temperature",
        10,
        "10.0 is below heat.initial_temperature, 20.0 degC; give at least that",
    ),
    (
        "cases.figures",
        {"bulk_temperature": 20, "running_cycles": 0, "flash": False},
        "the name is taken by a folder of the results; use none of figures, logs, benchmarks, geometry and studies",
    ),
    (
        "cases.Hot",
        {"bulk_temperature": 20, "running_cycles": 0, "flash": False},
        "not a case name; use small letters, digits and underscores, a letter first, at most 60 of them",
    ),
    ("cases.temperature_only", DROP, "missing case; figures and claims read it, so give it its three keys"),
    ("dynamics.reference_case", "with", "case with is worn; name a case with running_cycles 0"),
    ("dynamics.reference_case", "witout", "text 'witout' is no case (did you mean without?)"),
    (
        "sweeps.ste.last",
        0.05,
        "0.05 is not above sweeps.ste.first, 0.1; exchange them or widen the range",
    ),
    (
        "settling.longest_transient",
        399,
        "399 is below settling.transient_periods, 400; give at least that many",
    ),
    (
        "settling.sampled_periods",
        32,
        "32 is too few to see settling.largest_period, 60, come back in either half; give at least 240 mesh periods",
    ),
    ("settling.largest_period", 65, "65 is above the largest allowed value 64; give a whole number from 1 to 64"),
    ("friction.boundary", 0.3, "0.3 is above friction.dry, 0.2; lower it or raise friction.dry"),
]


@pytest.mark.parametrize(("path", "value", "text"), BAD, ids=[f"{n}-{bad[0]}" for n, bad in enumerate(BAD)])
def test_a_bad_key_gives_its_message(path, value, text):
    assert problems({path: value}) == [f"{path}: {text}"]


@pytest.mark.parametrize(
    ("changes", "lines"),
    [
        (
            {"lubricant.viscosity_law": "vogel", "lubricant.dynamic_viscosity_40": 0.005},
            [
                "lubricant.dynamic_viscosity_40: 0.005 is not above lubricant.dynamic_viscosity, 0.0094 Pa s; "
                "exchange them, oil is thicker at 40 degC than at 100 degC"
            ],
        ),
        (
            {
                "sweeps.mesh_frequency.cases": ["with", "withot", "with"],
                "portraits.mesh_frequency.without": [],
            },
            [
                "sweeps.mesh_frequency.cases[1]: text 'withot' is no case (did you mean without?)",
                "sweeps.mesh_frequency.cases[2]: case with is listed twice; take one out",
                "portraits.mesh_frequency.without: figures 13 to 18 draw this case; "
                "give a list with at least one value",
            ],
        ),
        (
            {"figures.diagonal": ["without", "worn"]},
            [
                "figures.diagonal[1]: text 'worn' is no case (cases: without, temperature_only, wear_only, "
                "n0700_t060, n1400_t080 and with)"
            ],
        ),
        (
            {"portraits.ste.with": [1.0, 3.5, 1.0, "x"]},
            ["portraits.ste.with[3]: text 'x' is not a number; give a number"],
        ),
        (
            {"maps.temperature": ["20 degC", "60 K s"]},
            [
                "maps.temperature[1]: text '60 K s' has a unit that does not convert to degC; give a number "
                "from -40 to 250 degC (or with its unit, such as 373.15 K)"
            ],
        ),
        (
            {"portraits.ste.with": [1.0, 3.5, 1.0]},
            [
                "portraits.ste.with[1]: 3.5 is outside the swept range, 0.1 to 3.0; take it out or widen sweeps.ste",
                "portraits.ste.with[2]: 1.0 is listed twice; take one out",
            ],
        ),
        (
            {"portraits.ste.without": [1.0], "portraits.ste.wth": [1.0]},
            [
                "portraits.ste.without: the case is not swept; add it to sweeps.ste.cases or leave its list empty",
                "portraits.ste.wth: text 'wth' is no case (did you mean with?)",
            ],
        ),
        (
            {
                "basins.points.ste.with": [1.0, 3.5],
                "basins.points.ste.wthout": [1.0],
                "basins.velocity": {"first": 1.0, "last": 1.0},
                "basins.resolution": 1,
            },
            [
                "basins.resolution: 1 is below the least allowed value 2; give a whole number from 2 to 500",
                "basins.velocity.last: 1.0 is not above basins.velocity.first, 1.0; exchange them or widen the range",
                "basins.points.ste.with[1]: 3.5 is outside the swept range, 0.1 to 3.0; "
                "take it out or widen sweeps.ste",
                "basins.points.ste.wthout: text 'wthout' is no case (did you mean without?)",
            ],
        ),
        (
            {"elasticity": [{"lw": "li"}, {"calibration": -1}]},
            [
                "elasticity: a list of 2 is not a section; give the keys law and calibration below it",
                "elasticity.calibration: -1.0 is below the least allowed value 0; give a number from 0 to 20",
                "elasticity.lw: unknown key (did you mean elasticity.law?)",
            ],
        ),
        (
            {"studies": {"Heat": {"members": {"t 1": {}}}, "heat": {"members": {"t2": 3}}, "wear": {"member": {}}}},
            [
                "studies.heat.members.t2: 3 is not a group of keys; give keys of the configuration with their values",
                "studies.wear.member: unknown key (did you mean studies.wear.members?)",
                "studies.Heat: not a name of a study; use small letters, digits and underscores, a letter first, "
                "at most 60 of them",
                "studies.Heat.members.(text 't 1'): not a name of a member; use small letters, digits and underscores, "
                "a letter first, at most 60 of them",
            ],
        ),
        (
            {"dynamics.torque_fluctuation.amplitudes": [0.1, -0.1], "dynamics.torque_fluctuation.frequency_ratio": 0},
            [
                "dynamics.torque_fluctuation.frequency_ratio: 0.0 is not above 0; give a number above 0 up to 100",
                "dynamics.torque_fluctuation.amplitudes[1]: -0.1 is below the least allowed value 0; "
                "give a number from 0 to 5",
            ],
        ),
        (
            {"dynamics.torque_fluctuation.amplitudes": [0.1, 0.2], "dynamics.torque_fluctuation.phases": [0.0]},
            [
                "dynamics.torque_fluctuation.phases: 1 phases for 2 amplitudes; give one phase for every amplitude",
            ],
        ),
        (
            {"dynamics": DROP, "dynamic": {}},
            [
                "dynamics: missing section; give its keys model, reference_case, damping_ratio, stiffness, harmonics, "
                "ste_amplitude, clearance, torque_fluctuation, bearings, tolerance and start",
                "dynamic: unknown key (did you mean dynamics?)",
            ],
        ),
    ],
)
def test_problems_that_come_together(changes, lines):
    assert problems(changes) == lines


def test_a_case_name_that_yaml_does_not_take_for_text():
    raw = load("config.yaml")
    raw["cases"][True] = raw["cases"]["with"]
    with pytest.raises(ConfigError, match=r"cases\.\(true\): the name is not text; put it in quotes"):
        check(raw)


@pytest.mark.parametrize("raw", [None, [], "config.yaml", 3])
def test_a_file_without_sections(raw):
    with pytest.raises(ConfigError, match=r"\(whole configuration\): .* is not a section; give the keys gear_pair, "):
        check(raw)


def oscillator(changes=None):
    waves = {"amplitudes": [0.2], "phases": [0.0]}
    return {"mean_force": 0.1, "stiffness": waves, "error": waves} | (changes or {})


@pytest.mark.parametrize(
    "name, given, line",
    [
        ("one", oscillator(), "oscillators.one: swept nowhere; add it to sweeps.mesh_frequency.cases"),
        ("with", oscillator(), "oscillators.with: the name is that of a case; choose another"),
        (
            "one",
            oscillator({"error": {"amplitudes": [0.1, 0.2], "phases": [0.0]}}),
            "oscillators.one.error.phases: 1 phases for 2 amplitudes; give one phase for every amplitude",
        ),
        (
            "one",
            oscillator({"error": {"amplitudes": [0.0, 0.2], "phases": [0.0, 0.0]}}),
            "oscillators.one.error.amplitudes: the first is 0 and another is not; all are scaled by the first, so give "
            "it a value, however small",
        ),
        (
            "one",
            oscillator({"mean_force": "much"}),
            "oscillators.one.mean_force: text 'much' is not a number; give a number from -100 to 100",
        ),
    ],
)
def test_oscillators_that_cannot_be(name, given, line):
    changes = {"oscillators": {name: given}}
    if "swept nowhere" not in line:
        changes["sweeps.mesh_frequency.cases"] = [name]
    assert problems(changes) == [line]


def test_what_is_listed_for_cases_is_passed_over_where_an_oscillator_is_given():
    raw = load("config.yaml")
    raw["oscillators"] = {"one": oscillator()}
    raw["sweeps"]["mesh_frequency"]["cases"] = ["one"]
    assert raw["portraits"]["mesh_frequency"]["with"]  # whose case is not swept now
    assert check(raw)["oscillators"]["one"]["error"]["amplitudes"] == [0.2]


def problems(changes):
    raw = load("config.yaml")
    for path, value in changes.items():
        *way, last = path.split(".")
        place = raw
        for key in way:
            place = place[key]
        if value is DROP:
            del place[last]
        else:
            place[last] = value
    with pytest.raises(ConfigError) as caught:
        check(raw)
    head, *lines = str(caught.value).split("\n")
    assert head == f"configuration: {len(lines)} problem{'s' * (len(lines) > 1)}"
    return [line.removeprefix("  ") for line in lines]

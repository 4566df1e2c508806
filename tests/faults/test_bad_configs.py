"""Five hundred generated faults of the configuration: never a traceback, always the key."""

import copy
import random
from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.members import members, merged
from gearwear.config.study import Configuration
from gearwear.config.text import dotted
from gearwear.config.types import entry_type, is_section, keys

ROOT = Path(__file__).resolve().parents[2]
SEED = 77
COUNT = 500
NEVER_VALID = ("no such ☃", float("nan"), float("-inf"), {"no": "such"}, [["no"]], 1e300, -1e300, {}, b"\0", 10**400)
REQUIRED = {
    path for path, field in keys(Configuration) if not is_section(field.annotation) and not entry_type(field.annotation)
}


def base():
    texts = [(ROOT / "config" / name).read_text(encoding="utf-8") for name in ("config.yaml", "studies/life.yaml")]
    return merged(*map(yaml.safe_load, texts))


def leaves(tree, path=()):
    """Return the paths of all values of a configuration; those of studies are its own kind."""
    if isinstance(tree, dict) and tree:
        return [leaf for key, below in tree.items() if key != "studies" for leaf in leaves(below, (*path, key))]
    return [path]


def faults():
    """Return path and value of generated faults; a path of a key that does not exist has a misspelled end."""
    chance = random.Random(SEED)
    print(f"seed {SEED}")
    ends = leaves(base())
    made = []
    while len(made) < COUNT:
        *way, last = chance.choice(ends)
        if chance.random() < 0.25:
            place = chance.randrange(len(last))
            made.append(((*way, last[:place] + chance.choice("xqZ_ é") + last[place:]), 1))
        else:
            made.append(((*way, last), chance.choice(NEVER_VALID)))
    return made


def put(tree, path, value):
    for key in path[:-1]:
        tree = tree[key]
    tree[path[-1]] = value


def refusal(raw) -> str:
    with pytest.raises(ConfigError) as refused:
        members(check(raw))
    return str(refused.value)


def test_every_fault_is_told_with_its_key():
    raw = base()
    members(check(raw))
    for path, value in faults():
        spoiled = copy.deepcopy(raw)
        put(spoiled, path, value)
        told = refusal(spoiled)
        assert f"\n  {dotted(path)}" in told, (path, value, told)


def test_every_missing_key_is_told():
    for path in sorted(path for path in REQUIRED if "<case>" not in path and "<name>" not in path):
        spoiled = copy.deepcopy(base())
        section = spoiled
        for key in path[:-1]:
            section = section[key]
        if path[-1] in section:
            del section[path[-1]]
            assert f"\n  {dotted(path)}: missing" in refusal(spoiled)


def test_a_fault_in_a_member_of_a_study_is_told_with_member_and_key():
    for path, value in faults()[:10]:
        fault = value
        for key in reversed(path):
            fault = {key: fault}
        raw = base() | {"studies": {"heat": {"members": {"m1": fault}}}}
        told = refusal(raw)
        assert "studies" in told and "heat" in told and "m1" in told and dotted(path) in told, (path, value, told)


def test_faults_on_the_command_line(make_project):
    project = make_project("bad")
    wrong, told = {}, []
    for path, value in faults()[:40]:
        if isinstance(value, bytes | dict) or (isinstance(value, int) and value > 1):
            continue  # no YAML, or merged with the value below and no fault then
        section = wrong
        for key in path[:-1]:
            section = section.setdefault(key, {})
        if path[-1] not in section:
            section[path[-1]] = value
            told.append(dotted(path))
    (project.folder / "bad.yaml").write_text(yaml.safe_dump(wrong), encoding="utf-8")
    run = project.snakemake("-n", "all", "--configfile", "config/config.yaml", "bad.yaml")
    assert run.returncode != 0 and "Traceback" not in run.stdout
    assert [key for key in told if f"\n  {key}" not in run.stdout] == []

"""No value of the configuration names a path, or anything else, outside the results of its run."""

from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.members import combinations, members, merged
from gearwear.config.study import leaves
from gearwear.config.text import dotted
from gearwear.config.types import schema_of

ROOT = Path(__file__).resolve().parents[3]
FOREIGN = (
    *("../x", "/etc/x", "a/b", "..", ".", "a\\b", "C:x", "~", "-x", "", "a b", "A", "é", "x\n", "\x00", "x" * 61),
    *("$HOME", "{root}", "`id`", "a;b", "<script>", '"x"', "a,b", "=1+1", "@x"),
)
NAMED = (  # tables whose free names become folders, files or wildcards
    ("cases",),
    ("oscillators",),
    ("studies",),
    ("studies", "life", "members"),
    *((*section, sweep) for section in (("portraits",), ("basins", "points")) for sweep in ("ste", "backlash")),
)
CASES = (
    ("dynamics", "reference_case"),
    ("sweeps", "mesh_frequency", "cases"),
    ("sweeps", "ste", "cases"),
    ("sweeps", "backlash", "cases"),
    ("maps", "case"),
    ("figures", "diagonal"),
)
OF_STUDIES = {f"studies.<name>.{key}" for key in ("case", "settings.<name>", "grid.<name>", "members.<name>")}


def base():
    texts = [(ROOT / "config" / name).read_text(encoding="utf-8") for name in ("config.yaml", "studies/life.yaml")]
    return merged(*map(yaml.safe_load, texts))


def takes_any_text(schema):
    """Return whether a value of this JSON schema, or a part of it, may be any text."""
    kind, below = schema.get("type"), schema.get("additionalProperties", False)
    if kind == "string":
        return "enum" not in schema and "const" not in schema
    if kind == "object":
        return below is True or (isinstance(below, dict) and takes_any_text(below))
    parts = [schema["items"]] if kind == "array" else schema.get("anyOf", [])
    return not (kind or parts or "enum" in schema or "const" in schema) or any(map(takes_any_text, parts))


def put(tree, path, value):
    for key in path[:-1]:
        tree = tree[key]
    tree[path[-1]] = value


def told(raw):
    with pytest.raises(ConfigError) as refused:
        members(check(raw))
    return str(refused.value).splitlines()


@pytest.mark.parametrize("table", NAMED, ids=dotted)
def test_a_free_name_is_no_path(table):
    raw = base()
    put(raw, table, dict.fromkeys(FOREIGN, {}))
    lines = told(raw)
    for text in FOREIGN:
        path = dotted((*table, text))
        assert any(line.startswith((f"  {path}: ", f"  {path}.")) for line in lines), text


def test_every_other_text_is_one_of_a_few_words_or_the_name_of_a_case():
    names = {".".join(path) for path, field in leaves() if takes_any_text(schema_of(field))}
    assert names == {*map(".".join, CASES), *OF_STUDIES}
    for *way, last in CASES:
        raw = base()
        listed = last in ("cases", "diagonal")
        put(raw, (*way, last), ["../x", "with"] if listed else "../x")
        key = dotted((*way, last, "[0]") if listed else (*way, last))
        assert any(line.startswith(f"  {key}: text '../x' is no case") for line in told(raw)), key


def test_a_member_of_a_study_can_name_no_path_either():
    raw, overrides = base(), {"one": {"cases": {"../x": {}}}, "two": {"figures": {"diagonal": ["/etc/x", "with"]}}}
    raw["studies"] = {"own": {"members": overrides | {"three": {"studies": {"../x": {}}}}}}
    lines = told(raw)
    for member, key in (("one", dotted(("cases", "../x"))), ("two", "figures.diagonal[0]"), ("three", "studies: ")):
        assert any(line.startswith(f"  studies/own/{member}: {key}") for line in lines), member


def test_values_of_a_grid_become_names_of_folders():
    grid = {"sweeps.order": ["../x", "/etc/x"], "heat.growth": ["..", "<script>", "=1+1"]}
    names = [one.name for one in combinations(grid)]
    assert len(set(names)) == len(names)
    assert all(name.isascii() and name.replace("_", "").isalnum() for name in names), names
    raw = base()
    raw["studies"] = {"own": {"grid": {"../x": [1, 2]}}}
    assert any(line.startswith(f"  {dotted(('studies', 'own', 'grid', '../x'))}: no key") for line in told(raw))

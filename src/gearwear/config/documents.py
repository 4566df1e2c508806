"""Writer of the JSON schema and of config/README.md from the models of the configuration.

Run as `python -m gearwear.config.documents` after a change of the models, defaults or stages.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml
from pydantic.fields import FieldInfo

from gearwear.config.check import check
from gearwear.config.messages import allowed
from gearwear.config.slices import STAGES, readers
from gearwear.config.study import Configuration, leaves
from gearwear.config.text import figure
from gearwear.config.types import declared, entry_type, schema_of, unit_of

ROOT = Path(__file__).resolve().parents[3]
SCHEMA_FILE = Path("workflow/schemas/config.schema.json")
TABLE_FILE = Path("config/README.md")

_DECIDES = {"decides_targets": "which files are made", "decides_jobs": "which jobs make the files"}
_MOST_SHOWN = 4
_ESCAPES = str.maketrans({"|": r"\|", "<": r"\<"})
_INTRODUCTION = """\
# Configuration

`config.yaml` holds every value of the default study; nothing has a default elsewhere. For another
study write an overlay with only the keys that differ and name it after the first file:

    snakemake -j2 all --configfile config/config.yaml my_study.yaml

Sections are merged key by key, lists are replaced; `smoke.yaml` and the files in `presets/` are such overlays.
A plain number is in the unit of its key, SI except rpm, deg and degC, and may be written `1.0e-8` or `1e-8`.
A value may carry a unit: `3 mm`, `206 GPa`, `9.4 mPa s`, `373 K`, `0.2 kN m`; the conversion is exact. Every start
checks the whole configuration and lists all its problems in one message, each with its key, its value and what is
allowed. The column "re-runs" names the stages that read a key; stages that use their results follow.

The tables below are generated: `PYTHONPATH=src python -m gearwear.config.documents`.
"""


def schema_text() -> str:
    """Return the JSON schema (draft 2020-12) of the configuration, sorted and indented."""
    schema = _without_titles(Configuration.model_json_schema())
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    schema["title"] = "Configuration of the gear wear workflow"
    text = json.dumps(schema, indent=2, sort_keys=True, ensure_ascii=True) + "\n"
    # Generic sections are named by the types of their values, which take several lines.
    for number, name in enumerate(name for name in schema["$defs"] if "_Annotated_" in name):
        kind = re.split("_+Annotated_", name)[0].rpartition("__")[2]
        text = text.replace(name + '"', f'{kind}{number}"')
    return text


def table_text(defaults: dict[str, Any], stages: Mapping[str, tuple[str, ...]]) -> str:
    """Return config/README.md.

    Parameters
    ----------
    defaults : the checked default configuration.
    stages : stage name -> dotted keys or sections it reads; `case` stands for the case at hand in `cases`,
        `{sweep}` and `{case}` for any sweep and case.
    """
    lines = [_INTRODUCTION.rstrip()]
    for name, field in Configuration.model_fields.items():
        entry = entry_type(field.annotation)
        meaning = (field.annotation if entry is None else entry).__doc__ or ""
        lines += ["", f"## {name}", "", meaning, ""]
        lines += ["| key | unit | allowed | default | meaning | re-runs |", "| --- | --- | --- | --- | --- | --- |"]
        lines += [_row(path, leaf, defaults, stages) for path, leaf in leaves() if path[0] == name]
    return "\n".join(lines) + "\n"


def write(root: Path = ROOT) -> None:
    """Write both files below `root`."""
    defaults = check(yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8")))
    for file, text in ((SCHEMA_FILE, schema_text()), (TABLE_FILE, table_text(defaults, STAGES))):
        (root / file).parent.mkdir(parents=True, exist_ok=True)
        (root / file).write_text(text, encoding="utf-8")


def _without_titles(schema: Any) -> Any:
    if isinstance(schema, list):
        return [_without_titles(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    return {
        key: _without_titles(value)
        for key, value in schema.items()
        if not (key == "title" and isinstance(value, str)) and key not in (*_DECIDES, "entries")
    }


def _row(
    path: tuple[str, ...], field: FieldInfo, defaults: dict[str, Any], stages: Mapping[str, tuple[str, ...]]
) -> str:
    decided = [what for mark, what in _DECIDES.items() if declared(field, mark)]
    cells = (
        f"`{'.'.join(path)}`",
        unit_of(field) or "-",
        allowed(schema_of(field)),
        _default(defaults, path),
        field.description or "",
        f"none: decides {decided[0]}" if decided else ", ".join(readers(path, stages)),
    )
    return f"| {' | '.join([cells[0], *(cell.translate(_ESCAPES) for cell in cells[1:])])} |"


def _default(values: Any, path: tuple[str, ...]) -> str:
    for position, key in enumerate(path):
        if key in ("<case>", "<name>"):
            rest = path[position + 1 :]
            return ", ".join(f"{name}: {_default(value, rest)}" for name, value in values.items())
        values = values[key]
    if isinstance(values, list):
        shown = ", ".join(_default(value, ()) for value in values[:_MOST_SHOWN])
        return f"[{shown}]" if len(values) <= _MOST_SHOWN else f"{len(values)} values"
    if isinstance(values, str):
        return values
    return json.dumps(values) if values is None or isinstance(values, bool) else figure(values)


if __name__ == "__main__":
    write()

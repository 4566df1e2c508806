"""The JSON schema of the configuration, and the tables of its keys for the documentation, both from the models.

Run as `python -m gearwear.config.documents` after a change of the models to write the schema.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic.fields import FieldInfo

from gearwear.config.messages import allowed
from gearwear.config.slices import readers
from gearwear.config.study import Configuration, leaves
from gearwear.config.text import figure
from gearwear.config.types import declared, entry_type, schema_of, unit_of

ROOT = Path(__file__).resolve().parents[3]
SCHEMA_FILE = Path("workflow/schemas/config.schema.json")

_DECIDES = {"decides_targets": "which files are made", "decides_jobs": "which jobs make the files"}
_MOST_SHOWN = 4
_ESCAPES = str.maketrans({"|": r"\|", "<": r"\<"})


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
    """Return the tables of all keys in Markdown, one for every section.

    Parameters
    ----------
    defaults : the checked default configuration.
    stages : stage name -> dotted keys or sections it reads; `case` stands for the case at hand in `cases`,
        `{sweep}` and `{case}` for any sweep and case.
    """
    lines: list[str] = []
    for name, field in Configuration.model_fields.items():
        entry = entry_type(field.annotation)
        meaning = (field.annotation if entry is None else entry).__doc__ or ""
        lines += ["", f"## {name}", "", meaning, ""]
        lines += ["| key | unit | allowed | default | meaning | re-runs |", "| --- | --- | --- | --- | --- | --- |"]
        lines += [_row(path, leaf, defaults, stages) for path, leaf in leaves() if path[0] == name]
    return "\n".join(lines[1:]) + "\n"


def write(root: Path = ROOT) -> None:
    """Write the schema below `root`."""
    (root / SCHEMA_FILE).parent.mkdir(parents=True, exist_ok=True)
    (root / SCHEMA_FILE).write_text(schema_text(), encoding="utf-8")


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

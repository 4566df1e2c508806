"""The data dictionary in docs/data.md, made from the table of fields.

Run as ``python -m gearwear.io.data_dictionary`` after a change of ``fields.py``.
"""

from __future__ import annotations

from pathlib import Path

from gearwear.io.variables import Variable, variables

FILE = Path(__file__).parents[3] / "docs" / "data.md"

_MOST_FLAGS = 8
_HEAD = """# Data dictionary

Made from `src/gearwear/io/variables.py` by `PYTHONPATH=workflow/scripts python -m gearwear.io.data_dictionary`. Every
variable of every result file stands here, with the unit and the name that its attributes `units` and `long_name` carry.
A dimension named like a variable is a coordinate. Flags are the numbers of `flag_values` with their `flag_meanings`.
Where a name stands twice, the dimensions tell which is meant. (nan) marks what may be missing.

| variable | unit | dimensions | meaning |
| --- | --- | --- | --- |
"""


def text() -> str:
    """Return the page."""
    return _HEAD + "".join(_row(name.removeprefix("swept "), field) for name, field in variables().items())


def write() -> None:
    """Write the page."""
    FILE.write_text(text(), encoding="utf-8")


def _row(name: str, field: Variable) -> str:
    shapes = " or ".join(f"({', '.join(dims)})" if dims else "scalar" for dims in field.dims)
    flags = list((field.flags or {}).items())
    shown = [f"{number} {word}" for word, number in flags[:_MOST_FLAGS]]
    if len(flags) > _MOST_FLAGS:
        shown += ["…", *(f"{number} {word}" for word, number in flags[-2:])]
    meaning = field.long_name + (f": {', '.join(shown)}" if shown else "") + (" (nan)" if field.may_be_missing else "")
    return f"| `{name}` | {field.units or '-'} | {shapes} | {meaning} |\n"


if __name__ == "__main__":
    write()

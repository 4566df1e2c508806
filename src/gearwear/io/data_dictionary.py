"""The data dictionary: every variable of the result files as a table in Markdown, for the documentation."""

from __future__ import annotations

from gearwear.io.variables import Variable, variables

_MOST_FLAGS = 8
_HEAD = """\
| variable | unit | dimensions | meaning |
| --- | --- | --- | --- |
"""


def text() -> str:
    """Return the table."""
    return _HEAD + "".join(_row(name.removeprefix("swept "), field) for name, field in variables().items())


def _row(name: str, field: Variable) -> str:
    shapes = " or ".join(f"({', '.join(dims)})" if dims else "scalar" for dims in field.dims)
    flags = list((field.flags or {}).items())
    shown = [f"{number} {word}" for word, number in flags[:_MOST_FLAGS]]
    if len(flags) > _MOST_FLAGS:
        shown += ["…", *(f"{number} {word}" for word, number in flags[-2:])]
    meaning = field.long_name + (f": {', '.join(shown)}" if shown else "") + (" (nan)" if field.may_be_missing else "")
    return f"| `{name}` | {field.units or '-'} | {shapes} | {meaning} |\n"

"""The targets of the workflow as a page of help, from the docstrings of the rules in workflow/Snakefile."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import NamedTuple

_RULE = re.compile(r'^rule (\w+):\n    """(.+?)"""', flags=re.MULTILINE | re.DOTALL)
_WIDTH, _MARGIN = 110, 14
_HEAD = """\
snakemake -j2 TARGET does only what is missing or out of date. Costs are those of the default study, in time
of one processor; a short job takes 2 s, most of it the start of Python.

"""
_FOOT = """
A target may also be the name of a result file. -n says what would run, and why; --directory FOLDER works
elsewhere; --configfile config/config.yaml mine.yaml lays changes over the configuration.
"""


class Target(NamedTuple):
    """A rule to ask for by name: what it makes, and what that costs."""

    name: str
    makes: str
    cost: str


def targets(snakefile: Path) -> list[Target]:
    """Return the targets in the order of the Snakefile; the docstring of each ends with `Cost: …`, if it has one."""
    found = []
    for name, docstring in _RULE.findall(snakefile.read_text(encoding="utf-8")):
        makes, _, cost = " ".join(docstring.split()).partition(" Cost: ")
        found.append(Target(name, makes, cost))
    return found


def page(snakefile: Path) -> str:
    """Return the help."""
    lines = []
    for target in targets(snakefile):
        text = target.makes + (f" Cost: {target.cost}" if target.cost else "")
        margin = " " * _MARGIN
        lines.append(textwrap.fill(text, _WIDTH, initial_indent=f"{target.name:<{_MARGIN}}", subsequent_indent=margin))
    return _HEAD + "\n".join(lines) + "\n" + _FOOT


def asked(arguments: list[str], target: str) -> bool:
    """Return whether a command line of snakemake asks for one target and for nothing else."""
    return [word for word in arguments if not re.fullmatch(r"-.*|\d+", word)] == [target]

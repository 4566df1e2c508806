"""Tables as CSV, and as a page that needs no other file."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from gearwear.io.atomic import atomic

_OF_FORMULAS = ("=", "+", "-", "@", "\t", "\r")


class Table(NamedTuple):
    """Names of the columns, and rows of texts or numbers."""

    columns: Sequence[str]
    rows: Sequence[Sequence[Any]]

    @classmethod
    def of(cls, rows: Sequence[Mapping[str, Any]]) -> Table:
        """Return the table of rows with the same keys, at least one row."""
        return cls(tuple(rows[0]), [tuple(row.values()) for row in rows])


def page_of(table: Table, template: Path, title: str) -> str:
    """Return the table as HTML, all text escaped.

    Parameters
    ----------
    template : file of a Jinja template with `title`, `columns` and `rows`.
    """
    return render(template.read_text(encoding="utf-8"), title=title, columns=table.columns, rows=table.rows)


def render(template: str, **values: Any) -> str:
    """Return a Jinja template with values in their places, all text escaped."""
    import jinja2  # most tables need no page

    environment = jinja2.Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
    return environment.from_string(template).render(values)


def write_csv(path: str | Path, columns: Iterable[str], rows: Iterable[Iterable[Any]]) -> None:
    """Write a table as CSV, complete or not at all; a number as the shortest text that reads back as the same one.

    Text that a spreadsheet would take for a formula gets an apostrophe before it.
    """
    with atomic(path) as temporary, open(temporary, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([map(_inert, row) for row in (columns, *rows)])


def _inert(cell: Any) -> Any:
    if not isinstance(cell, str) or cell == "-" or not cell.startswith(_OF_FORMULAS):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell

"""Tables as CSV, and as a page that needs no other file."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from gearwear.io import store

_OF_FORMULAS = ("=", "+", "-", "@", "\t", "\r")


def write_rows(rows: Sequence[Mapping[str, str]], path: str) -> None:
    """Write rows with the same keys, at least one, as CSV, complete or not at all."""
    write_csv(path, rows[0], (row.values() for row in rows))


def write(job, title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Write the table as the outputs of `job`; all text on the page is escaped.

    Parameters
    ----------
    job : object with `input.template` (Jinja), `output.csv` and `output.html`.
    title : of the page.
    columns, rows : of the table.
    """
    import jinja2  # most tables need no page

    rows = list(rows)
    environment = jinja2.Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
    template = environment.from_string(Path(job.input.template).read_text(encoding="utf-8"))
    write_csv(job.output.csv, columns, rows)
    with store.atomic(job.output.html) as page:
        Path(page).write_text(template.render(title=title, columns=columns, rows=rows), encoding="utf-8")


def write_csv(path: str, columns: Iterable[str], rows: Iterable[Iterable[Any]]) -> None:
    """Write a table as CSV, complete or not at all; a number as the shortest text that reads back as the same one.

    Text that a spreadsheet would take for a formula gets an apostrophe before it.
    """
    with store.atomic(path) as temporary, open(temporary, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([map(_inert, row) for row in (columns, *rows)])


def _inert(cell: Any) -> Any:
    if not isinstance(cell, str) or cell == "-" or not cell.startswith(_OF_FORMULAS):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell

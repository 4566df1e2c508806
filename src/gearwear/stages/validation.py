"""Stages of the validation: groups of checks, and the page of all of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from gearwear.figures import validation_page as page
from gearwear.io.tables import Table
from gearwear.run.stage import log, report
from gearwear.validation import outcomes
from gearwear.validation.checks import read, titles
from gearwear.validation.groups import QUANTITIES


def validation_group(checks: Path, group: str) -> Table:
    """Return what the checks of a group find."""
    own = [check for check in read(checks) if check.group == group]
    found = [outcomes.compute(check, QUANTITIES[group]) for check in own]
    log.info("%s", outcomes.summary(found))
    return Table.of(outcomes.rows(found))


def validation_page(checks: Path, found: list[Path], figures: list[Path], template: Path) -> dict[str, Any]:
    """Return all checks as a `table` and as a `page`."""
    rows = [row for path in found for row in outcomes.read_rows(path)]
    results = outcomes.merged(read(checks), rows)
    drawn = {path.stem: path.read_bytes() for path in figures}
    report(f"Validation: {outcomes.summary(results)}.")
    text = page.page(template.read_text(encoding="utf-8"), results, titles(checks), drawn)
    return {"table": Table.of(rows), "page": text}

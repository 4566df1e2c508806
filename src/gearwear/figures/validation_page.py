"""The validation as one page: every check with its source, what was found, and a figure a group."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from typing import Any

from gearwear.io.tables import render
from gearwear.validation.outcomes import AGREES, Outcome, summary


def page(template: str, outcomes: Sequence[Outcome], titles: Mapping[str, str], figures: Mapping[str, bytes]) -> str:
    """Return the page as HTML that needs no other file; all text is escaped.

    Parameters
    ----------
    template : of the page, Jinja.
    outcomes : of all checks.
    titles : of the groups, in the order of the page.
    figures : SVG of every group.
    """
    groups: list[dict[str, Any]] = []
    for name, title in titles.items():
        members = [outcome for outcome in outcomes if outcome.check.group == name]
        image = base64.b64encode(figures[name]).decode("ascii")
        groups.append({"title": title, "checks": [_shown(one) for one in members], "image": image})
        groups[-1]["agree"] = sum(one.verdict == AGREES for one in members)
    return render(template, groups=groups, summary=summary(list(outcomes)))


def _shown(outcome: Outcome) -> dict[str, Any]:
    check = outcome.check
    numbers = [
        {
            "at": f"{check.along.replace('_', ' ')} {at}".strip(),
            "expected": f"{expected:.10g}",
            "found": f"{found:.12g}",
            "tolerance": f"{tolerance:.3g}",
            "agrees": agrees,
        }
        for at, expected, found, tolerance, agrees in zip(
            check.at, check.expected, outcome.found, check.tolerance, outcome.agreements, strict=True
        )
    ]
    return {
        "id": f"{check.group}.{check.id}",
        "says": check.says,
        "source": check.source,
        "unit": "" if check.unit == "1" else check.unit,
        "remarks": [text for text in (check.note, check.differs) if text],
        "verdict": outcome.verdict,
        "numbers": numbers,
    }

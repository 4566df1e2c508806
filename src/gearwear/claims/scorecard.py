"""The scorecard: one verdict on each statement of the reference paper."""

from collections.abc import Iterable, Mapping
from typing import Any

from gearwear.claims import rules
from gearwear.claims.events import judge_event
from gearwear.claims.properties import PROPERTIES
from gearwear.claims.study import Study, Undecided
from gearwear.claims.sweeps import read_sweep
from gearwear.claims.windows import judge_window_of_cases
from gearwear.errors import BadFile

COLUMNS = ("id", "figure", "says", "expected", "found", "verdict")
VERDICTS = {True: rules.AGREE, False: rules.DIFFERS, None: rules.NOT_DECIDED}


def evaluate(
    claims: dict[str, Any], results: Mapping[Any, Any], diagonal: Iterable[tuple[str, int]]
) -> list[dict[str, str]]:
    """Return one row a claim, in the order of the claims.

    Parameters
    ----------
    claims
        Content of config/paper_claims.yaml.
    results, diagonal
        As in `gearwear.claims.study.Study`.

    Returns
    -------
    list of dict
        Texts under id, figure, says, expected, found and verdict: agree, differs or not decided.

    Raises
    ------
    BadFile
        If a claim is of an unknown kind, class or event, or a qualitative one has no function.
    """
    study = Study(results, tuple((case, int(cycle)) for case, cycle in diagonal))
    rows = []
    for claim in claims["claims"]:
        expected = expectation(claim)
        try:
            holds, found = judge(claim, study)
        except Undecided as reason:
            holds, found = None, str(reason)
        verdict = VERDICTS[None if holds is None else bool(holds)]
        texts = (claim["id"], str(claim["figure"]), claim["says"], expected, found, verdict)
        rows.append(dict(zip(COLUMNS, texts, strict=True)))
    return rows


def judge(claim: dict[str, Any], study: Study) -> tuple[bool | None, str]:
    """Return whether the results show what `claim` says (None: not decided), and what they show."""
    if claim["kind"] == "window":
        return judge_window_of_cases(study, cases_of(claim), claim["sweep"], claim["range"], claim["class"])
    if claim["kind"] == "numeric":
        sweep = read_sweep(study, claim["case"], claim["sweep"])
        return judge_event(sweep, claim["event"], claim["expected"])
    return PROPERTIES[claim["id"]](study)


def expectation(claim: Mapping[str, Any]) -> str:
    """Return in words what the results have to show for the verdict `agree`."""
    kind = claim["kind"]
    if kind == "window":
        low, high = claim["range"]
        return f"{' or '.join(claim['class'])} in {low:.2f}-{high:.2f} ({', '.join(cases_of(claim))})"
    if kind == "numeric":
        return f"{claim['event']} at {claim['expected']:.4f} +- {rules.EVENT_TOLERANCE} ({claim['case']})"
    if kind != "qualitative":
        raise BadFile(f"claim {claim['id']}: kind {kind!r} is unknown; use qualitative, numeric or window")
    if claim["id"] not in PROPERTIES:
        raise BadFile(f"claim {claim['id']}: no function decides it; add one to gearwear.claims.properties")
    return "holds"


def cases_of(claim: Mapping[str, Any]) -> list[str]:
    """Return the cases of a window claim, given as one name or a list."""
    return [claim["case"]] if isinstance(claim["case"], str) else claim["case"]


def summary(rows: list[dict[str, str]]) -> str:
    """Return the count of the verdicts, such as "46 of 54 agree, 7 differ, 1 not decided"."""
    count = {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS.values()}
    agree, differ, open_ = count[rules.AGREE], count[rules.DIFFERS], count[rules.NOT_DECIDED]
    return f"{agree} of {len(rows)} agree, {differ} differ, {open_} not decided"

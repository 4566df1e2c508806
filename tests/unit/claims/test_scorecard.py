from pathlib import Path

import pytest
import yaml

from gearwear.claims.scorecard import evaluate, expectation, summary
from gearwear.io.tables import Table, write_csv

DIAGONAL = [("without", 0), ("middle", 1), ("with", 2)]
ROOT = Path(__file__).parents[3]
CLAIMS = yaml.safe_load((ROOT / "config/paper_claims.yaml").read_text(encoding="utf-8"))


def numeric(expected, event="P1->P2"):
    return {
        "id": "doubling",
        "figure": 14,
        "kind": "numeric",
        "case": "with",
        "sweep": "mesh_frequency",
        "event": event,
        "expected": expected,
        "says": "the period doubles",
    }


def window(classes):
    return {
        "id": "band",
        "figure": "12a",
        "kind": "window",
        "case": ["without", "with"],
        "sweep": "mesh_frequency",
        "range": [0.1, 0.58],
        "class": classes,
        "says": "a band",
    }


def verdicts(claims, results):
    return [row["verdict"] for row in evaluate({"claims": claims}, results, DIAGONAL)]


def test_row_of_a_number(results):
    (row,) = evaluate({"claims": [numeric(1.047)]}, results, DIAGONAL)
    assert row == {
        "id": "doubling",
        "figure": "14",
        "says": "the period doubles",
        "expected": "P1->P2 at 1.0470 +- 0.03 (with)",
        "found": "1.0450 (between 1.0400 and 1.0500)",
        "verdict": "agree",
    }


def test_numbers_and_windows_agree_or_differ(results):
    claims = [numeric(1.047), numeric(1.2), window(["P1"]), window(["P2", "CH"])]
    assert verdicts(claims, results) == ["agree", "differs", "agree", "differs"]


def test_missing_results_are_not_decided_and_say_which(results):
    del results["sweep", "with", "mesh_frequency"]
    rows = evaluate({"claims": [numeric(1.047), window(["P1"])]}, results, DIAGONAL)
    assert [row["verdict"] for row in rows] == ["not decided", "not decided"]
    assert rows[0]["found"] == "no result sweep/with/mesh_frequency"


def test_every_qualitative_claim_agrees_on_the_synthetic_run(results):
    claims = [claim for claim in CLAIMS["claims"] if claim["kind"] == "qualitative"]
    rows = evaluate({"claims": claims}, results, DIAGONAL)
    assert {row["id"]: row["verdict"] for row in rows} == {claim["id"]: "agree" for claim in claims}


def test_every_claim_is_not_decided_without_results():
    rows = evaluate(CLAIMS, {}, DIAGONAL)
    assert [row["id"] for row in rows] == [claim["id"] for claim in CLAIMS["claims"]]
    assert {row["verdict"] for row in rows} == {"not decided"}


def test_results_are_opened_only_when_asked_for(results):
    class Lazy(dict):
        opened = []

        def __getitem__(self, key):
            self.opened.append(key)
            return super().__getitem__(key)

    lazy = Lazy(results)
    evaluate({"claims": [numeric(1.047)]}, lazy, DIAGONAL)
    assert set(lazy.opened) == {("sweep", "with", "mesh_frequency")}


def test_unknown_kind_event_class_or_property_is_refused(results):
    wrong = [
        {**numeric(1.0), "kind": "vague"},
        numeric(1.0, "grazing"),
        window(["P0"]),
        {"id": "unheard", "figure": 1, "kind": "qualitative", "says": "anything"},
    ]
    for claim in wrong:
        with pytest.raises(ValueError, match="unknown|no function"):
            evaluate({"claims": [claim]}, results, DIAGONAL)


def test_expectation_in_words():
    assert expectation(window(["QP", "P1"])) == "QP or P1 in 0.10-0.58 (without, with)"
    assert expectation({**window(["P1"]), "case": "with"}) == "P1 in 0.10-0.58 (with)"


def test_written_table_is_the_same_twice_and_readable(results, tmp_path):
    for name in ("first.csv", "second.csv"):
        rows = evaluate({"claims": [numeric(1.047), window(["P1"])]}, results, DIAGONAL)
        write_csv(tmp_path / name, *Table.of(rows))
    first = (tmp_path / "first.csv").read_bytes()
    assert first == (tmp_path / "second.csv").read_bytes()
    lines = first.decode().split("\n")
    assert lines[0] == "id,figure,says,expected,found,verdict"
    assert lines[1].startswith("doubling,14,the period doubles,P1->P2 at 1.0470 +- 0.03 (with),")
    assert len(lines) == 4


def test_summary_counts_the_verdicts(results):
    rows = evaluate({"claims": [numeric(1.047), numeric(1.2), numeric(9.0)]}, results, DIAGONAL)
    assert summary(rows) == "1 of 3 agree, 1 differ, 1 not decided"

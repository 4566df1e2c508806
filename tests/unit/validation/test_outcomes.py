"""Verdicts on numbers, and their table."""

import pytest

from gearwear.io.tables import Table, write_csv
from gearwear.validation import outcomes
from gearwear.validation.checks import Check
from gearwear.validation.outcomes import AGREES, DIFFERS, Outcome

CHECK = Check(
    "some", "one", "says", "source", "values", {}, "", ("a", "b"), "mm", (1.0, 2.0), (0.5, 0.0), "absolute", "", "", "",
    "",
)  # fmt: skip


@pytest.mark.parametrize(
    ("found", "agreements"),
    [
        ((1.5, 2.0), (True, True)),
        ((0.5, 2.0), (True, True)),
        ((1.5001, 2.0), (False, True)),
        ((1.0, 2.0000001), (True, False)),
        ((float("nan"), 2.0), (False, True)),
    ],
)
def test_a_number_agrees_within_its_own_tolerance(found, agreements):
    outcome = Outcome(CHECK, found)
    assert outcome.agreements == agreements
    assert outcome.verdict == (AGREES if all(agreements) else DIFFERS)


def test_what_is_found_is_given_in_the_unit_of_the_check():
    outcome = outcomes.compute(CHECK, {"values": lambda: (1.2e-3, 2.0e-3)})
    assert outcome.found == pytest.approx((1.2, 2.0))


def test_a_quantity_is_asked_for_every_value():
    check = CHECK._replace(along="x", at=("3", "4"), unit="1", given={"factor": 10.0})
    assert outcomes.compute(check, {"values": lambda factor, x: factor * x}).found == (30.0, 40.0)


@pytest.mark.parametrize(
    ("quantities", "words"),
    [({"other": lambda: 0.0}, "'values' is unknown; it may be other"), ({"values": lambda: (1.0,) * 3}, "2 expected")],
)
def test_unknown_quantities_and_other_counts_are_refused(quantities, words):
    with pytest.raises(ValueError, match=words):
        outcomes.compute(CHECK, quantities)


def test_a_table_read_again_gives_the_same_outcomes(tmp_path):
    first = Outcome(CHECK, (1.0 + 1 / 3, 2.0))
    second = Outcome(CHECK._replace(id="two", differs="it is known to"), (7.0, 2.0))
    write_csv(tmp_path / "table.csv", *Table.of(outcomes.rows([first, second])))
    rows = outcomes.read_rows(tmp_path / "table.csv")
    assert [row["verdict"] for row in rows] == [AGREES, AGREES, DIFFERS, AGREES]
    assert rows[2]["note"] == "it is known to"
    again = outcomes.merged([first.check, second.check], rows)
    assert [one.agreements for one in again] == [first.agreements, second.agreements]
    assert again[0].found == pytest.approx(first.found, rel=1e-14)
    assert outcomes.summary(again) == "1 of 2 checks agree, 3 of 4 numbers"

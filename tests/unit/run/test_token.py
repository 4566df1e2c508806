"""Jobs on other machines do what was planned, or nothing."""

import pytest

from gearwear.run import token
from gearwear.run.lock import LOCK

CONFIG = {"wear": {"pressure": 1.0}, "cases": {"with": {"running_cycles": 1e8}}}
KEY = "0" * 16  # of the sources of the package


@pytest.fixture
def sources(tmp_path):
    (tmp_path / "rules").mkdir()
    (tmp_path / "rules" / "state.smk").write_text("rule one:\n")
    (tmp_path / "stage.py").write_text("X = 1\n")
    (tmp_path / "notes.md").write_text("notes\n")
    return tmp_path


@pytest.fixture
def working(tmp_path, monkeypatch):
    """A working directory in which a run holds the lock, and no orders yet."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv(token.VARIABLE, "")
    monkeypatch.delenv(token.VARIABLE)
    LOCK.parent.mkdir()
    LOCK.write_text("first")


@pytest.mark.parametrize("name, text", [("stage.py", "X = 2\n"), ("rules/state.smk", "rule two:\n"), ("new.py", "")])
def test_the_plan_follows_every_source(sources, name, text):
    before = token.plan_of(CONFIG, sources, KEY)
    (sources / name).write_text(text)
    assert token.plan_of(CONFIG, sources, KEY) != before


def test_the_plan_follows_the_settings_but_not_their_order_nor_other_files(sources):
    before = token.plan_of(CONFIG, sources, KEY)
    (sources / "notes.md").write_text("other notes\n")
    assert token.plan_of(dict(reversed(CONFIG.items())), sources, KEY) == before
    assert token.plan_of(CONFIG | {"wear": {"pressure": 2.0}}, sources, KEY) != before
    assert token.plan_of(CONFIG, sources, "of other sources") != before


def test_a_job_that_finds_the_plan_goes_on(working):
    token.give("plan", "first")
    token.check_plan("plan")
    token.check_run()


def test_a_job_that_finds_another_plan_stops(working):
    token.give("plan", "first")
    with pytest.raises(token.Outdated, match="changed while the workflow was running.*start the workflow again"):
        token.check_plan("another")


def test_a_job_without_its_orders_stops(working):
    with pytest.raises(token.Outdated, match=f"{token.VARIABLE} is not set"):
        token.check_plan("plan")


def test_a_job_of_a_run_that_another_has_followed_stops(working):
    token.give("plan", "first")
    LOCK.write_text("second")
    with pytest.raises(token.Outdated, match="followed by another.*scancel"):
        token.check_run()


@pytest.mark.parametrize("given, held", [(None, "first"), ("plan", "first"), ("plan first", ""), ("plan first", None)])
def test_where_nothing_tells_of_another_run_a_job_goes_on(working, monkeypatch, given, held):
    if given:
        monkeypatch.setenv(token.VARIABLE, given)
    LOCK.unlink() if held is None else LOCK.write_text(held)
    token.check_run()

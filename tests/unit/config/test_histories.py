"""Wear histories: which cases share one, and how long it is."""

import copy
from pathlib import Path

import pytest
import yaml

from gearwear.config.check import check
from gearwear.config.histories import blocks, histories, history_of, updates_of

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def default():
    return check(yaml.safe_load((ROOT / "config" / "config.yaml").read_text(encoding="utf-8")))


def changed(config, key, value):
    result = copy.deepcopy(config)
    *groups, last = key.split(".")
    below = result
    for group in groups:
        below = below[group]
    below[last] = value
    return result


def test_a_longer_life_shares_the_history_and_asks_for_more_of_it(default):
    longer = changed(default, "cases.with.running_cycles", 3_000_000_000)
    assert history_of(longer, "with") == history_of(default, "with")
    (one,) = histories([(default, "with"), (longer, "with"), (default, "with")]).values()
    assert one["updates"] == 30 == updates_of(longer, "with") and updates_of(default, "with") == 21


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("cases.with.bulk_temperature", 90.0),
        ("cases.with.flash", False),
        ("cases.without.bulk_temperature", 25.0),  # the reference scales the excitation
        ("gear_pair.module", 3e-3),
        ("wear.cycles_per_update", 3e8),
        ("dynamics.damping_ratio", 0.08),
        ("settling.sampled_periods", 480),
    ],
)
def test_what_the_states_depend_on_names_another_history(default, key, value):
    assert history_of(changed(default, key, value), "with") != history_of(default, "with")


@pytest.mark.parametrize(("key", "value"), [("sweeps.mesh_frequency.points", 11), ("cases.n0700_t060.flash", False)])
def test_what_they_do_not_depend_on_names_the_same(default, key, value):
    assert history_of(changed(default, key, value), "with") == history_of(default, "with")


def test_blocks_follow_each_other_to_the_last_cycle_of_every_case():
    found = blocks({"new": 0, "short": 2, "worn": 7, "old": 6}, 3)
    assert found == {(1, 2): ["short"], (1, 3): ["worn", "old"], (4, 6): ["worn", "old"], (7, 7): ["worn"]}


def test_a_block_of_one_cycle_is_none():
    assert blocks({"worn": 3}, 1) == {}

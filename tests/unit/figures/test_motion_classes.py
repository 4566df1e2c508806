"""Runs of one motion class, and names of classes on paper."""

import numpy as np

from gearwear.figures.motion_classes import keys, name_of, runs, short


def test_runs_meet_midway_between_points_and_cover_the_axis():
    swept = np.array([0.0, 1.0, 2.0, 4.0, 5.0])
    assert runs(swept, ["P1", "P1", "P2", "CH", "CH"]) == [(0.0, 1.5, "P1"), (1.5, 3.0, "P2"), (3.0, 5.0, "CH")]


def test_runs_of_one_point():
    assert runs(np.array([1.0]), ["P1"]) == [(1.0, 1.0, "P1")]


def test_names_of_codes():
    assert [name_of(code) for code in (0, 1, 16, 100, 101)] == ["not_converged", "P1", "P16", "QP", "CH"]
    assert short("not_converged") == "?"


def test_keys_name_every_class_once_and_other_periods_together():
    labels = [key.get_label() for key in keys({"CH", "P5", "P7", "P1", "not_converged"})]
    assert labels == ["P1", "other period", "CH, chaotic", "?, not decided"]

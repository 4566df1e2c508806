"""Figure and page of the checks."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from gearwear.figures import validation_group, validation_page
from gearwear.validation.checks import Check
from gearwear.validation.outcomes import Outcome

PLAIN = Check(
    "some", "one", "plain <check>", "source & more", "q", {}, "", ("a", "b"), "mm", (1.0, 2.0), (0.5, 0.1), "absolute",
    "", "", "a note", "",
)  # fmt: skip
CURVE = PLAIN._replace(id="two", along="points", at=("4", "8"), expected=(0.0, 0.0), panel="Error", label="all")


def drawn(*outcomes):
    figure = Figure(figsize=(175 / 25.4, validation_group.height(outcomes) / 25.4))
    validation_group.draw_outcomes(figure, outcomes)
    return figure.axes


def test_dots_are_deviations_over_tolerances_and_crosses_are_outside():
    (strip,) = drawn(Outcome(PLAIN, (1.25, 2.05)), Outcome(PLAIN, (0.0, 1.0)))
    marks = [(line.get_marker(), line.get_xydata()) for line in strip.lines if line.get_marker() in "oX"]
    inside = np.concatenate([data for marker, data in marks if marker == "o"])
    outside = np.concatenate([data for marker, data in marks if marker == "X"])
    np.testing.assert_allclose(inside, [(0.5, 0), (0.5, 0)])
    assert outside[:, 1].tolist() == [1, 1] and (outside[:, 0] < -1).all()
    assert [text.get_text() for text in strip.texts] == ["-10"]
    assert [label.get_text() for label in strip.get_yticklabels()] == ["plain <check>"] * 2


def test_an_exact_number_without_tolerance_is_in_the_middle():
    (strip,) = drawn(Outcome(PLAIN._replace(tolerance=(0.0, 0.0)), (1.0, 2.0)))
    (dots,) = [line for line in strip.lines if line.get_marker() == "o"]
    assert dots.get_xdata().tolist() == [0.0, 0.0]


def test_errors_fall_on_logarithmic_scales():
    _, panel = drawn(Outcome(PLAIN, (1.0, 2.0)), Outcome(CURVE, (-1e-3, 1e-6)))
    assert panel.get_xscale() == panel.get_yscale() == "log"
    assert panel.lines[0].get_xydata().tolist() == [[4.0, 1e-3], [8.0, 1e-6]]
    assert panel.get_title(loc="left") == "(b) Error"


def test_a_curve_is_drawn_beside_what_is_expected():
    check = CURVE._replace(expected=(3.0, 4.0))
    _, panel = drawn(Outcome(PLAIN, (1.0, 2.0)), Outcome(check, (3.1, 4.1)))
    assert panel.lines[0].get_ydata().tolist() == [3.1, 4.1]
    (bars,) = panel.containers
    assert bars.lines[0].get_ydata().tolist() == [3.0, 4.0]


def test_page_counts_and_escapes():
    template = "{{ summary }}|{% for g in groups %}{{ g.title }} {{ g.agree }} {{ g.image }}{% for c in g.checks %}"
    template += "{{ c.says }} {{ c.source }} {{ c.verdict }} {{ c.remarks[0] }}{% endfor %}{% endfor %}"
    found = [Outcome(PLAIN, (1.0, 9.0))]
    page = validation_page.page(template, found, {"some": "Some <group>"}, {"some": b"<svg/>"})
    assert page.startswith("0 of 1 checks agree, 1 of 2 numbers|Some &lt;group&gt; 0 PHN2Zy8+")
    assert "plain &lt;check&gt; source &amp; more differs a note" in page


def test_a_group_without_figure_is_an_error():
    with pytest.raises(KeyError):
        validation_page.page("", [], {"some": "Some"}, {})

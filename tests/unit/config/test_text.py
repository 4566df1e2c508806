"""Text of configuration values."""

import pytest

from gearwear.config.text import dotted, figure, listed, shown


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0.3, "0.3"),
        (240, "240"),
        (2_100_000_000, "2.1e+9"),
        (1e-20, "1.0e-20"),
        (-6.5e-5, "-6.5e-5"),
        (0, "0"),
    ],
)
def test_figures_are_written_as_in_the_configuration_file(value, words):
    assert figure(value) == words
    assert float(words) == value


def test_text_of_lists_paths_and_values():
    assert listed(["a", "b", "c"]) == "a, b and c"
    assert listed(["a"]) == "a" and listed([]) == ""
    assert dotted(("portraits", "ste", "with", "[3]")) == "portraits.ste.with[3]"
    assert dotted(("cases", "a\nb")) == "cases.(text 'a\\nb')"
    assert shown("x" * 100) == "text '" + "x" * 40 + "...'"

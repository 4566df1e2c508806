"""How checks are read."""

import pytest
import yaml

from gearwear.validation.checks import read

ENTRY = {"id": "one", "says": "one is one", "source": "closed", "quantity": "same", "expected": 1.0, "absolute": 0.1}


@pytest.fixture
def file_of(tmp_path):
    def write(*entries):
        path = tmp_path / "checks.yaml"
        path.write_text(yaml.safe_dump({"sources": {"closed": "closed form"}, "groups": {"some": list(entries)}}))
        return path

    return write


def test_a_plain_check(file_of):
    (check,) = read(file_of(ENTRY))
    assert (check.group, check.id, check.source) == ("some", "one", "closed form")
    assert (check.expected, check.tolerance, check.at, check.kind) == ((1.0,), (0.1,), ("",), "absolute")


def test_relative_tolerances_are_of_each_expected_number(file_of):
    entry = {**ENTRY, "expected": [2.0, -400.0], "at": ["first", "second"], "relative": 0.01}
    entry.pop("absolute")
    (check,) = read(file_of(entry))
    assert check.tolerance == pytest.approx((0.02, 4.0))
    assert check.at == ("first", "second")


def test_one_expected_number_holds_along_all_values(file_of):
    (check,) = read(file_of({**ENTRY, "along": {"points": [4, 8, 16]}}))
    assert (check.along, check.at) == ("points", ("4", "8", "16"))
    assert (check.expected, check.tolerance) == ((1.0,) * 3, (0.1,) * 3)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"source": "hearsay"}, ["some, one", "hearsay", "closed"]),
        ({"unit": "furlong"}, ["some, one", "furlong", "mm"]),
        ({"relative": 0.1}, ["either relative or absolute"]),
        ({"absolute": None}, ["either relative or absolute"]),
        ({"expected": [1.0, 2.0], "at": ["a", "b", "c"]}, ["2 expected numbers", "3 places"]),
        ({"along": {"x": [1.0], "y": [2.0]}}, ["one parameter"]),
        ({"tolerance": 3}, ["some, one", "tolerance", "Extra"]),
        ({"expected": "much"}, ["some, one", "expected"]),
    ],
)
def test_a_bad_check_is_named_with_its_remedy(file_of, changes, words):
    path = file_of({**ENTRY, **changes})
    with pytest.raises(ValueError) as caught:
        read(path)
    for word in [str(path), *words]:
        assert word in str(caught.value)


def test_every_check_has_a_name_of_its_own(file_of):
    with pytest.raises(ValueError, match="some.one"):
        read(file_of(ENTRY, ENTRY))

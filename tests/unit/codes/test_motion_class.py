"""Names and codes of the classes of motion."""

import pytest

from gearwear.codes import motion_class


def test_names_and_codes_belong_together():
    assert motion_class.class_name(0) == "not_converged"
    assert motion_class.class_name(1) == "P1"
    assert motion_class.class_name(16) == "P16"
    assert motion_class.class_name(motion_class.QUASI_PERIODIC) == "QP"
    assert motion_class.class_name(motion_class.CHAOTIC) == "CH"
    assert len(set(motion_class.FLAG_VALUES)) == len(motion_class.FLAG_MEANINGS) == len(set(motion_class.FLAG_MEANINGS))
    assert len(motion_class.REASON_VALUES) == len(motion_class.REASON_MEANINGS)


def test_unknown_code_is_refused():
    with pytest.raises(ValueError, match="code 99"):
        motion_class.class_name(99)

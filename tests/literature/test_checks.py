"""Every check of config/validation.yaml, which names source and tolerance next to each number.

A check that is known to differ, and says why, has to go on differing: its remark would be out of date otherwise.
"""

from pathlib import Path

import pytest

from gearwear.validation.checks import read
from gearwear.validation.groups import QUANTITIES
from gearwear.validation.outcomes import AGREES, DIFFERS, compute

CHECKS = read(Path(__file__).resolve().parents[2] / "config" / "validation.yaml")


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: f"{check.group}.{check.id}")
def test_check(check):
    outcome = compute(check, QUANTITIES[check.group])
    assert outcome.verdict == (DIFFERS if check.differs else AGREES), outcome

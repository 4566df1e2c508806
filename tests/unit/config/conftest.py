"""The default configuration, checked."""

from pathlib import Path

import pytest
import yaml

from gearwear.config.check import check


@pytest.fixture
def config():
    """The checked default configuration."""
    file = Path(__file__).resolve().parents[3] / "config" / "config.yaml"
    return check(yaml.safe_load(file.read_text(encoding="utf-8")))

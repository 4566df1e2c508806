"""The default configuration, checked."""

from pathlib import Path

import pytest
import yaml

from gearwear.config.check import check


@pytest.fixture(scope="session")
def repository():
    """Folder of the program."""
    return Path(__file__).resolve().parents[3]


@pytest.fixture
def config(repository):
    """The checked default configuration."""
    return check(yaml.safe_load((repository / "config/config.yaml").read_text(encoding="utf-8")))

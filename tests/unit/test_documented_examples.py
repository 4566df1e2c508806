"""The examples of the library in the documents run, and give what their comments say."""

import re
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def examples(name: str) -> str:
    """Return the blocks of Python in a document, one after another."""
    blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    return "\n".join(blocks)


def test_the_page_of_the_library():
    names: dict = {}
    exec(examples("docs/how-to/library.md"), names)
    sweep, branches, basins = (names[name] for name in ("sweep", "branches", "basins"))
    assert sweep.period.values[0] == 1 and (sweep.period.values == 2).any() and (sweep.period.values == 0).any()
    assert branches.sizes["branch"] >= 2
    assert basins.share.sum().item() == pytest.approx(1)
    assert names["last"].wear_depth.max().item() == pytest.approx(0.2e-6, rel=0.3)


def test_the_first_example_of_the_readme():
    names: dict = {}
    exec(examples("README.md"), names)
    assert np.isclose(names["pair"].mesh_stiffness().mesh_stiffness.mean(), 3.0e8, rtol=0.02)

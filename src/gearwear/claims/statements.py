"""The statements of the reference paper, as their file lists them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml


def read(path: str | Path) -> list[dict[str, Any]]:
    """Return the statements of a file such as config/paper_claims.yaml."""
    return yaml.safe_load(Path(path).read_text(encoding="utf-8"))["claims"]

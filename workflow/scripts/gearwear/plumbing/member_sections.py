"""Sections of the configuration that describe studies made of members."""

from __future__ import annotations

from typing import Any

from gearwear.plumbing.key_types import CaseName, Section, table


class Study(Section):
    """Members: the same study with a few keys overridden, each computed in results/studies/STUDY/MEMBER."""

    members: dict[CaseName, dict[Any, Any]] = table(
        "Keys in which the member differs from this configuration, nested as here.", "members"
    )

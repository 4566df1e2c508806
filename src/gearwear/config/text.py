"""Text of configuration values, the same in messages, tables and figures."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Decimal
from typing import Any

Path = tuple[Any, ...]  # keys; a position in a list is "[i]"
Problem = tuple[Path, str]  # of a key, and the message

_PLAIN_KEY = re.compile(r"[A-Za-z0-9_-]{1,60}", re.ASCII)
_LONGEST_TEXT = 40
_LARGEST_SHOWN = 10**30


def shown(value: Any) -> str:
    """Return a short, safe text of any configuration value."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        cut = value if len(value) <= _LONGEST_TEXT else value[:_LONGEST_TEXT] + "..."
        return f"text {ascii(cut)}"
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, int | float):
        return figure(value) if abs(value) < _LARGEST_SHOWN else "a number beyond 1.0e+30"
    if isinstance(value, Mapping):
        return "a group of keys"
    if isinstance(value, list | tuple):
        return f"a list of {len(value)}"
    return f"a value of type {type(value).__name__}"


def dotted(path: Path) -> str:
    """Return `path` as a.b.c; positions in a list are ("[i]",) entries and follow without a dot."""
    name = ""
    for key in path:
        if isinstance(key, str) and re.fullmatch(r"\[\d+\]", key):
            name += key
        else:
            plain = isinstance(key, str) and _PLAIN_KEY.fullmatch(key)
            name += ("." if name else "") + (key if plain else f"({shown(key)})")
    return name or "(whole configuration)"


def listed(words: list[str], last: str = "and") -> str:
    """Return "a, b and c"."""
    return f" {last} ".join(filter(None, [", ".join(words[:-1]), words[-1] if words else ""]))


def figure(value: float) -> str:
    """Return a number as config.yaml writes it: 0.3, 240, 2.1e+9, 1.0e-20."""
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        return repr(value)
    number = Decimal(repr(value)).normalize()
    first, *rest = number.as_tuple().digits
    return f"{'-' * (value < 0)}{first}.{''.join(map(str, rest)) or '0'}e{number.adjusted():+d}"

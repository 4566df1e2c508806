"""What a module says to the interpreter: its code without comments, layout and docstrings, and what it imports.

To parse every module takes a quarter of the time of planning, so outlines are remembered from one command to the next
in the working directory, by the content of the module.
"""

from __future__ import annotations

import ast
import hashlib
import json
import sys
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

from gearwear.io.atomic import atomic

REMEMBERED = Path(".snakemake") / "outlines.json"
_NEW: list[str] = []


class Outline(NamedTuple):
    """Digest of the code of a module, and the dotted names that it imports, sorted."""

    digest: str
    imports: tuple[str, ...]


@cache
def outline(path: Path) -> Outline:
    """Return the outline of a module."""
    content = path.read_bytes()
    known, name = _known(), hashlib.sha256(content).hexdigest()
    if name not in known:
        known[name] = _read(content)
        _NEW.append(name)
    return known[name]


def remember() -> None:
    """Keep what was read for the jobs of this run and the next command; without a place to write, they parse again."""
    if _NEW:
        with suppress(OSError, ValueError), atomic(REMEMBERED) as temporary:
            Path(temporary).write_text(json.dumps({"reader": _reader(), "modules": _known()}), encoding="utf-8")
        _NEW.clear()


def _read(content: bytes) -> Outline:
    tree = ast.parse(content)
    for node in (tree, *_statements(tree)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    names: set[str] = set()
    for node in _statements(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            names.update((node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)))
    return Outline(hashlib.sha256(ast.unparse(tree).encode()).hexdigest(), tuple(sorted(names)))


def _statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements below a node, without their expressions: neither imports nor docstrings lie in these."""
    for field in ("body", "orelse", "finalbody", "handlers", "cases"):
        below = getattr(node, field, ())
        for one in below if isinstance(below, list) else ():
            yield one
            yield from _statements(one)


@cache
def _reader() -> str:
    """Return what outlines depend on beside the modules: this one, and the language."""
    return hashlib.sha256(Path(__file__).read_bytes() + sys.version.encode()).hexdigest()


@cache
def _known() -> dict[str, Outline]:
    with suppress(OSError, ValueError, TypeError, KeyError):
        kept = json.loads(REMEMBERED.read_text(encoding="utf-8"))
        if kept["reader"] == _reader():
            return {name: Outline(digest, tuple(imports)) for name, (digest, imports) in kept["modules"].items()}
    return {}

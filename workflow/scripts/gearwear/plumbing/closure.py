"""Digest of a stage script and of every project module it can reach.

Snakemake does not see imported modules; with this digest among a rule's parameters a change of the
physics re-runs the stages that use it. Comments, layout and docstrings do not count.
"""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2]


@lru_cache(None)
def digest(script: str | Path, root: str | Path = SCRIPTS) -> str:
    """Return 16 hexadecimal digits that change with the code `script` can run.

    Parameters
    ----------
    script : the stage script.
    root : folder from which absolute imports of project modules are resolved.
    """
    total = hashlib.sha256()
    for path in closure(Path(script), Path(root)):
        name = path.relative_to(root) if path.is_relative_to(root) else path.name
        total.update(f"{name}\0{_text(path)}\0".encode())
    return total.hexdigest()[:16]


def closure(script: Path, root: Path = SCRIPTS) -> list[Path]:
    """Return the project files that `script` imports, directly or not, itself included, sorted."""
    found: set[Path] = set()
    todo = [script]
    while todo:
        path = todo.pop()
        if path in found:
            continue
        found.add(path)
        todo += _neighbours(path, root)
    return sorted(found)


@lru_cache(None)
def _text(path: Path) -> str:
    return ast.unparse(_stripped(path))


@lru_cache(None)
def _stripped(path: Path) -> ast.Module:
    tree = ast.parse(path.read_bytes())
    for node in (tree, *_statements(tree)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    return tree


def _statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements below a node, without their expressions: neither imports nor docstrings lie in these."""
    for field in ("body", "orelse", "finalbody", "handlers", "cases"):
        below = getattr(node, field, ())
        for one in below if isinstance(below, list) else ():
            yield one
            yield from _statements(one)


@lru_cache(None)
def _neighbours(path: Path, root: Path) -> tuple[Path, ...]:
    names: set[str] = set()
    for node in _statements(_stripped(path)):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            names.update((node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)))
    return tuple(sorted({file for name in names for file in _files(name, root)}))


@lru_cache(None)
def _files(name: str, root: Path) -> tuple[Path, ...]:
    parts = name.split(".")
    stems = [root.joinpath(*parts[:depth]) for depth in range(1, len(parts) + 1)]
    candidates = [file for stem in stems for file in (stem.with_suffix(".py"), stem / "__init__.py")]
    return tuple(file for file in candidates if file.is_file())

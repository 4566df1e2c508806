"""Digest of a stage script and of every project module it can reach.

Snakemake does not see imported modules; with this digest among a rule's parameters a change of the
physics re-runs the stages that use it. Comments, layout and docstrings do not count.
"""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path

from gearwear.run.outlines import outline

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
        total.update(_entry(path, Path(root)))
    return total.hexdigest()[:16]


def closure(script: Path, root: Path = SCRIPTS) -> list[Path]:
    """Return the project files that `script` imports, directly or not, itself included, sorted."""
    found: set[Path] = set()
    todo = [script]
    while todo:
        path = todo.pop()
        if path not in found:
            found.add(path)
            todo += _neighbours(path, root)
    return sorted(found)


@lru_cache(None)
def _entry(path: Path, root: Path) -> bytes:
    name = path.relative_to(root) if path.is_relative_to(root) else path.name
    return f"{name}\0{outline(path).digest}\0".encode()


@lru_cache(None)
def _neighbours(path: Path, root: Path) -> tuple[Path, ...]:
    return tuple({file for name in outline(path).imports for file in _files(name, root)})


@lru_cache(None)
def _files(name: str, root: Path) -> tuple[Path, ...]:
    """Return the files of a dotted name: its module and the packages that this lies in."""
    parts = name.split(".")
    stems = (".".join(parts[:depth]) for depth in range(1, len(parts) + 1))
    return tuple(_modules(root)[stem] for stem in stems if stem in _modules(root))


@lru_cache(None)
def _modules(root: Path) -> dict[str, Path]:
    """Return the files of all modules and packages below `root`, by dotted name."""
    # a package comes after a module of its name and, as in the language, wins
    files = [(file.relative_to(root).with_suffix("").parts, file) for file in sorted(root.rglob("*.py"), reverse=True)]
    return {".".join(parts).removesuffix(".__init__"): file for parts, file in files}

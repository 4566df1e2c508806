"""Digest of the code that a stage can run.

Snakemake does not see imported modules. With this digest among the parameters of a rule, a change of the code re-runs
the stages that use it and no others. The digest covers the functions, classes and constants of this package that a
stage reaches by name. Comments, layout, docstrings and imports for type checkers do not count.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
_READ_AND_WRITE = ("io.store:save", "io.store:load")  # every stage does
# What the keys of the configuration are: their values reach a stage as settings, their help texts no number.
_DECLARATIONS = ("config.pair", "config.study", "config.types")
_DIGITS = 16
_WHOLE = "*"  # all definitions of a module
_AT_IMPORT = ""  # what a module does when it is imported

Symbol = tuple[str, str]  # module below the package, name


@cache
def digest(target: str, package: Path = PACKAGE) -> str:
    """Return 16 hexadecimal digits that change with the code that a function can run.

    Parameters
    ----------
    target : `module:function`, the module as a dotted name below the package.
    package : folder of the package.
    """
    total = hashlib.sha256()
    for (module, name), code in sorted(reached((target, *_READ_AND_WRITE), package)):
        total.update(f"{module}\0{name}\0{code}\0".encode())
    return total.hexdigest()[:_DIGITS]


def digests(targets: Iterable[str], folder: Path) -> dict[str, str]:
    """Return the digest of each target, from `folder` where an earlier command left them for the same sources.

    A folder that cannot be read or written costs time only.
    """
    targets, file = sorted(targets), folder / f"{source_key()}.json"
    with suppress(OSError, ValueError):
        kept = json.loads(file.read_text(encoding="utf-8"))
        if sorted(kept) == targets:
            return kept
    found = {target: digest(target) for target in targets}
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        partial = file.with_suffix(f".{hashlib.sha256(str(targets).encode()).hexdigest()[:8]}.tmp")
        partial.write_text(json.dumps(found), encoding="utf-8")
        partial.replace(file)
    return found


def memory(environment: dict[str, str]) -> Path:
    """Return the folder that keeps digests from one command to the next, in the cache of the user."""
    base = environment.get("GEARWEAR_CACHE") or Path(environment.get("XDG_CACHE_HOME") or "~/.cache", "gearwear")
    return Path(base).expanduser() / "digests"


@lru_cache
def source_key(package: Path = PACKAGE) -> str:
    """Return 16 hexadecimal digits that change with every Python file of the package."""
    total = hashlib.sha256()
    for path in sorted(package.rglob("*.py")):
        total.update(f"{path.relative_to(package)}\0".encode() + path.read_bytes())
    return total.hexdigest()[:_DIGITS]


def reached(targets: Iterable[str], package: Path = PACKAGE) -> set[tuple[Symbol, str]]:
    """Return the code of every definition that the targets reach, with its module and name."""
    found: set[tuple[Symbol, str]] = set()
    seen: set[Symbol] = set()
    todo: list[Symbol] = [(module, name) for module, _, name in (target.partition(":") for target in targets)]
    while todo:
        symbol = todo.pop()
        if symbol in seen or symbol[0] in _DECLARATIONS:
            continue
        seen.add(symbol)
        codes, symbols = _definition(symbol, package)
        found.update((symbol, code) for code in codes)
        todo += symbols
    return found


@cache
def _definition(symbol: Symbol, package: Path) -> tuple[list[str], set[Symbol]]:
    """Return the code of the statements that define a symbol, and the symbols behind it."""
    module, name = symbol
    source, inner = _source(module, package), ".".join(filter(None, symbol))
    statements = source.statements(name)
    symbols = {(module, _AT_IMPORT)} | {other for statement in statements for other in source.references(statement)}
    if name == _AT_IMPORT:
        symbols |= {(other, _AT_IMPORT) for other in source.imported()}
    elif name in source.names:  # imported from elsewhere
        symbols.add(source.names[name])
    elif not statements and _file(inner, package):
        symbols.add((inner, _WHOLE))
    return [_code(statement) for statement in statements], symbols


@cache
def _source(module: str, package: Path) -> _Source:
    return _Source(module, package)


@cache
def _file(module: str, package: Path) -> Path | None:
    path = package.joinpath(*filter(None, module.split(".")))
    files = (path.with_name(f"{path.name}.py"), path / "__init__.py")
    return next((file for file in files if file.is_file()), None)


class _Source:
    """The statements of a module, by the names that they define, and what they refer to."""

    def __init__(self, module: str, package: Path) -> None:
        self.module, self._package = module, package
        self._defined: dict[str, list[ast.stmt]] = {_AT_IMPORT: []}
        self.names: dict[str, Symbol] = {}
        file = _file(module, package)
        for statement in ast.parse(file.read_bytes()).body if file else ():
            if isinstance(statement, ast.Import | ast.ImportFrom):
                self.names |= self._names_of(statement)
            elif not _never_runs(statement) and not _is_docstring(statement):
                for name in _bound(statement) or (_AT_IMPORT,):
                    self._defined.setdefault(name, []).append(statement)

    def statements(self, name: str) -> list[ast.stmt]:
        """Return the statements that define a name."""
        if name == _WHOLE:
            return [statement for several in self._defined.values() for statement in several]
        return self._defined.get(name, [])

    def imported(self) -> set[str]:
        """Return the modules that are imported with this one, the packages around it included."""
        around = self.module.split(".")[:-1]
        packages = {".".join(around[:depth]) for depth in range(len(around) + 1)}
        return packages | {self._module_of(symbol) for symbol in self.names.values()}

    def references(self, statement: ast.stmt) -> Iterator[Symbol]:
        """Yield the symbols of the package that a statement names."""
        nodes = list(ast.walk(statement))
        known = dict(self.names)
        for node in nodes:
            if isinstance(node, ast.Import | ast.ImportFrom):
                inside = self._names_of(node)
                known |= inside
                yield from ((self._module_of(symbol), _AT_IMPORT) for symbol in inside.values())
        ignored = {id(inner) for node in nodes for inner in _own(node)}
        attribute = {
            id(node.value): node.attr
            for node in nodes
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
        }
        for node in nodes:
            if not isinstance(node, ast.Name) or not isinstance(node.ctx, ast.Load) or id(node) in ignored:
                continue
            if node.id in known:
                inner = ".".join(filter(None, known[node.id]))
                whole = _file(inner, self._package) is not None
                yield (inner, attribute.get(id(node), _WHOLE)) if whole else known[node.id]
            elif node.id in self._defined:
                yield self.module, node.id

    def _names_of(self, statement: ast.Import | ast.ImportFrom) -> dict[str, Symbol]:
        if isinstance(statement, ast.Import) or not (statement.module or "").startswith(self._package.name):
            return {}
        module = (statement.module or "").removeprefix(self._package.name).removeprefix(".")
        return {alias.asname or alias.name: (module, alias.name) for alias in statement.names}

    def _module_of(self, symbol: Symbol) -> str:
        inner = ".".join(filter(None, symbol))
        return inner if _file(inner, self._package) else symbol[0]


@cache
def _code(statement: ast.stmt) -> str:
    for node in ast.walk(statement):
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    return ast.unparse(statement)


def _bound(statement: ast.stmt) -> list[str]:
    """Return the names that a definition or an assignment binds; none for a statement of another kind."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        return [statement.name]
    if isinstance(statement, ast.Assign | ast.AnnAssign):
        targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
        parts = [part for target in targets for part in (target.elts if isinstance(target, ast.Tuple) else [target])]
        if all(isinstance(part, ast.Name) for part in parts):
            return [part.id for part in parts if isinstance(part, ast.Name)]
    return []


def _own(node: ast.AST) -> Iterator[ast.AST]:
    """Yield what names nothing of the module in a function: its type hints, and its parameters where it uses them."""
    if isinstance(node, ast.FunctionDef):
        several = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg)
        parameters = {one.arg: one.annotation for one in several if one is not None}
        for hint in filter(None, (node.returns, *parameters.values())):
            yield from ast.walk(hint)
        for statement in node.body:
            yield from (one for one in ast.walk(statement) if isinstance(one, ast.Name) and one.id in parameters)


def _never_runs(statement: ast.stmt) -> bool:
    """Return whether a statement is for type checkers, or for a module that is run as a program."""
    return isinstance(statement, ast.If) and ast.unparse(statement.test) in (
        "TYPE_CHECKING",
        "typing.TYPE_CHECKING",
        "__name__ == '__main__'",
    )


def _is_docstring(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)

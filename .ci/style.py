"""What the linters do not measure: no six lines of code stand twice, no function has 100 lines, no rule file long ones.

Docstrings, comments, imports, signatures and fields of tuples do not count as repeated.
"""

import ast
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
REPEATED_LINES, FUNCTION_LINES, COLUMNS = 6, 100, 120


def uncounted(tree: ast.Module) -> set[int]:
    """Return the numbers of the lines of docstrings, imports, signatures and fields."""
    lines: set[int] = set()
    for node in ast.walk(tree):
        text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        field = isinstance(node, ast.AnnAssign) and node.value is None
        if text or field or isinstance(node, ast.Import | ast.ImportFrom):
            lines.update(range(node.lineno, node.end_lineno + 1))
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            lines.update(range(node.lineno, node.body[0].lineno))
    return lines


def code(source: str) -> list[tuple[int, str]]:
    """Return number and text of every line that counts."""
    out = uncounted(ast.parse(source))
    lines = [(number, line.strip()) for number, line in enumerate(source.splitlines(), start=1) if number not in out]
    return [(number, line) for number, line in lines if line and not line.startswith("#")]


def repeated(sources: dict[str, str]) -> list[list[str]]:
    """Return the places, name and line, of every run of lines that stands in more than one of them."""
    places = defaultdict(list)
    for name, source in sources.items():
        lines = code(source)
        for first in range(len(lines) - REPEATED_LINES + 1):
            run = lines[first : first + REPEATED_LINES]
            places[tuple(line for _, line in run)].append(f"{name}:{run[0][0]}")
    return [where for where in places.values() if len(where) > 1]


def complaints() -> Iterator[str]:
    """Yield one line for everything that is wrong."""
    python = [*sorted((ROOT / "src").rglob("*.py")), *sorted((ROOT / "workflow").rglob("*.py"))]
    sources = {str(file.relative_to(ROOT)): file.read_text(encoding="utf-8") for file in python}
    for places in repeated(sources):
        yield f"the same {REPEATED_LINES} lines: {', '.join(places)}"
    for name, source in sources.items():
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.FunctionDef) and node.end_lineno - node.lineno >= FUNCTION_LINES:
                yield f"{name}:{node.lineno}: {node.name} has {node.end_lineno - node.lineno + 1} lines"
    for file in [ROOT / "run", *ROOT.rglob("workflow/**/*.smk"), *ROOT.glob("workflow/Snakefile")]:
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
            if len(line) > COLUMNS:
                yield f"{file.relative_to(ROOT)}:{number}: {len(line)} columns"


if __name__ == "__main__":
    copy = "".join(f"a{n} = {n}\n" for n in range(REPEATED_LINES))
    assert repeated({"first": copy, "second": f"import os\n{copy}"}) == [["first:1", "second:2"]]
    found = list(complaints())
    print("\n".join(found))
    sys.exit(bool(found))

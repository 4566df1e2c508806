"""No six lines of code stand twice; docstrings, comments, imports, signatures and fields of tuples are not counted."""

import ast
from collections import defaultdict
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "workflow" / "scripts"
LINES = 6


def apart(tree):
    """Return the numbers of the lines of docstrings, imports, signatures and fields."""
    lines = set()
    for node in ast.walk(tree):
        text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        field = isinstance(node, ast.AnnAssign) and node.value is None
        if text or field or isinstance(node, ast.Import | ast.ImportFrom):
            lines.update(range(node.lineno, node.end_lineno + 1))
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            lines.update(range(node.lineno, node.body[0].lineno))
    return lines


def code(source):
    """Return number and text of every line that counts."""
    out = apart(ast.parse(source))
    lines = [(number, line.strip()) for number, line in enumerate(source.splitlines(), start=1) if number not in out]
    return [(number, line) for number, line in lines if line and not line.startswith("#")]


def repeated(sources):
    """Return the places, name and line, of every run of lines that stands in more than one of them."""
    places = defaultdict(list)
    for name, source in sources.items():
        lines = code(source)
        for first in range(len(lines) - LINES + 1):
            run = lines[first : first + LINES]
            places[tuple(line for _, line in run)].append(f"{name}:{run[0][0]}")
    return [where for where in places.values() if len(where) > 1]


def test_no_code_stands_twice():
    assert not repeated({str(file.relative_to(SCRIPTS)): file.read_text("utf-8") for file in SCRIPTS.rglob("*.py")})


def test_the_search_finds_a_copy():
    body = "".join(f"    a{n} = {n}\n" for n in range(LINES))
    first, second = f'def f():\n    """Say."""\n{body}', f"import os\n\n\ndef g(\n    x,\n):\n    # why\n\n{body}"
    assert repeated({"first": first, "second": second}) == [["first:3", "second:9"]]
    assert not repeated({"first": first, "second": second.replace("a3", "b3")})

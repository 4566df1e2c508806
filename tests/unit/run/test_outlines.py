"""Outlines of modules, remembered in the working directory."""

import json
import subprocess
import sys

import pytest

from gearwear.run.digest import SCRIPTS
from gearwear.run.outlines import REMEMBERED

PROGRAM = f"""
import sys
sys.path.insert(0, {str(SCRIPTS)!r})
from pathlib import Path
from gearwear.run import outlines
read, parsed = outlines._read, []
outlines._read = lambda content: parsed.append(1) or read(content)
found = outlines.outline(Path("module.py"))
outlines.remember()
print(found.digest, *found.imports, len(parsed))
"""


@pytest.fixture
def outlined(tmp_path):
    """A function that gives digest, imports and how many modules were parsed, in a process of its own."""
    (tmp_path / ".snakemake").mkdir()
    (tmp_path / "module.py").write_text("import os\n\nX = 1\n")

    def ask():
        done = subprocess.run([sys.executable, "-c", PROGRAM], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout.split()

    ask.folder = tmp_path
    return ask


def test_a_module_is_parsed_once_however_many_processes_ask(outlined):
    first, second = outlined(), outlined()
    assert first[:-1] == second[:-1] and first[1:-1] == ["os"]
    assert (first[-1], second[-1]) == ("1", "0")


def test_a_changed_module_is_parsed_again(outlined):
    before = outlined()
    (outlined.folder / "module.py").write_text("import os\n\nX = 2\n")
    after = outlined()
    assert after[0] != before[0] and after[-1] == "1"


@pytest.mark.parametrize("kept", ["", "{", "[]", '{"reader": 1}', '{"reader": "x", "modules": {}}', "null"])
def test_a_spoiled_memory_is_made_anew(outlined, kept):
    before = outlined()
    (outlined.folder / REMEMBERED).write_text(kept)
    assert outlined() == before
    assert outlined()[-1] == "0"


def test_a_memory_of_another_reader_is_not_believed(outlined):
    before = outlined()
    file = outlined.folder / REMEMBERED
    other = json.loads(file.read_text()) | {"reader": "another"}
    file.write_text(json.dumps(other))
    assert outlined() == before


def test_without_a_place_to_remember_it_still_answers(outlined):
    (outlined.folder / ".snakemake").rmdir()
    assert outlined()[-1] == "1" and outlined()[-1] == "1"

"""The digest of the code a stage can run, and the rules of the source tree it rests on."""

import ast
import re
from pathlib import Path

import pytest

from gearwear.run import digest as module
from gearwear.run.digest import SCRIPTS, closure, digest
from gearwear.run.outlines import outline

ROOT = SCRIPTS.parents[1]
PACKAGE = sorted((SCRIPTS / "gearwear").rglob("*.py"))
STAGES = sorted(SCRIPTS.glob("*.py"))

TREE = {
    "stage.py": '"""A stage."""\n\nimport numpy as np\nfrom gears.mesh import stiffness\n\nprint(stiffness.K, np.pi)\n',
    "gears/__init__.py": '"""Gears."""\n',
    "gears/mesh/__init__.py": '"""Mesh."""\n',
    "gears/mesh/stiffness.py": '"""Stiffness."""\n\nfrom gears.steel import E\n\nK = 2 * E\n',
    "gears/steel.py": '"""Steel."""\n\nE = 206e9\n\n\ndef soft():\n    """Return less."""\n    return E / 2\n',
    "gears/unused.py": '"""Nobody imports it."""\n\nX = 1\n',
}


@pytest.fixture
def tree(tmp_path):
    for name, text in TREE.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path


def digest_of(tree):
    for cached in (module._modules, module._files, module._neighbours, module._entry, outline, digest):
        cached.cache_clear()
    return digest(tree / "stage.py", tree)


def rewrite(path: Path, old: str, new: str):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_closure_holds_the_script_its_modules_and_their_packages(tree):
    found = [path.relative_to(tree).as_posix() for path in closure(tree / "stage.py", tree)]
    assert found == [
        "gears/__init__.py",
        "gears/mesh/__init__.py",
        "gears/mesh/stiffness.py",
        "gears/steel.py",
        "stage.py",
    ]


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("gears/steel.py", "206e9", "207e9"),
        ("gears/steel.py", "E / 2", "E / 3"),
        ("gears/mesh/stiffness.py", "2 * E", "3 * E"),
        ("gears/__init__.py", '"""Gears."""', '"""Gears."""\nX = 1'),
        ("stage.py", "np.pi", "np.e"),
    ],
)
def test_digest_changes_with_code_however_far_away(tree, name, old, new):
    before = digest_of(tree)
    rewrite(tree / name, old, new)
    assert digest_of(tree) != before


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("gears/steel.py", "E = 206e9", "# of steel\nE   =   206e9  # Pa"),
        ("gears/steel.py", '"""Return less."""', '"""Return half of it."""'),
        ("gears/steel.py", '    """Return less."""\n', ""),
        ("gears/steel.py", "206e9", "2.06e11"),
        ("gears/mesh/stiffness.py", '"""Stiffness."""\n\n', ""),
        ("stage.py", "print(stiffness.K, np.pi)", "print(\n    stiffness.K,\n    np.pi,\n)"),
        ("gears/unused.py", "X = 1", "X = 2"),
    ],
)
def test_digest_keeps_with_comments_docstrings_layout_and_what_is_not_imported(tree, name, old, new):
    before = digest_of(tree)
    rewrite(tree / name, old, new)
    assert digest_of(tree) == before


def test_digest_does_not_depend_on_the_place_of_the_project(tree, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "copy"
    before = digest_of(tree)
    tree.rename(elsewhere)
    assert digest_of(elsewhere) == before


def test_digest_changes_when_a_module_moves(tree):
    before = digest_of(tree)
    (tree / "gears/steel.py").rename(tree / "gears/iron.py")
    rewrite(tree / "gears/mesh/stiffness.py", "gears.steel", "gears.iron")
    assert digest_of(tree) != before


def test_digest_sees_imports_inside_functions_and_circles(tree):
    rewrite(
        tree / "gears/steel.py",
        "    return E / 2",
        "    import gears.unused\n    import gears.mesh.stiffness\n    return 0",
    )
    assert tree / "gears/unused.py" in closure(tree / "stage.py", tree)


@pytest.mark.parametrize("script", STAGES, ids=lambda path: path.stem)
def test_stages_have_a_digest_of_sixteen_digits(script):
    assert re.fullmatch("[0-9a-f]{16}", digest(script))
    assert script in closure(script)


@pytest.mark.parametrize(
    ("script", "reached", "not_reached"),
    [
        ("build_stiffness.py", ["mesh/cantilever.py", "mesh/foundation.py", "heat/modulus.py"], ["wear/archard.py"]),
        ("advance_wear.py", ["wear/archard.py", "wear/film.py", "mesh/sharing.py"], ["mesh/cantilever.py"]),
        ("open_backlash.py", ["mesh/backlash.py"], ["mesh/stiffness.py", "heat/flash.py"]),
        ("build_geometry.py", ["geometry/involute.py"], ["dynamics/oscillator.py"]),
    ],
)
def test_stages_reach_their_physics_and_no_more(script, reached, not_reached):
    found = {
        path.relative_to(SCRIPTS / "gearwear").as_posix()
        for path in closure(SCRIPTS / script)
        if "gearwear" in path.parts
    }
    assert found >= set(reached)
    assert not found & set(not_reached)


def test_packages_import_nothing_of_the_project():
    """An import there would put every module of the package into every digest."""
    inits = [path for path in PACKAGE if path.name == "__init__.py"]
    assert {path.parent for path in PACKAGE} == {path.parent for path in inits}
    for path in inits:
        assert ast.get_docstring(ast.parse(path.read_text())), path
        assert not any(name.partition(".")[0] == "gearwear" for _, name in imports(path)), path


def imports(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from ((0, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.level, node.module or ""


@pytest.mark.parametrize("path", PACKAGE + STAGES, ids=lambda path: path.relative_to(SCRIPTS).as_posix())
def test_imports_are_absolute_static_and_the_package_knows_no_snakemake(path):
    names = list(imports(path))
    assert all(level == 0 for level, _ in names), "a relative import escapes the digest"
    assert not {"importlib"} & {name.partition(".")[0] for _, name in names}, "a dynamic import escapes the digest"
    if path in PACKAGE:
        assert not any(name.partition(".")[0] == "snakemake" for _, name in names)


@pytest.mark.parametrize("path", STAGES, ids=lambda path: path.stem)
def test_stages_see_only_their_slice_of_the_configuration(path):
    assert not re.search(r"\b(snakemake|job)\s*\.\s*config\b", path.read_text())


def test_stages_do_not_import_one_another_but_for_the_block_that_is_made_of_them():
    stems = {path.stem for path in STAGES}
    found = {path.stem: stems & {name.partition(".")[0] for _, name in imports(path)} for path in STAGES}
    links = {"advance_wear", "build_stiffness", "share_load", "open_backlash", "solve_response"}
    assert {stem: others for stem, others in found.items() if others} == {"run_block": links}


def test_the_digest_of_a_block_changes_with_every_stage_in_it():
    block = set(closure(SCRIPTS / "run_block.py"))
    for name in ("advance_wear", "build_stiffness", "share_load", "open_backlash", "solve_response"):
        assert set(closure(SCRIPTS / f"{name}.py")) <= block

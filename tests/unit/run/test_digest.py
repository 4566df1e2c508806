"""The digest of the code that a function can run, and the rules of the sources on which it rests."""

import ast
import re
import shutil
from importlib import import_module
from itertools import count
from pathlib import Path
from textwrap import dedent

import pytest

import gearwear
from gearwear.figures.sheet import Drawing
from gearwear.run import digest as module
from gearwear.run import stages
from gearwear.run.digest import PACKAGE, digest, digests, reached, source_key

MODULES = sorted(PACKAGE.rglob("*.py"))
STAGES = {stage: stages.target_of(stage) for stage in stages.MODULES}
FIGURES = {
    f"{path.stem}:{name}": f"figures.{path.stem}:{name}"
    for path in sorted((PACKAGE / "figures").glob("*.py"))
    for name, value in vars(import_module(f"gearwear.figures.{path.stem}")).items()
    if isinstance(value, Drawing)
}
TARGETS = STAGES | FIGURES

TREE = {
    "__init__.py": '"""Gears."""\n',
    "stages.py": """\
        from __future__ import annotations

        from functools import cache
        from typing import TYPE_CHECKING

        from gears import colours, steel, tables
        from gears.mesh import wheel
        from gears.mesh.stiffness import K as ripple
        from gears.mesh.stiffness import passed_on

        if TYPE_CHECKING:
            from gears.hints import Hint

        FIRST, SECOND = 1, 2


        def twice(function):
            return function


        class Base:
            SIZE = 3
            colours: int


        class Pair(Base):
            def whole(self):
                return self.SIZE * SECOND


        def stage(cfg: Hint, other: Hint) -> Hint:
            '''Do it.'''
            colours = 1
            return ripple, steel.soft(cfg), passed_on, decorated(), Pair().whole(), getattr(tables, cfg), other


        @twice
        def decorated():
            from gears.lazy import late

            return late(wheel.spokes)


        def other():
            return steel.hard()
        """,
    "mesh/__init__.py": '"""Mesh."""\n',
    "mesh/stiffness.py": """\
        '''Stiffness.'''

        from gears.mesh.wheel import rim as passed_on
        from gears.steel import E

        K = 2 * E
        UNUSED = 1
        """,
    "mesh/wheel.py": """\
        def rim():
            return "rim"


        spokes = 4
        hub = 5
        """,
    "steel.py": """\
        '''Steel.'''

        E = 206e9
        LIMIT = 3e8
        _known = []
        _known.append(LIMIT)


        def soft(cfg):
            '''Return less.'''
            return E / 2


        def hard():
            return 2 * E


        if __name__ == "__main__":
            print("as a program")
        """,
    "tables.py": "FIRST = 11\nNEXT = 12\n",
    "lazy.py": "def late(x):\n    return x\n",
    "hints.py": "class Hint:\n    pass\n",
    "colours.py": "RED = 1\n",
    "unread.py": "X = 1\n",
}


@pytest.fixture
def digest_after(tmp_path):
    """Return a function that gives the digest of `stages:stage` in a package after an edit."""
    places = count()

    def of(name=None, old="", new="", target="stages:stage"):
        package = tmp_path / str(next(places)) / "gears"
        for file, text in TREE.items():
            path = package / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(dedent(text))
        if name:
            edit(package / name, old, new)
        return digest(target, package)

    return of


def edit(path: Path, old: str, new: str):
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("stages.py", "return ripple", "return -ripple"),
        ("stages.py", "FIRST, SECOND = 1, 2", "FIRST, SECOND = 1, 3"),  # both names of one assignment
        ("stages.py", "return function", "return print"),  # a decorator
        ("stages.py", "SIZE = 3", "SIZE = 4"),  # the body of a class that another inherits
        ("stages.py", "self.SIZE * SECOND", "self.SIZE + SECOND"),  # a method
        ("mesh/stiffness.py", "2 * E", "3 * E"),  # imported under another name
        ("steel.py", "206e9", "207e9"),  # a constant behind an imported one
        ("steel.py", "E / 2", "E / 3"),  # a function of an imported module
        ("steel.py", "3e8", "4e8"),  # what a statement uses that runs at the import
        ("steel.py", "_known.append", "_known.remove"),
        ("mesh/wheel.py", '"rim"', '"tyre"'),  # passed on by the module that it is imported from
        ("mesh/wheel.py", "spokes = 4", "spokes = 5"),  # an attribute of a module
        ("lazy.py", "return x", "return -x"),  # imported inside a function
        ("tables.py", "NEXT = 12", "NEXT = 13"),  # of a module that is passed as a whole
        ("__init__.py", '"""Gears."""', '"""Gears."""\nprint(1)'),  # run at every import of the package
    ],
)
def test_digest_changes_with_code_however_far_away(digest_after, name, old, new):
    assert digest_after(name, old, new) != digest_after()


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("stages.py", "'''Do it.'''", "'''Do it all.'''"),
        ("stages.py", "return ripple, ", "return (\n        ripple\n    ), "),
        ("stages.py", "steel.hard()", "steel.hard"),  # of a function that has the name of a parameter
        ("stages.py", "gears.hints import Hint", "gears.unread import X as Hint"),  # for type checkers
        ("mesh/stiffness.py", "'''Stiffness.'''\n\n", ""),
        ("mesh/stiffness.py", "UNUSED = 1", "UNUSED = 2"),
        ("mesh/wheel.py", "hub = 5", "hub = 6"),
        ("steel.py", "E = 206e9", "# of steel\nE   =   2.06e11  # Pa"),
        ("steel.py", "    '''Return less.'''\n", ""),
        ("steel.py", "return 2 * E", "return 3 * E"),
        ("steel.py", "as a program", "by hand"),
        ("hints.py", "pass", "x = 1"),
        ("colours.py", "RED = 1", "RED = 2"),  # a local variable has the name of the module
        ("unread.py", "X = 1", "X = 2"),
    ],
)
def test_digest_keeps_with_comments_docstrings_layout_hints_and_what_is_not_reached(digest_after, name, old, new):
    assert digest_after(name, old, new) == digest_after()


def test_digests_of_two_functions_of_a_module_differ(digest_after):
    assert digest_after(target="stages:other") != digest_after()
    assert digest_after("steel.py", "2 * E", "3 * E", "stages:other") != digest_after(target="stages:other")


@pytest.fixture(scope="module")
def edited(tmp_path_factory):
    """Return a function that gives a copy of the program with edited modules, by their names."""

    def copy(edits):
        package = tmp_path_factory.mktemp("copy") / PACKAGE.name
        shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
        for path in sorted(package.rglob("*.py")):
            text = path.read_text(encoding="utf-8")
            path.write_text(edits(path.relative_to(package).as_posix(), text), encoding="utf-8")
        return package

    return copy


def changed(package, targets=TARGETS):
    """Return the stages and figures whose digest is another than that of the program."""
    return {name for name, target in targets.items() if digest(target, package) != digest(target)}


def test_every_stage_and_figure_has_a_digest_of_its_own():
    found = [digest(target) for target in TARGETS.values()]
    assert len(FIGURES) > 15
    assert all(re.fullmatch("[0-9a-f]{16}", one) for one in found)
    assert len(set(found)) == len(found)
    for target in TARGETS.values():
        assert tuple(target.split(":")) in {symbol for symbol, _ in reached([target])}


def test_no_digest_changes_with_words_and_with_what_nobody_reads(edited):
    """Docstrings, comments, help texts of keys, unread constants, the tables of units and variables."""
    unread = "\n\nNEVER_READ = 1  # by nobody\n\n\ndef never_called():\n    return NEVER_READ\n"
    words = {'"""Return ': '"""Compute ', '"3 mm, 65 um': '"4 mm, 65 um', '"Normal module."': '"Module."'}

    def edits(_, text):
        for old, new in words.items():
            text = text.replace(old, new)
        return f"# checked\n{text}{unread}"

    package = edited(edits)
    edit(package / "io" / "variables.csv", "number of teeth", "count of teeth")
    assert source_key(package) != source_key()
    assert not changed(package)


def test_no_stage_reaches_the_sections_of_the_configuration():
    for name, target in TARGETS.items():
        found = {module for (module, _), _ in reached([target])}
        assert not found & {f"config.{one}" for one in ("pair", "study", "types", "units", "check")}, name


def test_an_edit_changes_the_digests_of_the_stages_that_run_it(edited):
    module_of = {"basins": "motions/basins.py", "deformation": "heat/growth.py", "bifurcation:draw": "figures/sheet.py"}
    package = edited(lambda name, text: text.replace("return ", "return 0, ") if name in module_of.values() else text)
    kept = ("unworn", "wear", "mesh_excitation", "temperature", "sweep")
    assert changed(package, {name: TARGETS[name] for name in (*module_of, "wear_history", *kept)}) == {
        *module_of,
        "wear_history",
    }


@pytest.mark.parametrize(
    ("stage", "within", "without"),
    [
        ("mesh_excitation", {"mesh.cantilever", "mesh.foundation", "mesh.backlash", "contact.modulus"}, {"wear"}),
        ("wear", {"wear.archard", "contact.hertz", "mesh.sharing"}, {"mesh.cantilever", "mesh.backlash"}),
        ("geometry", {"geometry.involute", "geometry.deviations"}, {"oscillator", "integrate", "heat"}),
        ("unworn", {"chain.wear"}, {"contact.hertz", "wear"}),
        ("basins", {"motions.basins", "integrate.strobe_many", "integrate.strobe"}, {"heat", "mesh", "wear"}),
        ("warnings", {"validity.ranges"}, {"figures", "claims", "config"}),
    ],
)
def test_stages_reach_their_physics_and_no_more(stage, within, without):
    found = {module for (module, _), _ in reached([STAGES[stage]])}
    assert found >= within
    assert not [one for one in found if one in without or one.partition(".")[0] in without]


def test_digests_are_kept_for_the_same_sources(tmp_path, monkeypatch):
    folder, targets = tmp_path / "digests", ["chain.wear:wear", "chain.wear:unworn"]
    found = digests(targets, folder)
    assert found == {target: digest(target) for target in targets}
    asked = []
    monkeypatch.setattr(module, "digest", lambda target: asked.append(target) or "another")
    assert digests(targets, folder) == found and not asked
    assert set(digests(targets[:1], folder).values()) == {"another"}
    (file,) = folder.iterdir()
    for spoiled in ("", "{", "[]", '{"x": 1}'):
        file.write_text(spoiled)
        assert set(digests(targets, folder).values()) == {"another"}
    file.write_text("{}")
    monkeypatch.setattr(module, "source_key", lambda: "other_sources")
    digests(targets, folder)
    assert len(list(folder.iterdir())) == 2


def test_digests_need_no_place_to_be_kept(tmp_path):
    (tmp_path / "file").write_text("")
    assert digests(["chain.wear:wear"], tmp_path / "file" / "digests") == {"chain.wear:wear": digest("chain.wear:wear")}


@pytest.mark.parametrize(
    ("environment", "folder"),
    [
        ({"GEARWEAR_CACHE": "/a", "XDG_CACHE_HOME": "/b"}, "/a/digests"),
        ({"XDG_CACHE_HOME": "/b"}, "/b/gearwear/digests"),
        ({}, Path("~/.cache/gearwear/digests").expanduser()),
    ],
)
def test_digests_are_kept_in_the_cache_of_the_user(environment, folder):
    assert module.memory(environment) == Path(folder)


def test_packages_import_nothing_of_the_project():
    """An import there would be in every digest."""
    inits = [path for path in MODULES if path.name == "__init__.py"]
    assert {path.parent for path in MODULES} == {path.parent for path in inits}
    for path in inits:
        assert ast.get_docstring(ast.parse(path.read_text())), path
        package = ".".join(path.relative_to(PACKAGE).parts[:-1])
        assert not module._source(package, PACKAGE).names, path


def imports(path):
    """Yield level, module and names of every import; a plain import has no names."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((0, alias.name, []) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.level, node.module or "", [alias.name for alias in node.names]


def test_no_import_escapes_the_digest():
    by_name = set()  # modules that import others by names which no digest can know
    for path in MODULES:
        for level, name, names in imports(path):
            assert level == 0 and "*" not in names, path
            assert names or name.partition(".")[0] != "gearwear", path
            assert name != "gearwear" or not {*names} & {*gearwear.__all__} - {"__version__"}, path
            assert name.partition(".")[0] != "snakemake", path
            if name == "importlib":
                by_name.add(path.relative_to(PACKAGE).as_posix())
    assert by_name == {"__init__.py", "io/variables.py", "run/stage.py", "run/stages.py"}

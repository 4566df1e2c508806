"""The public names: light to import, documented by examples that run."""

import doctest
import importlib
import inspect
import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import gearwear

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = sorted(path for path in (ROOT / "examples").glob("*.py") if "gearwear.GearPair" in path.read_text())
CLASSES = [name for name in gearwear.__all__ if inspect.isclass(getattr(gearwear, name))]


def run(code: str, *arguments: str):
    return subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True)


def test_every_public_name_exists_and_no_other():
    assert all(getattr(gearwear, name) is not None for name in gearwear.__all__)
    assert set(dir(gearwear)) == set(gearwear.__all__)
    with pytest.raises(AttributeError, match="module 'gearwear' has no attribute 'nothing'"):
        gearwear.nothing  # noqa: B018


def test_importing_the_package_is_light_and_leaves_its_host_alone(tmp_path):
    code = """if True:
        import gc, json, os, sys
        def state():
            return [gc.get_threshold(), gc.get_freeze_count(), sorted(os.environ.items()), sys.getrecursionlimit(),
                    sorted(os.listdir())]
        before, known = state(), set(sys.modules)
        import gearwear
        gearwear.__version__
        print(json.dumps([before == state(), sorted({name.partition(".")[0] for name in set(sys.modules) - known})]))
    """
    same, added = json.loads(subprocess.check_output([sys.executable, "-c", code], cwd=tmp_path))
    assert same
    assert not {"numpy", "xarray", "numba", "pydantic", "matplotlib", "netCDF4", "snakemake"} & set(added)


def test_no_public_name_needs_matplotlib_or_snakemake():
    code = "import gearwear, sys; [getattr(gearwear, name) for name in gearwear.__all__]; print(*sys.modules)"
    assert not {"matplotlib", "snakemake"} & set(run(code).stdout.split())


def test_the_version_is_that_of_the_project():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert "version" in project["project"]["dynamic"]
    assert project["tool"]["setuptools"]["dynamic"]["version"] == {"attr": "gearwear.__version__"}
    assert gearwear.__version__.count(".") == 2


def test_the_command_of_the_project_is_the_command_line():
    command = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["scripts"]["gearwear"]
    module, _, name = command.partition(":")
    assert callable(getattr(importlib.import_module(module), name))


def public_methods():
    for name in CLASSES:
        for method, function in inspect.getmembers(getattr(gearwear, name), inspect.isroutine):
            if (
                not method.startswith("_")
                and method in vars(getattr(gearwear, name))
                and name in ("GearPair", "Oscillator")
            ):
                yield f"{name}.{method}", function


@pytest.mark.parametrize(("name", "function"), list(public_methods()))
def test_every_argument_and_result_is_documented_with_an_example(name, function):
    text = inspect.getdoc(function)
    assert "Returns\n-------" in text or " degC" in text.splitlines()[0] or "(degC)" in text
    assert ">>> import gearwear" in text
    for argument, parameter in inspect.signature(function).parameters.items():
        if argument not in ("self", "cls") and parameter.kind is not parameter.VAR_KEYWORD:
            assert argument in text, argument


@pytest.mark.parametrize("module", ["gearwear.pair", "gearwear.dynamics"])
def test_the_examples_of_the_documentation_give_what_they_say(module):
    result = doctest.testmod(importlib.import_module(module))
    assert result.attempted > 10
    assert result.failed == 0


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_the_example_scripts_run(path):
    printed = subprocess.run([sys.executable, path], capture_output=True, text=True, check=True).stdout
    assert len(printed.splitlines()) >= 5


def test_there_is_an_example_script():
    assert EXAMPLES

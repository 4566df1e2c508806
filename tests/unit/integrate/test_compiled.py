"""The cache of compiled kernels."""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from gearwear.integrate import compiled

RUN = """
import hashlib
from gearwear.integrate.strobe import strobe
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics
chaotic = Oscillator(1.4, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))
motion = strobe(chaotic, (0.0, 0.0), 300)
print(hashlib.sha256(b"".join(part.tobytes() for part in motion[:8])).hexdigest())
"""

TINY = """
import numpy as np
from gearwear.integrate import tangent
assert tangent.growth_of(np.zeros(2), 3.0, 4.0) > 1.6
print(tangent.__file__)
"""


UNTOUCHED = """
import os
from pathlib import Path
before = dict(os.environ)
import numba
settings = {name: getattr(numba.config, name) for name in dir(numba.config) if name.isupper()}
import gearwear.motions.settling, gearwear.orbits.branches
assert dict(os.environ) == before
assert {name: getattr(numba.config, name) for name in dir(numba.config) if name.isupper()} == settings
assert not list(Path.home().rglob("*"))
"""


def test_an_import_changes_nothing_in_its_host(tmp_path):
    environment = {
        name: value for name, value in os.environ.items() if name not in ("GEARWEAR_CACHE", "XDG_CACHE_HOME")
    }
    environment |= {"HOME": str(tmp_path), "PYTHONPATH": str(Path(compiled.__file__).parents[2])}
    subprocess.run([sys.executable, "-c", UNTOUCHED], env=environment, check=True)


def test_a_folder_of_the_machine_code_can_be_named(tmp_path, monkeypatch):
    monkeypatch.setattr(compiled, "_folder", None)
    compiled.use_cache(tmp_path)
    assert compiled._current_folder().parent == tmp_path / "numba"


def test_digest_changes_with_any_source(tmp_path):
    (tmp_path / "a.py").write_text("x = 1\n")
    first = compiled.source_digest(tmp_path)
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "b.py").write_text("y = 1\n")
    second = compiled.source_digest(tmp_path)
    (tmp_path / "inner" / "b.py").write_text("y = 2\n")
    third = compiled.source_digest(tmp_path)
    (tmp_path / "notes.txt").write_text("no source\n")
    assert len({first, second, third}) == 3
    assert compiled.source_digest(tmp_path) == third
    assert len(third) == 16


def test_folder_is_chosen_in_order(tmp_path):
    own, users = tmp_path / "own", tmp_path / "users"
    both = {"GEARWEAR_CACHE": str(own), "XDG_CACHE_HOME": str(users)}
    assert compiled.cache_folder(both, "abc") == own / "numba" / "abc"
    assert compiled.cache_folder({"XDG_CACHE_HOME": str(users)}, "abc") == users / "gearwear" / "numba" / "abc"
    assert (own / "numba" / "abc").is_dir()


def test_folder_that_cannot_be_made_is_replaced(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(compiled.tempfile, "tempdir", str(tmp_path))
    folder = compiled.cache_folder({"GEARWEAR_CACHE": str(tmp_path / "file")}, "abc")
    assert folder.is_dir()
    assert folder == tmp_path / f"gearwear-{os.getuid()}" / "numba" / "abc"


@pytest.mark.parametrize(
    "spoil", [lambda base: base.chmod(0o777), lambda base: (base.rmdir(), base.symlink_to("/tmp"))]
)
def test_machine_code_in_a_folder_of_others_is_not_run(spoil, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(compiled.tempfile, "tempdir", str(tmp_path))
    base = tmp_path / f"gearwear-{os.getuid()}"
    base.mkdir(mode=0o700)
    spoil(base)
    with pytest.raises(ValueError, match=f"{base}: .*GEARWEAR_CACHE"):
        compiled.cache_folder({"GEARWEAR_CACHE": str(tmp_path / "file")}, "abc")


def test_a_copy_of_the_program_finds_the_machine_code_and_another_program_does_not(tmp_path):
    package = Path(compiled.__file__).parents[1]
    times = {}
    for name in ("first", "copy", "changed"):
        copy = shutil.copytree(package, tmp_path / name / "gearwear", ignore=shutil.ignore_patterns("__pycache__"))
        if name == "changed":
            with open(copy / "integrate" / "tangent.py", "a") as file:
                file.write("\n")
        environment = dict(os.environ) | {"GEARWEAR_CACHE": str(tmp_path / "cache"), "PYTHONPATH": str(copy.parent)}
        found = subprocess.run(
            [sys.executable, "-c", TINY], env=environment, capture_output=True, text=True, check=True
        )
        assert str(copy) in found.stdout
        times[name] = {str(path): path.stat().st_mtime_ns for path in (tmp_path / "cache").rglob("*.nbc")}
    assert times["first"] and times["copy"] == times["first"]
    assert len(times["changed"]) == 2 * len(times["first"])


def test_cold_and_warm_cache_give_equal_bits(tmp_path):
    environment = dict(os.environ)
    environment["GEARWEAR_CACHE"] = str(tmp_path)
    environment["PYTHONPATH"] = str(Path(compiled.__file__).parents[2])
    digests, stored = [], []
    for _ in range(2):
        finished = subprocess.run(
            [sys.executable, "-c", RUN], env=environment, capture_output=True, text=True, check=True
        )
        digests.append(finished.stdout)
        files = sorted(tmp_path.rglob("*.nbc"))
        stored.append([(file.name, hashlib.sha256(file.read_bytes()).hexdigest()) for file in files])
    assert digests[0] == digests[1]
    assert stored[0] and stored[0] == stored[1]

"""The compiler of the numerical kernels and the cache of their machine code.

numba keys the machine code of a function by its own source file only, so that an edit of a *called* function in another
file meets stale machine code. This cache lies in a folder named by a digest over every source file of this package, and
by nothing else: copies of the program with equal sources share it. All kernels are compiled in strict IEEE arithmetic;
results are bit-equal from a cold and a warm cache.

The folder is chosen, and made, when the first kernel runs; importing this module changes nothing outside it.
"""

import functools
import hashlib
import os
import pickle
import stat
import sys
import tempfile
import uuid
from collections.abc import Callable, Mapping
from pathlib import Path

import numba
from numba.core.caching import NullCache
from numba.core.compiler import CompileResult
from numba.core.runtime import rtsys
from numba.core.serialize import dumps


def source_digest(folder: Path) -> str:
    """Sixteen hexadecimal digits over the names and contents of all Python files below a folder."""
    digest = hashlib.sha256()
    for file in sorted(folder.rglob("*.py")):
        content = file.read_bytes()
        digest.update(f"{file.relative_to(folder).as_posix()}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()[:16]


def cache_folder(environment: Mapping[str, str], digest: str) -> Path:
    """Writable folder of the machine code: GEARWEAR_CACHE, else the user's cache, else a temporary folder.

    Raises
    ------
    ValueError : the temporary folder is not the user's alone.
    """
    if environment.get("GEARWEAR_CACHE"):
        base = Path(environment["GEARWEAR_CACHE"])
    elif environment.get("XDG_CACHE_HOME"):
        base = Path(environment["XDG_CACHE_HOME"], "gearwear")
    else:
        base = Path("~/.cache/gearwear").expanduser()
    folder = base.absolute() / "numba" / digest
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError:
        base = Path(tempfile.gettempdir(), f"gearwear-{os.getuid()}")
        base.mkdir(mode=0o700, exist_ok=True)
        found = base.lstat()
        # What lies there is run, and anybody may have made a folder of this name before.
        if not stat.S_ISDIR(found.st_mode) or found.st_uid != os.getuid() or found.st_mode & 0o022:
            raise ValueError(
                f"{base}: others may write to it, so machine code in it cannot be trusted; give a folder of your own "
                "in the environment variable GEARWEAR_CACHE"
            ) from None
        folder = base / "numba" / digest
        folder.mkdir(parents=True, exist_ok=True)
        return folder


_digest = source_digest(Path(__file__).parent)  # of the sources as they are imported
_folder: Path | None = None


def use_cache(folder: str | Path) -> None:
    """Keep the machine code below a folder instead of that of `cache_folder`; kernels already loaded stay."""
    global _folder
    _folder = cache_folder({"GEARWEAR_CACHE": str(folder)}, _digest)


def _current_folder() -> Path:
    global _folder
    if _folder is None:
        _folder = cache_folder(os.environ, _digest)
    return _folder


@functools.cache
def _file_digest(path: str) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


class _MachineCode(NullCache):
    """Cache of one function, a file for each signature and kind of processor."""

    def __init__(self, function: Callable):
        self._name = f"{function.__module__}.{function.__qualname__}"
        self._source = _file_digest(function.__code__.co_filename)  # which need not lie in this package

    def load_overload(self, sig, target_context) -> CompileResult | None:
        try:
            data = self._file(sig, target_context.codegen()).read_bytes()
        except FileNotFoundError:
            return None
        # Only the memory manager is needed to run loaded code. numba's own cache makes everything ready that compiles
        # code, which imports scipy.linalg and takes half a second.
        rtsys.initialize(target_context)
        return CompileResult._rebuild(target_context, *pickle.loads(data))

    def save_overload(self, sig, data: CompileResult) -> None:
        file = self._file(sig, data.library.codegen)
        unfinished = file.with_suffix(f".{uuid.uuid4().hex}")  # other jobs may write the same file
        unfinished.write_bytes(dumps(data._reduce()))
        unfinished.replace(file)

    def _file(self, sig, codegen) -> Path:
        key = repr((self._source, sig, codegen.magic_tuple(), numba.__version__, sys.version_info[:2]))
        return _current_folder() / f"{self._name}-{hashlib.sha256(key.encode()).hexdigest()[:16]}.nbc"


def njit(function: Callable | None = None, **options):
    """Compile a function in strict arithmetic at its first call, or load its machine code from the cache."""
    if function is None:
        return functools.partial(njit, **options)
    kernel = numba.njit(nogil=True, fastmath=False, error_model="numpy", **options)(function)
    kernel._cache = _MachineCode(function)
    return kernel


# For kernels that allocate nothing: they borrow the arrays of their caller without counting references to them. In
# small functions the counting, in atomic instructions, would take most of the time.
njit_noalloc = functools.partial(njit, _nrt=False)

# The same, and written into the caller by the compiler: for the small formulas inside the kernels.
njit_inline = functools.partial(njit_noalloc, forceinline=True)

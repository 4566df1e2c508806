"""The compiler of the numerical kernels and the place of their machine code.

numba keys a cached function by its own source file only, so an edit of a *called* function in another file
would meet stale machine code. The cache folder is therefore named by a digest over every source file of this
package, and by nothing else: copies of the program with equal sources share their machine code. All kernels are
compiled in strict IEEE arithmetic: results are bit-equal from a cold and a warm cache.
"""

import functools
import hashlib
import os
import stat
import tempfile
from pathlib import Path


def source_digest(folder: Path) -> str:
    """Sixteen hexadecimal digits over the names and contents of all Python files below a folder."""
    digest = hashlib.sha256()
    for file in sorted(folder.rglob("*.py")):
        content = file.read_bytes()
        digest.update(f"{file.relative_to(folder).as_posix()}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()[:16]


def cache_folder(environment: dict[str, str], digest: str) -> Path:
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


CACHE_FOLDER = cache_folder(dict(os.environ), source_digest(Path(__file__).parent))
os.environ["NUMBA_CACHE_DIR"] = str(CACHE_FOLDER)

import numba  # noqa: E402  (the cache folder must be set first)
from numba.core.caching import UserProvidedCacheLocator  # noqa: E402


class ByDigest(UserProvidedCacheLocator):
    """Place of the machine code of a function, wherever its source file lies."""

    @classmethod
    def get_suitable_cache_subpath(cls, py_file: str) -> str:
        """Return the name of the package, not of the folder around it."""
        return Path(py_file).parent.name


# numba may have been imported, and have read its environment, before this module.
numba.config.CACHE_DIR = str(CACHE_FOLDER)
numba.config.CACHE_LOCATOR_CLASSES = f"{__name__}.{ByDigest.__name__}"

njit = functools.partial(numba.njit, cache=True, nogil=True, fastmath=False, error_model="numpy")

# For kernels that allocate nothing: they borrow the arrays of their caller without counting references to them. In
# small functions the counting, in atomic instructions, would take most of the time.
borrowing = functools.partial(njit, _nrt=False)

# The same, and written into the caller by the compiler: for the small formulas inside the kernels.
inlined = functools.partial(borrowing, forceinline=True)

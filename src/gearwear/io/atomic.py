"""Files that are written complete or not at all."""

from __future__ import annotations

import errno
import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from gearwear.errors import BadFile

_REFUSALS = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES, errno.EIO, errno.EFBIG)
_PROBE = 1 << 16  # bytes, more than the block of any file system


@contextmanager
def atomic(path: str | Path) -> Iterator[str]:
    """Give a temporary name beside `path` that becomes `path` only if the body succeeds.

    Raises
    ------
    BadFile : the system refuses to write, as on a full disk; the message names the file and the reason.
    """
    # The host, as an orphan on another one may have the same number.
    temporary = f"{path}.{socket.gethostname()}.{os.getpid()}.tmp"
    try:
        yield temporary
        with open(temporary, "rb") as file:
            os.fsync(file.fileno())
        Path(temporary).replace(path)
    except (OSError, RuntimeError) as error:
        if refusal := _refusal(temporary, error):
            raise BadFile(f"{path}: cannot be written ({refusal}); mend that and run the workflow again") from None
        raise
    finally:
        with suppress(FileNotFoundError):
            Path(temporary).unlink()


def _refusal(temporary: str, error: Exception) -> str | None:
    """Return why the system would not write; netCDF hides the reason or takes it for another, writing on shows it."""
    try:
        with open(temporary, "ab") as file:
            file.write(bytes(_PROBE))
    except OSError as found:
        error = found
    if isinstance(error, OSError) and error.errno in _REFUSALS:
        return f"{error.strerror}, {errno.errorcode[error.errno]}"
    return None

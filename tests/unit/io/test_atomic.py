"""Files that are written complete or not at all, and why one could not be."""

import errno
import os
import re
from pathlib import Path

import pytest

from gearwear.io.atomic import atomic


def test_a_full_disk_is_named(tmp_path):
    with (
        pytest.raises(
            ValueError, match=re.escape("made.nc: cannot be written (No space left on device, ENOSPC); mend")
        ),
        atomic(tmp_path / "made.nc"),
    ):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "error", [RuntimeError("NetCDF: HDF error"), PermissionError(errno.EACCES, "Permission denied")]
)
def test_the_reason_that_netcdf_hides_or_takes_for_another_is_found(tmp_path, error):
    # a name that leads to a device which is always full
    with pytest.raises(ValueError, match="ENOSPC"), atomic(tmp_path / "made.nc") as temporary:
        Path(temporary).symlink_to("/dev/full")
        raise error
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("error", [RuntimeError("NetCDF: HDF error"), OSError("broken"), OSError(-101, "HDF error")])
def test_an_error_that_is_not_of_the_system_stays_as_it_is(tmp_path, error):
    with pytest.raises(type(error)) as raised, atomic(tmp_path / "made.nc"):
        raise error
    assert raised.value is error

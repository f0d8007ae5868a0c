"""Files that are written aside and renamed: each is whole, or the one before. An error names its file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Callable

ASIDE = ".tmp"


def write_whole(path: Path, content: "bytes | memoryview | str") -> None:
    """The content is on the disk when it returns. Raises OSError with the path and the reason; nothing is left aside then."""
    aside = path.with_name(path.name + ASIDE)
    try:
        try:
            with open(aside, "wb") as file:
                file.write(content.encode("utf-8") if isinstance(content, str) else content)
                file.flush()
                os.fsync(file.fileno())
            os.replace(aside, path)
        finally:
            aside.unlink(missing_ok=True)
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(path)) from error


def netcdf_content(fill: Callable) -> memoryview:
    """A netCDF-4 file that `fill(file)` fills, made in memory: the library meets no disk that may be full, whose torn file
    it would close a second time, which ends the process."""
    import netCDF4

    file = netCDF4.Dataset("in memory", "w", format="NETCDF4", memory=1)
    fill(file)
    return file.close()

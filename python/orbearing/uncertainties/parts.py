"""Libraries that not every installation has."""

from __future__ import annotations

import importlib

from orbearing.errors import CaseError


def openturns():
    """OpenTURNS, or the remedy."""
    return _library("openturns", "python3-openturns", "openturns")


def xarray():
    return _library("xarray", "python3-xarray python3-netcdf4", "xarray netCDF4")


def _library(name: str, debian: str, pypi: str):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise CaseError(f"orbearing uncertainty: the Python library {name} was not found ({error}); required: {name} "
                       f"(Debian: {debian}; PyPI: {pypi})") from error

"""A study as named arrays with units: the same content as a netCDF file and as an xarray Dataset."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.lives import life_in_words
from orbearing.studies.design import SPEED, Design, Parameter
from orbearing.studies.table import SPEED_COLUMN, ResultTable
from orbearing.units import units_of
from orbearing.whole_files import netcdf_content, write_whole

CONVENTIONS = "CF-1.10"

STATUS = "ok, or why a point has no result"


@dataclass(frozen=True)
class Variable:
    """An array along named dimensions."""

    name: str
    dimensions: tuple[str, ...]
    values: np.ndarray
    attributes: dict[str, Any]


@dataclass(frozen=True)
class Content:
    """Everything that a study's file holds."""

    dimensions: tuple[tuple[str, int], ...]
    coordinates: list[Variable]
    variables: list[Variable]
    attributes: dict[str, Any]


def cf_unit(unit: str) -> str:
    """As udunits and pint both read it: factors apart by a space."""
    return unit.replace(".", " ").replace("*", " ")


def name_of(parameter: Parameter) -> str:
    """A parameter's coordinate: its path, the speed as in the table of a sweep."""
    return SPEED_COLUMN if parameter.path == SPEED else parameter.path


def in_rpm(speed: Parameter) -> np.ndarray:
    """[rpm] Values of the speed."""
    return speed.values if speed.unit == "rpm" else speed.si * 60.0 / (2.0 * np.pi)


def peaks(design: Design, table: ResultTable, life_key: str) -> tuple[np.ndarray, np.ndarray]:
    """Of each variant the number of the point with the longest of these lives on the grid, -1 where none has one, and that life [h]."""
    life = table.column(life_key).reshape(-1, design.shape[-1])
    known = np.where(np.isfinite(life) & (life > 0.0), life, -np.inf)
    best = known.argmax(axis=1)
    longest = known[np.arange(len(known)), best]
    found = np.isfinite(longest)
    numbers = np.where(found, np.arange(len(known)) * design.shape[-1] + best, -1)
    return numbers, np.where(found, longest, np.nan)


def content_of(design: Design, table: ResultTable, attributes: dict[str, Any]) -> Content:
    """Named arrays of a study, finished or not; peaks by the life that its attribute `life_key` names. Columns without a number at any point are left out."""
    lengths = tuple((SPEED_COLUMN if name == SPEED else name, length) for name, length in design.dimensions)
    names = tuple(name for name, _ in lengths)
    coordinates = [Variable(name, (name,), np.arange(length), {"long_name": f"number of the {name}, from 0"})
                   for name, length in lengths if all(name_of(p) != name for p in design.parameters)]
    for p in design.parameters:
        attached = {"long_name": p.meaning, **({"units": cf_unit(p.unit)} if p.is_number else {})}
        along = SPEED_COLUMN if p.dimension == SPEED else p.dimension
        coordinates.append(Variable(name_of(p), (along,), in_rpm(p) if p.path == SPEED else p.values, attached))
    taken = {coordinate.name for coordinate in coordinates}
    variables = []
    for index, column in enumerate(table.columns):
        if column not in taken and not np.isnan(table.rows[:, index]).all():
            variables.append(_variable(column, names, table.rows[:, index].reshape(design.shape)))
    variables.append(Variable("status", names, table.status.reshape(design.shape), {"long_name": STATUS}))
    if design.over_speed and attributes["life_key"] in table.columns:
        variables += _peak_variables(design, table, names[:-1], attributes["life_key"])
    return Content(lengths, coordinates, variables, {"Conventions": CONVENTIONS, **attributes})


def _variable(name: str, dimensions: tuple[str, ...], values: np.ndarray, meaning: str = "") -> Variable:
    return Variable(name, dimensions, values, {"units": units_of(name), "long_name": meaning or life_in_words(name) or name.replace("_", " ")})


def _peak_variables(design: Design, table: ResultTable, dimensions: tuple[str, ...], life_key: str) -> list[Variable]:
    numbers, lives = peaks(design, table, life_key)
    speed = next(p for p in design.parameters if p.path == SPEED)
    found = numbers >= 0
    speeds = np.where(found, in_rpm(speed)[np.where(found, numbers % design.shape[-1], 0)], np.nan)
    shape = design.shape[:-1]
    point = Variable("peak_point", dimensions, numbers.reshape(shape), {"long_name": f"number of the point of the longest {life_key}"})
    return [_variable("peak_speed_rpm", dimensions, speeds.reshape(shape), f"speed of the longest {life_key} on the grid of speeds"),
            _variable("peak_life_h", dimensions, lives.reshape(shape), f"longest {life_key} over the grid of speeds"), point]


def to_xarray(content: Content):
    """The content as an xarray.Dataset."""
    import xarray

    def pairs(variables):
        return {v.name: xarray.Variable(v.dimensions, v.values, v.attributes) for v in variables}

    return xarray.Dataset(pairs(content.variables), pairs(content.coordinates), content.attributes)


def write_netcdf(path: Path, content: Content) -> None:
    """The content as a netCDF-4 file, written aside and renamed: it is whole or the one before."""

    def fill(file) -> None:
        file.setncatts(content.attributes)
        for name, length in content.dimensions:
            file.createDimension(name, length)
        coordinates = " ".join(v.name for v in content.coordinates if v.dimensions != (v.name,))
        for variable in content.coordinates:
            _put(file, variable)
        for variable in content.variables:
            _put(file, variable, coordinates)

    write_whole(path, netcdf_content(fill))


def content_of_xarray(dataset) -> Content:
    """The inverse of `to_xarray`."""
    def variables(found) -> list[Variable]:
        return [Variable(str(name), tuple(map(str, one.dims)), np.asarray(one.values), dict(one.attrs)) for name, one in found.items()]

    return Content(tuple((str(name), length) for name, length in dataset.sizes.items()), variables(dataset.coords), variables(dataset.data_vars), dict(dataset.attrs))


def _put(file, variable: Variable, coordinates: str = "") -> None:
    if variable.values.dtype.kind in "OU":
        target = file.createVariable(variable.name, str, variable.dimensions)
    else:
        target = file.createVariable(variable.name, variable.values.dtype, variable.dimensions, zlib=True, complevel=1, shuffle=True, endian="little",
                                     **({"fill_value": np.nan} if variable.values.dtype.kind == "f" else {}))
    target.setncatts({**variable.attributes, **({"coordinates": coordinates} if coordinates else {})})
    target[...] = variable.values

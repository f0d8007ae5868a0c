"""The result of a study: a table of all its points, the peak of each variant, pictures, a page."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.lives import LUNDBERG_PALMGREN
from orbearing.studies.dataset import content_of, in_rpm, peaks, to_xarray
from orbearing.studies.design import SPEED, Design
from orbearing.studies.folder import read_folder
from orbearing.studies.table import DONE, NOT_COMPUTED, ResultTable
from orbearing.units import units_in


@dataclass(frozen=True)
class StudyResult:
    """Points of a study, finished or not; `folder` is None where nothing was written."""

    header: dict
    design: Design
    table: ResultTable = field(repr=False)
    attributes: dict[str, Any] = field(repr=False)
    folder: Path | None = None

    @property
    def points(self) -> int:
        """Points of the study, finished or not."""
        return self.design.points

    @property
    def missing(self) -> int:
        """Points that are not computed yet."""
        return int(len(self.table.missing()))

    @property
    def failed(self) -> int:
        """Points that were computed and have no result; `status` says why."""
        return self.table.failed

    @property
    def warnings(self) -> list[str]:
        """What must be said of the results."""
        return [line for line in self.attributes.get("warnings", "").split("\n") if line]

    @property
    def life_key(self) -> str:
        """The governing life of its case, by which peaks and pictures go; a column of the table."""
        return self.attributes["life_key"]

    @property
    def parameters(self) -> tuple[str, ...]:
        """Paths of all that varies, the speed among them."""
        return tuple(parameter.path for parameter in self.design.parameters)

    def to_xarray(self):
        """An xarray.Dataset: every result over the dimensions of the study, all parameters as coordinates in their customary units, each variant's
        peak of the governing life on the grid as peak_speed_rpm [rpm] and peak_life_h [h]. `units` are as pint and udunits read them."""
        return to_xarray(content_of(self.design, self.table, self.attributes))

    def variants(self) -> list[dict[str, Any]]:
        """One record for each variant: its parameters (numbers in their customary units), and the peak of its governing life on the grid of speeds;
        that life under its own key where the speed is no dimension. None where no point has one."""
        design, speeds = self.design, self.design.shape[-1] if self.design.over_speed else 1
        own = [p for p in design.parameters if not (design.over_speed and p.path == SPEED)]
        first = np.arange(design.variants) * speeds
        columns = {p.path: p.values[design.along(p, first)].tolist() for p in own}
        if design.over_speed and self.life_key in self.table.columns:
            numbers, lives = peaks(design, self.table, self.life_key)
            speed = in_rpm(next(p for p in design.parameters if p.path == SPEED))
            columns["peak_speed_rpm"] = [float(speed[number % speeds]) if number >= 0 else None for number in numbers]
            columns["peak_life_h"] = [float(life) if np.isfinite(life) else None for life in lives]
        elif self.life_key in self.table.columns:
            columns[self.life_key] = [float(life) if np.isfinite(life) else None for life in self.table.column(self.life_key)]
        bad = ((self.table.status != DONE) & self.table.finished).reshape(-1, speeds).sum(axis=1)
        columns["failed_points"] = bad.tolist()
        return [dict(zip(columns, row)) for row in zip(*columns.values())]

    def failures(self) -> dict[str, int]:
        """Why points have no result, and how many each."""
        texts = self.table.status[(self.table.status != DONE) & (self.table.status != NOT_COMPUTED)]
        reasons, counts = np.unique(texts.astype(str), return_counts=True)
        return dict(zip(reasons.tolist(), counts.tolist()))

    def plot(self, axes=None):
        """Life over speed, a curve for each variant (of very many: median and quantiles), or life over the parameter where the speed is no dimension.
        Returns the matplotlib axes."""
        from orbearing.studies.pictures import life_picture

        return life_picture(self, axes)

    def report(self, path) -> Path:
        """Writes one self-contained page; returns its path."""
        from orbearing.studies.pictures import write_report

        return write_report(self, Path(path))

    def __repr__(self) -> str:
        sizes = " x ".join(f"{name} {length}" for name, length in self.design.dimensions)
        open_points = f", {self.missing} not computed" if self.missing else ""
        return f"StudyResult({self.header['case']}, {self.header['fidelity']}: {sizes} = {self.points} points, {self.failed} failed{open_points})"

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        try:
            return self.to_xarray()._repr_html_()
        except ImportError:
            return f"<pre>{self!r}</pre>"


def open_study(folder) -> StudyResult:
    """A study as its folder holds it, finished or not. Raises CaseError where there is none."""
    folder = Path(folder)
    header, design, table = read_folder(folder)
    # The peaks of folders whose header names no life go by that of Lundberg and Palmgren.
    attributes = {"life_key": LUNDBERG_PALMGREN, **header.pop("attributes", {})}
    return StudyResult(header, design, table, attributes, folder)


def json_of(result: StudyResult) -> str:
    """The result as one JSON object: what the command line prints with --json."""
    content = {"case": result.header["case"], "fidelity": result.header["fidelity"], "life_key": result.life_key,
               "dimensions": [{"name": name, "length": length} for name, length in result.design.dimensions],
               "parameters": [{"path": p.path, "dimension": p.dimension, "unit": p.unit or None, "meaning": p.meaning} for p in result.design.parameters],
               "points": result.points, "failed_points": result.failed, "missing_points": result.missing, "failures": result.failures(),
               "variants": result.variants(), "assumptions": json.loads(result.attributes.get("assumptions", "[]")), "warnings": result.warnings,
               "versions": {"orbearing": result.header["program_version"], "instruction_set": result.header["instruction_set"]}}
    content["units"] = {p.path: p.unit for p in result.design.parameters if p.unit} | units_in(content["variants"])
    return json.dumps(content, indent=2, allow_nan=False)

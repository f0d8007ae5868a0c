"""What the study found: numbers, arrays, pictures, files."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from orbearing.uncertainties.inputs import UncertainInputs
from orbearing.uncertainties.lives import Peaks
from orbearing.uncertainties.parts import xarray


class UncertaintyResult:
    """Frozen. `data` is what `orbearing uncertainty --json` prints; arrays are by sample.

    point_values (samples, inputs) and curve_values (curves, inputs) are in SI; point_lives (samples) and curve_lives (curves,
    speeds) in hours; peak_speeds [rpm] and peak_lives [h] of each curve. NaN where a point failed.
    """

    def __init__(self, data: dict, inputs: UncertainInputs, point_values, point_lives, speeds_rpm, curve_values, lives, peaks: Peaks):
        self._arrays = {"point_values": point_values, "point_lives": point_lives, "speeds_rpm": speeds_rpm,
                        "curve_values": curve_values, "curve_lives": lives[1:], "case_lives": lives[0],
                        "peak_speeds": peaks.speed_rpm[1:], "peak_lives": peaks.life_h[1:]}
        for array in self._arrays.values():
            array.setflags(write=False)
        self._data = data
        self.inputs = inputs

    @property
    def data(self) -> dict:
        """What `orbearing uncertainty --json` prints."""
        return self._data

    def __getattr__(self, name: str):
        try:
            return self.__dict__["_arrays"][name]
        except KeyError:
            raise AttributeError(name) from None

    @property
    def failed(self) -> int:
        """Operating points without a life, of all samples."""
        return int(np.isnan(self.point_lives).sum() + np.isnan(self.curve_lives).sum())

    def to_xarray(self):
        """Samples as an xarray Dataset with units as CF has them: of the operating point over `sample`, of whole curves over `curve` and
        `input_speed`."""
        xr = xarray()
        variables = {}
        for column, number in enumerate(self.inputs.numbers):
            attributes = {"units": number.unit, "long_name": number.path, "distribution": number.given}
            for prefix, dimension, values in (("", "sample", self.point_values), ("curve.", "curve", self.curve_values)):
                variables[prefix + number.path] = (dimension, values[:, column] * number.units_per_si, attributes)
        life = self._data["life"]
        hours = {"units": "h", "long_name": f"{life} of one bearing" if not life.startswith("system") else life}
        variables["life"] = ("sample", self.point_lives, hours)
        variables["curve.life"] = (("curve", "input_speed"), self.curve_lives, hours)
        variables["case.life"] = ("input_speed", self.case_lives, hours)
        variables["peak_speed"] = ("curve", self.peak_speeds, {"units": "rpm", "long_name": "input speed of the longest life"})
        variables["peak_life"] = ("curve", self.peak_lives, {**hours, "long_name": "life at the peak"})
        coordinates = {"input_speed": ("input_speed", self.speeds_rpm, {"units": "rpm"})}
        settings = {key: value for key, value in self._data["settings"].items()}
        return xr.Dataset(variables, coordinates, {"case": self._data["case"], "Conventions": "CF-1.8", **settings})

    def plot(self):
        """Three matplotlib figures by name: life over speed, the peak, the indices."""
        from orbearing.uncertainties.figures import figures

        return figures(self)

    def report(self, path) -> Path:
        """One page with the figures, nothing outside it; the same result gives the same bytes."""
        from orbearing.report import write_all
        from orbearing.uncertainties.page import page

        path = Path(path)
        write_all(path.parent, {path.name: page(self)})
        return path

    def json(self) -> str:
        """`data` as JSON text."""
        return json.dumps(self._data, indent=1, ensure_ascii=False) + "\n"

    def save(self, folder, resolved: str | None = None) -> Path:
        """uncertainty.json, samples.nc, uncertainty.html and the figures as SVG and PNG; case.resolved.yaml where its text is given."""
        from orbearing.uncertainties.files import save

        return save(self, Path(folder), resolved)

    def __repr__(self) -> str:
        point = self._data["operating_point"]
        middle = point["of_uncertain_inputs"]["percentiles"]
        return (f"UncertaintyResult({self._data['case']}: {self._data['life']} at {point['speed_rpm']:g} rpm, 5 to 95 %: "
                f"{middle['5']:,.0f} to {middle['95']:,.0f} h)")

    def _repr_html_(self) -> str:
        from orbearing.uncertainties.page import answer

        return answer(self)

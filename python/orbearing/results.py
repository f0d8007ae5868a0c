"""Results as frozen objects: the command line's JSON, its numbers as arrays, xarray datasets, plots and reports."""

from __future__ import annotations

import atexit
import contextlib
import html
import inspect
import json
import shutil
import sys
import tempfile
import weakref
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional, Protocol

import numpy as np

from orbearing.units import unit_in

if TYPE_CHECKING:
    import xarray
    from orbearing import _core
    from orbearing.blocks import FigureBlock


def number_array(values) -> np.ndarray:
    """Numbers with NaN in place of None, not to be written to."""
    array = np.array([np.nan if value is None else value for value in values], dtype=float)
    array.flags.writeable = False
    return array


def _frozen(value):
    if isinstance(value, dict):
        return MappingProxyType({key: _frozen(one) for key, one in value.items()})
    return tuple(_frozen(one) for one in value) if isinstance(value, list) else value


def _thawed(value):
    if isinstance(value, Mapping):
        return {key: _thawed(one) for key, one in value.items()}
    return [_thawed(one) for one in value] if isinstance(value, tuple) else value


def _new_axes(width: float = 1.0):
    """Axes of the size of the report's figures, so many times as wide."""
    from matplotlib import pyplot

    from orbearing import style

    figure, axes = pyplot.subplots(figsize=(style.PANEL[0] * width, style.PANEL[1]), layout="constrained")
    _watch(figure)
    return axes


_undrawn: list = []  # figures that nothing has shown or saved


def _watch(figure) -> None:
    """A script that ends with a plot that nothing has shown or saved says how; in a notebook it is drawn."""
    if not _undrawn:
        atexit.register(_say_how_to_show)
    _undrawn.append(figure)
    figure.canvas.mpl_connect("draw_event", lambda _: _undrawn.remove(figure) if figure in _undrawn else None)


def _say_how_to_show() -> None:
    if _undrawn:
        print("orbearing: plot() has drawn a figure that was neither shown nor saved; call matplotlib.pyplot.show(), or plot().figure.savefig('plot.png')",
              file=sys.stderr)
        _undrawn.clear()


class ComputedCase(Protocol):
    """What a result knows of its case, an orbearing.Case."""

    name: str
    core: "_core.CoreCase"

    def copy(self) -> "ComputedCase":
        """The same case, which changes by itself."""


class _KeptFolder:
    """A folder that goes with the last result that has it; other processes do not get it."""

    def __init__(self, path: str):
        weakref.finalize(self, shutil.rmtree, path, ignore_errors=True)

    def __copy__(self):
        return self

    def __deepcopy__(self, _):
        return self

    def __reduce__(self):
        return type(None), ()


class Result(Mapping):
    """What a command found. A mapping of the keys of its JSON; arrays are read-only.

    case: the case it was computed from. folder: where its files are, if anywhere; `kept`, a folder around it, goes with
    the result.
    """

    def __init__(self, data: dict, command: str, case: "ComputedCase", options: Optional[dict] = None, folder: Optional[str] = None,
                 kept: Optional[str] = None):
        self._data = _frozen(data)
        self._command, self._case, self._options = command, case, MappingProxyType(dict(options or {}))
        self._folder, self._kept = folder, _KeptFolder(kept) if kept else None
        self._whole = True

    def __getstate__(self):
        return {**self.__dict__, "_data": self.data, "_options": dict(self._options), "_has_kept": self._kept is not None}

    def __setstate__(self, state):
        has_kept = state.pop("_has_kept")
        self.__dict__.update({**state, "_data": _frozen(state["_data"]), "_options": MappingProxyType(state["_options"])})
        if has_kept and self._kept is None:
            self.__dict__["_folder"] = None  # of another process, which deletes it

    @property
    def data(self) -> dict:
        """The JSON object of the command line, as plain dicts and lists of its own."""
        return _thawed(self._data)

    @property
    def case(self) -> "ComputedCase":
        """The case it was computed from, a copy."""
        return self._case.copy()

    @property
    def folder(self) -> Optional[Path]:
        """Where its files are, if anywhere."""
        return Path(self._folder) if self._folder else None

    @property
    def warnings(self) -> tuple[str, ...]:
        """Formulas outside the range of their source, inputs that do not fit together, in words."""
        return tuple(self._data.get("warnings", ()))

    def __getitem__(self, key: str):
        return self._data[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def __setattr__(self, name: str, value) -> None:
        if "_whole" in self.__dict__:
            raise AttributeError(f"{type(self).__name__} is a result and does not change")
        super().__setattr__(name, value)

    def to_xarray(self) -> "xarray.Dataset":
        """Tables of the result along a dimension each, single numbers as scalars; units in `attrs["units"]`."""
        import xarray

        variables: dict = {}
        for key, value in self._data.items():
            if isinstance(value, bool) or isinstance(value, str) or value is None:
                continue
            if isinstance(value, (int, float)):
                variables[key] = ((), value, {"units": self._unit(key)})
            elif isinstance(value, tuple) and value and all(isinstance(one, (int, float)) for one in value):
                variables[key] = ((key.split("_")[0],), number_array(value), {"units": self._unit(key)})
            elif isinstance(value, tuple) and value and all(isinstance(one, Mapping) for one in value) and key not in _REMARKS:
                # Names of several tables may be the same: those of the first are kept as they are.
                for name, column in _table(value, key, self._units()).items():
                    variables[name if name not in variables else f"{column[0][0]}_{name}"] = column
        return xarray.Dataset(variables, attrs=self._attributes())

    def plot(self, axes=None):
        """Draws the result with matplotlib and returns the axes. A notebook shows them; in a script call matplotlib.pyplot.show(), or
        `plot().figure.savefig("plot.png")`."""
        raise NotImplementedError(f"a result of {self._command} has no plot of its own; see to_xarray() and report()")

    def report(self, path) -> Path:
        """Writes the report, one self-contained page, to the file `path` and returns it."""
        from orbearing import _core

        with self._written() as folder:
            _core.compute(None, "report", {"folders": [folder]})
            target = Path(path)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes((Path(folder) / "report.html").read_bytes())
            animations = Path(folder) / "animations"
            if animations.is_dir():
                shutil.copytree(animations, target.parent / "animations", dirs_exist_ok=True)
        return target

    def figures(self) -> dict[str, "FigureBlock"]:
        """The figures of the report by name, each with its pictures (SVG), caption and numbers; notebooks show them."""
        from orbearing import _core, report_data
        from orbearing.report import blocks_of
        from orbearing.result_folder import Report

        with self._written() as folder:
            text, _ = _core.compute(None, "report", {"folders": [folder], "data_only": True})
            content = report_data.complete(json.loads(text), report_data.Program(Path(folder)))
            return {block.slug: block for block in blocks_of(Report(content, Path(folder)))}

    @contextlib.contextmanager
    def _written(self):
        """The folder of the results; one of a result without is computed again into a folder that goes."""
        from orbearing import _core

        if self._folder is not None:
            yield self._folder
            return
        with tempfile.TemporaryDirectory(prefix="orbearing-") as spare:
            folder = str(Path(spare) / "results")
            _core.compute(self._case.core, self._command, {**self._options, "output": folder})
            yield folder

    def __repr__(self) -> str:
        return f"<orbearing.{type(self).__name__} of {self._case.name}: {', '.join(self._data)}>"

    def _repr_html_(self) -> str:
        single = {key: value for key, value in self._data.items() if isinstance(value, (int, float, str))}
        return _html_table(["", ""], [[key, _shown(value)] for key, value in single.items()], f"{self._command} of {self._case.name}",
                           self.warnings)

    def _units(self) -> Mapping[str, Any]:
        return self._data.get("units", {})

    def _unit(self, name: str) -> str:
        return unit_in(self._units(), name)

    def _attributes(self) -> dict:
        from orbearing import _core

        return {"Conventions": "CF-1.10", "title": f"{self._command} of {self._case.name}", "source": f"Orbearing {_core.version}",
                "case_hash": self._case.core.hash()}


# Lists of records that are no results.
_REMARKS = ("assumptions", "inputs", "derived")


def _table(rows, key: str, units) -> dict:
    """Columns of records of numbers and texts, along a dimension called as the list, in the singular."""
    dimension = {"meshes": "mesh", "envelope_peaks": "envelope_peak"}.get(key, key[:-1] if key.endswith("s") else key)
    columns: dict = {}
    names = dict.fromkeys(name for row in rows for name in row)
    for name in names:
        values = [row.get(name) for row in rows]
        shown = name if name not in ("case",) else f"{dimension}_{name}"
        if all(value is None or isinstance(value, (int, float)) for value in values):
            columns[shown] = ((dimension,), number_array(values), {"units": unit_in(units, name)})
        elif all(value is None or isinstance(value, str) for value in values):
            columns[shown] = ((dimension,), np.array([value or "" for value in values], dtype=object))
    return columns


def _shown(value) -> str:
    return f"{value:.6g}" if isinstance(value, float) else html.escape(str(value))


def _html_table(heads, rows, title: str, warnings=()) -> str:
    head = "".join(f"<th>{one}</th>" for one in heads)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    remarks = "".join(f"<p>⚠ {html.escape(one)}</p>" for one in warnings)
    return f"<b>{html.escape(title)}</b><table><tr>{head}</tr>{body}</table>{remarks}"


class SweepResult(Result):
    """Operating points. Columns of sweep.csv are attributes: result.L10mrh, result.life_h, result.input_speed_rpm, ... (points).

    life_key: the governing life, a column. peak: speed and that life of the grid's best point and of the best of all, as in the JSON.
    """

    @property
    def life_key(self) -> str:
        """The governing life (`life.method`), by which the peak is found."""
        return self.peak["life_key"]

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns, with their units."""
        return tuple(name for name in self._data["points"][0] if name != "planets")  # lists, of planets that carry unlike loads

    @property
    def peak(self) -> Mapping[str, Optional[float]]:
        """Of the governing life, life_key: speed_rpm and life_h of the grid's best point, refined_speed_rpm and refined_life_h of the best
        of all, and between_rpm, the neighbours of that one."""
        return self._data["peak"]

    @property
    def refined(self) -> np.ndarray:
        """Which points were added around the peak."""
        return np.array([point.get("refined") is True for point in self._data["points"]])

    def column(self, name: str) -> np.ndarray:
        """A column by its name: numbers with NaN where there is none, or texts."""
        values = [point[name] for point in self._data["points"]]
        if all(value is None or isinstance(value, (int, float)) for value in values):
            return number_array(values)
        return np.array([value or "" for value in values], dtype=object)

    def __getattr__(self, name: str):
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._data["points"][0]:
            return self.column(name)
        raise AttributeError(f"a sweep has no column {name!r}; its columns: {', '.join(self._data['points'][0])}")

    def to_xarray(self, points: bool = False) -> "xarray.Dataset":
        """The grid with its axes as dimensions, the first of them input_speed_rpm; with `points`, all of them in a row,
        those that were added around the peak too."""
        import xarray

        attributes = {**self._attributes(), **{f"peak_{key}": value for key, value in self.peak.items()
                                                if isinstance(value, (int, float))}}
        names = [name for name in self.columns if name != "refined"]
        chosen = np.arange(len(self["points"])) if points else np.flatnonzero(~self.refined)
        flat = xarray.Dataset({name: (("point",), self.column(name)[chosen], {"units": self._unit(name)} if name != "status" else {})
                               for name in names if self.column(name).dtype == float or name == "status"}, attrs=attributes)
        if points:
            return flat.assign(refined=(("point",), self.refined)).set_coords("input_speed_rpm")
        axes = ["input_speed_rpm"] + [name for name in names if "." in name and not name.startswith("sets.")]
        axes = [name for name in axes if len(np.unique(flat[name])) > 1 or name == "input_speed_rpm"]
        if np.prod([len(np.unique(flat[name])) for name in axes]) != len(chosen):
            return flat.set_coords(axes)  # no grid, as with the bins of a load spectrum
        if len(axes) == 1:
            return flat.swap_dims(point=axes[0]).set_coords(axes)
        import pandas

        units = {name: dict(flat[name].attrs) for name in axes}
        index = pandas.MultiIndex.from_arrays([flat[name].values for name in axes], names=axes)
        grid = flat.drop_vars(axes).assign_coords(point=index).unstack("point")
        for name in axes:
            grid[name].attrs.update(units[name])
        return grid

    def series(self, point: int = 0) -> "xarray.Dataset":
        """What the file of a point holds: loads by place, and in motion all that was kept over time. Needs a result with a
        folder, as of one in motion."""
        import xarray

        if self._folder is None:
            raise ValueError("found a result without files; required: one in motion, or output=FOLDER")
        return xarray.load_dataset(sorted((Path(self._folder) / "points").glob("*.nc"))[point])

    def plot(self, axes=None):
        """Governing life over speed, with the peak."""
        from orbearing import style

        axes = axes or _new_axes()
        speed, life = self.input_speed_rpm, self.column(self.life_key)
        order = np.argsort(speed, kind="stable")
        grid = ~self.refined[order]
        axes.plot(speed[order], np.where(life[order] > 0, life[order], np.nan), color=style.BLUE, linewidth=1.0)
        axes.plot(speed[order][grid], life[order][grid], "o", color=style.BLUE, markerfacecolor="white", label="points of the sweep")
        best, longest = self.peak.get("refined_speed_rpm"), self.peak.get("refined_life_h")
        if best and longest:
            axes.plot([best], [longest], "*", color=style.ORANGE, markersize=12, markeredgecolor=style.BLACK,
                      label=f"peak: {best:,.0f} rpm, {longest:,.0f} h")
        style.speed_axis(axes)
        style.life_axis(axes, self.life_key)
        axes.set_title(self._case.name, loc="left")
        axes.legend()
        return axes

    def _repr_html_(self) -> str:
        from orbearing import style

        shown = ["input_speed_rpm", "planet_load_N", "inner_load_max_N", "outer_load_max_N", self.life_key, f"system_{self.life_key}", "status"]
        rows = [[_shown(point[name]) for name in shown] for point in self["points"] if not point.get("refined")]
        best = self.peak.get("refined_speed_rpm")
        title = f"{self._case.name}, {self._options.get('fidelity', 'quasi-static')}" + (
            f": {style.life_name(self.life_key)} peaks at {best:,.0f} rpm with {self.peak['refined_life_h']:,.0f} h" if best else "")
        return _html_table(shown, rows, title, self.warnings)


class CheckResult(Result):
    """Inputs and what follows from them."""

    def _repr_html_(self) -> str:
        rows = [[row["path"], _shown(row["given"]), row["standing"], _shown(row["reason"])] for row in self["inputs"]]
        return _html_table(["input", "value", "", "reason"], rows, f"check of {self._case.name}", self.warnings)


class ModesResult(Result):
    """Natural frequencies: arrays frequency_Hz and multiplicity, texts kind (modes)."""

    @property
    def frequency_Hz(self) -> np.ndarray:
        """[Hz] (modes)"""
        return number_array([mode["frequency_Hz"] for mode in self["modes"]])

    @property
    def kind(self) -> tuple[str, ...]:
        """rotational, translational or planet; of a pair of bearings tilt_x and so on (modes)"""
        return tuple(mode["kind"] for mode in self["modes"])

    @property
    def multiplicity(self) -> np.ndarray:
        """How often each frequency occurs (modes)"""
        return number_array([mode["multiplicity"] for mode in self["modes"]])

    def plot(self, axes=None):
        """Frequencies, coloured by kind."""
        from orbearing import style

        axes = axes or _new_axes()
        kinds = list(dict.fromkeys(self.kind))
        for kind, colour in zip(kinds, style.SERIES[1:] + style.SERIES[:1]):
            places = [i for i, one in enumerate(self.kind) if one == kind]
            axes.bar(places, self.frequency_Hz[places], color=colour, label=kind)
        axes.set_xlabel("mode")
        axes.set_ylabel("natural frequency (Hz)")
        style.thousands(axes.yaxis)
        axes.legend()
        return axes


class MeshResult(Result):
    """Stiffness of each mesh over a mesh period."""

    def to_xarray(self) -> "xarray.Dataset":
        """stiffness_N_per_m (mesh, fraction) and the scalars of each mesh."""
        import xarray

        meshes = self["meshes"]
        fraction = number_array([point[0] for point in meshes[0]["curve"]])
        curves = np.array([[point[1] for point in mesh["curve"]] for mesh in meshes], dtype=float)
        variables = _table(meshes, "meshes", self._units())
        variables["stiffness_N_per_m"] = (("mesh", "fraction"), curves, {"units": "N m-1", "long_name": "mesh stiffness"})
        names = variables.pop("name")[1]
        return xarray.Dataset(variables, attrs=self._attributes(), coords={
            "mesh": names, "fraction": ("fraction", fraction, {"units": "1", "long_name": "share of the mesh period"})})

    def plot(self, axes=None):
        """Stiffness over the mesh period."""
        from orbearing import style

        axes = axes or _new_axes()
        data = self.to_xarray()
        for name, colour, dash in zip(data.mesh.values, style.SERIES * 4, style.DASHES * 4):
            axes.plot(data.fraction, 1e-6 * data.stiffness_N_per_m.sel(mesh=name), color=colour, linestyle=dash, label=name)
        axes.set_xlabel("share of the mesh period")
        axes.set_ylabel("mesh stiffness (N/µm)")
        axes.set_ylim(bottom=0)
        axes.legend(fontsize=7)
        return axes


class CrownResult(Result):
    """Lives and pressures over drop and tilt; `optimum`, `straight` and `recommended` as in the JSON. Their governing_life_h is the life
    that `life_key` names, life_h that of Lundberg and Palmgren."""

    @property
    def life_key(self) -> str:
        """The life that the optimum makes longest."""
        return self["life_key"]

    @property
    def optimum(self) -> Mapping[str, Any]:
        """The profile and drop with the longest governing life, the worst over the tilts studied."""
        return self["optimum"]

    @property
    def straight(self) -> Mapping[str, Any]:
        """The same of straight rollers."""
        return self["straight"]

    def plot(self, axes=None):
        """Governing life over the drop, a line for each tilt."""
        from orbearing import style

        axes = axes or _new_axes()
        series: dict = {}
        stated = self["tilt"] == "stated"  # else each drop has a tilt of its own
        for point in self["points"]:
            series.setdefault((point.get("profile"), point.get("tilt_mrad") if stated else None), []).append(point)
        for ((profile, tilt), points), colour, dash in zip(series.items(), style.SERIES * 8, style.DASHES * 8):
            label = style.tilt_text(tilt) if profile is None else f"{profile}, {style.tilt_text(tilt)}"
            axes.plot([p["drop_um"] for p in points], [p["governing_life_h"] for p in points], "o", color=colour, linestyle=dash, markersize=3.5,
                      label=label)
        axes.plot([self.optimum["drop_um"]], [self.optimum["governing_life_h"]], "*", color=style.ORANGE, markeredgecolor=style.BLACK,
                  markersize=12, label="optimum")
        axes.set_xlabel("drop of one roller (µm)")
        axes.set_ylabel(style.life_label(self.life_key))
        style.thousands(axes.yaxis)
        axes.legend()
        return axes


class StiffnessResult(Result):
    """5 x 5 stiffness over speed and load."""

    def to_xarray(self) -> "xarray.Dataset":
        """stiffness (point, force, displacement) in N/m, N/rad, N m/m and N m/rad, with speed and loads of each point."""
        import xarray

        points = self["points"]
        matrices = np.array([[[np.nan if value is None else value for value in row] for row in point["stiffness"]]
                             if point["stiffness"] is not None else np.full((5, 5), np.nan) for point in points], dtype=float)
        freedoms = ["x", "y", "z", "tilt_x", "tilt_y"]
        loads = {f"load_{key}": (("point",), number_array([point["load"].get(key) for point in points]), {"units": self._unit(key)})
                 for key in points[0].get("load", {})}
        speed = number_array([point.get("speed_rpm") for point in points])
        return xarray.Dataset({"stiffness": (("point", "force", "displacement"), matrices), "speed_rpm": (("point",), speed, {"units": "rpm"}),
                               **loads}, coords={"force": freedoms, "displacement": freedoms}, attrs=self._attributes())

    def ross_element(self, n: int, load: int = 0):
        """A bearing for a rotor in ROSS (ross-rotordynamics 2 and 3) at node `n`, undamped: radial stiffness over speed under
        the load of that number, in the order in which the table has them. x is along the load here; weight in ROSS is along y."""
        import ross

        keys = [tuple(round(value, 6) for value in point["load"].values()) for point in self["points"]]  # moments of 0 are round-off
        chosen = list(dict.fromkeys(keys))[load]
        points = [point for point, key in zip(self["points"], keys) if key == chosen]
        points = sorted(points, key=lambda point: point["speed_rpm"])
        terms = {f"k{a}{b}": [point["stiffness"][i][j] for point in points] for i, a in enumerate("xy") for j, b in enumerate("xy")}
        if len(points) == 1:
            return ross.BearingElement(n=n, cxx=0.0, **{name: values[0] for name, values in terms.items()})
        # Release 3 warns below five speeds: those between are linear, as in ross.xls.
        parts = -(-4 // (len(points) - 1))
        at, every = np.arange(len(points)), np.arange(parts * (len(points) - 1) + 1) / parts
        terms = {name: np.interp(every, at, values).tolist() for name, values in terms.items()}
        speeds = np.interp(every, at, [point["speed_rpm"] * np.pi / 30 for point in points]).tolist()
        # `frequency` is that of the excitation from release 3 on; `speed` is the rotor's in each release that knows it.
        known = inspect.signature(ross.BearingElement.__init__).parameters
        return ross.BearingElement(n=n, cxx=[0.0] * len(every), **{"speed" if "speed" in known else "frequency": speeds}, **terms)

    def plot(self, axes=None):
        """Diagonal terms in translation over the points."""
        from orbearing import style

        axes = axes or _new_axes()
        data = self.to_xarray()
        for name, colour in zip("xyz", style.SERIES):
            axes.plot(data.speed_rpm, 1e-6 * data.stiffness.sel(force=name, displacement=name), "o-", color=colour, label=f"{name}{name}")
        axes.set_xlabel("speed (rpm)")
        axes.set_ylabel("stiffness (N/µm)")
        axes.legend()
        return axes


class SensitivityResult(Result):
    """Derivatives of a result by the numbers of a case, the largest elasticity first."""

    def to_xarray(self) -> "xarray.Dataset":
        """derivative, its error and elasticity (input), with the value, unit and meaning of each; what has no derivative is left out."""
        import xarray

        columns = _table(self["inputs"], "inputs", self._units())
        paths = columns.pop("path")[1]
        return xarray.Dataset(columns, coords={"input": paths}, attrs=self._attributes())

    def plot(self, axes=None, most: int = 15):
        """Elasticities, the largest `most` of them."""
        from orbearing import style

        axes = axes or _new_axes(width=1.4)
        rows = [row for row in self["inputs"] if row["elasticity"] is not None][:most][::-1]
        axes.barh([row["path"] for row in rows], [row["elasticity"] for row in rows],
                  color=[style.BLUE if row["elasticity"] > 0 else style.VERMILION for row in rows])
        axes.axvline(0.0, color=style.BLACK, linewidth=0.8)
        axes.set_xlabel(f"change of {self.get('quantity', 'life')} by 1 % more of the input (%), {self._case.name}")
        axes.set_ylabel("")
        return axes

    def _repr_html_(self) -> str:
        shown = ["path", "value", "unit", "derivative", "elasticity"]
        rows = [[_shown(row.get(name)) for name in shown] for row in self["inputs"]]
        return _html_table(shown, rows, f"sensitivities of {self._case.name}", self.warnings)

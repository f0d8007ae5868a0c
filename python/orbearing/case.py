"""A case: read, changed, computed."""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
import warnings as python_warnings
from pathlib import Path
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from orbearing import _core
from orbearing.errors import CaseError
from orbearing.results import CheckResult, CrownResult, MeshResult, ModesResult, Result, SensitivityResult, StiffnessResult, SweepResult

PathLike = Union[str, "os.PathLike[str]"]
Progress = Union[None, bool, Callable[[int, int, str], None]]


def load(path: PathLike, settings: Optional[Mapping[str, Any]] = None) -> "Case":
    """Reads and checks a case file, or the case.yaml of a folder.

    settings: values in place of the file's, by path, as with case[path] = value.
    Raises CaseError with every mistake, each with file, line, column and key.
    """
    if path == "":
        raise CaseError("path: found an empty text; required: a case file or its folder")
    file = Path(path)
    file = file / "case.yaml" if file.is_dir() else file
    return Case(file=str(file), settings=settings)


def parse(text: str, name: str = "case", settings: Optional[Mapping[str, Any]] = None) -> "Case":
    """The same of a text; `name` stands for the file in messages."""
    return Case(file=name, text=text, settings=settings)


def cases() -> dict[str, Path]:
    """Cases that ship with the package, by name."""
    here = Path(__file__)
    places = [here.parent / "share" / "orbearing" / "cases", here.resolve().parents[2] / "cases", here.parents[2] / "cases"]
    if len(here.parents) > 4:  # PREFIX/lib/python3/dist-packages/orbearing, as Debian has it
        places.append(here.parents[4] / "share" / "orbearing" / "cases")
    for folder in places:
        if folder.is_dir():
            own, validation = folder.glob("*/case.yaml"), folder.glob("validation/*/case.yaml")
            return {file.parent.name: file for file in [*sorted(own), *sorted(validation)]}
    return {}


def evaluate(case: "Case", paths: Sequence[str], values, fidelity: str = "quasi-static", jobs: int = 0,
             progress: Progress = None) -> tuple[list[str], np.ndarray, list[str]]:
    """Operating points of a case with numbers replaced, all in one call and without files.

    paths: inputs of the case, input.speed as any other; "path[i]" is element i of a list of numbers.
    values: (variants, paths), in SI.
    Returns the names of a sweep's columns, their numbers (variants, columns) with NaN where there is none, and each
    variant's status. The numbers are those of a sweep to the last bit, whatever `jobs`.
    """
    table = np.ascontiguousarray(values, dtype=float)
    with _reporting(progress, len(table)) as report:
        return _core.evaluate(case.core, list(paths), table, fidelity, jobs, report)


class Case:
    """A case with its changes. Reading an input gives its value in SI; what is written is a number in SI or text as in a case file.

    It keeps the text that it was read from, and the files that the text names: what becomes of them has no effect on it."""

    def __init__(self, file: str, text: Optional[str] = None, settings: Optional[Mapping[str, Any]] = None):
        self._source: dict = {"name": file} if text is None else {"name": file, "text": text, "files": {}}
        self._settings: list[tuple[str, str]] = []
        if not isinstance(settings or {}, Mapping):
            raise CaseError(f"settings: found a value of type {type(settings).__name__}; required: a dict of values by their paths")
        for path, value in (settings or {}).items():
            self._replace_setting(path, value)
        self._take(self._settings)

    def __getstate__(self):
        # Another process may not see the files.
        return {"source": self._source, "settings": self._settings}

    def __setstate__(self, state):
        self._source, self._settings = state["source"], []
        self._take([tuple(one) for one in state["settings"]])

    @property
    def core(self) -> "_core.CoreCase":
        """The checked case; it never changes, a change of an input makes another."""
        return self._core

    @property
    def name(self) -> str:
        """The name that the case gives itself."""
        return self._core.name()

    @property
    def model(self) -> str:
        """What is computed: planetary-drivetrain, ball-bearing, ..."""
        return self._core.model()

    @property
    def life_key(self) -> Optional[str]:
        """The governing life (`life.method`): L10mrh, L10rh, L10mh, L10h or life_h; None of a model without one."""
        from orbearing.lives import governing_life

        governing = governing_life(self._core)
        return governing and governing["key"]

    @property
    def resolved(self) -> str:
        """The resolved case as YAML, from which the same numbers follow."""
        return self._core.resolved()

    @property
    def inputs(self) -> list[dict]:
        """All that may stand in this case: path, kind, unit, si_unit, meaning, given, source and reason of each."""
        return self._core.inputs()

    def __getitem__(self, path: str):
        """The value at a path: a number in SI, a text, a switch, a list, or rows as lists or dicts; None where it has none.
        What is read may be written back."""
        return self._core.value(_path(path))

    def given(self, path: str) -> Optional[str]:
        """The value as written, with its unit: "10 um"."""
        return self._core.given(_path(path))

    def __setitem__(self, path: str, value) -> None:
        """Replaces an independent value, and all that follows from it: a text with its unit ("80 um"), a number in SI
        (8e-5), a switch, a list, or a block as a dict; None leaves the key out, as `del` does. Raises CaseError, and leaves the case as
        it was, where it does not fit or another input replaces it: what is written reads back as it was written."""
        self._change({path: value})

    def __delitem__(self, path: str) -> None:
        """Leaves a key, or a block of keys, out of the case: its default counts, if it has one. Raises KeyError where the case does not state it."""
        if not self._states(_path(path)):
            raise KeyError(f"{path}: not stated by the case")
        self._change({path: None})

    def copy(self, settings: Optional[Mapping[str, Any]] = None) -> "Case":
        """A case of its own, with further values replaced."""
        other = Case.__new__(Case)
        other._source, other._settings, other._core = self._source, list(self._settings), self._core
        if settings:
            other._change(settings)
        return other

    def check(self) -> CheckResult:
        """Every input and what follows from it."""
        return self._compute("check", CheckResult)

    def run(self, fidelity: Optional[str] = None, output: Optional[PathLike] = None, gears: bool = False,
            progress: Progress = None) -> Result:
        """The case's own analysis at its operating point; `gears`: the vibration of the gears alone."""
        kind = SweepResult if self.model == "planetary-drivetrain" and not gears else Result
        return self._compute("run", kind, output=output, progress=progress, fidelity=fidelity, gears=gears or None)

    def sweep(self, fidelity: str = "quasi-static", jobs: int = 0, grid_only: bool = False, direction: Optional[str] = None,
              output: Optional[PathLike] = None, resume: bool = False, progress: Progress = None) -> SweepResult:
        """All operating points of the case, and those that refine the peak of life unless `grid_only`.

        fidelity: quasi-static, dynamic, co-simulated or monolithic.
        direction: "up" or "down": each point from the final state of its neighbour in speed.
        output: folder of the results, as of the command line. In motion a temporary one is kept with the result where
        none is given, so that its points and its report need no second computation.
        """
        return self._compute("sweep", SweepResult, output=output, progress=progress, fidelity=fidelity,
                             jobs=jobs or None, grid_only=grid_only or None, resume=resume or None, **{"continue": direction})

    def crown(self, output: Optional[PathLike] = None, progress: Progress = None, jobs: int = 0, **options) -> CrownResult:
        """Trade study of the rollers' profile; options are those of `orbearing crown`, with _ for -: tilts, drops, ..."""
        return self._compute("crown", CrownResult, output=output, progress=progress, jobs=jobs or None, **options)

    def modes(self, speed: Optional[str] = None) -> ModesResult:
        """Natural frequencies and what each mode is; at rest unless a speed such as "6000 rpm" is given."""
        return self._compute("modes", ModesResult, speed=speed)

    def mesh(self) -> MeshResult:
        """Mesh stiffness over a mesh period, contact ratio and phases."""
        return self._compute("mesh", MeshResult)

    def stiffness(self, output: Optional[PathLike] = None) -> StiffnessResult:
        """5 x 5 stiffness of a bearing over speed and load."""
        return self._compute("stiffness", StiffnessResult, output=output)

    def sensitivities(self, output: Optional[PathLike] = None, fidelity: Optional[str] = None, result: str = "", by: Sequence[str] = (),
                      jobs: int = 0, progress: Progress = None) -> SensitivityResult:
        """Derivatives of the life, or of the number of a run whose key is `result`, by every number of the case or of the inputs `by`."""
        return self._compute("sensitivities", SensitivityResult, output=output, progress=progress, fidelity=fidelity, result=result or None,
                             by=list(by), jobs=jobs or None)

    def table(self, output: PathLike, over: Optional[Mapping[str, tuple]] = None, results: Sequence[str] = (), fidelity: Optional[str] = None,
              bound: Optional[float] = None, points: Optional[int] = None, jobs: int = 0, resume: bool = False,
              progress: Progress = None) -> "Table":
        """Results over up to 6 inputs as a table in the folder `output`; over: two ends of each input, by path, as in a case
        or in SI; without it the ranges of the case's sweep. Options as of `orbearing table`."""
        from orbearing.table import Table

        ends = {path: [_as_text(path, end) for end in pair] for path, pair in (over or {}).items()}
        self._compute("table", Result, output=output, progress=progress, fidelity=fidelity, bound=bound, points=points, jobs=jobs or None,
                      resume=resume or None, over=[f"{path}={low}..{high}" for path, (low, high) in ends.items()],
                      result=list(results))
        return Table(output)

    def uncertainty(self, **options) -> "UncertaintyResult":
        """See orbearing.uncertainty(): the spread of life by the numbers that the case's block `uncertain:` names."""
        from orbearing.uncertainties import uncertainty

        return uncertainty(self, **options)

    def study(self, vary: Optional[Mapping[str, Any]] = None, **options) -> "StudyResult":
        """See orbearing.study(): many variants in one table."""
        from orbearing.studies import study

        return study(self, vary, **options)

    def signals(self, vary: Sequence[str] = (), output: Optional[PathLike] = None, fidelity: Optional[str] = None,
                noise: float = 0.0, seed: int = 1, progress: Progress = None) -> Result:
        """Labelled vibration signals of a scratched bearing; `vary` as "path=[value, value]"."""
        return self._compute("signals", Result, output=output, progress=progress, fidelity=fidelity, vary=list(vary), noise=noise,
                             seed=seed)

    def fmu(self, path: PathLike, fmi: int = 2, model: str = "bearing", windows: bool = False, progress: Progress = None) -> Result:
        """Writes an FMU: one bearing of one planet, or the gear set. windows: with the library for Windows, which the first use builds."""
        return self._compute("fmu", Result, output=path, progress=progress, fmi=str(fmi), model=model, windows=windows or None)

    def bearing(self) -> "Bearing":
        """A planet bearing of this case that the caller moves, as the FMU would be moved, in this process."""
        from orbearing.machine import Bearing

        return Bearing(self)

    def gears(self) -> "Gears":
        """The gear set without its planet bearings, to which the caller brings their forces."""
        from orbearing.machine import Gears

        return Gears(self)

    def evaluate(self, paths: Sequence[str], values, fidelity: str = "quasi-static", jobs: int = 0, progress: Progress = None):
        """See orbearing.evaluate()."""
        return evaluate(self, paths, values, fidelity, jobs, progress)

    def __repr__(self) -> str:
        changed = "".join(f", {path}={text}" for path, text in self._settings)
        return f"<orbearing.Case {self.name} ({self.model}){changed}>"

    def _repr_html_(self) -> str:
        import html

        rows = "".join(
            f"<tr><td><code>{row['path']}</code></td><td>{html.escape(row['given'])}</td><td>{row['source']}</td>"
            f"<td>{html.escape(row['reason'] or row['meaning'])}</td></tr>"
            for row in self.inputs if row["given"] is not None and row["source"] in ("given", "assumed"))
        return (f"<b>{html.escape(self.name)}</b> ({self.model})<table><tr><th>input</th><th>value</th><th></th>"
                f"<th>reason or meaning</th></tr>{rows}</table>")

    def _change(self, settings: Mapping[str, Any]) -> None:
        before = list(self._settings)
        try:
            for path, value in settings.items():
                self._replace_setting(path, value)
            self._take(self._settings)
        except BaseException:
            self._settings = before
            raise

    def _states(self, path: str) -> bool:
        first, _, axis = path.partition(".")
        if first == "sweep":
            return axis in self._core.axes() if axis else bool(self._core.axes())
        return first in ("uncertain", "assumed") or any(
            (row["path"] == path or row["path"].startswith(path + ".")) and row["source"] in ("given", "assumed") for row in self.inputs)

    def _replace_setting(self, path: str, value) -> None:
        text = _NOTHING if value is None else _as_text(_path(path), value)
        # A former setting within a block that is replaced would otherwise be put into the new one.
        kept = [one for one in self._settings if one[0] != path and not one[0].startswith(path + ".")]
        self._settings = [*kept, (path, text)]

    def _take(self, settings: list[tuple[str, str]]) -> None:
        """Reads what is kept of the case with settings."""
        source = self._source
        try:
            if "text" in source:
                self._core = _core.parse(source["text"], source["name"], settings, source["files"], as_set=True)
            else:
                self._core = _core.load(source["name"], settings, as_set=True)
        except CaseError as error:
            raise error.without_option() from None
        self._source, self._settings = self._core.source(), settings

    def _compute(self, command: str, kind, output: Optional[PathLike] = None, progress: Progress = None, **options):
        given = {name: value for name, value in options.items() if value is not None}
        kept = None
        if output is not None:
            given["output"] = os.fspath(output)
        elif command in ("run", "sweep") and given.get("fidelity", "quasi-static") != "quasi-static" and kind is SweepResult:
            kept = tempfile.mkdtemp(prefix="orbearing-")
            given["output"] = str(Path(kept) / "results")
        try:
            with _reporting(progress, None) as report:
                text, failures = _core.compute(self._core, command, given, report)
        except BaseException:
            if kept:
                shutil.rmtree(kept, ignore_errors=True)
            raise
        found = json.loads(text)
        for line in [*failures, *_implausible(found)]:
            python_warnings.warn(line, RuntimeWarning, stacklevel=3)
        return kind(found, command=command, case=self.copy(), options=given, folder=given.get("output"), kept=kept)


_NOTHING = "null"  # leaves a key out


def _implausible(found) -> list[str]:
    """Of numbers that no real machine has: the first reason, and how many points have one."""
    points = found.get("points") if isinstance(found, dict) else None
    if not isinstance(points, list):  # of a table: their number
        return []
    reasons = [str(point["status"]) for point in points if isinstance(point, dict) and str(point.get("status", "")).startswith("implausible: ")]
    return [f"{reasons[0]}; in {len(reasons)} of {len(points)} points. Numbers without a unit are in SI: 55 is 55 W"] if reasons else []


def _path(path) -> str:
    if isinstance(path, str):
        return path
    raise CaseError(f"found a path of type {type(path).__name__}; required: a text, as 'input.power'")


def _as_text(path: str, value) -> str:
    """A value as it would stand in a case; numbers without a unit are in SI, as reading gives them."""
    value = _plain(value)
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, int, float, list, dict)):
        return _yaml(_in_si(path, value))
    raise CaseError(f"found a value of type {type(value).__name__}; required: a text with its unit, a number, a switch, a list or a dict")


def _yaml(value) -> str:
    """A text as it is, all else as JSON, which YAML reads; numbers stay numbers and quantities stand without quotes."""
    return value if isinstance(value, str) else json.dumps(value)


def _plain(value):
    """Of numpy's numbers and arrays and of tuples: numbers and lists."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(one) for one in value]
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    return value


# Keys of blocks that are no part of a path: `sweep: {input.speed: ...}` holds values of input.speed.
_OF_FIELDS = ("sweep.",)
_RANGE = ("from", "to", "step")


def _in_si(path: str, value):
    """The value with the SI unit behind each number of a quantity."""
    for block in _OF_FIELDS:
        path = path.removeprefix(block)
    units = _core.si_units(path)
    if units is None:
        if not isinstance(value, dict):
            return value
        return {key: _in_si(key if path in ("sweep", "") else f"{path}.{key}", one) for key, one in value.items()}
    unit, columns = units
    if columns:
        return [_row_in_si(row, columns) for row in value] if isinstance(value, list) else value
    if isinstance(value, dict):  # of a sweep
        return {key: _quantity(one, unit) if key in _RANGE else one for key, one in value.items()}
    return [_quantity(one, unit) for one in value] if isinstance(value, list) else _quantity(value, unit)


def _row_in_si(row, columns: Sequence[tuple[str, str]]):
    if isinstance(row, dict):
        units = dict(columns)
        return {key: _quantity(one, units.get(key, "")) for key, one in row.items()}
    return [_quantity(one, unit) for one, (_, unit) in zip(row, columns)] + list(row[len(columns):]) if isinstance(row, list) else row


def _quantity(value, unit: str):
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return f"{value!r} {unit}" if number and unit else value


class _reporting:
    """What the program tells of its progress: to nobody, to a function, or to tqdm where that is installed."""

    def __init__(self, progress: Progress, total: Optional[int]):
        self._progress, self._total, self._bar = progress, total, None

    def __enter__(self):
        if self._progress is None or self._progress is False:
            return None
        if callable(self._progress):
            return self._progress if self._total is None else (lambda done: self._progress(done, self._total, ""))
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return self._plain
        self._bar = tqdm(total=self._total, file=sys.stderr, leave=False)
        return self._advance

    def __exit__(self, *_):
        if self._bar is not None:
            self._bar.close()

    def _advance(self, done: int, total: Optional[int] = None, doing: str = "") -> None:
        if total is not None and (self._bar.total != total or self._bar.desc != doing):
            self._bar.reset(total)
            self._bar.set_description_str(doing)
        self._bar.update(done - self._bar.n)

    def _plain(self, done: int, total: Optional[int] = None, doing: str = "") -> None:
        print(f"\r{doing}{done} of {total or self._total} done", end="", file=sys.stderr, flush=True)


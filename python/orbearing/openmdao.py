"""A run as a component of OpenMDAO: inputs of a case in, results out, with derivatives. `docs/openmdao.md` shows how.

`Responses` is the same without OpenMDAO; `component` requires that package (pip install openmdao).
"""

from __future__ import annotations

import difflib
import re
from typing import Mapping, Sequence, Union

from orbearing.case import Case
from orbearing.errors import CaseError, ComputationError
from orbearing.units import unit_in

REMEDY = "orbearing.openmdao.component: OpenMDAO is required (pip install openmdao); Responses works without it"
NUMBERS = ("quantity", "number")


class Responses:
    """Numbers of a run as functions of inputs of its case.

    inputs: paths of numbers of the case, as bearing.radial_clearance; their values are in SI.
    outputs: keys of what `orbearing run --json` prints, of a drivetrain of its first point; one within another as displacement/radial_um.
    fidelity: as of `orbearing run`; none: the case's own analysis.
    steps: none: derivatives of `orbearing sensitivities`, which chooses steps by the scatter of the run. Or a step [SI] for each input: central differences.
    """

    def __init__(self, case: Case, inputs: Sequence[str], outputs: Sequence[str], fidelity: str | None = None, steps: Mapping[str, float] | None = None):
        self.case, self.inputs, self.outputs, self.fidelity = case.copy(), list(inputs), list(outputs), fidelity
        self.steps = dict(steps) if steps is not None else None
        known = {row["path"]: row for row in case.inputs}
        self._require_inputs(known)
        self._require_steps()
        self.input_units = {path: known[path]["si_unit"] for path in self.inputs}
        run = self._run({})
        self._require_outputs(run)
        self.start = {path: float(self.case[path]) for path in self.inputs}
        self.output_units = {key: unit_in(run.get("units", {}), key.rsplit("/", 1)[-1]) for key in self.outputs}

    def values(self, at: Mapping[str, float]) -> dict[str, float]:
        """Each output where inputs have these values [SI]; inputs that are not named keep those of the case."""
        run = self._run(at)
        return {key: _number(run, key) for key in self.outputs}

    def slopes(self, at: Mapping[str, float]) -> dict[tuple[str, str], float]:
        """Derivative of each output by each input, in the output's unit over the input's SI unit."""
        return self._differences(at) if self.steps is not None else self._sensitivities(at)

    def _run(self, at: Mapping[str, float]) -> Mapping:
        return _first_point(self._at(at).run(fidelity=self.fidelity))

    def _at(self, at: Mapping[str, float]) -> Case:
        unknown = sorted(set(at) - set(self.inputs))
        if unknown:
            raise CaseError([f"{path}: no input of these responses; required: one of {', '.join(self.inputs)}" for path in unknown])
        return self.case.copy({path: float(value) for path, value in at.items()})

    def _differences(self, at: Mapping[str, float]) -> dict[tuple[str, str], float]:
        base = {**self.start, **at}
        found = {}
        for path, step in self.steps.items():
            above, below = (self.values({**base, path: base[path] + side * step}) for side in (1.0, -1.0))
            found.update({(key, path): (above[key] - below[key]) / (2.0 * step) for key in self.outputs})
        return found

    def _sensitivities(self, at: Mapping[str, float]) -> dict[tuple[str, str], float]:
        case, found = self._at(at), {}
        for key in self.outputs:
            result = case.sensitivities(fidelity=self.fidelity, result=key, by=self.inputs)
            rows = {row["path"]: row for row in result["inputs"]}
            found.update({(key, path): self._slope(case, rows.get(path), path) for path in self.inputs})
        return found

    def _slope(self, case: Case, row: Mapping | None, path: str) -> float:
        """An input that is no row of the table has no effect."""
        if row is None:
            return 0.0
        if row["derivative"] is None:
            raise ComputationError(f"{path}: no derivative was found; required: steps for central differences")
        return row["derivative"] / self._factor(case, row, path)

    def _factor(self, case: Case, row: Mapping, path: str) -> float:
        """One of the unit of the table in SI."""
        if not self.input_units[path]:
            return 1.0
        return float(case[path]) / row["value"] if row["value"] else case.core.si(path, f"1 {row['unit']}")

    def _require_inputs(self, known: Mapping[str, Mapping]) -> None:
        faults = []
        for path in self.inputs:
            if path not in known:
                near = difflib.get_close_matches(path, known, 1)
                faults.append(f"{path}: no input of the case; required: a number of it" + (f", as {near[0]}" if near else ""))
            elif known[path]["kind"] not in NUMBERS:
                faults.append(f"{path}: found the kind {known[path]['kind']}; required: a number that may change by small steps")
            elif known[path]["given"] is None:
                faults.append(f"{path}: the case has no value; required: one to start from")
        faults = faults or list(self.case.core.without_effect(self.inputs, self.fidelity).values())
        if faults or not self.inputs or len(set(self.inputs)) < len(self.inputs):
            raise CaseError(faults or ["inputs: found none, or one twice; required: paths of numbers of the case"])

    def _require_steps(self) -> None:
        if self.steps is None:
            return
        if set(self.steps) != set(self.inputs) or not all(step > 0.0 for step in self.steps.values()):
            raise CaseError(f"steps: found {', '.join(self.steps) or 'none'}; required: a step above 0 for each of {', '.join(self.inputs)}")

    def _require_outputs(self, run: Mapping) -> None:
        faults = []
        for key in self.outputs:
            try:
                _number(run, key)
            except ComputationError as fault:
                near = difflib.get_close_matches(key, list(_keys(run)), 1, 0.3)
                faults.append(f"{fault}" + (f"; nearest: {near[0]}" if near else ""))
        if faults or not self.outputs:
            raise CaseError(faults or ["outputs: found none; required: keys of what `orbearing run --json` prints"])


def _first_point(run: Mapping) -> Mapping:
    if "points" not in run:
        return run
    point = dict(run["points"][0])
    status = point.get("status", "ok")
    if status != "ok":
        raise ComputationError(f"the run: {status}")
    return {**point, "units": run["units"]}


def _number(run: Mapping, key: str) -> float:
    value: object = run
    for part in key.split("/"):
        value = value.get(part) if isinstance(value, Mapping) else None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ComputationError(f"{key}: the run has no number of this name; required: a key of `orbearing run --json`")
    return float(value)


def _keys(run: Mapping, before: str = ""):
    for key, value in run.items():
        if isinstance(value, Mapping):
            yield from _keys(value, f"{before}{key}/")
        elif isinstance(value, (int, float)):
            yield before + key


def variable_name(key: str) -> str:
    """The name of an input or output in OpenMDAO: bearing.radial_clearance is bearing:radial_clearance."""
    return re.sub(r"\W", ":", key)


def openmdao_unit(unit: str) -> str | None:
    """The unit as OpenMDAO writes it: kg/m3 is kg/m**3; None of a plain number."""
    text = re.sub(r"(?<=[A-Za-z])(-?\d+)", r"**\1", unit.replace(".", "*").replace(" ", "*"))
    return None if text in ("", "1") else text


def component(case: Union[Case, Responses], inputs: Sequence[str] = (), outputs: Sequence[str] = (), **options):
    """An ExplicitComponent with the variables of `Responses(case, inputs, outputs, **options)`, or of given ones."""
    try:
        import openmdao.api as om
        from openmdao.utils.units import valid_units
    except ImportError as error:
        raise ImportError(REMEDY) from error
    responses = case if isinstance(case, Responses) else Responses(case, inputs, outputs, **options)

    def unit_of(text: str) -> str | None:
        unit = openmdao_unit(text)
        return unit if unit and valid_units(unit) else None  # as millions of revolutions: a plain number

    class RunComponent(om.ExplicitComponent):
        """A run of a case."""

        def setup(self) -> None:
            for path in responses.inputs:
                self.add_input(variable_name(path), val=responses.start[path], units=unit_of(responses.input_units[path]))
            for key in responses.outputs:
                self.add_output(variable_name(key), units=unit_of(responses.output_units[key]))

        def setup_partials(self) -> None:
            self.declare_partials("*", "*")

        def compute(self, inputs, outputs) -> None:
            for key, value in responses.values(self._at(inputs)).items():
                outputs[variable_name(key)] = value

        def compute_partials(self, inputs, partials) -> None:
            for (key, path), slope in responses.slopes(self._at(inputs)).items():
                partials[variable_name(key), variable_name(path)] = slope

        @staticmethod
        def _at(inputs) -> dict[str, float]:
            return {path: float(inputs[variable_name(path)][0]) for path in responses.inputs}

    return RunComponent()

"""What a page shows of a sweep besides its points: fine curves, loads by place, single effects. The program computes them from the case of the folder."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Callable

import numpy as np

from orbearing import effects, gear_data
from orbearing.blocks import is_number
from orbearing.errors import CaseError, ComputationError
from orbearing.result_folder import lies_on, record, records, same
from orbearing.terminal import StatusLine

FINE_POINTS = 221
RPM = 30.0 / np.pi  # of 1 rad/s
FINE = ("planet_load_N", "tangential_load_N", "radial_mesh_load_N", "centrifugal_load_N")
IN_MOTION = ("cage_slip", "orbit_slip", "roller_slip", "power_loss_W", "inner_load_rms_N", "outer_load_rms_N")
COUPLED = ("co-simulated", "monolithic")


class Program:
    """The program with the case of a result folder: in this process by its library, else as a process of its own."""

    def __init__(self, folder: Path, path: str = "", quiet: bool = True):
        self._folder, self._path, self._quiet = folder, path, quiet

    def inputs(self) -> effects.Inputs:
        """All inputs by their paths."""
        return {row["path"]: row for row in self._ask("check", self._folder / "case.resolved.yaml")["inputs"]}

    def points(self, **wanted) -> list:
        """Points of the bearing, as `--bearing-points` of the command report takes them."""
        return self._ask("report", self._folder, bearing_points=json.dumps(wanted))

    def point_of_case(self) -> dict:
        """At the speed of the case, by the quasi-static model."""
        return next(iter(records(self._ask("run", self._folder / "case.resolved.yaml").get("points"))), {})

    def lundberg_palmgren_life_at(self, rpm: float, settings: list[str]) -> float | None:
        """Of one bearing of the case with these settings, by the quasi-static model [h]."""
        found = self._ask("sweep", self._folder / "case.resolved.yaml", set=[*settings, f"sweep={{input.speed: [{rpm!r} rpm]}}"])
        return found["points"][0]["life_h"]

    def reliability(self) -> float | None:
        """Of the modified lives."""
        return record(self.inputs().get("life.reliability")).get("value")

    def influences(self, assumed: list[str], result: str = "") -> dict:
        """Effect of each assumed number on a result of the run, by the quasi-static model: that of `orbearing sensitivities`."""
        inputs = self.inputs()
        numbers = {path for path in assumed if is_number(record(inputs.get(path)).get("value"))}
        if not numbers:
            return {}
        # Requested for all inputs, since those without effect on the result are refused where they are named.
        found = self._ask("sensitivities", self._folder / "case.resolved.yaml", **({"result": result} if result else {}))
        return {**found, "inputs": [row for row in records(found.get("inputs")) if row.get("path") in numbers]}

    def say(self, text: str) -> None:
        """What is computed and takes long, on standard error, in a log as well."""
        if not self._quiet:
            print(f"report: {text}", file=sys.stderr, flush=True)

    def _ask(self, command: str, what: Path, **options):
        try:
            from orbearing import _core
        except ImportError:
            words = [f"--{name.replace('_', '-')}={one}" for name, value in options.items() for one in (value if isinstance(value, list) else [value])]
            done = subprocess.run([self._path, command, str(what), "--json", *words], capture_output=True, text=True, check=False)
            if done.returncode:
                raise CaseError(done.stderr.strip()) from None
            return json.loads(done.stdout)
        line = StatusLine(not self._quiet)

        def show(done: int, all_points: int, doing: str) -> None:
            if line.is_due:
                line.show(f"{doing}{done} of {all_points} points done")

        try:
            return json.loads(_core.compute(None, command, {"folders": [str(what)], **options}, show)[0])
        finally:
            line.end()


class _Bearing:
    """The bearing that is shown, at speeds and under changes."""

    def __init__(self, program: Program, shown: dict):
        self._program, self._shown = program, shown

    def points(self, speeds_rpm, changes=((),), fidelity: str = "quasi-static", loads: bool = False) -> list:
        return self._program.points(settings=self._shown["settings"], set=self._shown["set"], changes=[list(settings) for settings in changes],
                                    speeds=[float(speed) / RPM for speed in speeds_rpm], fidelity=fidelity, loads=loads)

    def under(self, changes: list[effects.Change], speeds_rpm, fidelity: str = "quasi-static") -> list[tuple[effects.Change, list[dict]]]:
        """Points of each change that fits the case."""
        found = self.points(speeds_rpm, [change.settings for change in changes], fidelity)
        return [(change, points) for change, points in zip(changes, found) if points is not None]


def influences(content: dict, program: Program, life: str = "") -> dict:
    """The same for all assumptions of a result, on `life`, else the one that the case requires, else the governing one of the worst bearing; `problem` where
    there is none."""
    required = next((one for one in records(content.get("verdicts")) if one.get("requirement") == "life"), {})
    if required.get("key") != record(content.get("peak")).get("life_key"):
        life = life or str(required.get("result") or "")
    assumed = [str(row.get("key")) for row in records(content.get("assumptions"))]
    try:
        found = program.influences(assumed, life)
    except (CaseError, ComputationError) as error:
        return {"problem": f"The influence of assumptions is not computed: {error}"}
    return {**found, "unit": found.get("unit") if not life else "Mrev" if life.endswith("Mrev") else "h", "reliability": program.reliability()}


def own_point(content: dict, program: Program) -> dict:
    """The operating point of the case where the sweep has no point at its speed: computed by the quasi-static model; else empty."""
    own = content.get("own_speed_rpm")
    if content["fidelity"] != "quasi-static" or content.get("slice") or any(same(point.get("input_speed_rpm"), own) for point in records(content.get("points"))):
        return {}
    try:
        return program.point_of_case()
    except (CaseError, ComputationError):
        return {}


def complete(content: dict, program: Program, every_effect: bool = False) -> dict:
    """The content of report.json with all that its pictures draw. `every_effect`: of motion in time all effects, not only the chief ones."""
    shown = content.get("shown")
    if not isinstance(shown, dict):
        return content
    content = {key: value for key, value in content.items() if key != "shown"}
    bearing, grid, fidelity = _Bearing(program, shown), shown["speeds_rpm"], content["fidelity"]
    speeds, in_motion = sorted({min(grid), shown["peak_speed_rpm"], max(grid)}), fidelity in ("dynamic", *COUPLED)
    inputs = program.inputs()
    fine = np.linspace(min(grid), max(grid), FINE_POINTS)
    at_rest = bearing.under(effects.at_rest(inputs, shown["set"]), fine)
    _add_effects_of_assumptions(content)
    content["influences"] = influences(content, program)
    content["own_point"] = own_point(content, program)
    content["published"] = published(content, lambda rpm: program.lundberg_palmgren_life_at(rpm, shown["settings"]))
    life = record(content.get("peak")).get("life_key") or "life_h"
    content["fine"] = {"speed_rpm": fine.tolist(), **{name: _column(at_rest[0][1], name) for name in (life, *FINE)}}
    polar = {one["speed_rpm"]: one for one in _polar(bearing, sorted({*speeds, *(_best(content) if in_motion else [])}))}
    content["polar"] = [polar[speed] for speed in speeds]
    if "gears" in content:
        content["gears"] = gear_data.arranged(content["gears"])
    content["drawing"] |= _loads_of_rollers(polar[shown["peak_speed_rpm"]], content["drawing"]["rollers"])
    content["ablation"] = [_curve(change, points, fine, life) for change, points in at_rest]
    content["dynamic"] = None
    if in_motion:
        alone = [] if fidelity in COUPLED else effects.in_motion(inputs, every_effect, shown["set"])
        if alone:
            program.say(f"single effects in motion: {len(alone)} at {', '.join(f'{speed:g}' for speed in speeds)} rpm, each a run in time")
        changes = bearing.under(alone, speeds, "dynamic") if alone else []
        content["dynamic"] = {"ablation": [_motion(change, points, speeds, life) for change, points in changes],
                              "quasi_static": {"polar": list(polar.values())}}
    if fidelity in COUPLED:
        program.say(f"the same speeds without feedback of the bearings on the gears: {len(grid)} {'points' if len(grid) > 1 else 'point'} in motion")
        one_way = bearing.points(grid, fidelity="dynamic")[0]
        content["coupled"] = {"how": how(inputs, fidelity),
                              "one_way": {"speed_rpm": grid, **{name: _column(one_way, name) for name in (life, "outer_load_rms_N")}}}
    return content


def published(content: dict, life_at: Callable[[float], float | None]) -> list[dict]:
    """Published peaks of life, each with our life of Lundberg and Palmgren at its speed, since sources publish no other.

    Of the point of the sweep there, on the line of speeds that is shown; else computed where the sweep is by the quasi-static model, else None. Nothing
    is interpolated.
    """
    rows = [row for row in records(content.get("validation")) if row.get("reading") == "" and row.get("published") is not None]
    speed = next((row["published"] for row in reversed(rows) if row["quantity"] == "peak_speed_rpm"), None)
    found = []
    for row in rows if speed is not None else []:
        if row["quantity"] != "peak_life_h":
            continue
        there = next((point for point in records(content.get("points")) if same(point.get("input_speed_rpm"), speed)
                      and lies_on(point, record(content.get("slice"))) and is_number(point.get("carrier_speed_rpm"))), None)
        ours, by = (there["life_h"], "point of the sweep") if there else (None, "")
        if not there and content["fidelity"] == "quasi-static":
            ours, by = life_at(speed), "computed for this comparison"
        found.append({"source": row["source"], "quantity": row["quantity"], "speed_rpm": speed, "life_h": row["published"], "ours_h": ours, "ours_by": by})
    return found


def how(inputs: effects.Inputs, fidelity: str) -> str:
    """How gears and bearings act on each other, in words."""
    if fidelity == "monolithic":
        return "gears and all bearings as one system of equations"
    order, degree, window, passes = (inputs[f"simulation.exchange.{name}"]["value"] for name in ("order", "extrapolation", "window", "passes"))
    repeated = f", each repeated up to {passes:.0f} times" if passes > 1 else ""
    return (f"co-simulated, {order.title()} exchange of degree {degree:.0f} in windows of at most {1e6 * window:.3g} µs{repeated}")


def _best(content: dict) -> list[float]:
    """The speed of the longest life, refined where it is; empty where there is none."""
    peak = record(content.get("peak"))
    return [speed for speed in (peak.get("refined_speed_rpm"), peak.get("speed_rpm")) if is_number(speed)][:1]


def _column(points: list[dict], name: str) -> list:
    return [point.get(name) for point in points]


def _polar(bearing: _Bearing, speeds_rpm: list[float]) -> list[dict]:
    """Loads of the rollers by place."""
    found = []
    for speed, point in zip(speeds_rpm, bearing.points(speeds_rpm, loads=True)[0]):
        radial = [point.get(name) for name in ("radial_mesh_load_N", "centrifugal_load_N")]
        found.append({"speed_rpm": speed, **{name: point.get(name, []) for name in ("angle_deg", "inner_load_N", "outer_load_N")},
                      "planet_load_x_N": sum(radial) if all(map(is_number, radial)) else None, "planet_load_y_N": point.get("tangential_load_N")})
    return found


def _loads_of_rollers(polar: dict, rollers: int) -> dict:
    """Of the many angles at which the cage was looked at, the first."""
    stride = max(1, len(polar["angle_deg"]) // rollers)
    return {"speed_rpm": polar["speed_rpm"], "roller_angle_deg": polar["angle_deg"][::stride], "inner_load_N": polar["inner_load_N"][::stride],
            "outer_load_N": polar["outer_load_N"][::stride]}


def _curve(change: effects.Change, points: list[dict], speeds_rpm: np.ndarray, life: str) -> dict:
    lives = _column(points, life)
    best = max(range(len(lives)), key=lambda i: lives[i] if is_number(lives[i]) else -np.inf)
    return {"name": change.name, "group": change.group, "speed_rpm": speeds_rpm.tolist(), "life_key": life, life: lives, "peak_speed_rpm": float(speeds_rpm[best]),
            "peak_life_h": lives[best]}


def _motion(change: effects.Change, points: list[dict], speeds_rpm: list[float], life: str) -> dict:
    rows = []
    for speed, point in zip(speeds_rpm, points):
        rows.append({"speed_rpm": speed, "status": point["status"]})
        if life in point:
            rows[-1] |= {**{name: point.get(name) for name in (life, *IN_MOTION)}, "steady": bool(point.get("steady"))}
    return {"name": change.name, "group": change.group, "life_key": life, "points": rows}


def _add_effects_of_assumptions(content: dict) -> None:
    """To each assumption the effect of its first other reading, where the project knows one."""
    for entry in records(content.get("assumptions")):
        first = next((row for row in records(content.get("sensitivities"))
                      if row.get("assumption") == entry.get("key") and row.get("life_change_h") is not None), {})
        entry |= {"worth_h": first.get("life_change_h"), "worth_text": first.get("reading", "")}

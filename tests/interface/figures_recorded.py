#!/usr/bin/env python3
"""Every figure in every form is as recorded: all that is drawn with its looks, captions, tables and reasons why nothing is drawn.

What figures_test.py derives from results is checked there; this test finds that anything else changed. Where a change is meant, `--record` writes
records/figures.json.xz anew.
Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import sys
import types
import unittest
import unittest.mock
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import netCDF4  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: matplotlib, numpy or netCDF4 is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import kept_records  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
import report_fixture as fixture  # noqa: E402
import whole_drawing  # noqa: E402
from orbearing import report, style  # noqa: E402
from orbearing.figures import (ablation, ball_motion, bearing_drawing, branches, cage_orbit, carrier_revolution, coupled, crown, defect,  # noqa: E402
                               dynamic_ablation, dynamic_polar, gears, life_curve, load_spectrum, planet_load, polar_loads, power_loss, roller_history,
                               roller_loads, roller_orbit, roller_pressure, slip, slip_map, slip_traces, static_loads)
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report  # noqa: E402

RECORDS = kept_records.Records("figures")
GONE = object()
drawn = []  # figures of this run


def keep(canvas, target, **more):
    """In place of the drawing: its number, by which the picture is told."""
    target.write(f"<svg>{len(drawn)}</svg>")
    drawn.append(whole_drawing.whole(canvas.figure))


def picture_of(picture):
    head, number = str(picture).removesuffix("</svg>").rsplit(">", 1)
    return {"name": picture.name, "element": head, "figure": drawn[int(number)]}


def table_of(table):
    """Column by column, so that long ones are kept as samples."""
    return table and {"head": list(table.head), "columns": [list(column) for column in zip(*table.rows)], "rows": len(table.rows)}


def block_of(block):
    return {"slug": block.slug, "title": block.title, "caption": block.caption, "missing": block.missing, "pictures": [picture_of(one) for one in block.pictures],
            "summary": table_of(block.summary), "data": table_of(block.data)}


def changed(content, edits):
    """The same with other values at these paths, as points.*.life_h; GONE: without them. A function takes the old value or, of a new one, its record."""
    for path, value in edits.items():
        content = _changed(content, path.split("."), value)
    return content


def _changed(place, way, value):
    """Copied along the way alone."""
    whole = dict(place) if isinstance(place, dict) else list(place)
    for key in range(len(whole)) if way[0] == "*" else [int(way[0]) if isinstance(whole, list) else way[0]]:
        if len(way) > 1:
            whole[key] = _changed(whole[key], way[1:], value)
        elif value is GONE:
            del whole[key]
        else:
            whole[key] = value(whole[key] if isinstance(whole, list) or key in whole else whole) if callable(value) else value
    return whole


def begin(seed=44):
    """The fixtures' numbers from their beginning, whatever was made before."""
    made.RANDOM = np.random.default_rng(seed)


def of_life(key):
    """Results by another life than that of Lundberg and Palmgren."""
    return {"peak.life_key": key, "points.*." + key: lambda row: None if row["life_h"] is None else 0.7 * row["life_h"],
            "points.*.system_" + key: lambda row: None if row["life_h"] is None else 0.11 * row["life_h"]}


def in_memory(values_at):
    """Files of points that no disk holds: variables by speed."""
    return unittest.mock.patch.multiple("orbearing.point_file", _path=lambda folder, speed, others: speed, _read=lambda speed, where: PointFile(values_at(speed)))


def variables(speed):
    return {name: made.change(name, values) for name, (_, _, values) in dynamic.variables(speed).items()}


def without(*names):
    return lambda speed: {name: values for name, values in variables(speed).items() if name not in names}


def uncaged(speed):
    """Rollers without a cage."""
    found = without("cage_speed", "cage_position", "cage_angle")(speed)
    return found | {"orbit_speed": variables(speed)["cage_speed"] * 1.03}


def backwards(speed):
    """Rollers that turn the other way, with instants that are not known."""
    found = variables(speed)
    hole = np.zeros(dynamic.INSTANTS, bool)
    hole[7:19] = True
    flipped = {"roller_angle": np.mod(-found["roller_angle"], 2 * np.pi)}
    flipped["roller_angle"] = np.where(hole, np.nan, flipped["roller_angle"])
    flipped["roller_spin"] = np.where(hole, np.nan, found["roller_spin"])
    return found | flipped


def still(speed):
    """A roller that does not go round."""
    return variables(speed) | {"roller_angle": np.full((fixture.ROLLERS, dynamic.INSTANTS), 1.25)}


def unloaded(speed):
    return variables(speed) | {name: 0.0 * variables(speed)[name] for name in ("roller_inner_load", "roller_outer_load", "inner_load", "outer_load")}


def outward(speed):
    """Rollers that press on the outer race alone."""
    return variables(speed) | {name: share * variables(speed)[name] for name, share in (("roller_inner_load", 0.31), ("inner_load", 0.31), ("roller_outer_load", 1.7),
                                                                                        ("outer_load", 1.7))}


def spot(speed):
    """A cage that stays near one place of its land."""
    turn = np.linspace(0, 2 * np.pi, dynamic.INSTANTS)
    size = 1e-6 * (1.0 + speed / 6000.0)
    return variables(speed) | {"cage_position": np.array([1.3e-4 + 5 * size * np.cos(turn), 0.9e-4 + 8 * size * np.sin(turn)])}


@unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", keep)
@unittest.mock.patch("orbearing.style.panels_of", lambda figure: ())
class Figures(kept_records.Recorded):
    records = RECORDS

    def block(self, name, draw, *values):
        """The record of one figure, or of several."""
        with style.context():
            found = draw(*values)
        self.check(name, [block_of(one) for one in found] if isinstance(found, (list, tuple)) else block_of(found))

    def test_life_over_speed(self):
        begin()
        still_one, moving = fixture.make_report(), made.moving()
        several = [{"source": "", "speed_rpm": 4100, "life_h": 33333.0}, {"source": "_of [Rev" "2020], " + 12 * "a long name ", "speed_rpm": 5200, "life_h": 44444.0},
                   {"source": "[Old" "1999]", "speed_rpm": None, "life_h": 1.0}, {"source": "[Old" "1999]", "speed_rpm": 3000.0, "life_h": 0.0}]
        for name, content in {
                "quasi-static": still_one, "in motion": moving, "L10mh": changed(still_one, of_life("L10mh")), "L10mrh, in motion": changed(moving, of_life("L10mrh")),
                "no peak": changed(still_one, {"peak": {}}), "no life": changed(still_one, {"points.*.life_h": None, "peak": {"life_key": "L10h"}}),
                "no life of Lundberg and Palmgren": changed(still_one, {"points.*.life_h": None}), "one point": changed(still_one, {"points": still_one["points"][5:6]}),
                "peak of the grid": changed(still_one, {"peak.refined_speed_rpm": GONE, "peak.refined_life_h": GONE, "fine": {}}),
                "other sources": changed(still_one, {"published": several}), "no source": changed(still_one, {"published": []}),
                "torque": changed(still_one, {"assumptions.0.key": "input.power", "assumptions.0.reason": "input.torque times speed"}),
                "torque curve": changed(still_one, {"assumptions.1.key": "input.power", "assumptions.1.reason": "input.torque_curve at this speed"}),
                "added points": changed(still_one, {"points.5.refined": True, "points.6.refined": True, "points.7.status": "implausible: speed"}),
                "all lives the same": changed(still_one, {"points.*.life_h": 5000.0, "fine.life_h": [], "published": [], "peak.life_h": 5000.0, "peak.refined_life_h": 5000.0}),
                "peak beyond": changed(still_one, {"peak": {"speed_rpm": 90000, "life_h": -1.0}}),
                "failed without speed": changed(still_one, {"points.2": {"status": "failed"}, "points.3.status": None, "points.4.life_h": -3.0}),
                "without gears": changed(moving, {"gears": None}), "no excited meeting": changed(moving, {"gears.meetings.*.excited": False}),
                "meetings at the ends": changed(moving, {"gears.meetings.0.speed_rpm": 4550.0, "gears.meetings.1.speed_rpm": 8450.0, "gears.meetings.2.speed_rpm": 4600.0,
                                                         "gears.meetings.3.excited": True, "gears.meetings.3.speed_rpm": 4721.0}),
                "many points": changed(still_one, {"points": [fixture.point(1000 + 100 * i) for i in range(61)]}),
        }.items():
            self.block(f"life: {name}", life_curve.block, Report(content, None))

    def test_loads_over_speed(self):
        begin()
        content = made.moving()
        bare = {"fine": {}, "points.*": lambda row: {"input_speed_rpm": row["input_speed_rpm"]}}
        for name, edits in {"all": {}, "sweep alone": {"fine": {}}, "nothing": bare, "two points": {"fine": {}, "points": content["points"][:2]},
                            "many points": {"points": [fixture.point(1000 + 100 * i) for i in range(61)], "fine": {}},
                            "peak above the least load": {"peak.refined_speed_rpm": 11900.0}, "peak below the least load": {"peak.refined_speed_rpm": 1100.0}, "no peak": {"peak": {}}}.items():
            one = Report(changed(content, edits), None)
            self.block(f"planet load: {name}", planet_load.block, one)
            self.block(f"roller loads: {name}", roller_loads.block, one)
        for name, edits in {"all": {}, "uncaged": {"points.*.orbit_slip": lambda row: 1e-7 * row["input_speed_rpm"] + 0.001, "points.*.cage_slip": None},
                            "nothing": {"points.*.cage_slip": None, "points.*.roller_slip": None}, "rollers alone": {"points.*.cage_slip": None},
                            "many": {"points": [{**content["points"][0], "input_speed_rpm": 1000.0 + 100.0 * i} for i in range(61)]}}.items():
            self.block(f"slip: {name}", slip.block, Report(changed(content, edits), None))
        for name, edits in {"all": {}, "nothing": bare, "one point": {"points": content["points"][3:4]}, "uneven": {"points": content["points"][::-2]},
                            "no neighbours": {"points.*.power_loss_neighbours_W": None}, "no loss": {f"points.*.power_loss_{name}_W": 0.0 for name in (*dynamic.CAUSES, "neighbours")},
                            "one unknown": {"points.4.power_loss_rolling_W": None, "points.1.power_loss_drag_W": -3.0}}.items():
            self.block(f"power loss: {name}", power_loss.block, Report(changed(content, edits), None))

    def test_loads_around_the_bearing(self):
        begin()
        content = changed(made.moving(), {"polar.0.angle_deg": lambda angles: [angle - 100.0 for angle in angles]})
        still_one = fixture.make_report()
        long_ring = {"speed_rpm": 777.0, "angle_deg": [6.0 * i for i in range(61)], "inner_load_N": [float(i) for i in range(61)], "outer_load_N": [61.0 - i for i in range(61)]}
        for name, edits in {"all": {}, "no direction": {"polar.*.planet_load_x_N": None}, "no loads": {"polar": []}, "one without": {"polar.1.angle_deg": []},
                            "no loads at all": {"polar.*.inner_load_N": lambda x: [0.0] * len(x), "polar.*.outer_load_N": lambda x: [0.0] * len(x), "polar.*.planet_load_y_N": GONE},
                            "one race": {"polar.0.inner_load_N": [], "polar.2.outer_load_N": lambda x: [None, *x[1:]]}, "many": {"polar": [long_ring]}}.items():
            self.block(f"polar: {name}", polar_loads.block, Report(changed(content, edits), None))
        for name, edits in {"all": {}, "clearance": {"drawing.clearance_um": 12.5}, "no clearance": {"drawing.clearance_um": None}, "no speed": {"drawing.speed_rpm": None},
                            "no cage": {"drawing.cage_inner_mm": None}, "cage inside out": {"drawing.cage_outer_mm": 30.0}, "no bore": {"drawing.bore_mm": None},
                            "no size": {"drawing.outside_mm": 0.0, "drawing.roller_diameter_mm": GONE}, "no loads": {"drawing.inner_load_N": [], "drawing.outer_load_N": []},
                            "no angles": {"drawing.roller_angle_deg": lambda x: [None, *x[1:]], "drawing.outer_load_N": lambda x: [*x[:-1], None]},
                            "other loads": {"drawing.inner_load_N": lambda x: [3.0 * one for one in x]}}.items():
            self.block(f"drawing: {name}", bearing_drawing.block, Report(changed(still_one, edits), None))
        angles, loads = [200.0, 10.0, 100.0, 300.0], [0.0, 700.0, 40.0, 250.0]
        for name, kind, record in (("static", "static", {"contact_loads_N": loads, "steps": {"element_angles_deg": angles}}), ("nothing", "static", {}),
                                   ("even", "static", {"contact_loads_N": loads, "steps": {"element_angles_deg": angles[:3]}}),
                                   ("pair", "pair", {"contact_loads_N": [*loads, 1.0, 2.0, 3.0, 4.0], "steps": {"element_angles_deg": angles}})):
            self.block(f"elements: {name}", static_loads.block, Report({kind: record}, None), kind)

    def test_single_effects(self):
        begin()
        content = made.moving()
        small = {"ablation": [one for one in content["ablation"] if one["name"] in ("all effects", "no own orbit", "no Coriolis")]}
        for name, edits in {"all": {}, "small": small, "no reference": {"ablation.0.name": "other"}, "nothing": {"ablation": []}, "reference alone": {"ablation": content["ablation"][:1]},
                            "one point": {"ablation.*.speed_rpm": lambda x: x[20:21], "ablation.*.life_h": lambda x: x[20:21]},
                            "groups": {"ablation.1.group": "clearance", "ablation.5.group": "inertia", "ablation.7.name": "film of a name that is so long that it stands alone"},
                            "L10mh": {"ablation.*.L10mh": lambda row: [0.5 * x for x in row["life_h"]], "ablation.*.life_key": "L10mh"},
                            "two lives": {"ablation.0.L10mh": lambda row: [0.5 * x for x in row["life_h"]], "ablation.0.life_key": "L10mh"},
                            "unsorted": {"ablation.*.speed_rpm": lambda x: x[::-1], "ablation.1.life_h": lambda x: [None, -1.0, *x[2:]], "ablation.2.peak_speed_rpm": None},
                            "other speeds": {"ablation.1.speed_rpm": lambda x: [one + 1e-3 for one in x], "ablation.2.speed_rpm": lambda x: [one * (1 + 1e-13) for one in x]}}.items():
            one = Report(changed(content, edits), None)
            self.block(f"inertia: {name}", ablation.inertia_block, one)
            self.block(f"clearance: {name}", ablation.clearance_block, one)
        runs = "dynamic.ablation"
        mild = [one for one in content["dynamic"]["ablation"] if one["name"] != "no carrier centrifugal"]
        for name, edits in {"all": {}, "mild": {runs: mild}, "nothing": {runs: []}, "reference alone": {runs: content["dynamic"]["ablation"][:1]},
                            "no reference": {f"{runs}.0.name": "all others"}, "uncaged": {f"{runs}.*.points.*.orbit_slip": lambda row: 3 * row["cage_slip"]},
                            "L10mrh": {f"{runs}.*.life_key": "L10mrh", f"{runs}.*.points.*.L10mrh": lambda row: 0.3 * row["life_h"]},
                            "failed": {f"{runs}.1.points.0": {"speed_rpm": 1000, "status": "failed"}, f"{runs}.2.points.1.speed_rpm": None},
                            "shorter": {f"{runs}.2.points.*.life_h": lambda x: 0.001 * x, f"{runs}.3.points.*.roller_slip": lambda x: -20.0 * x}}.items():
            self.block(f"single terms: {name}", dynamic_ablation.block, Report(changed(content, edits), None))

    def test_branches(self):
        begin()
        content = made.moving()
        both = "branches.runs"
        for name, edits in {"all": {}, "same": {f"{both}.1.points": content["branches"]["runs"][0]["points"]}, "one": {both: content["branches"]["runs"][:1]},
                            "no drift": {"branches.load_drift": None}, "nothing": {both: []}, "unsteady": {f"{both}.0.points.2.steady": 0, f"{both}.1.points.4.steady": 0},
                            "other speeds": {f"{both}.1.points.*.input_speed_rpm": lambda x: x + 1.0}, "wide": {"branches.load_drift": 2.0},
                            "order": {f"{both}.0.name": "own start", f"{both}.1.points": lambda x: x[::-1]}, "holes": {f"{both}.0.points.1.cage_slip": None,
                            f"{both}.0.points.2.inner_load_rms_N": None}, "uncaged": {f"{both}.*.points.*.orbit_slip": 0.0123}}.items():
            self.block(f"branches: {name}", branches.block, Report(changed(content, edits), None))
        lined = changed(content, {"slice": {"kW": 5.0}, f"{both}.*.points.*.kW": 5.0, f"{both}.0.points.3.kW": 6.0})
        self.block("branches: on a line", branches.block, Report(lined, None))

    def test_motion_over_time(self):
        begin()
        content = made.moving()
        rings, history, orbit, traces, cage = dynamic_polar, roller_history, roller_orbit, slip_traces, cage_orbit
        every = (rings, history, orbit, traces, cage)
        best = {"points": content["points"][5:6], "peak.refined_speed_rpm": 6000.0}  # one speed is shown
        for name, values, edits, figures in (
                ("all", variables, {}, every), ("uncaged", uncaged, best, (traces, cage)), ("backwards", backwards, best, (history, orbit, traces)),
                ("unloaded", unloaded, best, (rings, history, orbit)), ("outward", outward, best, (rings, history, orbit)), ("spot", spot, best, (cage,)), ("no loads by place", without("angle"), best, every),
                ("no ring", variables, best | {"dynamic": {}, "polar": []}, (rings,)), ("ring of the page", variables, best | {"dynamic.quasi_static": {}}, (rings,)),
                ("uneven ring", variables, best | {"dynamic.quasi_static.polar.*.speed_rpm": lambda x: x * 1.0009, "dynamic.quasi_static.polar.1.outer_load_N": lambda x: [None, *x[1:]]}, (rings,)),
                ("ring without a race", variables, best | {"dynamic.quasi_static.polar.1.inner_load_N": []}, (rings,)),
                ("nothing over time", without("time"), best, every), ("no life", variables, {"points.*.life_h": None, "peak": {}}, every),
                ("no kinematics", variables, best | {"kinematics.cage": 0.0}, (traces,)), ("inner land", variables, best | {"drawing.guide_land_mm": 35.2}, (cage,)),
                ("no land", variables, best | {"drawing.guide_land_mm": None}, (cage,)), ("land on the cage", variables, best | {"drawing.guide_land_mm": 38.0}, (cage,))):
            for one in figures:
                with in_memory(values):
                    self.block(f"{one.__name__.rsplit('.', 1)[-1]}: {name}", one.block, Report(changed(content, edits), Path()))
        with in_memory(still):
            self.block("roller history: no orbit", roller_history.block, Report(content, Path()))
        for place in (0.2, 0.7):  # of the clearance: the small orbit near the middle has no inset
            turn = np.linspace(0, 2 * np.pi, 30)
            path = 200.0 * place + np.array([6.0 * np.cos(turn), 9.0 * np.sin(turn) ** 3])
            with style.context():
                self.check(f"cage orbit: small, at {place}", picture_of(cage_orbit._draw((2500.0, None, path), 200.0, "orbit")))
        self.block("files: none", roller_history.block, Report(content, None))

    def test_gears(self):
        begin()
        whole = {"gears": made.gears()}
        pair = "gears.tooth_pairs.0"
        for name, edits in {
                "all": {}, "nothing": {"gears": {"other": 1}}, "internal": {f"{pair}.gears.1.radius_mm": lambda x: x[::-1], f"{pair}.contact_x_mm": -0.4},
                "lower first": {f"{pair}.gears.0.centre_y_mm": 60.0, f"{pair}.gears.0.sense": -1.0, f"{pair}.gears.1.centre_y_mm": -70.0, f"{pair}.gears.1.sense": 1.0},
                "without teeth": {f"{pair}.gears.0.teeth": 0}, "two pairs": {"gears.tooth_pairs": lambda pairs: [*pairs, {**pairs[0], "mesh": "planet and ring"}]},
                "torn curves": {"gears.meshes.0.curve": lambda x: [*x[:5], [None, 1.0], "a"], "gears.meshes.1.mean_N_per_m": None, "gears.meshes.1.at_pitch_point.pair_N_per_m": None},
                "names": {"gears.meshes.0.name": "", "gears.meshes.1.at_pitch_point.hertz_N_per_m": -1.0},
                "shapes": {"gears.mode_shapes.modes.0.shape": [0.0] * 18, "gears.mode_shapes.modes.1.shape": [1.0], "gears.mode_shapes.modes.2.multiplicity": 3},
                "more shapes": {"gears.mode_shapes.modes": lambda modes: [*modes, {**modes[1], "name": "X9", "kind": "other"}]},
                "no radius": {"gears.mode_shapes.ring_radius_mm": 0.0}, "one speed": {"gears.campbell.speed_rpm": [1000.0], "gears.campbell.modes.*.frequency_Hz": lambda x: x[:1],
                                                                                      "gears.campbell.mesh_frequency_Hz": [310.0]},
                "modes with holes": {"gears.campbell.modes.0.frequency_Hz": lambda x: [*x[:3], None], "gears.campbell.modes.1.name": "T1", "gears.campbell.modes.2.name": "T1"},
                "high harmonics": {"gears.campbell.mesh_frequency_Hz": [400.0, 1500.0, 2600.0, 4000.0]}, "no meetings": {"gears.meetings.*.excited": None}, "odd meetings": {"gears.meetings.*.excited": True, "gears.meetings.1.order": None, "gears.meetings.2.order": 4},
                "failed runs": {"gears.runs.1.status": "not steady", "gears.runs.3.status": "", "gears.runs.0.acceleration_m_per_s2": {}},
                "no runs": {"gears.runs.*.acceleration_m_per_s2": {}, "gears.runs.0.status": "ended early"}, "unsorted runs": {"gears.runs": lambda runs: runs[::-1]},
                "holes in runs": {"gears.runs.1.acceleration_m_per_s2.x.rms": None, "gears.runs.*.swept": None, "gears.runs.2.load_sharing.mean": lambda x: x[:2]},
                "five planets": {"gears.runs.*.load_sharing.mean": [0.8, 0.9, 1.05, 1.1, 1.15], "gears.runs.*.load_sharing.largest": [1.3, 1.35, 1.4, 1.45, 1.05]},
                "one run": {"gears.runs": lambda runs: runs[:1]}, "no shares": {"gears.runs.*.load_sharing": {}},
                "no spectrum": {"gears.spectrum.amplitude_N": [0.0] * 5, "gears.spectrum.status": "failed"}, "spectrum without speed": {"gears.spectrum.speed_rpm": None, "gears.spectrum.status": ""},
                "wide spectrum": {"gears.spectrum.amplitude_N": [90.0, 1e-9, 0.0, 3.0, 0.25], "gears.spectrum.mesh_frequency_Hz": 333.0}}.items():
            found = changed(whole, edits)
            touched = {path.split(".")[1] for path in edits if path.count(".") > 0}
            for draw in gears.BLOCKS:
                part = {"pair_block": "tooth_pairs", "stiffness_block": "meshes", "shape_block": "mode_shapes", "campbell_block": "campbell", "spectrum_block": "spectrum"}
                if not touched or part.get(draw.__name__, "runs") in touched or ("meetings" in touched and draw.__name__ in ("campbell_block", "acceleration_block")):
                    self.block(f"gears, {draw.__name__}: {name}", draw, found["gears"])
        with style.context():
            self.check("gears: Campbell diagram beside a life", picture_of(gears.gear_modes.campbell_beside_life(whole["gears"], 2000.0, 8000.0, (4.6, 4.4))))

    def test_two_ways(self):
        begin()
        content = made.coupled()
        for name, edits in {"all": {}, "one system": {"fidelity": "monolithic", "coupled.how": None}, "no life": {"points.*.life_h": None}, "L10mh": of_life("L10mh") | {
                "coupled.one_way.L10mh": [1.0e4, 2.0e4, 3.0e4, 4.0e4, 1.5e4, 1.7e4]}, "no life of both": {"coupled.one_way.life_h": [0.0] * 6},
                "no residual": {"points.*.interface_energy_residual": None}, "negative": {"points.*.interface_energy_residual": lambda x: -x},
                "shorter": {"coupled.one_way.life_h": [9e5, 8e5, 7e5, 6e5, 5e5, 0.0]}}.items():
            draw = coupled.blocks if name in ("all", "one system", "no residual", "negative") else coupled._comparison
            self.block(f"two ways: {name}", draw, Report(changed(content, edits), None))

    def test_slip_over_speed_and_power(self):
        begin()
        content = made.powers()
        fine = made.fine_powers()
        for name, found in {
                "all": content, "fine": fine, "fine, both signs": changed(fine, {"points.*.cage_slip": lambda x: None, "points.*.roller_slip": 0.01, "points.3.roller_slip": -0.02}),
                "no load": changed(fine, {"points.7.planet_load_N": None}), "no axis": changed(content, {"axes": []}), "one value": changed(content, {"points": content["points"][::2]}),
                "no slip": changed(content, {"points.*.cage_slip": None, "points.*.roller_slip": None}), "both signs": changed(content, {"points.0.cage_slip": -0.02}),
                "ahead": changed(content, {"points.*.cage_slip": lambda x: -abs(x) - 0.001}), "holes": changed(content, {"points.1.roller_slip": None, "points.2.planet_load_N": None}),
                "no kinematics": changed(content, {"kinematics": {}}), "no inner race": changed(content, {"kinematics.inner_race": None}), "no outer race": changed(content, {"kinematics.outer_race": None}), "no cage": changed(content, {"kinematics.cage": 0, "points.*.orbit_slip": lambda row: 0.3 * row["roller_slip"]}),
                "another axis": changed(content, {"axes": [{"column": "speed"}, {"column": "torque"}], "slice": {"torque": 7.0, "input.power_kW": 150.0}, "points.*.torque": 7.0,
                                                  "points.1.torque": 9.0, "points.3.torque": 9.0, "points.5.torque": 9.0})}.items():
            self.block(f"slip map: {name}", slip_map.block, Report(found, None))

    def test_load_spectra(self):
        begin()
        content = made.spectrum()
        files = [{"file": name, "share": share, "damage_share": damage, "damage_share_L10mh": other, "skid_risk_share": risk, "skid_risk_hours": hours}
                 for name, share, damage, other, risk, hours in (("a.csv", 0.2, 0.3, 0.35, 0.01, 11.0), ("b.csv", 0.5, 0.6, None, 0.02, 22.0), ("c.csv", 0.3, None, 0.1, None, None))]
        bins = {"spectrum.bins.*.worst_bearing_h": lambda row: 0.4 * row["life_h"] if row["life_h"] else None}
        alike = [{**content["spectrum"], "kW": 3.0}, {**content["spectrum"], "kW": 4.0, "life_h": 777.0}]
        for name, edits in {
                "all": {}, "no bins": {"spectrum.bins": []}, "worst bearing": {**bins, "spectrum.worst_bearing_key": "shortest_L10mrh", "spectrum.worst_bearing_h": 2222.0, "spectrum.limiting_set": "low",
                                                                           "spectrum.L10mrh": 3210.0, "spectrum.life_key": "L10mrh", "spectrum.system_L10mrh": 432.0},
                "over the carrier": {"spectrum.worst_bearing_key": "carrier_L10mh", "spectrum.worst_bearing_h": 1111.0, "spectrum.files": files},
                "files": {"spectrum.files": files, "spectrum.skid_risk_share": 0.0321, "spectrum.skid_risk_hours": 432.1, "spectrum.minimum_load": 0.02},
                "skid risk": {"spectrum.skid_risk_share": 0.0321, "spectrum.minimum_load": 0.02}, "L10mh": {"spectrum.life_key": "L10mh", "spectrum.files": files},
                "many bins": {"spectrum.bins": lambda bins: [{**bins[i % 4], "damage_share": 0.01 * ((7 * i) % 13), "share": 0.02 * ((5 * i) % 11)} for i in range(14)]},
                "no time": {"spectrum.bins.*.share": 0.0, "spectrum.bins.*.damage_share": None}, "several": {"spectrum": alike, "slice": {"kW": 4.0}},
                "several, none on the line": {"spectrum": alike, "slice": {"kW": 5.0}}}.items():
            self.block(f"spectrum: {name}", load_spectrum.block, Report(changed(content, edits), None))

    def test_crowning(self):
        begin()
        content, computed = made.crown(), made.computed_crown()
        shown = "figures"
        for name, found in {"stated": content, "computed": computed, "nothing": {"crown": {"x": 1}, "figures": {}}}.items():
            self.block(f"crown: {name}", crown.blocks, Report(found, None))
        drops, fronts, speeds, zones = (lambda found: crown.drops(found["crown"]["recommended"]), lambda found: crown.fronts(found[shown]["fronts"], found["crown"]),
                                        lambda found: crown.speeds(found[shown]["speeds"], crown.life_key_of(found["crown"])), lambda found: crown.zones(found[shown]["zone"]))
        by_tilt, outlines = (lambda found: crown.life_map(found[shown]["map"], found["crown"]), lambda found: crown.profiles(found[shown]["profiles"], found[shown]))
        for name, draw, base, edits in (
                ("drops without marks", drops, content, {"crown.recommended.by_laminae": None, "crown.recommended.straight_life_share": None, "crown.recommended.missed": []}),
                ("map, L10mh", by_tilt, content, {"crown.life_key": "L10mh"}), ("map, no reference", by_tilt, content, {"crown.reference": None, "crown.straight.governing_life_h": None}),
                ("map, no tolerances", by_tilt, computed, {f"{shown}.map.drop_tolerance_um": None, f"{shown}.map.tilt_tolerance_mrad": None}),
                ("map, drop's tolerance", by_tilt, computed, {f"{shown}.map.drop_tolerance_um": 30.0, f"{shown}.map.tilt_tolerance_mrad": None}),
                ("map, tilt's tolerance", by_tilt, computed, {f"{shown}.map.drop_tolerance_um": None}),
                ("map, robust without tolerances", by_tilt, content, {f"{shown}.map.tilt_tolerance_mrad": None, f"{shown}.map.drop_tolerance_um": None}),
                ("map, best at the ends", by_tilt, content, {f"{shown}.map.governing_life_h": [[3e4, 1e4], [2e4, 2e4], [1e4, 3e4]], "crown.robust": None}),
                ("map, best between", by_tilt, content, {f"{shown}.map.governing_life_h": [[1.1e4, 2.0e4], [3.3e4, 2.9e4], [2.5e4, 1.7e4]]}), ("map, torn", by_tilt, content, {f"{shown}.map.drop_um": [1.0]}), ("front without points", fronts, content, {f"{shown}.fronts.0.points": [], "crown.life_key": "L10mh"}),
                ("zones, one", zones, content, {f"{shown}.zone": lambda zones: zones[:1], f"{shown}.zone.0.tilt_mrad": None}),
                ("zones of bearings", zones, content, {f"{shown}.zone.1.bearing": 2, f"{shown}.zone.2.places.1.pressure_MPa": None, f"{shown}.zone.3.places.0.angle_deg": 300.0,
                                                       f"{shown}.zone.3.places.3.angle_deg": -170.0}),
                ("speeds at two tilts", speeds, content, {f"{shown}.speeds.1.tilt_mrad": 0.7}), ("speeds, computed tilt", speeds, content, {f"{shown}.speeds.*.tilt_mrad": None, "crown.life_key": "L10mh"}),
                ("speeds, one", speeds, content, {f"{shown}.speeds.*.speed_rpm": [1000.0]}), ("profiles, two", outlines, content, {f"{shown}.profiles": lambda x: x[:2]}),
                ("profiles, deep", outlines, content, {f"{shown}.profiles.*.drop_um": lambda x: [2.5 * one for one in x]}),
                ("profiles, shallow", outlines, content, {f"{shown}.profiles.*.drop_um": lambda x: [0.4 * one for one in x]}),
                ("profiles, flat", outlines, content, {f"{shown}.profiles.*.drop_um": [0.0] * 8})):
            self.block(f"crown: {name}", draw, changed(base, edits))
        self.check("crown: lives", [[crown.life_key_of(one), crown.half_space_life_key(one)] for one in ({}, {"life_key": "life_h"}, {"life_key": "L10mrh"})])

    def test_pressures(self):
        begin()
        def contact(profile, tilt):
            return {"profile": profile, "tilt_mrad": tilt, "x_mm": [0.0, 1.0, 2.5, 3.0, 4.0, 4.5], "y_um": [0.0, 10.0, 20.0, 30.0],
                    "pressure_MPa": [[*made.some(3, 100.0, 900.0), 0.0] for _ in range(6)]}

        one, two = contact("arc", 0.25), contact("straight", 0.0)
        for name, found in {"one": [one], "two": [one, two], "none": [], "uneven": [{**one, "y_um": [0.0]}, two], "nothing carries": [{**one, "pressure_MPa": [[0.0] * 4] * 6}]}.items():
            self.block(f"pressure map: {name}", roller_pressure.map_block, found)
        curves = [{"profile": f"profile {i % 9}", "tilt_mrad": tilt, "x_mm": [0.0, 1.0, 3.0], "pressure_MPa": made.some(3, 100.0, 900.0), "edge_ratio": 1.1 + i, "peak_pressure_MPa": 800.0 + i}
                  for i, tilt in enumerate([0.0] * 9 + [0.5] * 3)]
        for name, found, hertz in (("many", curves, 600.0), ("no peaks", changed(curves, {"*.peak_pressure_MPa": None}), None), ("computed", changed(curves[:2], {"*.tilt_mrad": None}), 300.0)):
            self.block(f"pressure: {name}", roller_pressure.block, found, hertz)

    def test_scratches_and_balls(self):
        begin()
        for name, (content, values) in {"scratch": made.scratch(), "run-up": made.run_up()}.items():
            for more, edits, found in (("all", {}, values), ("nothing", {}, {}), ("no shaft", {"defect.shaft_Hz": 0.0}, values), ("roller", {"defect.roller_pass_Hz": 300.0, "defect.inner_pass_Hz": None, "defect.band_Hz": None}, values)):
                self.block(f"{name}: {more}", defect.blocks, Report(changed(content, edits), None), PointFile(found))
        content, values = made.scratch()
        lines = [{"frequency_Hz": 50.0 * i, "amplitude": 1.0 + i, "is": f"{i}"} for i in range(1, 60)]
        self.block("scratch: many lines", defect.blocks, Report(changed(content, {"defect.envelope_peaks": lines, "defect.spectrum_peaks": lines}), None), PointFile(values))
        content, values = made.balls()
        for name, edits, found, problem in (("all", {}, values, ""), ("nothing", {"balls.heat_W": {}}, {}, "no file"), ("no motion", {"balls.heat_W.spin": None}, {}, "")):
            self.block(f"balls: {name}", ball_motion.blocks, Report(changed(content, edits), None), PointFile(found, problem))

    def test_a_revolution_of_the_carrier(self):
        bearings = [{"planet": planet, "position_mm": place, "load_min_N": 1.5 * planet + place / 100, "load_max_N": 2.5 * planet - place / 100, "equivalent_load_N": 2.0 * planet,
                     "tilt_max_mrad": 0.1 * planet, "L10h_h": 900.0 - 10 * planet + place, "L10rh": 700.0 + place, "L10mh": None, "life_h": 650.0 + planet} for planet in (1, 2) for place in (-50.0, 50.0)]
        meshes = [{"planet": planet, "with": wheel, "K_Hbeta": 1.0 + 0.11 * planet + len(wheel) / 100, "face_load_N_per_mm": made.some(3, 10.0, 90.0)} for planet in (1, 2) for wheel in ("sun", "ring")]
        begin()
        loads = [made.some(4, 10.0, 90.0) for _ in range(3)]
        carrier = {"bearings": bearings, "meshes": meshes, "carrier_angle_deg": [0.0, 120.0, 240.0], "face_position_mm": [-20.0, 0.0, 20.0], "bearing_loads_N": loads,
                   "expected_load_N": 15.0, "largest_load_share": 2.4}
        for one in meshes:
            one["face_load_N_per_mm"] = made.some(3, 10.0, 90.0)
        for name, edits in {"all": {}, "L10rh": {"peak.life_key": "L10rh"}, "no life": {"peak.life_key": "L10mh"}, "nothing": {"carrier.bearings": []}, "torn": {"carrier.bearing_loads_N": loads[:2]},
                            "not expected": {"carrier.expected_load_N": None, "carrier.meshes": meshes[:1]}, "no meshes": {"carrier.meshes": None}}.items():
            self.block(f"carrier: {name}", carrier_revolution.block, Report(changed({"carrier": carrier, "peak": {"life_key": "L10h"}}, edits), None))

    def test_uncertain_lives(self):
        from orbearing.uncertainties.figures import figures
        for name, edit in (("all", {}), ("no motion", {"motion": []}), ("no peak", {"peak": None}), ("L10mh", {"life": "L10mh"}), ("several sets", {"life": "sets.low.system_L10mh"})):
            begin()
            result = made.uncertainty()
            result.data.update(edit)
            try:
                found = {kind: whole_drawing.whole(figure) for kind, figure in figures(result).items()}
            except (TypeError, KeyError, AttributeError) as error:  # what a study always holds
                found = type(error).__name__
            self.check(f"uncertain: {name}", found)

    def test_of_whole_results(self):
        """Which figures a result has, in their order: none has what it needs, so that each gives the reason."""
        part = {"x": 1}
        kinds = {"quasi-static": {}, "in motion": {"fidelity": "dynamic", "gears": part}, "coupled": {"fidelity": "co-simulated", "gears": part, "branches": part, "axes": [part]},
                 "axes in motion": {"fidelity": "dynamic", "axes": [part], "branches": part}, "axes at rest": {"fidelity": "quasi-static", "axes": [part]},
                 "monolithic": {"fidelity": "monolithic"}, "spectrum": {"spectrum": part}, "carrier": {"carrier": part}, "both": {"carrier": part, "spectrum": [part]},
                 "crown": {"crown": part}, "scratch": {"defect": part}, "balls": {"balls": part}, "static": {"static": part}, "pair": {"pair": part}}
        with unittest.mock.patch("orbearing.point_file.read_only_point", lambda folder: PointFile({})):
            self.check("order of figures", {name: [[block.slug, block.title, block.missing] for block in report.blocks_of(Report({"points": [], **content}, None))]
                                            for name, content in kinds.items()})


class Looks(kept_records.Recorded):
    """What all figures share."""

    records = RECORDS

    def test_words_and_numbers(self):
        from matplotlib.figure import Figure
        self.check("words", {
            "tilts": [style.tilt_text(one) for one in (None, 0.0, 0.123456, 12.0)], "lives": [[style.life_name(key), style.a_life(key), style.life_label(key)] for key in ("life_h", "L10mh")],
            "labels": [style.legend_label(text) for text in ("short", "_hidden", 30 * "long ", "x" * 200, "a b " * 60)],
            "points": [style.points_look(count, curve) for count in (1, style.MOST_MARKERS, style.MOST_MARKERS + 1) for curve in (False, True)]})
        looks = {}
        for name, low, high in (("narrow", 3.0, 900.0), ("wide", 1.0, 5000.0)):
            axes = Figure().add_subplot()
            axes.plot([1, 2], [low, high])
            style.life_axis(axes, "L10mh")
            style.speed_axis(axes)
            looks[name] = whole_drawing.axes_of(axes)
            axes.set_xscale("log")
            style.speed_axis(axes)
            looks[f"{name}, logarithmic"] = whole_drawing.axes_of(axes)
        self.check("axes", looks)
        before = dict(matplotlib.rcParams)
        try:
            style.use()
            self.check("settings", {key: str(value) for key, value in matplotlib.rcParams.items() if str(value) != str(matplotlib.rcParamsDefault[key]) and "path" not in key})
        finally:
            with unittest.mock.patch("warnings.warn"):
                matplotlib.rcParams.update({key: value for key, value in before.items() if key != "backend"})

    def test_numbers_of_drawings(self):
        """Each kind of artist as drawn.py reads it."""
        from matplotlib.figure import Figure
        from matplotlib.patches import Annulus, Circle, Ellipse, Polygon, Rectangle
        from orbearing.drawn import panels_of, states_map
        figure = Figure()
        one, two, three = figure.subplots(1, 3)
        one.plot([1, 2, 3], [4.0, np.nan, 6.0], label="line", marker="o")
        one.plot([1, 2], [7.0, 8.0], label="_hidden")
        one.axhline(2.5, label="level")
        one.axvline(1.25)
        one.plot([0.1, 0.2], [0.3, 0.4], transform=one.transAxes)
        one.bar([1.0, 2.0], [3.0, -4.0], width=0.5, label="bars")
        one.barh([5.0, 6.0], [1.5, 2.5], height=0.25)
        one.fill_between([1.0, 2.0, 3.0], [0.5, 0.6, 0.7], [1.5, 1.7, 1.9], label="band")
        one.fill_between([1.0, 2.0, 3.0], 0, 1, where=[True, True, False], transform=one.get_xaxis_transform(), label="shade")
        one.axvspan(1.1, 1.4, label="span")
        for patch in (Circle((1.0, 2.0), 0.5, label="circle"), Annulus((2.0, 3.0), 0.75, 0.25), Polygon([(0, 0), (1, 0.5), (0.5, 1)]), Rectangle((1.0, 2.0), 3.0, 4.0, label="box"), Ellipse((0, 0), 1, 2)):
            one.add_patch(patch)
        one.scatter([1.0, 2.0], [3.0, 4.0], s=[5.0, 6.0], c=[0.25, 0.75], label="points")
        one.scatter([1.5], [2.5], s=7.0)
        one.vlines([1.0, 2.0], 0.5, [1.5, 2.5], label="lines")
        one.set_title("left", loc="left")
        one.legend()
        one.set(xlabel="x", ylabel="y", xlim=(0, 9), ylim=(-8, 7))
        one.set_xticks([1, 2], ["a", "b"])
        one.annotate("words", (1, 2))
        x, y, z = np.arange(3.0), np.arange(2.0), np.arange(6.0).reshape(2, 3)
        states_map(two.contourf(x, y, z, levels=[0.5, 2.5, 4.5]), x, y, z)
        states_map(two.contour(x, y, np.ma.masked_greater(z, 4.5), [1.5]), x, y, np.ma.masked_greater(z, 4.5))
        two.set_title("centre")
        mesh = three.pcolormesh(x, y, z, shading="nearest")
        three.set_title("right", loc="right")
        figure.colorbar(mesh, ax=three).set_label("bar")
        inset = three.inset_axes([0.1, 0.1, 0.3, 0.3])
        inset.plot([1, 2], [3, 4])
        three.inset_axes([0.5, 0.5, 0.1, 0.1])
        found = panels_of(figure)
        self.check("numbers of drawings", [[panel.title, panel.x_label, panel.y_label, list(panel.x_limits), list(panel.y_limits), list(panel.texts), [list(one) for one in panel.ticks], list(panel.legend),
                                            [[series.kind, series.label, [np.shape(column) for column in series.columns], [np.ravel(column) for column in series.columns], series.marked] for series in panel.series]] for panel in found])

    def test_svg(self):
        """Names, marks and clips of an element that stands in a page."""
        from matplotlib.figure import Figure
        with style.context():
            figure, axes = style.panel()
            self.assertIsInstance(figure, Figure)
            axes.plot([1, 2], [3, 4], marker="o")
            text = str(style.to_svg(figure, "slug", 'a "quoted" <text>'))
        import re
        self.check("element", {"head": text[:text.index(">") + 1], "names": sorted(set(re.findall(r'\bid="([^"]*)"', text)))[:400],
                               "uses": sorted(set(re.findall(r'href="([^"]*)"|url\(([^)]*)\)', text))), "outside": re.findall(r"xmlns|<!--|metadata|http", text)})


if __name__ == "__main__":
    kept_records.main(RECORDS)

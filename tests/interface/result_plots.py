#!/usr/bin/env python3
"""Plots of results, of studies and of the validation guide, and the moving bearing, beside the results.

As figures_test.py, whose comparison is used. Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import tempfile
import types
import unittest
import unittest.mock
from pathlib import Path

from figures_test import Expected, Q, faults, line, np, number, rows, speed_axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from orbearing import animate, results, style
from orbearing.drawn import panels_of
from orbearing.validation.pictures import scatter
from orbearing.validation.rows import Row

RATED = "L10mrh of one bearing (h)"  # of the governing life, which has other values than life_h here
CASE = types.SimpleNamespace(name="a case", core=types.SimpleNamespace(hash=lambda: "0"))


class Compared(unittest.TestCase):
    def check(self, name, figure, *expected):
        found = faults(name, panels_of(figure), list(expected))
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def plotted(self, kind, data, **options):
        figure = Figure()
        with unittest.mock.patch.object(results.Result, "_attributes", lambda self: {}):
            kind(data, "x", CASE).plot(figure.add_subplot(), **options)
        return figure


class Results(Compared):
    def test_sweep(self):
        points = [{"input_speed_rpm": s, "life_h": 1.5e4, "L10mrh": h, "refined": added} for s, h, added in
                  ((3000.0, 21000.0, False), (1000.0, 9000.0, False), (2000.0, 17000.0, True), (5000.0, None, False))]
        peak = {"life_key": "L10mrh", "speed_rpm": 3000.0, "life_h": 21000.0, "refined_speed_rpm": 2500.0, "refined_life_h": 22222.0}
        figure = self.plotted(results.SweepResult, {"points": points, "peak": peak})
        grid = [p for p in points if not p["refined"]]
        self.check("sweep", figure, speed_axes(rows(points, "input_speed_rpm", "L10mrh"), rows(grid, "input_speed_rpm", "L10mrh", "points of the sweep"),
                                               rows(peak, "refined_speed_rpm", "refined_life_h", "peak: 2,500 rpm, 22,222 h"), y_label=RATED, title="a case"))
        self.assertEqual(figure.axes[0].lines[0].get_xdata().tolist(), [1000.0, 2000.0, 3000.0, 5000.0])

    def test_modes(self):
        modes = [{"frequency_Hz": f, "kind": kind, "multiplicity": n} for f, kind, n in
                 ((412.0, "rotational", 1), (533.0, "translational", 2), (671.0, "rotational", 1), (790.0, "planet", 1))]
        bars = [("bars", kind, ([i for i, m in enumerate(modes) if m["kind"] == kind], Q([m["frequency_Hz"] for m in modes if m["kind"] == kind], "Hz")))
                for kind in ("rotational", "translational", "planet")]
        figure = self.plotted(results.ModesResult, {"modes": modes})
        self.check("modes", figure, Expected(*[(kind, label, (places, lengths)) for kind, label, (places, lengths) in bars], x="Hz", x_label="mode",
                                             y_label="natural frequency (Hz)"))

    def test_mesh(self):
        meshes = [{"name": name, "curve": [[0.0, k], [0.3, 1.1 * k], [0.8, 0.9 * k]], "mean_N_per_m": k} for name, k in (("sun mesh", 3.1e8), ("ring mesh", 4.2e8))]
        curves = [line([p[0] for p in m["curve"]], Q([p[1] for p in m["curve"]], "N/m"), m["name"]) for m in meshes]
        figure = self.plotted(results.MeshResult, {"meshes": meshes})
        self.check("mesh", figure, Expected(*curves, x="", x_label="share of the mesh period", y_label="mesh stiffness (N/µm)"))

    def test_crown(self):
        points = [{"profile": "arc", "tilt_mrad": t, "drop_um": d, "life_h": 1e4, "governing_life_h": h} for t, d, h in ((0.0, 1.0, 9e3), (0.0, 4.0, 11e3), (0.5, 1.0, 7e3), (0.5, 4.0, 8e3))]
        best = {"drop_um": 3.25, "life_h": 1e4, "governing_life_h": 12e3}
        series = [rows([p for p in points if p["tilt_mrad"] == t], "drop_um", "governing_life_h", f"arc, tilt {t:g} mrad") for t in (0.0, 0.5)]
        figure = self.plotted(results.CrownResult, {"points": points, "life_key": "L10mrh", "tilt": "stated", "optimum": best, "straight": {}})
        self.check("crown", figure, Expected(*series, rows(best, "drop_um", "governing_life_h", "optimum"), x_label="drop of one roller (µm)", y_label=RATED))

    def stiffness(self):
        tables = [(1000.0, np.arange(25.0).reshape(5, 5) * 1e7 + 1e8), (4000.0, np.arange(25.0).reshape(5, 5) * 2e7 + 1e8)]
        return tables, {"points": [{"speed_rpm": s, "load": {"x_N": 100.0 + s, "moment_x_N_m": 0.5}, "stiffness": k.tolist()} for s, k in tables]}

    def test_stiffness(self):
        tables, data = self.stiffness()
        series = [line(Q([s for s, _ in tables], "rpm"), Q([k[i, i] for _, k in tables], "N/m"), f"{name}{name}") for i, name in enumerate("xyz")]
        self.check("stiffness", self.plotted(results.StiffnessResult, data), Expected(*series, x_label="speed (rpm)", y_label="stiffness (N/µm)"))

    def test_stiffness_as_arrays_and_for_a_rotor(self):
        """rad/s for ROSS, and each displacement by its name."""
        tables, data = self.stiffness()
        result = results.StiffnessResult(data, "stiffness", CASE)
        with unittest.mock.patch.object(results.Result, "_attributes", lambda self: {}):
            arrays = result.to_xarray()
        names = ["x", "y", "z", "tilt_x", "tilt_y"]
        for i, force in enumerate(names):
            for j, along in enumerate(names):
                self.assertEqual(float(arrays.stiffness.sel(force=force, displacement=along)[1]), tables[1][1][i, j])
        self.assertEqual((arrays.load_x_N.attrs["units"], arrays.load_x_N.values.tolist()), ("N", [1100.0, 4100.0]))
        for point in data["points"]:
            point["load"]["x_N"] = 100.0

        def of_release_2(n, kxx, cxx, kyy=None, kxy=0, kyx=0, frequency=None):
            return {**locals(), "over": frequency}

        def of_release_3(n, kxx, cxx, kyy=None, kxy=0, kyx=0, speed=None, frequency=None):
            self.assertIsNone(frequency)  # that of the whirl
            return {**locals(), "over": speed}

        for signature in (of_release_2, of_release_3):
            ross = types.ModuleType("ross")
            ross.BearingElement = type("BearingElement", (), {"__new__": lambda cls, *a, **given: signature(*a, **given), "__init__": signature})
            with unittest.mock.patch.dict("sys.modules", ross=ross):
                element = results.StiffnessResult(data, "stiffness", CASE).ross_element(n=3)
            # Five speeds, of which the first and the last are computed.
            np.testing.assert_allclose(element["over"], np.linspace(1000, 4000, 5) * 2 * np.pi / 60)
            for name, (i, j) in {"kxx": (0, 0), "kxy": (0, 1), "kyx": (1, 0), "kyy": (1, 1)}.items():
                np.testing.assert_allclose(element[name], np.linspace(*(k[i, j] for _, k in tables), 5), err_msg=name)
            self.assertEqual((element["n"], element["cxx"]), (3, [0.0] * 5))

    def test_sensitivities(self):
        inputs = [{"path": f"a.{n}", "elasticity": e, "derivative": 1.0} for n, e in enumerate((-4.0, 2.5, None, 1.25))]
        figure = self.plotted(results.SensitivityResult, {"inputs": inputs}, most=2)
        panel = Expected(("bars", "", ([0, 1], [2.5, -4.0])), x="", x_label="change of life by 1 % more of the input (%), a case", y_label="")
        panel.row_names = ("a.1", "a.0")
        self.check("sensitivities", figure, panel)

    def test_tables_of_a_notebook(self):
        """Each number stands below its own head."""
        point = {"input_speed_rpm": 1.5, "planet_load_N": 2.5, "inner_load_max_N": 3.5, "outer_load_max_N": 4.5, "L10mrh": 5.5, "system_L10mrh": 6.5, "status": "ok"}
        text = results.SweepResult({"points": [point], "peak": {"life_key": "L10mrh", "refined_speed_rpm": 7777.0, "refined_life_h": 8888.0}}, "sweep", CASE)._repr_html_()
        self.assertIn("<tr>" + "".join(f"<th>{key}</th>" for key in point) + "</tr><tr>"
                      + "".join(f"<td>{value}</td>" for value in (1.5, 2.5, 3.5, 4.5, 5.5, 6.5, "ok")) + "</tr>", text)
        self.assertIn("L10mrh peaks at 7,777 rpm with 8,888 h", text)
        row = {"path": "a.b", "value": 1.25, "unit": "mm", "derivative": 2.25, "elasticity": 3.25}
        text = results.SensitivityResult({"inputs": [row]}, "sensitivities", CASE)._repr_html_()
        self.assertIn("<th>path</th><th>value</th><th>unit</th><th>derivative</th><th>elasticity</th>", text)
        self.assertIn("<td>a.b</td><td>1.25</td><td>mm</td><td>2.25</td><td>3.25</td>", text)
        row = {"path": "a.b", "given": "1 mm", "standing": "assumed", "reason": "why"}
        text = results.CheckResult({"inputs": [row]}, "check", CASE)._repr_html_()
        self.assertIn("<td>a.b</td><td>1 mm</td><td>assumed</td><td>why</td>", text)


class Studies(Compared):
    """Lives of variants: curves, bands, points, and the speeds of their peaks."""

    def result(self, lives, clearances, speeds=(1000.0, 3000.0, 2000.0)):
        from orbearing.studies.design import SPEED, Design, Parameter
        from orbearing.studies.result import StudyResult
        from orbearing.studies.table import Chunk, ResultTable
        um = np.array(clearances)
        parameters = [Parameter("bearing.radial_clearance", "bearing.radial_clearance", "um", "", tuple(f"{one:g} um" for one in um), 1e-6 * um, um)]
        sizes = [("bearing.radial_clearance", len(um))]
        if speeds:
            rpm = np.array(speeds)
            parameters.append(Parameter(SPEED, SPEED, "rpm", "", tuple(f"{one:g} rpm" for one in rpm), rpm * np.pi / 30, rpm))
            sizes.append((SPEED, len(rpm)))
        table = ResultTable(lives.size)
        columns = np.column_stack([np.tile(speeds or [1.0], len(um)), 1e9 / lives.ravel(), lives.ravel()])
        table.add(Chunk(np.arange(lives.size), ("input_speed_rpm", "life_h", "L10mrh"), columns))
        return StudyResult({"case": "x", "fidelity": "quasi-static"}, Design(tuple(parameters), tuple(sizes), "grid", 0), table, {"life_key": "L10mrh"})

    def drawn(self, result):
        from orbearing.studies.pictures import life_picture
        figure = Figure()
        life_picture(result, figure.add_subplot())
        return figure

    def test_few_variants_are_curves_with_their_names(self):
        lives = np.array([[11.0, 13.0, 12.0], [21.0, 24.0, 22.0]]) * 1e3
        speed = Q([1000.0, 2000.0, 3000.0], "rpm")
        series = [line(speed, Q(row[[0, 2, 1]], "h"), f"bearing.radial_clearance {name} um") for row, name in zip(lives, ("5", "20"))]
        figure = self.drawn(self.result(lives, (5.0, 20.0)))
        self.check("curves", figure, speed_axes(*series, y_label=RATED))
        self.assertEqual([one.get_xdata().tolist() for one in figure.axes[0].lines], [[1000.0, 2000.0, 3000.0]] * 2)  # from left to right
        self.assertEqual([one.get_marker() for one in figure.axes[0].lines], ["None", "None"])

    def test_more_are_coloured_by_the_parameter(self):
        lives = 1e4 * np.random.default_rng(1).uniform(1.0, 2.0, (9, 3))
        figure = self.drawn(self.result(lives, np.arange(9.0)))
        series = [line(Q([1000.0, 2000.0, 3000.0], "rpm"), Q(row[[0, 2, 1]], "h")) for row in lives]
        self.check("coloured", figure, speed_axes(*series, y_label=RATED), Expected(y_label="bearing.radial_clearance (um)"))
        self.assertEqual(figure.axes[1].get_ylim(), (0.0, 8.0))

    def test_many_are_bands(self):
        lives = 1e4 * np.random.default_rng(2).uniform(1.0, 2.0, (70, 3))
        lives[3, 1] = np.nan
        ordered = np.sort(lives[:, [0, 2, 1]], axis=0)

        def share(percent):  # between the two of order, as many as there are without a gap
            found = []
            for column in ordered.T:
                known = column[np.isfinite(column)]
                place = percent / 100 * (len(known) - 1)
                found.append(known[int(place)] + place % 1 * (known[min(int(place) + 1, len(known) - 1)] - known[int(place)]))
            return Q(found, "h")

        speed = Q([1000.0, 2000.0, 3000.0], "rpm")
        self.check("bands", self.drawn(self.result(lives, np.arange(70.0))),
                   speed_axes(("band", "5 to 95 % of the variants", (speed, share(5), share(95))), ("band", "25 to 75 %", (speed, share(25), share(75))),
                              line(speed, share(50), "median"), y_label=RATED))

    def test_without_speeds_over_the_parameter(self):
        lives = np.array([9e3, 8e3, 4e3])
        self.check("parameter", self.drawn(self.result(lives, (0.0, 15.0, 40.0), ())),
                   Expected(line([0.0, 15.0, 40.0], Q(lives, "h")), x="", x_label="bearing.radial_clearance (um)", y_label=RATED))

    def test_peaks(self):
        from orbearing.studies import pictures
        lives = np.array([[11.0, 13.0, 12.0], [21.0, 24.0, 27.0]]) * 1e3
        result = self.result(lives, (5.0, 20.0))
        with style.context(), unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", lambda self, target, **more: target.write("<svg></svg>")):
            picture = pictures._peak_block(result).pictures[0]
            page = pictures.page_of(result)
        circles = ("points", "", ([5.0, 20.0], Q([13e3, 27e3], "h"), [14.0], Q([3000.0, 2000.0], "rpm")))
        found = faults("peaks", picture.panels, [Expected(circles, x="", z="rpm", x_label="bearing.radial_clearance (um)", y_label="longest L10mrh of one bearing (h)"),
                                                 Expected(y_label="speed of the peak (rpm)")])
        self.assertEqual(found, [], "\n" + "\n".join(found))
        self.assertIn("Of 2 variants the longest L10mrh is 27,000 h (bearing.radial_clearance 20 um), the shortest 13,000 h.", page)
        self.assertIn("bearing.radial_clearance (um)</th>", page)

    def test_speeds_in_another_unit_are_shown_in_rpm(self):
        from orbearing.studies.dataset import in_rpm
        from orbearing.studies.design import SPEED, Parameter
        si = np.array([10.0, 200.0])
        shown = in_rpm(Parameter(SPEED, SPEED, "rad/s", "", ("10 rad/s", "200 rad/s"), si, si))
        np.testing.assert_allclose(shown, [300.0 / np.pi, 6000.0 / np.pi], rtol=1e-12)


class Guide(Compared):
    def test_ours_over_theirs(self):
        def row(kind, published, ours, scattered=None, band=None):
            return Row("c", "[A]", kind, "load", "q", "m", "", published, ours, 0.05, scattered, band, "reproduced", "", False, False)

        measured = [row("measurement", 100.0, 110.0, 0.02, {"low_50": 105.0, "high_50": 115.0, "low_90": 95.0, "high_90": 130.0}), row("measurement", 250.0, 240.0)]
        computed = [row("program", -400.0, -404.0)]
        shown = [abs(r.published) for r in measured + computed] + [abs(r.ours) for r in measured + computed]
        edge = [min(shown) / 1.15, max(shown) * 1.15]
        off = lambda r: 100.0 * (r.ours / r.published - 1.0)  # noqa: E731
        whole = [line([100.0, 250.0], [110.0, 240.0], ""), line([400.0], [404.0], ""), line(edge, edge)]
        whole += [("segments", "", one) for one in (([98.0], [110.0], [102.0], [110.0]), ([100.0], [95.0], [100.0], [130.0]))]
        beside = [line([100.0, 250.0], [off(r) for r in measured]), line([400.0], [off(computed[0])]), line([100.0, 250.0], [0.0, 0.0]),
                  *(("segments", "", one) for one in (([100.0], [-5.0], [100.0], [30.0]), ([100.0], [-2.0], [100.0], [2.0])))]
        figure = scatter("load", measured + computed)
        self.check("guide", figure, Expected(*whole, x="", y="", x_label="published (units of the rows)", y_label="ours",
                                             legend=("measurement (2)", "program (1)")),
                   Expected(*beside, x="", y="", x_label="published (units of the rows)", y_label="ours less published (%)"))


class Moving(Compared):
    """The ball bearing that moves: both projections at one instant, in metres."""

    VALUES = {"bearing.balls": "3", "bearing.ball_diameter": "8 mm", "bearing.pitch_diameter": "40 mm", "bearing.cage.inner_diameter": "36 mm",
              "bearing.cage.outer_diameter": "0.043 m"}

    def test_places_at_an_instant(self):
        time = np.array([0.0, 0.1, 0.2])
        run = {"time": time, "first_ball_angle": np.array([0.2, 0.8, 1.4]), "first_ball_inner_load": np.array([10.0, 30.0, 20.0]),
               "inner_speed": np.array([10.0, 20.0, 30.0]), "cage_x": 1e-5 * np.array([1.0, 2.0, 1.5]), "cage_y": 1e-5 * np.array([0.5, -1.0, 0.7]),
               "inner_x": 1e-5 * np.array([0.2, 0.4, 0.3]), "inner_y": 1e-5 * np.array([0.1, 0.3, -0.2])}
        figure = Figure()
        animate.Drawing(figure, self.VALUES, run).show(0.15)
        first, turned, ball, pitch = 1.1, 1.5 + 0.05 * 22.5, 0.004, 0.02  # the integral of the speed: trapezoids, and straight between instants
        turned = 1.5 + (4.0 - 1.5) / 2
        largest = max(np.hypot(run["cage_x"], run["cage_y"]).max(), np.hypot(run["inner_x"], run["inner_y"]).max())
        factor, thick = 0.04 * 2 * pitch / largest, 0.45 * ball
        cage, inner = factor * np.array([1.75e-5, -0.15e-5]), factor * np.array([0.35e-5, 0.05e-5])

        def at(x, y):  # the load, along x, points down
            return np.array([y, -x])

        circle = lambda place, outer, inside=0.0: ("circle", "", tuple(np.atleast_1d(v) for v in (*place, outer, inside)))  # noqa: E731
        balls = [pitch * np.array([np.cos(first + 2 * np.pi * k / 3), np.sin(first + 2 * np.pi * k / 3)]) for k in range(3)]
        ends = np.array([at(inner[0] + r * np.cos(turned), inner[1] + r * np.sin(turned)) for r in (pitch - ball - 1.5 * thick, pitch - ball)])
        front = [circle((0, 0), pitch + ball + thick, pitch + ball), circle(at(*inner), pitch - ball, pitch - ball - 1.5 * thick),
                 circle(at(*cage), 0.0215, 0.018), line(ends[:, 0], ends[:, 1]), *(circle(at(*b), ball) for b in balls)]
        wide = 1.3 * ball
        side = [("area", "", ([-wide, wide], sorted(s * np.array([pitch + ball, pitch + ball + thick])))) for s in (-1, 1)]
        side += [("area", "", ([-wide, wide], -inner[0] + np.array(sorted(s * np.array([pitch - ball, pitch - ball - 1.5 * thick]))))) for s in (-1, 1)]
        side += [("area", "", ([-wide, wide], -cage[0] + np.array(sorted(s * np.array([0.018, 0.0215]))))) for s in (-1, 1)]
        side += [circle((0.0, -b[0]), ball) for b in balls if b[1] > -0.2 * pitch]
        reach = 1.12 * (pitch + ball + thick)
        self.check("moving", figure, Expected(*front, x="", y="", title=f"{150.0:7.1f} ms, {25.0 * 60 / (2 * np.pi):5.0f} rpm", x_limits=(-reach, reach), y_limits=(-reach, reach)),
                   Expected(*side, x="", y="", x_limits=(-0.5 * reach, 0.5 * reach), y_limits=(-reach, reach)))

    def test_a_balls_shade_is_its_load_where_it_stands(self):
        angle = np.array([0.01, 0.02, 3.0, 6.2])
        loads = animate.load_by_place({"first_ball_angle": angle, "first_ball_inner_load": np.array([10.0, 30.0, 8.0, 4.0])})
        self.assertEqual([loads[0], loads[int(3.0 / (2 * np.pi) * 72)], loads[71], loads[5]], [20.0, 8.0, 4.0, 0.0])

    def test_balls_are_as_dark_as_they_are_loaded(self):
        """Three balls at three places where the first one had 10, 30 and 20 N: from 15 % without load to 100 % at the largest."""
        angle = 0.2 + 2 * np.pi * np.arange(3) / 3
        run = {"time": np.array([0.0, 1.0, 2.0]), "first_ball_angle": angle, "first_ball_inner_load": np.array([10.0, 30.0, 20.0]),
               "inner_speed": np.ones(3), **{name: np.full(3, 1e-5) for name in ("cage_x", "cage_y", "inner_x", "inner_y")}}
        figure = Figure()
        animate.Drawing(figure, self.VALUES, run).show(0.0)
        wanted = [0.15 + 0.85 * load / 30.0 for load in (10.0, 30.0, 20.0)]
        front = [one.get_alpha() for one in figure.axes[0].patches if isinstance(one, Circle)]
        np.testing.assert_allclose(front, wanted, rtol=1e-12)
        height = {round(-0.02 * np.cos(place), 9): dark for place, dark in zip(angle, wanted)}  # of a ball's middle across the axis
        side = [one for one in figure.axes[1].patches if isinstance(one, Circle)]
        self.assertEqual(len(side), 2, "the third is behind the axis")
        for one in side:
            self.assertAlmostEqual(one.get_alpha(), height[round(one.center[1], 9)], 12)

    def test_lengths_of_the_resolved_case(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "case.resolved.yaml")
            path.write_text("bearing:\n  balls: 9\n  cage:\n    inner_diameter: 30 mm  # assumed\n  ball_diameter: 0.8 cm\noutput: x\n", encoding="utf-8")
            values = animate.resolved(path)
        self.assertEqual(values["bearing.balls"], "9")
        self.assertEqual([animate.length(values, f"bearing.{name}") for name in ("cage.inner_diameter", "ball_diameter")], [0.03, 0.008])


class Numbers(unittest.TestCase):
    def test_this_tests_own_reading_of_numbers(self):
        self.assertEqual([number(v) for v in (6500, 43869.0, 0.25, 12.345678, 934.25)], ["6,500", "43,869", "0.25", "12.346", "934.25"])




if __name__ == "__main__":
    unittest.main()

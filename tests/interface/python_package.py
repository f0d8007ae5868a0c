"""The Python package beside the command line: the same numbers, errors with file, line and key, results that do not
change, a bearing that a script moves, Ctrl-C."""

# The package `orbearing`.
import copy
import gc
import json
import os
import pathlib
import pickle
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

import program

orbearing = program.package()

CASES = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"]) / "cases"
REDUCER = CASES / "reducer_150kW" / "case.yaml"
COMMAND = os.environ["ORBEARING"]
# A parent that ignores SIGINT would pass that on to the programs below.
signal.signal(signal.SIGINT, signal.default_int_handler)


def printed(*arguments):
    done = subprocess.run([COMMAND, *map(str, arguments), "--json"], capture_output=True, text=True)
    return json.loads(done.stdout)


class TheSameNumbers(unittest.TestCase):
    def test_sweep_to_the_last_digit(self):
        case = orbearing.load(REDUCER)
        case["bearing.radial_clearance"] = "10 um"
        self.assertEqual(case.sweep().data, printed("sweep", REDUCER, "--set", "bearing.radial_clearance=10 um"))

    def test_every_command(self):
        case = orbearing.load(REDUCER)
        for name in ("check", "modes", "mesh"):
            with self.subTest(name):
                self.assertEqual(getattr(case, name)().data, printed(name, REDUCER))
        self.assertEqual(case.crown(drops="0 um, 10 um", starts=1).data, printed("crown", REDUCER, "--drops", "0 um, 10 um", "--starts", "1"))
        self.assertEqual(case.modes(speed="6000 rpm").data, printed("modes", REDUCER, "--speed", "6000 rpm"))

    def test_every_case_runs_as_by_the_command_line(self):
        for file in sorted(CASES.glob("*_iso16281/case.yaml")) + [CASES / "harris_209" / "case.yaml", CASES / "duplex_7020" / "case.yaml"]:
            with self.subTest(file.parent.name):
                result = orbearing.load(file).run()
                self.assertEqual(result.data, printed("run", file))
                result.to_xarray()

    def test_variants_are_points_of_a_sweep(self):
        case = orbearing.load(REDUCER)
        points = case.sweep(grid_only=True)
        speeds = [case.core.si("input.speed", f"{speed} rpm") for speed in points.input_speed_rpm]
        columns, table, status = case.evaluate(["input.speed"], np.array(speeds)[:, None], jobs=1)
        for name in ("life_h", "inner_load_max_N", "film_outer_um", "system_life_h"):
            np.testing.assert_array_equal(table[:, columns.index(name)], points.column(name), name)
        again = case.evaluate(["input.speed"], np.array(speeds)[::-1, None], jobs=2)[1]
        np.testing.assert_array_equal(again[::-1], table)  # whatever order and threads
        self.assertEqual(set(status), {"ok"})

    def test_variants_in_motion_have_the_same_bits_in_any_order_on_any_threads(self):
        """Neighbouring speeds and clearances, one way and as one system, with oil on races and in pockets."""
        case = orbearing.load(REDUCER)
        for path, value in {"film.enabled": "true", "contact.squeeze": "true", "bearing.cage.pocket_film": "hydrodynamic",
                            "simulation.observed_revolutions": "1", "simulation.most_revolutions": "2", "simulation.length_error": "2e-6 mm"}.items():
            case[path] = value
        rows = np.array([[speed, clearance] for speed in (600.0, 620.0) for clearance in (0.0, 20e-6)])
        order = np.random.default_rng(1).permutation(len(rows))
        for fidelity in ("dynamic", "monolithic"):
            with self.subTest(fidelity):
                paths = ["input.speed", "bearing.radial_clearance"]
                columns, table, status = case.evaluate(paths, rows, fidelity=fidelity, jobs=1)
                again = case.evaluate(paths, rows[order], fidelity=fidelity, jobs=2)[1]
                np.testing.assert_array_equal(again, table[order])
                lives = table[:, columns.index("life_h")]
                self.assertEqual((set(status), len(set(lives))), ({"ok"}, len(rows)))

    def test_200_sweeps_in_one_call(self):
        case = orbearing.load(REDUCER)
        speeds = np.tile(np.linspace(1000, 12000, 12) * np.pi / 30, 200)
        clearances = np.repeat(np.linspace(0, 40e-6, 200), 12)
        begin = time.perf_counter()
        columns, table, status = case.evaluate(["input.speed", "bearing.radial_clearance"], np.c_[speeds, clearances])
        seconds = time.perf_counter() - begin
        print(f"200 sweeps of 12 speeds: {seconds:.2f} s")
        self.assertEqual(set(status), {"ok"})
        life = table[:, columns.index("life_h")].reshape(200, 12)
        self.assertTrue((np.diff(life[:, 5]) < 0).all())  # less life by more clearance


# Values that are read are round, and may be written back.
class WhatIsReadMayBeWritten(unittest.TestCase):
    def test_values_are_round(self):
        case = orbearing.load(REDUCER)
        case["bearing.radial_clearance"] = "80 um"
        self.assertEqual(repr(case["bearing.radial_clearance"]), "8e-05")
        self.assertEqual(repr(case["gearset.module"]), "0.003")
        self.assertEqual(repr(case["input.power"]), "150000.0")

    def test_numbers_are_in_si(self):
        case = orbearing.load(REDUCER)
        case["bearing.radial_clearance"] = 8e-5
        self.assertEqual(case["bearing.radial_clearance"], 8e-5)
        self.assertEqual(case.copy({"bearing.radial_clearance": "80 um"})["bearing.radial_clearance"], 8e-5)
        case["bearing.cage"] = {"inner_diameter": np.float64(0.034), "outer_diameter": 0.0376, "width": "9.5 mm", "density": 1140}
        self.assertEqual(case["bearing.cage.inner_diameter"], 0.034)
        case["sweep.input.speed"] = {"from": 100.0, "to": 300.0, "step": 100.0}
        self.assertEqual(len(case.core.axes()["input.speed"]), 3)
        with self.assertRaisesRegex(orbearing.CaseError, "out of range"):
            case["bearing.radial_clearance"] = 80

    def test_every_value_of_every_case_goes_round(self):
        count = 0
        for name, file in orbearing.cases().items():
            case = orbearing.load(file)
            texts = []
            for row in case.inputs:
                path = row["path"]
                if row["source"] in ("absent", "default") or path in ("model",):
                    continue
                texts.append((path, case[path]))
            again = case.copy(dict(texts))
            for path, value in texts:
                with self.subTest(case=name, path=path):
                    self.assertEqual(again[path], value)
                    count += 1
        self.assertGreater(count, 1000)


# A host with a decimal comma (Qt, GTK and R set it), before the first case and after it.
class UnderADecimalComma(unittest.TestCase):
    SCRIPT = """
import json, locale, sys, orbearing
before = sys.argv[1] == "before"
if not before:
    orbearing.load(sys.argv[2])
locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
assert locale.localeconv()["decimal_point"] == ","
case = orbearing.load(sys.argv[2])
case["lubricant.grade"] = "ISO VG 220"
case["sweep.input.speed"] = "{from: 10 rpm, to: 250 rpm, step: 40 rpm}"
sweep = case.sweep()
print(json.dumps([case.resolved, sweep.data], sort_keys=True))
"""

    def test_numbers_are_those_of_a_point(self):
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder + "/de_DE.UTF-8"], capture_output=True,
                                  check=False) if shutil.which("localedef") else None
            use = "import locale; locale.setlocale(locale.LC_ALL, 'de_DE.UTF-8')"  # what is made may lack parts
            if made is None or subprocess.run([sys.executable, "-c", use], env={**os.environ, "LOCPATH": folder}, capture_output=True,
                                              check=False).returncode != 0:
                self.skipTest("localedef cannot make a locale with a decimal comma (Debian: the package locales)")
            environment = {**os.environ, "LOCPATH": folder, "PYTHONPATH": str(pathlib.Path(orbearing.__file__).parents[1])}
            found = [subprocess.run([sys.executable, "-c", script, when, str(REDUCER)], capture_output=True, text=True, env=environment, check=False)
                     for when, script in (("before", self.SCRIPT), ("after", self.SCRIPT),
                                          ("never", re.sub("(?m)^(locale.set|assert).*$", "", self.SCRIPT)))]
            for one in found:
                self.assertEqual(one.returncode, 0, one.stderr)
            self.assertEqual(found[0].stdout, found[2].stdout)
            self.assertEqual(found[1].stdout, found[2].stdout)


class ErrorsSayWhere(unittest.TestCase):
    def test_unknown_key(self):
        case = orbearing.load(REDUCER)
        with self.assertRaises(orbearing.CaseError) as caught:
            case["bearing.radial_clearence"] = "10 um"
        self.assertEqual(caught.exception.mistakes[0].key, "bearing.radial_clearence")
        self.assertIn("did you mean 'bearing.radial_clearance'", str(caught.exception))
        self.assertEqual(case["bearing.radial_clearance"], 0.0)  # the case is as it was
        with self.assertRaises(orbearing.CaseError):
            case["bearing.radial_clearence"]

    def test_file_line_and_column_of_every_mistake(self):
        text = REDUCER.read_text().replace("150 kW", "150 kN").replace("planets: 4", "planets: four")
        with self.assertRaises(orbearing.CaseError) as caught:
            orbearing.parse(text, "my.yaml")
        found = {mistake.key: mistake for mistake in caught.exception.mistakes}
        self.assertEqual(set(found), {"input.power", "gearset.planets"})
        line = found["input.power"].line
        self.assertEqual(found["input.power"].file, "my.yaml")
        self.assertIn("150 kN", text.splitlines()[line - 1])

    def test_a_failed_variant_is_a_status(self):
        case = orbearing.load(REDUCER)
        columns, table, status = case.evaluate(["bearing.pitch_diameter"], [[case["bearing.pitch_diameter"]], [1e-3]])
        self.assertEqual(status[0], "ok")
        self.assertNotEqual(status[1], "ok")
        self.assertTrue(np.isnan(table[1, columns.index("life_h")]))

    def test_wrong_options(self):
        case = orbearing.load(REDUCER)
        for call in (lambda: case.sweep(fidelity="exact"), lambda: case.evaluate(["input.spead"], [[1.0]]),
                     lambda: case.evaluate(["input.speed", "input.speed"], [[1.0, 1.0]]), lambda: case.crown(dropz="1 um"),
                     lambda: orbearing.load(CASES / "missing" / "case.yaml"), lambda: case.__setitem__("name", object())):
            with self.assertRaises(orbearing.CaseError):
                call()

    def test_what_is_no_text_and_no_number(self):
        """Each value of another type, beyond UTF-8, empty or out of bounds is a mistake of the input, by each function."""
        case = orbearing.load(REDUCER)
        pair = {"input.power": ["1 kW", "2 kW"]}
        sample = {"sampler": "lhs", "samples": 2}
        whole = "found; a whole number of at least"
        for call, said in ((lambda: case[None], "found a path of type NoneType; required: a text, as 'input.power'"),
                           (lambda: case.given(3), "found a path of type int"), (lambda: case.__setitem__(3, "1"), "found a path of type int"),
                           (lambda: case.__delitem__(b"x"), "found a path of type bytes"), (lambda: case.copy({3: "1"}), "found a path of type int"),
                           (lambda: orbearing.load(REDUCER, [("input.power", "1 kW")]),
                               "settings: found a value of type list; required: a dict of values by their paths"),
                           (lambda: orbearing.load(""), "path: found an empty text; required: a case file or its folder"),
                           (lambda: orbearing.load("\ud800"), "found the character '\\ud800'; required: text in UTF-8"),
                           (lambda: case.__setitem__("input.power", "\ud800"), "found the character '\\ud800'"),
                           (lambda: case["\ud800"], "found the character '\\ud800'"),
                           (lambda: case.run(fidelity=""), "--fidelity: found an empty text; required: a value"),
                           (lambda: case.sweep(jobs=True), "--jobs: found 'true'; required: a whole number"),
                           (lambda: case.study(pair, jobs=-1), f"jobs: -1 {whole} 0 and at most 4096 is required"),
                           (lambda: case.study(pair, jobs=1.5), f"jobs: 1.5 {whole} 0"),
                           (lambda: case.study(pair, seed=-1, **sample), f"seed: -1 {whole} 0"),
                           (lambda: case.study(pair, seed=1.5, **sample), f"seed: 1.5 {whole} 0"),
                           (lambda: case.study(pair, sampler="lhs", samples=float("nan")), f"samples: nan {whole} 1"),
                           (lambda: case.study(pair, sampler="lhs", samples=True), f"samples: True {whole} 1"),
                           (lambda: case.study(pair, output=""), "output: found an empty name; required: a folder")):
            with self.assertRaises(orbearing.CaseError) as caught:
                call()
            self.assertTrue(str(caught.exception).startswith(said), caught.exception)
        self.assertEqual(case["input.power"], 150e3)


class Options(unittest.TestCase):
    """Of the commands that Python carries out, read as those of the others."""

    def test_values_are_what_they_seem(self):
        from orbearing.rexs.__main__ import main as convert
        from orbearing.studies.__main__ import main as study
        from orbearing.uncertainties.__main__ import main as uncertainty
        whole = "a whole number of at least"
        empty = "found an empty text; a value is required"
        address = "the address that dask scheduler prints is required, as tcp://host:8786"
        for main, words, said in ((study, ("--jobs", "1_0"), f"--jobs: found '1_0'; {whole} 1 and at most 4096 is required"),
                                  (study, ("--jobs", "\u0663"), f"--jobs: found '\u0663'; {whole} 1"),
                                  (study, ("--jobs", "99999"), f"--jobs: found '99999'; {whole} 1"),
                                  (study, ("--seed", "-1"), f"--seed: found '-1'; {whole} 0 is required"),
                                  (study, ("--samples", "nan"), f"--samples: found 'nan'; {whole} 1 is required"),
                                  (study, ("--table", ""), f"--table: {empty}"),
                                  (study, ("--scheduler", ""), f"--scheduler: {empty}"),
                                  (study, ("--scheduler", "x"), f"--scheduler: found 'x'; {address}"),
                                  (study, ("--scheduler", "tcp://h:99999"), f"--scheduler: found 'tcp://h:99999'; {address}"),
                                  (study, ("--nosuch\x1b[2J",), "unrecognized arguments: --nosuch\\x1b[2J"),
                                  (uncertainty, ("--curves", "1e3"), f"--curves: found '1e3'; {whole} 2 is required"),
                                  (uncertainty, ("--life", ""), f"--life: {empty}"),
                                  (uncertainty, ("--speeds", " "), f"--speeds: {empty}"),
                                  (uncertainty, ("--motion", "-1"), f"--motion: found '-1'; {whole} 0 is required"),
                                  (convert, ("--results", ""), f"--results: {empty}"), (convert, ("-o", ""), f"-o/--output: {empty}")):
            done = program.within(main, REDUCER, *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), (words, done.stderr))
            self.assertIn(said, done.stderr)


class Results(unittest.TestCase):
    def test_do_not_change(self):
        sweep = orbearing.load(REDUCER).sweep(grid_only=True)
        with self.assertRaises(AttributeError):
            sweep.peak = None
        with self.assertRaises(TypeError):
            sweep["points"][0]["life_h"] = 1.0
        with self.assertRaises(ValueError):
            sweep.life_h[0] = 1.0
        before = sweep.case["bearing.radial_clearance"]
        sweep.case["bearing.radial_clearance"] = "10 um"
        self.assertEqual(sweep.case["bearing.radial_clearance"], before)

    def test_datasets_have_axes_and_units(self):
        case = orbearing.load(REDUCER, {"sweep.bearing.radial_clearance": ["0 um", "10 um", "20 um"]})
        grid = case.sweep(grid_only=True).to_xarray()
        self.assertEqual(dict(grid.sizes), {"input_speed_rpm": 12, "bearing.radial_clearance_um": 3})
        self.assertEqual(grid.life_h.attrs["units"], "h")
        self.assertEqual(grid["bearing.radial_clearance_um"].attrs["units"], "um")
        alone = orbearing.load(REDUCER, {"bearing.radial_clearance": "10 um"}).sweep(grid_only=True)
        np.testing.assert_array_equal(grid.life_h.sel({"bearing.radial_clearance_um": 10}), alone.life_h)
        meshes = case.mesh().to_xarray()
        self.assertEqual(meshes.stiffness_N_per_m.dims, ("mesh", "fraction"))

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_motion_keeps_its_series_and_report(self):
        case = orbearing.load(REDUCER, {"simulation.observed_revolutions": 1, "simulation.most_revolutions": 2})
        result = case.run(fidelity="dynamic")
        self.assertIn("time", " ".join(result.series().variables))
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn(b"<svg", result.report(pathlib.Path(folder) / "new" / "page.html").read_bytes())

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_figures_of_the_report_are_functions_of_results(self):
        figures = orbearing.load(REDUCER, {"sweep.input.speed": ["6000 rpm"]}).sweep(grid_only=True).figures()
        self.assertEqual(len(figures["life"].pictures), 2)
        self.assertIn("<svg", figures["polar"]._repr_html_())
        self.assertIn("crown-drop", self.few_rollers().crown(drops="0 um, 5 um", starts=1).figures())

    def few_rollers(self):
        return orbearing.load(REDUCER, {"bearing.rollers": 7})

    def test_plots_and_notebook_displays(self):
        import matplotlib

        matplotlib.use("agg")
        case = orbearing.load(REDUCER)
        for result in (case.sweep(grid_only=True), case.modes(), case.mesh(), self.few_rollers().crown(drops="0 um, 5 um", starts=1)):
            axes = result.plot()
            self.assertTrue(axes.get_xlabel() and axes.get_ylabel())
            self.assertIn("<table>", result._repr_html_())
        self.assertIn("bearing.rollers", case._repr_html_())
        for result in (case.check(), orbearing.load(CASES / "ball_6305_iso16281").run()):
            self.assertIn("<table>", result._repr_html_())

    def test_a_case_travels_to_other_processes(self):
        case = orbearing.load(REDUCER, {"bearing.radial_clearance": "10 um"})
        twin = pickle.loads(pickle.dumps(case))
        np.testing.assert_array_equal(twin.sweep(grid_only=True).life_h, case.sweep(grid_only=True).life_h)
        self.assertEqual(twin.core.hash(), case.core.hash())

    def test_progress_is_reported(self):
        seen = []
        orbearing.load(REDUCER).sweep(progress=lambda done, every, doing: seen.append((done, every)))
        self.assertTrue(seen and seen[0][1] == 12)


class LiveMachine(unittest.TestCase):
    """A bearing in this process: the participant of the co-simulation."""

    def bearing(self):
        planet = orbearing.load(REDUCER).bearing()
        planet.set_input(planet_displacement_x=8e-6, planet_speed=300.0, carrier_speed=200.0)
        planet.initialize()
        return planet

    def test_saved_states_repeat_to_the_bit(self):
        planet = self.bearing()
        for _ in range(20):
            planet.advance(1e-5)
        state = planet.save()
        planet.advance(1e-4)
        force = planet.force
        planet.advance(1e-4)
        planet.restore(state)
        planet.advance(1e-4)
        np.testing.assert_array_equal(planet.force, force)
        other = self.bearing()
        other.restore(state)
        other.advance(1e-4)
        np.testing.assert_array_equal(other.force, force)
        self.assertAlmostEqual(other.time, 3e-4, 12)

    def test_directional_derivatives_by_differences(self):
        planet = self.bearing()
        planet.advance(1e-4)
        step = 1e-10
        at = planet._machine.input("planet.displacement.x")
        forces = []
        for sign in (1, -1):
            planet.set_input("planet.displacement.x", at + sign * step)
            forces.append(planet.force)
        planet.set_input("planet.displacement.x", at)
        difference = (forces[0] - forces[1]) / (2 * step)
        np.testing.assert_allclose(-planet.stiffness[:, 0], difference, rtol=1e-5, atol=1e-6 * abs(difference).max())
        np.testing.assert_allclose(planet.directional_derivative(["force.x", "force.y"], ["planet.displacement.x"], [2.0]),
                                   -2 * planet.stiffness[:, 0])

    def test_what_is_not_known_is_refused(self):
        planet = self.bearing()
        with self.assertRaisesRegex(orbearing.CaseError, "planet.displacement.x"):
            planet.set_input("planet.place", 0.0)
        with self.assertRaises(orbearing.CaseError):
            planet.advance(0.0)
        with self.assertRaises((orbearing.CaseError, ValueError)):
            planet.restore(np.zeros(3))

    def test_gears(self):
        gears = orbearing.load(REDUCER).gears()
        gears.advance(1e-5)
        self.assertTrue(all(np.isfinite(list(gears.all_outputs().values()))))


ENDLESS = """
import sys, time, numpy, orbearing
case = orbearing.load(sys.argv[1])
print("begun", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
case.mesh()  # and the program goes on
print("alive", flush=True)
"""


CLASSED = CASES / "reducer_nu204" / "case.yaml"  # with bearing.clearance_class


class Editing(unittest.TestCase):
    """What is written reads back as it was written; a key can be left out again; a case keeps what it read."""

    def test_what_another_input_replaces_is_refused(self):
        case = orbearing.load(CLASSED)
        before = case["bearing.radial_clearance"]
        with self.assertRaises(orbearing.CaseError) as caught:
            case["bearing.radial_clearance"] = "10 um"
        self.assertIn("bearing.radial_clearance: found '10 um', which another input replaces: it counts only where bearing.clearance_class is not given; "
                      "required: one of both", str(caught.exception))
        self.assertEqual((case["bearing.radial_clearance"], case["bearing.clearance_class"]), (before, "CN"))
        with self.assertRaises(orbearing.CaseError):
            orbearing.load(CLASSED, {"bearing.radial_clearance": 1e-5})

    def test_a_key_is_left_out(self):
        for leave_out in (lambda case: case.__delitem__("bearing.clearance_class"), lambda case: case.__setitem__("bearing.clearance_class", None)):
            case = orbearing.load(CLASSED, {"bearing.clearance_class": "C3"})
            leave_out(case)
            self.assertEqual(case.given("bearing.clearance_class"), "CN")  # the default of a designation
            case["bearing.radial_clearance"] = "10 um"
            self.assertEqual((case["bearing.radial_clearance"], case["bearing.clearance_class"]), (1e-5, None))
            del case["bearing.radial_clearance"]
            self.assertEqual(case["bearing.clearance_class"], "CN")
        case = orbearing.load(REDUCER)
        self.assertIsNotNone(case["bearing.radial_clearance"])
        with self.assertRaisesRegex(orbearing.CaseError, "bearing.radial_clearance: missing"):
            del case["bearing.radial_clearance"]
        self.assertIsNotNone(case["bearing.radial_clearance"])
        case["life.cleanliness"] = "-/17/14"
        self.assertEqual(case["life.cleanliness"], "-/17/14")
        del case["life.cleanliness"]
        self.assertIsNone(case["life.cleanliness"])
        with self.assertRaises(KeyError):
            del case["life.cleanliness"]
        case["life.cleanliness"] = None  # left out already
        with self.assertRaisesRegex(orbearing.CaseError, "life.clenliness: unknown key"):
            case["life.clenliness"] = None

    def test_blocks_and_sweeps_are_left_out(self):
        case = orbearing.load(REDUCER)
        self.assertEqual(len(case.sweep(grid_only=True)["points"]), 12)
        del case["sweep"]
        self.assertEqual(len(case.sweep(grid_only=True)["points"]), 1)
        case = orbearing.load(CLASSED)
        case["bearing.clearance_state"] = "unmounted"
        self.assertIn("warm oil", [row["reason"] for row in case.inputs])
        del case["bearing.temperature"]
        self.assertIsNone(case["bearing.temperature.pin"])
        self.assertNotIn("warm oil", [row["reason"] for row in case.inputs])  # a reason goes with its value

    def test_a_setting_of_null_by_the_command_line(self):
        found = printed("check", CLASSED, "--set", "bearing.clearance_class=null", "--set", "bearing.radial_clearance=10 um", "--set", "bearing.clearance_state=unmounted")
        self.assertEqual({one["path"]: one["given"] for one in found["inputs"]}["bearing.radial_clearance"], "10 um")
        refused = subprocess.run([COMMAND, "check", CLASSED, "--set", "bearing.clearence=null"], capture_output=True, text=True)
        self.assertEqual((refused.returncode, refused.stderr), (2, "--set: bearing.clearence: unknown key; the path of an input, to be left out, is required\n"))

    def test_every_number_reads_back(self):
        """Each number that the case states, written as it reads, in its unit and 1 % larger where it may be."""
        for file in (REDUCER, CASES / "deep_groove_motor" / "case.yaml"):
            case = orbearing.load(file)
            for row in case.inputs:
                if row["kind"] not in ("quantity", "number") or row["source"] == "absent" or row["given"] is None:
                    continue
                path, value = row["path"], case[row["path"]]
                for written in (value, 1.01 * value):
                    try:
                        case[path] = written
                    except orbearing.CaseError:
                        continue  # beyond its range, beside others, or given by another input
                    self.assertTrue(np.isclose(case[path], written, rtol=1e-12, atol=0.0), (path, written, case[path]))
                case = orbearing.load(file)

    def test_a_case_keeps_the_text_that_it_read(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.yaml"
            file.write_text(REDUCER.read_text())
            (pathlib.Path(folder) / "loads.csv").write_text("speed_rpm,power_kW,share\n6000,150,0.5\n3000,50,0.5\n")
            case = orbearing.load(file, {"spectrum": {"file": "loads.csv"}})
            rows = case["spectrum"]
            file.write_text(REDUCER.read_text().replace("power: 150 kW", "power: 300 kW"))
            (pathlib.Path(folder) / "loads.csv").write_text("speed_rpm,power_kW,share\n600,15,1\n")
            case["bearing.radial_clearance"] = "1 um"
            self.assertEqual((case["input.power"], case["spectrum"], case["bearing.radial_clearance"]), (150e3, rows, 1e-6))
            here = os.getcwd()
            try:
                os.chdir("/")
                file.unlink()
                (pathlib.Path(folder) / "loads.csv").unlink()
                case["bearing.radial_clearance"] = "2 um"
                for other in (case.copy({"input.power": "140 kW"}), pickle.loads(pickle.dumps(case)).copy({"input.power": "140 kW"})):
                    self.assertEqual((other["input.power"], other["spectrum"], other["bearing.radial_clearance"]), (140e3, rows, 2e-6))
            finally:
                os.chdir(here)

    def test_a_pickled_case_derives_anew(self):
        """A value that follows from others is no statement of the case: it follows in the copy as well."""
        case = orbearing.load(REDUCER)
        other = pickle.loads(pickle.dumps(case))
        for one in (case, other):
            one["bearing.roller_diameter"] = "5 mm"
        self.assertEqual(other.inputs, case.inputs)
        self.assertEqual(other.core.hash(), case.core.hash())


class ResultsTravel(unittest.TestCase):
    """Results, tables and errors of every kind can be copied and pickled."""

    def test_every_kind_of_result(self):
        case = orbearing.load(REDUCER)
        case["sweep"] = {"input.speed": ["3000 rpm", "6000 rpm"]}
        uncertain = orbearing.load(CASES / "reducer_150kW_uncertain" / "case.yaml")
        results = [case.check(), case.run(), case.sweep(grid_only=True), case.modes(), case.mesh(), case.stiffness(),
                   case.crown(drops="0 um, 10 um", starts=1), case.sensitivities(by=["input.power"]),
                   case.study({"bearing.radial_clearance": ["0 um", "10 um"]}, progress=False), uncertain.uncertainty(samples=16, curves=4, index_samples=8)]
        for result in results:
            for again in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result), copy.copy(result)):
                with self.subTest(type(result).__name__):
                    self.assertIs(type(again), type(result))
                    if isinstance(result, orbearing.Result):
                        self.assertEqual((again.data, again.warnings, repr(again)), (result.data, result.warnings, repr(result)))
                        self.assertEqual(again.case.core.hash(), result.case.core.hash())
                        with self.assertRaises(AttributeError):
                            again.more = 1
        kinds = {type(result).__name__ for result in results}
        self.assertEqual({name for name in vars(orbearing.results) if name.endswith("Result")} - kinds, {"Result"} - kinds)

    def test_files_of_a_result_in_motion(self):
        """A copy shares them; they are deleted with the last one, and another process does not get them."""
        moved = orbearing.load(REDUCER, {"simulation.observed_revolutions": 1, "simulation.most_revolutions": 2})
        result = moved.run(fidelity="dynamic")
        folder = result.folder
        self.assertTrue(folder.is_dir())
        same, sent = copy.deepcopy(result), pickle.loads(pickle.dumps(result))
        self.assertEqual((same.folder, sent.folder), (folder, None))
        del result
        self.assertTrue(folder.is_dir())
        del same
        gc.collect()
        self.assertFalse(folder.exists())


class CtrlC(unittest.TestCase):
    """A call that does not stop ends by the time limit of the test: it takes hours."""

    CALLS = {"variants": "case.evaluate(['input.speed'], numpy.full((10**6, 1), 600.0))",
             "sweep": "case.copy({'sweep.input.speed': {'from': '1000 rpm', 'to': '12000 rpm', 'step': '0.2 rpm'}}).sweep()"}

    def test_raises_long_before_the_end(self):
        for name, call in self.CALLS.items():
            with self.subTest(name):
                child = subprocess.Popen([sys.executable, "-c", ENDLESS.format(call=call), str(REDUCER)], stdout=subprocess.PIPE,
                                         text=True, env={**os.environ, "PYTHONPATH": sys.path[0]})
                self.assertEqual(child.stdout.readline(), "begun\n")
                time.sleep(1.0)
                begin = time.perf_counter()
                child.send_signal(signal.SIGINT)
                self.assertEqual(child.stdout.readline(), "interrupted\n")
                seconds = time.perf_counter() - begin
                self.assertEqual(child.stdout.readline(), "alive\n")
                child.stdout.close()
                child.wait()
                print(f"Ctrl-C in {name}: {seconds:.2f} s")


if __name__ == "__main__":
    unittest.main()

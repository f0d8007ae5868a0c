"""`orbearing crown` from outside: the contract's keys, what must hold of a study, bad input, folders, the page."""

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from program import CASES, LEFT_TO_FULL, REDUCER, SECONDS

ROUND_OFF = 1e-9  # relative, of lives whose loads balance to 1e-12


def call(*arguments):
    command = [os.environ["ORBEARING"], *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def crown(*options, case=REDUCER):
    """JSON of a study."""
    with tempfile.TemporaryDirectory() as folder:
        result = call("crown", case, "-o", pathlib.Path(folder) / "out", "--json", *options)
        assert result.returncode == 0, result.stderr
        assert result.stderr == "", result.stderr
        return json.loads(result.stdout)


def refusal(*options, case=REDUCER):
    """What is said of bad input; nothing may be written."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        result = call("crown", case, "-o", out, *options)
        assert result.returncode == 2, (result.returncode, result.stdout, result.stderr)
        assert not out.exists()
        return result.stderr


def life_at(study, drop, tilt):
    return next(p["governing_life_h"] for p in study["points"] if (p["drop_um"], p["tilt_mrad"]) == (drop, tilt))


STATED = ("--tilts", "0 mrad, 1 mrad, 2 mrad")


class LivesInRun(unittest.TestCase):
    """Lives that `run` gives for the recommended profile, under the spectrum of the case; where it shortens them, that stands first."""

    CASE = CASES / "templates" / "industrial.yaml"
    SETTINGS = ("bearing.laminae=30", "spectrum=[{power: 120 kW, speed: 1500 rpm, share: 0.3}, {power: 10 kW, speed: 750 rpm, share: 0.7}]")

    def life_in_run(self, key, *settings):
        words = [word for setting in (*self.SETTINGS, *settings) for word in ("--set", setting)]
        return json.loads(call("run", self.CASE, "--json", *words).stdout)["spectrum"][key]

    def test_of_a_profile_that_shortens_the_life(self):
        words = [word for setting in self.SETTINGS for word in ("--set", setting)]
        with tempfile.TemporaryDirectory() as folder:
            done = call("crown", self.CASE, "-o", pathlib.Path(folder) / "out", "--drops", "0 um : 12 um : 4 um", "--starts", "1", *words)
            found = json.loads((pathlib.Path(folder) / "out" / "crown.json").read_text(encoding="utf-8"))["result"]
        lives, tilted, advice = found["in_run"], found["in_run"]["at_study_tilt"], found["recommended"]
        profile = "bearing.profile={{kind: iso16281, drop: {:.6g} um}}"
        self.assertEqual(lives["case_h"], self.life_in_run(lives["life_key"]))
        self.assertEqual(lives["recommended_h"], self.life_in_run(lives["life_key"], profile.format(advice["drop_um"])))
        self.assertAlmostEqual(lives["longest_h"] / self.life_in_run(lives["life_key"], profile.format(lives["longest_drop_um"])), 1, delta=1e-5)
        self.assertGreaterEqual(lives["longest_h"], max(lives["recommended_h"], self.life_in_run(lives["life_key"], profile.format(4))))
        self.assertEqual((tilted["recommended_h"], tilted["longest_h"]), (advice["governing_life_h"], found["optimum"]["governing_life_h"]))
        self.assertLess(lives["recommended_h"], lives["case_h"])
        self.assertTrue(advice["shortens_governing_life"])
        said = f"recommended: a drop of {advice['drop_um']:.3g} um {advice['status']}"
        self.assertIn(f"shortens L10mrh of run from {lives['case_h']:.6g} to {lives['recommended_h']:.6g} h; the longest is", advice["status"])
        self.assertEqual((found["warnings"][0], done.stdout.splitlines()[0]), (said, "warning: " + said))
        self.assertTrue(done.stdout.splitlines()[-1].startswith(f"run gives {lives['life_key']} {lives['case_h']:.6g} h for the case, "))


class RangeOfDrops(unittest.TestCase):
    """The drops that are studied extend until the best lies below the greatest, unless they are stated."""

    TILTED = ("--tilts", "8 mrad")
    CASE = CASES / "templates" / "e-drive.yaml"
    CURVE = 0.02  # of a drop: interpolation over wider nodes

    def test_extends_to_the_optimum(self):
        study = crown(*self.TILTED, case=self.CASE)
        greatest = max(point["drop_um"] for point in study["points"])
        wide = crown(*self.TILTED, "--drops", "0 um : 128 um : 4 um", case=self.CASE)
        for part in ("recommended", "optimum"):
            self.assertLess(study[part]["drop_um"], 0.99 * greatest)
            self.assertAlmostEqual(study[part]["drop_um"] / wide[part]["drop_um"], 1.0, delta=self.CURVE)
        self.assertFalse(any("greatest studied" in warning for warning in study["warnings"]))

    def test_extends_no_further_than_drops_that_can_be_stated(self):
        study = crown("--tilts", "90 mrad", "--starts", "1", case=self.CASE)
        greatest = max(point["drop_um"] for point in study["points"])
        self.assertTrue(500.0 < greatest <= 1000.0, greatest)
        self.assertTrue(study["recommended"]["most_is_greatest_studied"])

    def test_stated_drops_stay(self):
        study = crown(*self.TILTED, "--drops", "0 um : 16 um : 2 um", case=self.CASE)
        self.assertEqual(max(point["drop_um"] for point in study["points"]), 16.0)
        self.assertTrue(study["recommended"]["most_is_greatest_studied"])
        self.assertTrue(any("the best drop is the greatest studied" in warning for warning in study["warnings"]))


class ComputedTilt(unittest.TestCase):
    """Tilts are computed where none are stated."""

    @classmethod
    def setUpClass(cls):
        cls.study = crown()

    def test_points_and_designs(self):
        study, points = self.study, self.study["points"]
        self.assertEqual(study["tilt"], "computed")
        self.assertEqual(list(points[0])[:6], ["drop_um", "tilt_mrad", "life_h", "governing_life_h", "peak_pressure_MPa", "edge_ratio"])
        self.assertGreaterEqual(len({p["drop_um"] for p in points}), 8)
        self.assertTrue(all(0.01 < p["tilt_mrad"] < 0.05 for p in points))  # the pin's slope at 6000 rpm
        for key in ("optimum", "straight"):
            self.assertEqual(list(study[key])[:5], ["profile", "drop_um", "life_h", "governing_life_h", "peak_pressure_MPa"])
        self.assertGreaterEqual(study["optimum"]["life_h"], max(p["life_h"] for p in points) * (1 - ROUND_OFF))
        straight = next(p for p in points if p["drop_um"] == 0)
        self.assertAlmostEqual(study["straight"]["life_h"] / straight["life_h"], 1, delta=ROUND_OFF)
        self.assertNotIn("untilted_life_h", study["straight"])

    def test_straight_it_is_the_life_of_a_run(self):
        result = call("run", REDUCER, "--json", "--set", "bearing.tilt_state=computed", "--set", "bearing.laminae=40")
        point = json.loads(result.stdout)["points"][0]
        straight = next(p for p in self.study["points"] if p["drop_um"] == 0)
        self.assertAlmostEqual(straight["life_h"] / point["life_h"], 1, delta=1e-7)  # laminae add up in another order
        self.assertAlmostEqual(straight["tilt_mrad"] / point["largest_bearing_tilt_mrad"], 1, delta=1e-5)

    def test_no_crown_is_needed_where_nothing_leans(self):
        advice = self.study["recommended"]
        self.assertTrue(advice["no_crown_needed"])
        self.assertEqual(advice["least_drop_um"], 0)
        self.assertGreater(advice["straight_life_share"], advice["life_kept_in_band"])
        self.assertLess(advice["missed"][1]["life_share"], 1)
        self.assertEqual(len(advice["points"]), 1)
        self.assertNotIn("within_tolerances", advice)
        self.assertAlmostEqual(max(p["life_share"] for p in advice["curve"]), 1, delta=1e-3)

    def test_an_inclined_pin_asks_for_a_crown(self):
        found = crown("--set", "support.pin_inclination.tangential=2 mrad", "--starts", "2")
        advice = found["recommended"]
        self.assertFalse(advice["no_crown_needed"])
        self.assertGreater(advice["drop_um"], self.study["recommended"]["drop_um"])
        self.assertGreater(advice["points"][0]["load_share"], 1.2)

    @unittest.skipIf(LEFT_TO_FULL, "left to tools/test --full")
    def test_tolerances_cost_life_by_their_probability(self):
        """The uniform ones in tools/test --full, or by hand. Of few rollers, as each point of a quadrature has its own half-space pressures."""
        few = ["--drops", "4 um", "--starts", "1", "--tolerance", "1 um", "--tilt-tolerance", "0.5 mrad", "--set", "bearing.laminae=16",
               "--set", "bearing.rollers=7"]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out"
            result = call("crown", REDUCER, "-o", out, "--json", *few)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.check_page(out)
        advice = json.loads(result.stdout)["recommended"]
        normal = advice["within_tolerances"]
        self.assertEqual((normal["distribution"], normal["drop_um"], normal["pin_inclination_mrad"]), ("normal", 1, 0.5))
        others = [crown(*few, "--distribution", kind)["recommended"]["within_tolerances"]
                  for kind in ("worst", "uniform") if kind == "worst" or not LEFT_TO_FULL]
        lives = [one["half_space_life_h"] for one in (*others, normal)]
        self.assertEqual(lives, sorted(lives))
        self.assertLess(lives[-1], advice["half_space_life_h"])
        self.assertLess(normal["quadrature_error"], 0.02)

    def check_page(self, out):
        if not importlib.util.find_spec("matplotlib"):
            return
        self.assertEqual(call("report", out).returncode, 0)
        page = (out / "report.html").read_text(encoding="utf-8")
        for text in ("No crown is needed", "bearing 2 of a planet", "unloaded pin is inclined", "normal distribution"):
            self.assertIn(text, page)
        self.assertNotIn('class="missing"', page)

    def test_stated_and_computed_exclude_each_other(self):
        self.assertIn("--tilts: found together with", refusal("--tilts", "1 mrad", "--set", "bearing.tilt_state=computed", "--set", "bearing.laminae=20"))
        self.assertIn("stated tilts", refusal(*STATED, "--tolerance", "1 um", "--distribution", "uniform"))
        self.assertIn("without a tolerance", refusal("--distribution", "uniform"))
        for option in ("--tilts", "--drops", "--profile", "--tolerance", "--shares"):
            self.assertIn("an empty text", refusal(option, ""))

    def test_a_stated_tilt_of_the_case_does_not_decide(self):
        found = crown("--starts", "1", "--set", "bearing.laminae=40", "--set", "bearing.misalignment.planet_tilt=1 mrad")
        self.assertEqual(found["tilt"], "computed")
        self.assertTrue(any("planet_tilt" in text and "no effect" in text for text in found["warnings"]))
        self.assertAlmostEqual(found["recommended"]["drop_um"], self.study["recommended"]["drop_um"], delta=1e-6)

    def test_rollers_that_yield_are_warned_of(self):
        found = crown("--starts", "1", "--drops", "4 um", "--set", "input.speed=100 rpm", "--set", "bearing.rollers=7")
        self.assertTrue(any("yield" in text for text in found["warnings"]))

    def test_what_cannot_be_computed_is_stated_and_said(self):
        with tempfile.TemporaryDirectory() as folder:
            result = call("crown", REDUCER, "-o", pathlib.Path(folder) / "out", "--json", "--drops", "4 um", "--starts", "1",
                          "--set", "bearing.laminae=40", "--set", "bearing.misalignment.carrier_wind_up=0.01 deg")
        found = json.loads(result.stdout)
        self.assertEqual(found["tilt"], "stated")
        self.assertTrue(any("carrier_wind_up" in text and "--tilts" in text for text in found["warnings"]))


class Text(unittest.TestCase):
    def test_warnings_are_before_the_results(self):
        """That tilts are assumed decides how a crown is to be read; it was the last of some hundred lines."""
        with tempfile.TemporaryDirectory() as folder:
            words = ("--drops", "0 um, 10 um", "--starts", "1", "--set", "gearset.planet_rim=elastic")
            lines = call("crown", REDUCER, "-o", folder, *words).stdout.splitlines()
        warnings = [i for i, line in enumerate(lines) if line.startswith("warning: ")]
        self.assertEqual(warnings, list(range(len(warnings))), lines)
        self.assertTrue(warnings)


class Contract(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.study = crown(*STATED)

    def test_points(self):
        points = self.study["points"]
        self.assertEqual(list(points[0])[:6], ["drop_um", "tilt_mrad", "life_h", "governing_life_h", "peak_pressure_MPa", "edge_ratio"])
        self.assertEqual({p["tilt_mrad"] for p in points}, {0, 1, 2})
        self.assertGreaterEqual(len({p["drop_um"] for p in points}), 8)
        self.assertTrue(all(p["status"] == "ok" and p["life_h"] > 0 and p["peak_pressure_MPa"] > 500 for p in points))

    def test_optimum_and_straight_are_the_worst_over_the_tilts(self):
        for key in ("optimum", "straight"):
            self.assertEqual(list(self.study[key])[:5], ["profile", "drop_um", "life_h", "governing_life_h", "peak_pressure_MPa"])
        at_zero = [p for p in self.study["points"] if p["drop_um"] == 0]
        straight = self.study["straight"]
        self.assertEqual((straight["profile"], straight["drop_um"]), ("straight", 0))
        self.assertAlmostEqual(straight["life_h"] / min(p["life_h"] for p in at_zero), 1, delta=ROUND_OFF)
        self.assertAlmostEqual(straight["peak_pressure_MPa"], max(p["peak_pressure_MPa"] for p in at_zero), delta=1e-3)

    def test_no_point_of_the_grid_beats_the_optimum(self):
        worst = {}
        for p in self.study["points"]:
            worst[p["drop_um"]] = min(worst.get(p["drop_um"], float("inf")), p["life_h"])
        best = self.study["optimum"]["life_h"]
        self.assertGreaterEqual(best, max(worst.values()))
        self.assertLess(best, 1.05 * max(worst.values()))
        self.assertGreater(best, 1.5 * self.study["straight"]["life_h"])
        self.assertEqual(self.study["optimum"]["starts"]["in_optimum"], 10)

    def test_straight_and_untilted_it_is_the_life_of_a_run(self):
        with tempfile.TemporaryDirectory() as folder:
            result = call("run", REDUCER, "-o", pathlib.Path(folder) / "out", "--json")
            life = json.loads(result.stdout)["points"][0]["life_h"]
        self.assertAlmostEqual(life_at(self.study, 0, 0) / life, 1, delta=ROUND_OFF)

    def test_crown_takes_the_edge_peak_away(self):
        straight = next(p for p in self.study["points"] if (p["drop_um"], p["tilt_mrad"]) == (0, 2))
        self.assertGreater(straight["edge_ratio"], 1.5)
        self.assertLess(self.study["optimum"]["peak_pressure_MPa"], 0.8 * straight["peak_pressure_MPa"])


class Choices(unittest.TestCase):
    def test_spectrum_is_miners_sum_of_its_speeds(self):
        few = ["--set", "sweep.input.speed={from: 3000 rpm, to: 9000 rpm, step: 6000 rpm}", "--set", "bearing.rollers=7", "--tilts", "1 mrad",
               "--drops", "4 um", "--starts", "1"]
        lives = [life_at(crown(*few, "--set", f"input.speed={rpm} rpm"), 4, 1) for rpm in (3000, 9000)]
        equal = life_at(crown(*few, "--spectrum"), 4, 1)
        self.assertAlmostEqual(equal * (0.5 / lives[0] + 0.5 / lives[1]), 1, delta=ROUND_OFF)
        mostly_slow = life_at(crown(*few, "--spectrum", "--shares", "0.9, 0.1"), 4, 1)
        self.assertAlmostEqual(mostly_slow * (0.9 / lives[0] + 0.1 / lives[1]), 1, delta=ROUND_OFF)

    def test_lists_and_ranges(self):
        study = crown("--tilts", "0.5 mrad, 1e-3 rad", "--drops", "1 um : 7 um : 3 um, 0.02 mm", "--starts", "1")
        self.assertEqual(sorted({p["tilt_mrad"] for p in study["points"]}), [0.5, 1])
        self.assertEqual(sorted({p["drop_um"] for p in study["points"]}), [1, 4, 7, 20])

    def test_several_profiles_and_the_best_of_them(self):
        study = crown(*STATED, "--profile", "circular, straight-circular", "--starts", "2", "--set", "bearing.rollers=7")
        lives = {best["profile"]: best["life_h"] for best in study["optima"]}
        self.assertEqual(set(lives), {"circular", "straight-circular"})
        self.assertEqual(study["optimum"]["life_h"], max(lives.values()))
        share = next(best for best in study["optima"] if best["profile"] == "straight-circular")["crowned_share"]
        self.assertTrue(0.1 <= share <= 0.95)

    def test_tolerance_asks_for_more_crown(self):
        study = crown(*STATED, "--tolerance", "1 um", "--tilt-tolerance", "0.5 mrad", "--starts", "3", "--set", "bearing.rollers=7")
        robust, best = study["robust"], study["optimum"]
        self.assertGreater(robust["drop_um"], best["drop_um"])
        self.assertGreater(robust["governing_life_in_band_h"], best["governing_life_in_band_h"])
        self.assertLess(robust["governing_life_h"], best["governing_life_h"])

    def test_life_of_the_standard_feels_the_ends(self):
        study = crown(*STATED, "--life", "iso16281", "--starts", "1")
        self.assertEqual(study["life_key"], "L10rh")
        self.assertTrue(all(p["governing_life_h"] == p["L10rh"] for p in study["points"]))
        self.assertGreater(life_at(study, 1, 0), life_at(study, 0, 0))
        self.assertGreater(study["optimum"]["drop_um"], 3)

    def test_one_set_of_multi_stage(self):
        case = CASES / "three_sets_150kW" / "case.yaml"
        text = refusal(case=case)
        self.assertIn("--of: found nothing", text)
        name = text.rsplit(":", 1)[1].split(",")[0].strip()
        study = crown("--of", name, "--drops", "4 um", "--tilts", "1 mrad", "--starts", "1", case=case)
        self.assertGreater(study["points"][0]["life_h"], 0)


class BadInput(unittest.TestCase):
    def test_every_mistake_at_once(self):
        text = refusal("--tilts", "2", "--drops", "5 kg, -1 um", "--profile", "round", "--tolerance", "1 h")
        for option in ("--tilts", "--drops", "--profile", "--tolerance"):
            self.assertIn(option + ": found", text)
        self.assertIn("iso16281", text)
        self.assertIn("mrad", text)

    def test_values_out_of_place(self):
        self.assertIn("0 to 100 mrad", refusal("--tilts", "-1 mrad"))
        self.assertIn("above 0", refusal("--drops", "0 um"))
        self.assertIn("FROM : TO : STEP", refusal("--drops", "0 um : 5 um : 2 um"))
        self.assertIn("FROM : TO : STEP", refusal("--drops", "0 um : 5 um : 0 um"))
        self.assertIn("one for each speed", refusal("--shares", "0.5, 0.5"))
        self.assertIn("greatest drop", refusal("--tolerance", "1 mm"))
        self.assertIn("--life", refusal("--life", "endless"))
        self.assertIn("--starts", refusal("--starts", "0"))

    def test_cases_without_a_planet_bearing(self):
        self.assertIn("planetary-drivetrain", refusal(case=CASES / "harris_209" / "case.yaml"))

    def test_output_is_required(self):
        result = call("crown", REDUCER)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--output", result.stderr)


class Folders(unittest.TestCase):
    few = ("--drops", "0 um, 4 um", "--tilts", "0 mrad, 1 mrad", "--starts", "1")

    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.out = pathlib.Path(place.name) / "deep" / "out"
        cls.first = call("crown", REDUCER, "-o", cls.out, "--json", *cls.few)
        assert cls.first.returncode == 0, cls.first.stderr

    def test_a_second_study_does_not_overwrite_the_first(self):
        self.assertEqual(call("crown", REDUCER, "-o", self.out, *self.few).returncode, 2)
        self.assertEqual(call("sweep", REDUCER, "-o", self.out, "--resume").returncode, 2)

    def test_resume_shows_the_same_and_refuses_another(self):
        again = call("crown", REDUCER, "-o", self.out, "--json", "--resume", *self.few)
        self.assertEqual((again.returncode, again.stdout), (0, self.first.stdout))
        self.assertEqual(call("crown", REDUCER, "-o", self.out, "--resume", *self.few, "--spectrum").returncode, 2)
        self.assertEqual(call("crown", REDUCER, "-o", self.out, "--resume", *self.few, "--set", "input.power=75 kW").returncode, 2)

    def test_files(self):
        self.assertEqual({p.name for p in self.out.iterdir()}, {"crown.json", "case.resolved.yaml", "manifest.jsonl", "points"})
        try:
            import xarray
        except ImportError:
            self.skipTest("xarray is missing")
        with xarray.open_dataset(self.out / "points" / "00000.nc") as data:
            self.assertEqual({name: data.sizes[name] for name in ("profile", "drop", "tilt")}, {"profile": 1, "drop": 2, "tilt": 2})
            self.assertEqual(data["life"].attrs["units"], "h")
            life = next(p["life_h"] for p in json.loads(self.first.stdout)["points"] if p["drop_um"] == 4 and p["tilt_mrad"] == 1)
            self.assertEqual(float(data["life"][0, 1, 1]), life)

    def test_page(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib is missing")
        out = self.out.with_name("with_page")
        shutil.copytree(self.out, out)
        result = call("report", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        page = (out / "report.html").read_text(encoding="utf-8")
        for slug in ("crown-drop", "crown-map", "crown-front", "crown-profiles", "roller-pressure", "crown-zone", "crown-speeds"):
            self.assertIn(f'<section id="{slug}">', page)
        self.assertNotIn('class="missing"', page)


class Terminal(unittest.TestCase):
    def test_table_and_quiet(self):
        with tempfile.TemporaryDirectory() as folder:
            few = ("--drops", "4 um", "--tilts", "1 mrad", "--starts", "1", "--set", "bearing.rollers=7")
            shown = call("crown", REDUCER, "-o", pathlib.Path(folder) / "a", *few)
            for text in ("recommended.drop_um", "straight", "ISO/TS 16281", "optimum.life_h"):
                self.assertIn(text, shown.stdout)
            self.assertEqual(call("crown", REDUCER, "-o", pathlib.Path(folder) / "b", "--quiet", *few).stdout, "")

    def test_help(self):
        text = call("crown", "--help").stdout
        for option in ("--profile", "--tilts", "--drops", "--spectrum", "--shares", "--tolerance", "--tilt-tolerance", "--distribution", "--life", "--of", "--starts"):
            self.assertIn(option, text)
        self.assertIn("crown", call("--help").stdout)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    unittest.main()

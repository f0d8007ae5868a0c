#!/usr/bin/env python3
"""Uncertain lives against analysis: designs, distributions, Sobol indices, chaos expansions, Weibull's scatter, peaks."""

# Uncertainty, on lives in closed form.
import importlib.util
import math
import os
import sys
import unittest

import numpy as np

if importlib.util.find_spec("openturns") is None:
    print("openturns was not found (Debian: python3-openturns)")
    sys.exit(77)

import openturns as ot

from orbearing.errors import CaseError
from orbearing.uncertainties import chaos, design, indices, scatter
from orbearing.uncertainties.inputs import UncertainInputs, UncertainNumber
from orbearing.uncertainties.lives import RPM, SPEED, _next_speed, refined_peaks
from orbearing.uncertainties.settings import Settings
from orbearing.uncertainties.study import Study

POWER = UncertainNumber("input.power", "uniform", 150e3, least=100e3, most=200e3, si_unit="W", unit="kW", units_per_si=1e-3)
MASS = UncertainNumber("planet.mass", "uniform", 1.0, least=0.5, most=1.5)
# Life at constant power P and speed n under the tangential load P/n and the centrifugal load m n^2 of a planet of mass m: scaled
# by n ~ (P/m)^(1/3) all curves are one, so that the peak stands at n ~ P^(1/3) m^(-1/3) and is as high as P^(-23/9) m^(-7/9).
SPEED_POWERS = (1.0 / 3.0, -1.0 / 3.0)
LIFE_POWERS = (-23.0 / 9.0, -7.0 / 9.0)
RANDOM_ERROR = 5.0  # standard errors: a wrong seed in some 10^6 would fail


def closed_form(power, mass, speed):
    """Life [h] at a speed [rpm]."""
    n = speed / 6000.0
    load = np.hypot(power / 150e3 / n, mass * n**2)
    return 1e4 / n * load ** (-10.0 / 3.0)


def top(power, mass):
    """Speed [rpm] of the peak: d ln L / d ln n = 0 gives (m n^3 / P)^2 = 7/23."""
    return 6000.0 * np.cbrt(power / 150e3 / mass * math.sqrt(7.0 / 23.0))


def moment(number, power):
    """Mean of x^power of a uniform number."""
    low, high = number.least, number.most
    return (high ** (power + 1) - low ** (power + 1)) / ((power + 1) * (high - low))


def product_indices(powers):
    """First and total indices, mean and standard deviation of the product of powers of POWER and MASS: with v_i the variance of a
    factor over the square of its mean, V = prod(1 + v_i) - 1, S_i = v_i / V, T_i = v_i prod_(j != i)(1 + v_j) / V."""
    v = np.array([moment(number, 2 * power) / moment(number, power) ** 2 - 1 for number, power in zip((POWER, MASS), powers)])
    variance = np.prod(1 + v) - 1
    mean = math.prod(moment(number, power) for number, power in zip((POWER, MASS), powers))
    return v / variance, v * (1 + v[::-1]) / variance, mean, mean * math.sqrt(variance)


class Designs(unittest.TestCase):
    def test_same_seed_same_bits_and_the_generator_of_others_goes_on(self):
        ot.RandomGenerator.SetSeed(5)
        undisturbed = [ot.RandomGenerator.Generate() for _ in range(3)]
        for method in design.METHODS:
            with self.subTest(method):
                ot.RandomGenerator.SetSeed(5)
                first = design.points(method, 64, 3, 7)
                self.assertEqual([ot.RandomGenerator.Generate() for _ in range(3)], undisturbed)
                np.testing.assert_array_equal(first, design.points(method, 64, 3, 7))
                self.assertFalse(np.array_equal(first, design.points(method, 64, 3, 8)))
                self.assertTrue(((first > 0) & (first < 1)).all())

    def test_a_latin_hypercube_has_one_point_in_each_row(self):
        points = design.points("lhs", 50, 4, 1)
        np.testing.assert_array_equal(np.sort(np.floor(50 * points), axis=0), np.arange(50.0)[:, None] * np.ones(4))

    def test_pick_freeze_takes_one_group_from_the_other_half(self):
        first, second, joined, alone = design.pick_freeze("monte-carlo", 10, ((0, 2), (1,)), 3, 1).reshape(4, 10, 3)
        np.testing.assert_array_equal(joined, np.column_stack([second[:, 0], first[:, 1], second[:, 2]]))
        np.testing.assert_array_equal(alone, np.column_stack([first[:, 0], second[:, 1], first[:, 2]]))


class Distributions(unittest.TestCase):
    COUNT = 200000

    def sample(self, *numbers, correlations=None):
        inputs = UncertainInputs(list(numbers), correlations)
        return inputs.values(design.points("monte-carlo", self.COUNT, len(inputs), 3))

    def check(self, values, mean, deviation):
        self.assertAlmostEqual(values.mean(), mean, delta=RANDOM_ERROR * deviation / math.sqrt(self.COUNT))
        self.assertAlmostEqual(values.std(), deviation, delta=RANDOM_ERROR * deviation / math.sqrt(self.COUNT))

    def test_moments_in_si(self):
        um = 1e-6
        values = self.sample(UncertainNumber("a", "normal", 0.0, 10 * um, 2 * um), UncertainNumber("b", "uniform", 0.0, least=20 * um, most=45 * um),
                             UncertainNumber("c", "triangular", 0.0, least=1 * um, peak=2 * um, most=6 * um),
                             UncertainNumber("d", "truncated-normal", 0.0, 10 * um, 2 * um, least=9 * um),
                             UncertainNumber("e", "truncated-normal", 0.0, 10 * um, 2 * um, most=9 * um),
                             UncertainNumber("f", "truncated-normal", 0.0, 10 * um, 2 * um, least=9 * um, most=11 * um)).T / um
        self.check(values[0], 10.0, 2.0)
        self.check(values[1], 32.5, 25.0 / math.sqrt(12.0))
        self.check(values[2], 3.0, math.sqrt((1 + 4 + 36 - 2 - 6 - 12) / 18.0))
        # Inverse Mills ratios at 1/2 of a standard deviation.
        edge, above = math.exp(-0.125) / math.sqrt(2 * math.pi), 0.5 * math.erfc(-0.5 / math.sqrt(2))
        ratio = edge / above
        self.check(values[3], 10 + 2 * ratio, 2 * math.sqrt(1 - 0.5 * ratio - ratio**2))
        ratio = edge / (1 - above)
        self.check(values[4], 10 - 2 * ratio, 2 * math.sqrt(1 + 0.5 * ratio - ratio**2))
        self.check(values[5], 10.0, 2 * math.sqrt(1 - edge / (2 * above - 1)))
        for column, low, high in ((1, 20, 45), (2, 1, 6), (3, 9, math.inf), (4, -math.inf, 9), (5, 9, 11)):
            self.assertTrue(((values[column] >= low - 1e-9) & (values[column] <= high + 1e-9)).all())

    def test_correlations_of_normal_scores(self):
        numbers = [UncertainNumber(name, "normal", 0.0, 5.0, 2.0) for name in "abcd"]
        wanted = np.array([[1, 0.6, 0, 0], [0.6, 1, 0, 0.3], [0, 0, 1, 0], [0, 0.3, 0, 1]])
        inputs = UncertainInputs(numbers, wanted)
        self.assertEqual(inputs.groups, ((0, 1, 3), (2,)))
        self.assertEqual(inputs.group_names, ("a + b + d", "c"))
        found = np.corrcoef(self.sample(*numbers, correlations=wanted).T)
        np.testing.assert_allclose(found, wanted, atol=RANDOM_ERROR / math.sqrt(self.COUNT))

    def test_standard_variables_make_the_same_numbers(self):
        inputs = UncertainInputs([POWER, UncertainNumber("a", "normal", 0.0, 5.0, 2.0), UncertainNumber("b", "uniform", 0.0, least=0.0, most=1.0)],
                                 [[1, 0, 0], [0, 1, 0.5], [0, 0.5, 1]])
        cube = design.points("monte-carlo", 100, 3, 1)
        standard, marginals = inputs.standard(cube)
        np.testing.assert_allclose(150e3 + 50e3 * standard[:, 0], inputs.values(cube)[:, 0], rtol=1e-12)
        np.testing.assert_allclose(5.0 + 2.0 * standard[:, 1], inputs.values(cube)[:, 1], rtol=1e-9)
        self.assertEqual([one.getName() for one in marginals], ["Uniform", "Normal", "Normal"])


class SobolIndices(unittest.TestCase):
    INPUTS = UncertainInputs([POWER, MASS])

    def test_of_the_peak_by_its_cube_root_law(self):
        for method in design.METHODS:
            for powers in (SPEED_POWERS, LIFE_POWERS):
                with self.subTest(method=method, powers=powers):
                    values = self.INPUTS.values(design.pick_freeze(method, 4096, self.INPUTS.groups, 2, 1))
                    found = indices.by_pick_freeze(np.prod(values ** np.array(powers), axis=1), self.INPUTS.group_names, 2)
                    first, total, _, deviation = product_indices(powers)
                    for got, edges, wanted in ((found.first, found.first_interval, first), (found.total, found.total_interval, total)):
                        self.assertTrue((edges[:, 0] < got).all() and (got < edges[:, 1]).all())
                        self.assertTrue((np.ptp(edges, axis=1) < 0.15).all(), edges)
                        # Within the interval widened from 95 % to what one in 10^5 leaves.
                        self.assertTrue((np.abs(got - wanted) <= 2.2 * 0.5 * np.ptp(edges, axis=1)).all(), (got, edges, wanted))
                    self.assertAlmostEqual(math.sqrt(found.variance) / deviation, 1.0, delta=0.1)

    def test_intervals_hold_the_index_nineteen_times_of_twenty(self):
        wanted = product_indices(LIFE_POWERS)[0][0]
        held, runs = 0, 100
        for seed in range(runs):
            values = self.INPUTS.values(design.pick_freeze("monte-carlo", 512, self.INPUTS.groups, 2, seed))
            low, high = indices.by_pick_freeze(np.prod(values ** np.array(LIFE_POWERS), axis=1), self.INPUTS.group_names, seed).first_interval[0]
            held += low <= wanted <= high
        self.assertGreaterEqual(held, 85)  # 95 expected, standard deviation 2.2

    def test_few_rows_make_no_index_of_an_idle_input(self):
        inputs = UncertainInputs([POWER, MASS, UncertainNumber("idle", "uniform", 0.0, least=-1.0, most=1.0)])
        errors = []
        for seed in range(20):
            values = inputs.values(design.pick_freeze("monte-carlo", 100, inputs.groups, 3, seed))
            errors.append(indices.by_pick_freeze(np.prod(values[:, :2] ** np.array(SPEED_POWERS), axis=1), inputs.group_names, 1).first[2])
        # A correlation scatters by r ~ 1 / sqrt(100); by Eq. (1) r - (1 - r) r = r^2 is left of it.
        self.assertLess(np.sqrt(np.mean(np.square(errors))), 0.03)

    def test_of_correlated_inputs_as_one_group(self):
        numbers = [UncertainNumber(name, "normal", 0.0, 1.0, 1.0) for name in "abc"]
        inputs = UncertainInputs(numbers, [[1, 0.5, 0], [0.5, 1, 0], [0, 0, 1]])
        values = inputs.values(design.pick_freeze("sobol", 4096, inputs.groups, 3, 1))
        found = indices.by_pick_freeze(values.sum(axis=1), inputs.group_names, 1)
        self.assertEqual(found.names, ("a + b", "c"))
        np.testing.assert_allclose(found.first, [0.75, 0.25], atol=0.03)  # variances 3 and 1

    def test_failed_rows_are_left_out_and_no_variance_has_no_shares(self):
        values = self.INPUTS.values(design.pick_freeze("sobol", 256, self.INPUTS.groups, 2, 1))
        results = values.sum(axis=1)
        results[3] = np.nan
        self.assertEqual(indices.by_pick_freeze(results, self.INPUTS.group_names, 1).samples, 4 * 255)
        same = indices.by_pick_freeze(np.ones(4 * 256), self.INPUTS.group_names, 1)
        self.assertEqual((same.variance, same.total.tolist()), (0.0, [0.0, 0.0]))


class ChaosExpansions(unittest.TestCase):
    def test_beside_monte_carlo_and_analysis(self):
        inputs = UncertainInputs([POWER, MASS])
        for powers in (SPEED_POWERS, LIFE_POWERS):
            with self.subTest(powers):
                cube = design.points("sobol", 500, 2, 1)
                standard, marginals = inputs.standard(cube)
                found = chaos.expansion(standard, marginals, np.prod(inputs.values(cube) ** np.array(powers), axis=1), inputs.groups,
                                        inputs.group_names, 1)
                first, total, mean, deviation = product_indices(powers)
                many = np.prod(inputs.values(design.points("monte-carlo", 200000, 2, 9)) ** np.array(powers), axis=1)
                for wanted_mean, wanted_deviation in ((mean, deviation), (many.mean(), many.std())):
                    self.assertAlmostEqual(found.mean / wanted_mean, 1.0, delta=0.01)
                    self.assertAlmostEqual(found.standard_deviation / wanted_deviation, 1.0, delta=0.05)
                self.assertGreater(found.predictivity, 0.999)
                np.testing.assert_allclose(found.indices.first, first, atol=2e-3)
                np.testing.assert_allclose(found.indices.total, total, atol=2e-3)

    def test_error_at_results_left_out_is_that_of_leaving_each_out(self):
        """By the hat matrix as by a fit of all others, for each number of terms."""
        generator = np.random.default_rng(3)
        terms = np.column_stack([np.ones(12), generator.normal(size=(12, 3))])
        results = terms @ [2.0, 1.0, 0.3, 0.0] + 0.2 * generator.normal(size=12)
        errors = []
        for size in (1, 2, 3, 4):
            left = [results[j] - terms[j, :size] @ np.linalg.lstsq(np.delete(terms[:, :size], j, 0), np.delete(results, j), rcond=None)[0] for j in range(12)]
            errors.append(sum(e * e for e in left) / 12 / results.var())
        count, error = chaos._best_size(terms, results)
        self.assertEqual(count, int(np.argmin(errors)) + 1)
        self.assertAlmostEqual(error, min(errors), delta=1e-9)

    def test_foretells_nothing_of_noise(self):
        inputs = UncertainInputs([POWER, MASS])
        standard, marginals = inputs.standard(design.points("sobol", 500, 2, 1))
        noise = np.random.Generator(np.random.PCG64(1)).normal(size=500)
        self.assertLess(chaos.expansion(standard, marginals, noise, inputs.groups, inputs.group_names, 1).predictivity, 0.1)


class Scatter(unittest.TestCase):
    def test_weibull_at_given_inputs(self):
        self.assertAlmostEqual(float(scatter.single_lives(100.0, 0.1)), 100.0, places=9)
        # Median life over L10 by the slope of 9/8: (ln 2 / ln(1/0.9))^(8/9) = 5.34.
        self.assertAlmostEqual(float(scatter.single_lives(1.0, 0.5)), 5.3363, places=4)
        self.assertAlmostEqual(float(scatter.single_lives(1.0, 0.05, reliability=0.95)), 1.0, places=12)

    def test_of_another_reliability_by_a_1(self):
        """ISO 281: a_1 = 0.95 (ln R / ln 0.9)^(2/3) + 0.05, for 95 % 0.6379; by the slope of 9/8 it would be 0.5274."""
        a_1 = 0.95 * (math.log(0.95) / math.log(0.9)) ** (2.0 / 3.0) + 0.05
        self.assertAlmostEqual(a_1, 0.6379, places=4)
        self.assertAlmostEqual((math.log(0.95) / math.log(0.9)) ** (8.0 / 9.0), 0.5274, places=4)
        one = {"L10h": np.array([1e4, 2e4]), "a_ISO": np.array([1.5, 0.7])}
        one["L10mh"] = a_1 * one["a_ISO"] * one["L10h"]
        one["L10mrh"], one["L10rh"] = 0.5 * one["L10mh"], np.array([3e4, 4e4])
        one |= {f"system_{name}": 0.2 * one[name] for name in ("L10mrh", "L10rh")}
        for name, wanted in (("L10mh", a_1), ("L10mrh", a_1), ("system_L10mrh", a_1), ("L10h", 1.0), ("L10rh", 1.0), ("system_L10rh", 1.0)):
            np.testing.assert_allclose(scatter.reliability_factors(name, one), [wanted, wanted], rtol=1e-14, err_msg=name)
        # With several sets the row has the shortest of each life, so that those of one row need not be of one set.
        sets = {f"sets.{name}.{key}": values * factor ** (key != "a_ISO") for name, factor in (("a", 1.0), ("b", 3.0)) for key, values in one.items()
                if key in ("L10h", "a_ISO", "L10mh", "L10mrh")}
        sets["sets.a.L10mh"][0] = np.nan
        sets |= {"L10h": np.array([1e4, 9e4]), "a_ISO": np.array([1.5, 1.5]), "L10mh": np.array([2e4, 3e4]), "L10mrh": np.array([3e4, 5e4])}
        np.testing.assert_allclose(scatter.reliability_factors("L10mrh", sets), [a_1, a_1], rtol=1e-14)
        np.testing.assert_allclose(scatter.reliability_factors("sets.b.L10mrh", sets), [a_1, a_1], rtol=1e-14)

    def test_both_together(self):
        failed = np.array([0.05, 0.1, 0.5, 0.95])
        np.testing.assert_allclose(scatter.joint_lives([100.0, 100.0], failed), scatter.single_lives(100.0, failed), rtol=1e-12)
        lives = np.array([50.0, 100.0, 400.0])
        for share, time in zip(failed, scatter.joint_lives(lives, failed)):
            self.assertAlmostEqual(scatter.failed_share(time, lives), share, places=12)
        self.assertLess(scatter.joint_lives(lives, 0.1)[0], lives.mean())

    def test_both_together_as_drawn(self):
        generator = np.random.Generator(np.random.PCG64(1))
        lives = generator.lognormal(4.0, 0.5, 1000)
        drawn = scatter.single_lives(lives[generator.integers(0, 1000, 400000)], generator.uniform(size=400000))
        for share in (0.05, 0.5, 0.95):
            time = scatter.joint_lives(lives, share)[0]
            self.assertAlmostEqual(float(np.mean(drawn <= time)), share, delta=RANDOM_ERROR * math.sqrt(share * (1 - share) / 400000))


class Peaks(unittest.TestCase):
    GRID = np.arange(1000.0, 12001.0, 1000.0)

    def test_are_computed_points_next_to_the_top(self):
        generator = np.random.Generator(np.random.PCG64(1))
        power, mass = generator.uniform(100e3, 200e3, 300), generator.uniform(0.5, 1.5, 300)
        asked = []

        def lives_at(rows, speeds):
            asked.append(len(rows))
            return closed_form(power[rows], mass[rows], speeds)

        peaks = refined_peaks(self.GRID, closed_form(power[:, None], mass[:, None], self.GRID), lives_at)
        np.testing.assert_array_equal(peaks.life_h, closed_form(power, mass, peaks.speed_rpm))
        self.assertLess(np.abs(peaks.speed_rpm - top(power, mass)).max(), 2.0)
        self.assertFalse(peaks.at_end.any())
        self.assertEqual(peaks.points, sum(asked))
        self.assertLess(peaks.points / 300, 5)

    def test_the_next_speed_lies_in_the_wider_gap(self):
        """Without a curve through three lives the middle of the wider gap; with its top at the best point a short step into that gap."""
        unknown = _next_speed(np.array([[1000.0, 2000.0, 4000.0], [1000.0, 3000.0, 4000.0]]), np.full((2, 3), np.nan))
        np.testing.assert_array_equal(unknown, [3000.0, 2000.0])
        parabola = np.exp(-np.array([[1.0, 0.0, 4.0], [4.0, 0.0, 1.0]]))  # ln(life) = -((n - n_top)/1000 rpm)^2
        right, left = _next_speed(np.array([[1000.0, 2000.0, 4000.0], [1000.0, 3000.0, 4000.0]]), parabola)
        self.assertTrue(2000.0 < right < 2100.0, right)
        self.assertTrue(2900.0 < left < 3000.0, left)

    def test_at_an_end_and_where_points_fail(self):
        grid = np.array([1000.0, 2000.0, 3000.0])
        lives = np.array([[1.0, 2.0, 3.0], [1.0, np.nan, 0.5], [1.0, 2.0, 1.0]])
        peaks = refined_peaks(grid, lives, lambda rows, speeds: np.full(len(rows), np.nan))
        np.testing.assert_array_equal(peaks.at_end, [True, False, False])
        self.assertEqual((peaks.speed_rpm[0], peaks.life_h[0]), (3000.0, 3.0))
        self.assertTrue(np.isnan(peaks.life_h[1:]).all())


class WholeStudy(unittest.TestCase):
    CASE = {"name": "closed form", "inputs": [], "governing_life": {"key": "life_h"}, "warnings": [], "uncertain": {"correlations": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inputs": [
        {"path": number.path, "distribution": number.distribution, "value": number.value, "mean": None, "standard_deviation": None,
         "from": number.least, "peak": None, "to": number.most, "si_unit": number.si_unit, "unit": number.unit, "units_per_si": number.units_per_si,
         "given": "{uniform: ...}", "reason": ""} for number in (POWER, MASS, UncertainNumber("idle", "uniform", 0.0, least=-1.0, most=1.0))]}}

    @staticmethod
    def evaluate(paths, values, fidelity):
        named = dict(zip(paths, values.T))
        life = closed_form(named["input.power"], named["planet.mass"], named[SPEED] / RPM) * (1.0 if fidelity == "quasi-static" else 0.9)
        failed = named["input.power"] > 199.9e3
        life[failed] = np.nan
        return {"life_h": life, "system_life_h": life / 8}, ["too much" if one else "ok" for one in failed]

    def study(self, **settings):
        return Study(self.CASE, 6000.0, Peaks.GRID, self.evaluate, Settings(**{"samples": 1000, "curves": 300, "index_samples": 200, **settings})).run()

    def test_says_what_analysis_says(self):
        result = self.study(motion=3)
        data = result.data
        # The expansion of the peak's speed against analysis: failed samples are a thousandth of all.
        for name, powers in (("speed_rpm", SPEED_POWERS), ("life_h", LIFE_POWERS)):
            first, total, *_ = product_indices(powers)
            rows = data["peak"][name]["indices"]
            np.testing.assert_allclose([row["first"] for row in rows], [*first, 0.0], atol=0.02)
            np.testing.assert_allclose([row["total"] for row in rows], [*total, 0.0], atol=0.02)
            np.testing.assert_allclose([row["expected_reduction_of_variance"] for row in rows],
                                       [row["first"] * data["peak"][name]["chaos"]["standard_deviation"] ** 2 for row in rows], rtol=1e-12)
        good = np.isfinite(result.peak_speeds)
        np.testing.assert_allclose(result.peak_speeds[good], top(*result.curve_values[good, :2].T), atol=2.0)
        self.assertEqual(data["measure_first"][1]["measure"], "planet.mass")
        self.assertTrue(any("idle: no effect" in text for text in data["warnings"]), data["warnings"])
        self.assertTrue(any("too much" in text for text in data["warnings"]))
        self.assertEqual(data["operating_point"]["failed"], int(np.isnan(result.point_lives).sum()))
        self.assertGreater(result.failed, 0)
        self.assertEqual([row["percentile"] for row in data["motion"]], [5.0, 50.0, 95.0])
        for row in data["motion"]:
            self.assertAlmostEqual(row["ratio"], 0.9, places=12)
        band = data["operating_point"]["of_uncertain_inputs"]["percentiles"]
        np.testing.assert_array_equal(list(band.values()), np.nanpercentile(result.point_lives, [5, 25, 50, 75, 95]))

    @unittest.skipIf(os.environ.get("ORBEARING_FULL") == "no", "left to tools/test --full")
    def test_same_settings_same_bits(self):
        first = self.study().json()
        one, other = self.study(), self.study(seed=2)
        self.assertEqual(first, one.json())
        for arrays in ("point_lives", "curve_lives", "peak_lives"):
            self.assertFalse(np.isclose(getattr(one, arrays), getattr(other, arrays)).any(), arrays)

    def test_samples_that_fail_are_counted_for_the_point_the_speeds_and_the_peak(self):
        def evaluate(paths, values, fidelity):
            results, status = self.evaluate(paths, values, fidelity)
            results["life_h"][values[:, list(paths).index("input.power")] > 170e3] = np.nan
            return results, status

        result = Study(self.CASE, 6000.0, Peaks.GRID, evaluate, Settings(samples=100, curves=20, index_samples=20)).run()
        data = result.data
        for found, lives in ((data["operating_point"]["failed"], result.point_lives), (data["peak"]["failed"], result.peak_lives),
                             *((row["failed"], result.curve_lives[:, i]) for i, row in enumerate(data["speeds"]))):
            self.assertEqual(found, int(np.isnan(lives).sum()))
            self.assertGreater(found, 1)

    def test_the_governing_life_and_one_l10(self):
        """With a reliability of 95 % the governing life is L5mr; bearings scatter about the L10mr that a_1 makes of it."""
        a_1 = 0.95 * (math.log(0.95) / math.log(0.9)) ** (2.0 / 3.0) + 0.05

        def rated(reliability_factor):
            def evaluate(paths, values, fidelity):
                columns, status = self.evaluate(paths, values, fidelity)
                basic, modification = 0.7 * columns["life_h"], np.full(len(values), 1.3)
                return {**columns, "L10h": basic, "a_ISO": modification, "L10mh": reliability_factor * modification * basic,
                        "L10mrh": reliability_factor * 0.4 * columns["life_h"]}, status
            case = {**self.CASE, "governing_life": {"key": "L10mrh"}}
            return Study(case, 6000.0, Peaks.GRID, evaluate, Settings(samples=400, curves=20, index_samples=20)).run().data

        ninety, more = rated(1.0), rated(a_1)
        self.assertEqual((ninety["life"], more["life"]), ("L10mrh", "L10mrh"))
        self.assertEqual(more["weibull"]["reliability"], 0.9)
        self.assertAlmostEqual(more["weibull"]["a_1"], a_1, places=12)
        for one, other in ((ninety["operating_point"], more["operating_point"]), *zip(ninety["speeds"], more["speeds"])):
            self.assertAlmostEqual(other["life_at_the_case_h"] / one["life_at_the_case_h"], a_1, places=12)
            self.assertAlmostEqual(other["of_uncertain_inputs"]["mean"] / one["of_uncertain_inputs"]["mean"], a_1, places=12)
            self.assertAlmostEqual(other["of_single_bearings_at_the_case"]["L10"] / one["life_at_the_case_h"], 1.0, places=12)
            for band in ("of_single_bearings_at_the_case", "of_both"):
                self.assertAlmostEqual(other[band]["L10"] / one[band]["L10"], 1.0, places=9)
                np.testing.assert_allclose(list(other[band]["percentiles"].values()), list(one[band]["percentiles"].values()), rtol=1e-9)

    def test_a_governing_life_without_a_number_is_refused(self):
        def evaluate(paths, values, fidelity):
            columns, status = self.evaluate(paths, values, fidelity)
            return {**columns, "L10mrh": np.full(len(values), np.nan)}, status

        with self.assertRaisesRegex(CaseError, "L10mrh, the governing life, has no number at the case's operating point; one of life_h, system_life_h is required"):
            Study({**self.CASE, "governing_life": {"key": "L10mrh"}}, 6000.0, Peaks.GRID, evaluate, Settings(samples=10, curves=5, index_samples=5)).run()

    def test_another_life(self):
        self.assertEqual(self.study(life="system_life_h").data["life"], "system_life_h")
        with self.assertRaisesRegex(CaseError, "one of life_h, system_life_h is required"):
            self.study(life="cage_slip")

    def test_arrays_with_units(self):
        result = self.study(curves=20)
        found = result.to_xarray()
        self.assertEqual(dict(found.sizes), {"sample": 1000, "curve": 20, "input_speed": 12})
        self.assertEqual(found["input.power"].attrs["units"], "kW")
        np.testing.assert_allclose(found["input.power"], 1e-3 * result.point_values[:, 0])
        self.assertEqual(set(result.plot()), {"life_band", "peak", "indices"})
        with self.assertRaises(ValueError):
            result.point_lives[0] = 1.0

    def test_settings_of_no_use(self):
        for wrong in ({"samples": 1}, {"curves": True}, {"method": "grid"}, {"speeds_rpm": (2.0, 1.0)}, {"seed": -1}):
            with self.subTest(wrong), self.assertRaises(CaseError):
                self.study(**wrong)


if __name__ == "__main__":
    unittest.main()

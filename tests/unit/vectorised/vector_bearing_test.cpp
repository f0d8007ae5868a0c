// The vectorised bearing by all instruction sets, and its linear algebra against differences.
#include "bearing/motion/vector_bearing.hpp"

#include <gtest/gtest.h>

#include "bearing/motion/snapshot.hpp"
#include "tests/many_scratches.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::vectorised::vector_bearing_test {
namespace {

using motion::BearingModel;
using motion::DynamicsParameters;

constexpr int kStates = 30;
constexpr double kAgreement = 1e-10;  // of the largest rate of a kind: required; round-off gives about 1e-13
constexpr double kSlopeError = 1e-6;  // required; central differences of kinked laws give about 1e-8

constexpr double kKink =
    1e-5;  // differences over two steps part by the bend of the laws, 1e-6, or at a kink, more

struct Variant {
  const char* name;
  bool film;
  bool inner_guidance;
  TractionLaw traction;
  int rollers;
  bool rough = false;  // mixed lubrication, waves on the races, unequal rollers
  int laminae = 0;     // of crowned rollers
  double tilt = 0.0;   // [rad]  of the bore
  bool scratched = false;
  bool rim = false;   // bends
  bool full = false;  // no cage
  bool squeeze = false;
  bool pocket_film = false;
  double gravity = 0.0;  // [m/s^2]
};

class VectorBearingTest : public testing::TestWithParam<Variant> {
 protected:
  VectorBearingTest() {
    if (GetParam().full) bearing = test::full_complement_bearing();
    bearing.rollers().count = GetParam().rollers;
    parameters.race.film_in_approach = GetParam().film;
    parameters.race.traction = GetParam().traction;
    parameters.race.squeeze = GetParam().squeeze;
    if (GetParam().pocket_film) parameters.cage.pocket_film = motion::PocketFilm::hydrodynamic;
    if (GetParam().inner_guidance) {
      bearing.cage.guidance = Race::inner;
      parameters.cage.guide_diameter = 33.1e-3;
    }
    if (GetParam().rough) {
      parameters.race.lubrication = motion::Lubrication::mixed;
      bearing.inner.form = {{.order = 2, .amplitude = 1e-6, .phase = 0.4, .rotating = false}};
      bearing.outer.form = {{.order = 3, .amplitude = 2e-6, .phase = 1.0, .rotating = true},
                            {.order = 11, .amplitude = 0.3e-6, .phase = 2.0, .rotating = false}};
      bearing.rollers().diameter_deviation = {0.0, 1e-6, -1e-6, 2e-6};
    }
    bearing.rollers().laminae = GetParam().laminae;
    bearing.rollers().profile = profile::CircularCrown{bearing.rollers().length, 5e-6};
    bearing.inner.profile = profile::CircularCrown{bearing.rollers().length, 1e-6};
    point.bore_tilt = GetParam().tilt * Eigen::Vector2d(0.8, 0.6);
    parameters.excitation = {.angular_frequency = 3e4,
                             .harmonics = {{.order = 1, .cosine = {0.0, 10.0}, .sine = {20.0, 49.0}},
                                           {.order = 3, .cosine = {5.0, 0.0}, .sine = {0.0, 0.0}}}};
    if (GetParam().rim) point.outer_race = test::bending_race();
    parameters.gravity = {.across = GetParam().gravity, .angle = 0.7};
    point.carrier.acceleration = 300.0;
  }

  BearingModel model_now(bool rollers = true) const {
    BearingModel model = bearing_model(bearing, point, parameters);
    if (GetParam().scratched)
      defect::put_scratches(rollers ? test::scratched_everywhere() : test::scratched_races(), model);
    return model;
  }

  Eigen::VectorXd shaken(const BearingModel& model, double length) {
    const double share = GetParam().full && GetParam().rollers == 21
                             ? 0.2
                             : 1.0;  // of rollers that touch, with less room than pockets
    return test::shaken_state(model, bearing, parameters, share * length, 0.05, random);
  }

  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = test::reducer_point(6000.0);
  test::Random random;
};

// Largest magnitude in each kind of variable, so that errors are weighed where they belong.
Eigen::VectorXd scale_by_kind(const BearingModel& model, const Eigen::VectorXd& values) {
  const Eigen::Index z = model.layout.rollers;
  Eigen::VectorXd scale(values.size());
  for (Eigen::Index group = 0; group < model.layout.groups(); ++group)
    scale.segment(group * z, z).setConstant(values.segment(group * z, z).cwiseAbs().maxCoeff());
  const auto pairs = [&](Eigen::Index at, Eigen::Index n) {
    scale.segment(at, n).setConstant(values.segment(at, n).cwiseAbs().maxCoeff());
  };
  if (model.layout.caged) {
    pairs(model.layout.cage(), 2);
    pairs(model.layout.cage() + 2, 1);
    pairs(model.layout.cage() + 3, 2);
    pairs(model.layout.cage() + 5, 1);
  }
  for (const Eigen::Index body : {model.layout.bore(), model.layout.pin()}) {
    pairs(body, 2);
    pairs(body + 2, 2);
  }
  if (model.layout.waves > 0) {
    pairs(model.layout.wave(), model.layout.waves);
    pairs(model.layout.wave_speed(), model.layout.waves);
  }
  if (model.layout.followed > 0) pairs(model.layout.turned(), model.layout.followed);
  return scale.cwiseMax(1e-300);
}

TEST_P(VectorBearingTest, IsTheSameByAllInstructionSets) {
  const BearingModel model = model_now();
  VectorBearing equations(model, mechanics::InstructionSet::baseline);
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    VectorBearing vectorised(model, set);
    double worst = 0.0;
    for (int i = 0; i < kStates; ++i) {
      const Eigen::VectorXd x = shaken(model, i % 3 == 0 ? 2e-6 : 2e-5);
      Eigen::VectorXd expected(x.size()), found(x.size());
      equations.derivative(1e-3, x, expected);
      const std::vector<double> padded = vectorised.padded(x);
      std::vector<double> rate(padded.size());
      for (const bool linear : {false, true}) {
        if (linear)
          vectorised.linearise(1e-3, padded.data(), rate.data());
        else
          vectorised.derivative(1e-3, padded.data(), rate.data());
        vectorised.flatten(rate.data(), found);
        const Eigen::VectorXd scale = scale_by_kind(model, expected);
        const Eigen::VectorXd error = (found - expected).cwiseAbs().cwiseQuotient(scale);
        Eigen::Index at = 0;
        worst = std::max(worst, error.maxCoeff(&at));
        ASSERT_LT(error.maxCoeff(), kAgreement)
            << name_of(set) << ", " << motion::variable_names(model.layout)[static_cast<std::size_t>(at)];
      }
    }
    RecordProperty("worst_" + name_of(set), std::to_string(worst));
  }
}

TEST_P(VectorBearingTest, LoadsAreThoseOfTheSnapshot) {
  const BearingModel model = model_now();
  VectorBearing vectorised(model);
  const Eigen::VectorXd x = shaken(model, 2e-6);
  const motion::Snapshot expected = motion::snapshot(model, x);
  std::vector<double> padded = vectorised.padded(x), rate(padded.size());
  vectorised.derivative(0.0, padded.data(), rate.data());
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    EXPECT_NEAR(vectorised.loads().inner[j], expected.inner.load[j], 1e-9 * expected.inner.load.maxCoeff());
    EXPECT_NEAR(vectorised.loads().outer[j], expected.outer.load[j], 1e-9 * expected.outer.load.maxCoeff());
  }
}

// k = (1 - g J)^-1 b solved in blocks satisfies k - g J k = b with J k from differences.
TEST_P(VectorBearingTest, SolvesWithTheTrueJacobian) {
  if (GetParam().tilt != 0.0) GTEST_SKIP() << "what passes through a roller's tilt is left out of the slopes";
  if (GetParam().rim) GTEST_SKIP() << "what passes between waves and rollers is left out of the slopes";
  const BearingModel model = model_now(false);  // what a roller has turned is left out of the slopes
  int compared = 0, kinked = 0;
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    VectorBearing vectorised(model, set);
    const auto rate_at = [&](const Eigen::VectorXd& x) {
      const std::vector<double> padded = vectorised.padded(x);
      std::vector<double> rate(padded.size());
      Eigen::VectorXd flat(x.size());
      vectorised.derivative(0.0, padded.data(), rate.data());
      vectorised.flatten(rate.data(), flat);
      return flat;
    };
    for (int i = 0; i < kStates; ++i) {
      const double g = i % 2 == 0 ? 2e-6 : 2e-5;
      const Eigen::VectorXd x = shaken(model, i % 3 == 0 ? 2e-6 : 2e-5);
      const Eigen::VectorXd size = scale_by_kind(model, rate_at(x));
      Eigen::VectorXd b(x.size());
      for (Eigen::Index n = 0; n < b.size(); ++n) b[n] = size[n] * random();
      std::vector<double> padded = vectorised.padded(x), rate(padded.size()), rhs = vectorised.padded(b),
                          k(padded.size());
      std::fill(rhs.begin() + model.layout.rollers, rhs.begin() + vectorised.layout().lanes(), 0.0);
      vectorised.linearise(0.0, padded.data(), rate.data());
      ASSERT_TRUE(vectorised.factor(g));
      vectorised.solve(rhs.data(), k.data());
      Eigen::VectorXd flat(x.size());
      vectorised.flatten(k.data(), flat);
      // Far below g, and extrapolated from two steps: the laws bend within a stage.
      const auto difference = [&](double step) -> Eigen::VectorXd {
        return (rate_at(x + step * flat) - rate_at(x - step * flat)) / (2.0 * step);
      };
      const double step = 1e-5 * g;
      const Eigen::VectorXd narrow = difference(step), wide = difference(2.0 * step);
      const Eigen::VectorXd slope = (4.0 * narrow - wide) / 3.0;
      const Eigen::VectorXd error = flat - g * slope - b;
      const Eigen::VectorXd scale =
          scale_by_kind(model, flat.cwiseAbs() + g * slope.cwiseAbs() + b.cwiseAbs());
      ++compared;
      if ((g * (narrow - wide)).cwiseAbs().cwiseQuotient(scale).maxCoeff() > kKink) {
        ++kinked;  // a contact opens or closes between the differences: there is no slope to compare with
        continue;
      }
      Eigen::Index at = 0;
      const double worst = error.cwiseAbs().cwiseQuotient(scale).maxCoeff(&at);
      EXPECT_LT(worst, kSlopeError) << name_of(set) << ", g = " << g << ", state " << i << ", "
                                    << motion::variable_names(model.layout)[static_cast<std::size_t>(at)];
    }
  }
  // Rollers with 3 um between them open and close oftener than pockets of 100 um.
  EXPECT_LT(kinked, compared / (GetParam().full ? 2 : 3));
}

// The slope by time alone: of the load on the bore and of gravity, which turns.
TEST_P(VectorBearingTest, KnowsItsSlopeByTime) {
  if (GetParam().rough || GetParam().scratched || GetParam().rim)
    GTEST_SKIP() << "the slope of what turns with a race is left out";
  const BearingModel model = model_now();
  VectorBearing vectorised(model);
  constexpr double kTime = 1e-3, kStep = 1e-8;  // [s]
  const std::vector<double> x = vectorised.padded(shaken(model, 2e-6));
  std::vector<double> before(x.size()), after(x.size()), slope(x.size());
  vectorised.derivative(kTime - kStep, x.data(), before.data());
  vectorised.derivative(kTime + kStep, x.data(), after.data());
  vectorised.linearise(kTime, x.data(), slope.data());
  vectorised.time_slope(kTime, slope.data());
  double largest = 0.0;
  for (const double one : slope) largest = std::max(largest, std::abs(one));
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(slope[i], (after[i] - before[i]) / (2.0 * kStep), 1.0 + 1e-4 * largest) << "entry " << i;
}

INSTANTIATE_TEST_SUITE_P(
    Variants, VectorBearingTest,
    testing::Values(
        Variant{"dry", false, false, TractionLaw::regularised_coulomb, 15},
        Variant{"film", true, false, TractionLaw::regularised_coulomb, 15},
        Variant{"film_and_shear", true, false, TractionLaw::limiting_shear, 15},
        Variant{"inner_guidance", true, true, TractionLaw::limiting_shear, 16},
        Variant{"rough", true, false, TractionLaw::limiting_shear, 15, true},
        Variant{"rough_and_dry", false, false, TractionLaw::regularised_coulomb, 20, true},
        Variant{"laminae", true, false, TractionLaw::regularised_coulomb, 15, false, 7},
        Variant{"tilted", true, false, TractionLaw::regularised_coulomb, 15, false, 32, 1e-3},
        Variant{"tilted_and_dry", false, false, TractionLaw::limiting_shear, 17, false, 12, 3e-3},
        Variant{"scratched", true, false, TractionLaw::regularised_coulomb, 15, false, 0, 0.0, true},
        Variant{"scratched_and_rough", false, false, TractionLaw::limiting_shear, 20, true, 0, 0.0, true},
        // Rims that bend.
        Variant{"rim", false, false, TractionLaw::regularised_coulomb, 15, false, 0, 0.0, false, true},
        Variant{"rim_and_all", true, false, TractionLaw::limiting_shear, 17, true, 12, 1e-3, true, true},
        Variant{"few_rollers", false, false, TractionLaw::regularised_coulomb, 5},
        // Rollers that touch one another, all of them, some, or in a chain with an end.
        Variant{"full_complement", true, false, TractionLaw::regularised_coulomb, 21, false, 0, 0.0, false,
                false, true},
        Variant{"full_complement_rough", false, false, TractionLaw::limiting_shear, 21, true, 0, 0.0, false,
                false, true},
        Variant{"full_complement_tilted", true, false, TractionLaw::regularised_coulomb, 21, false, 12, 1e-3,
                false, false, true},
        Variant{"without_cage", false, false, TractionLaw::regularised_coulomb, 16, false, 0, 0.0, false,
                false, true},
        // Squeeze film.
        Variant{"squeeze", false, false, TractionLaw::regularised_coulomb, 15, false, 0, 0.0, false, false,
                false, true},
        Variant{"squeeze_film", true, false, TractionLaw::limiting_shear, 15, false, 0, 0.0, false, false,
                false, true},
        Variant{"squeeze_and_all", true, false, TractionLaw::limiting_shear, 17, true, 12, 1e-3, true, true,
                false, true},
        Variant{"pocket_film", false, false, TractionLaw::regularised_coulomb, 15, false, 0, 0.0, false,
                false, false, false, true},
        Variant{"squeeze_and_pocket_film", true, true, TractionLaw::limiting_shear, 17, true, 0, 0.0, false,
                false, false, true, true},
        Variant{"squeeze_full_complement", true, false, TractionLaw::regularised_coulomb, 21, true, 7, 0.0,
                false, false, true, true},
        // So heavy that weight shows beside the contacts.
        Variant{"weight", false, false, TractionLaw::regularised_coulomb, 17, false, 0, 0.0, false, false,
                false, false, false, 2e4},
        Variant{"weight_full_complement", true, false, TractionLaw::regularised_coulomb, 21, false, 0, 0.0,
                false, false, true, false, false, 2e4}),
    [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

}  // namespace
}  // namespace orbearing::bearing::vectorised::vector_bearing_test

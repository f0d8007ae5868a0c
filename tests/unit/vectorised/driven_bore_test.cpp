// The bearing with a driven or open bore: equal results of all instruction sets, and its linear algebra
// against that of the free bore.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::vectorised::driven_bore_test {
namespace {

using motion::BearingModel;
using motion::BoreMotion;
using motion::BoreReaction;

constexpr int kStates = 30;
constexpr double kAgreement = 1e-10;  // of the largest number of a kind: required; found 3e-11

struct Variant {
  const char* name;
  bool film;
  bool inner_guidance;
  bool rough;
  bool full = false;  // no cage
};

class OpenBore : public testing::TestWithParam<Variant> {
 protected:
  OpenBore() {
    parameters.race.film_in_approach = GetParam().film;
    if (GetParam().full) bearing = test::full_complement_bearing();
    if (GetParam().inner_guidance) {
      bearing.cage.guidance = Race::inner;
      parameters.cage.guide_diameter = 33.1e-3;
    }
    if (!GetParam().rough) return;
    parameters.race.lubrication = motion::Lubrication::mixed;
    bearing.outer.form = {{.order = 3, .amplitude = 2e-6, .phase = 1.0, .rotating = true},
                          {.order = 11, .amplitude = 0.3e-6, .phase = 2.0, .rotating = false}};
    bearing.rollers().diameter_deviation = {0.0, 1e-6, -1e-6, 2e-6};
  }

  Eigen::VectorXd shaken(const BearingModel& model, int i) {
    return test::shaken_state(model, bearing, parameters, i % 3 == 0 ? 2e-6 : 2e-5, 0.05, random);
  }
  BoreMotion random_motion(const BearingModel& model, const Eigen::VectorXd& x) {
    BoreMotion motion;
    motion.position = x.segment<2>(model.layout.bore());
    motion.velocity = x.segment<2>(model.layout.bore() + 2);
    motion.acceleration = {100.0 * random(), 100.0 * random()};
    motion.speed = -700.0 + 300.0 * random();
    motion.angle = 10.0 * random();
    motion.carrier_speed = 200.0 * random();
    motion.carrier_acceleration = 500.0 * random();
    return motion;
  }

  Bearing bearing = test::reducer_bearing();
  motion::DynamicsParameters parameters = test::reducer_parameters();
  OperatingPoint point = test::reducer_point(6000.0);
  test::Random random;
};

TEST_P(OpenBore, IsTheSameByAllInstructionSets) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  VectorBearing baseline(model, mechanics::InstructionSet::baseline);
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    VectorBearing vectorised(model, set);
    for (int i = 0; i < kStates; ++i) {
      const Eigen::VectorXd x = shaken(model, i);
      const BoreMotion motion = random_motion(model, x);
      Eigen::VectorXd expected(x.size()), found(x.size());
      const BoreReaction on_bore = baseline.derivative(motion, x, expected);
      const std::vector<double> padded = vectorised.padded(x);
      std::vector<double> rate(padded.size());
      if (i % 2 == 0)
        vectorised.linearise(motion, padded.data(), rate.data());
      else
        vectorised.derivative(motion, padded.data(), rate.data());
      vectorised.flatten(rate.data(), found);
      const Eigen::Index z = model.layout.rollers;
      for (int group = 0; group < 5; ++group)
        EXPECT_LT((found - expected).segment(group * z, z).norm(),
                  kAgreement * expected.segment(group * z, z).norm());
      for (Eigen::Index k = model.layout.cage(); k < model.layout.size(); ++k)
        EXPECT_NEAR(
            found[k], expected[k],
            kAgreement * expected.tail(model.layout.size() - model.layout.cage()).cwiseAbs().maxCoeff());
      const BoreReaction here = vectorised.reaction();
      EXPECT_LT((here.force - on_bore.force).norm(), kAgreement * on_bore.force.norm()) << name_of(set);
      EXPECT_NEAR(here.moment, on_bore.moment,
                  kAgreement * on_bore.force.norm() * model.geometry.outer_radius)
          << name_of(set);
    }
  }
}

// The bore's row, put together from its inertia and the reduced bearing, gives what the free bearing gives.
TEST_P(OpenBore, ClosedByItsInertiaIsTheFreeBearing) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  const double m = model.bore_mass, turn = model.frame.centrifugal, late = model.frame.euler,
               coriolis = model.frame.coriolis_speed;
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    VectorBearing vectorised(model, set);
    for (int i = 0; i < kStates; ++i) {
      const double g = i % 2 == 0 ? 2e-6 : 2e-5;
      const std::vector<double> x = vectorised.padded(shaken(model, i));
      std::vector<double> rhs(x.size()), closed(x.size()), open(x.size());
      vectorised.linearise(0.0, x.data(), rhs.data());
      ASSERT_TRUE(vectorised.factor(g));
      vectorised.solve(rhs.data(), closed.data());
      PortMatrix port;
      double force[3];
      ASSERT_TRUE(vectorised.factor_open(g, false, port));
      vectorised.reduce(rhs.data(), open.data(), force);
      const double* b = rhs.data() + vectorised.layout().bore();
      Eigen::Matrix2d matrix;
      const double diagonal = m * (1.0 - g * g * turn), off = m * g * (2.0 * coriolis + g * late);
      matrix << diagonal + port.a[0][0], port.a[0][1] - off, port.a[1][0] + off, diagonal + port.a[1][1];
      const Eigen::Vector2d right(force[0] + m * (b[2] + g * (turn * b[0] + late * b[1])),
                                  force[1] + m * (b[3] + g * (turn * b[1] - late * b[0])));
      const Eigen::Vector2d found = matrix.inverse() * right;
      const double rate[3] = {found[0], found[1], 0.0};
      vectorised.complete(rhs.data(), rate, open.data());
      const Eigen::Index z = model.layout.rollers;
      Eigen::VectorXd one(model.layout.size()), other(one);
      vectorised.flatten(closed.data(), one);
      vectorised.flatten(open.data(), other);
      for (int group = 0; group < 5; ++group)
        EXPECT_LT((one - other).segment(group * z, z).norm(), 1e-9 * one.segment(group * z, z).norm())
            << name_of(set) << ", group " << group;
      const Eigen::Index rings = model.layout.size() - model.layout.cage();
      EXPECT_LT((one - other).tail(rings).norm(), 1e-9 * one.tail(rings).norm()) << name_of(set);
    }
  }
}

// Effects of a stage on the bearing, and of the bearing on the bore, when the bore's velocity or rotation has
// a rate: against differences of the right-hand side along the same motion. Left out are a land that rotates
// with the bore, waves that rotate and neighbours.
class PortOfBore : public OpenBore {};

TEST_P(PortOfBore, AnswersToRatesAsTheRightHandSideDoes) {
  constexpr double kOfDifferences = 1e-4;  // [-]
  const BearingModel model = bearing_model(bearing, point, parameters);
  const bool land = model.layout.caged && !GetParam().inner_guidance;
  VectorBearing vectorised(model);
  const PaddedLayout& layout = vectorised.layout();
  int kinked = 0, compared = 0;
  for (int i = 0; i < kStates; ++i) {
    const double g = i % 2 == 0 ? 1e-6 : 5e-6;
    const Eigen::VectorXd flat = shaken(model, i);
    BoreMotion motion = random_motion(model, flat);
    motion.acceleration = {0.0, 0.0};
    const std::vector<double> x = vectorised.padded(flat), nothing(x.size(), 0.0);
    std::vector<double> rates(x.size());
    for (int which = 0; which < 3; ++which) {
      vectorised.linearise(motion, x.data(), rates.data());
      PortMatrix port;
      ASSERT_TRUE(vectorised.factor_open(g, true, port));
      double force[3], rate[3] = {};
      rate[which] = which < 2 ? 1e3 : 1e5;  // [m/s^2], [rad/s^2]
      std::vector<double> k(x.size());
      vectorised.reduce(nothing.data(), k.data(), force);
      for (const double each : force) ASSERT_EQ(each, 0.0);
      vectorised.complete(nothing.data(), rate, k.data());
      struct Slope {
        Eigen::VectorXd rates;
        Eigen::Vector3d reaction;
      };
      const auto difference = [&](double by) {
        Slope slope{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(x.size())), Eigen::Vector3d::Zero()};
        for (const double side : {1.0, -1.0}) {
          std::vector<double> moved = x;
          for (std::size_t n = 0; n < x.size(); ++n) moved[n] += side * by * k[n];
          BoreMotion turned = motion;
          turned.speed += side * by * rate[2];
          vectorised.derivative(turned, moved.data(), rates.data());
          slope.rates += side / (2.0 * by) * Eigen::Map<Eigen::VectorXd>(rates.data(), slope.rates.size());
          const BoreReaction on_bore = vectorised.reaction();
          slope.reaction +=
              side / (2.0 * by) * Eigen::Vector3d(on_bore.force.x(), on_bore.force.y(), on_bore.moment);
        }
        return slope;
      };
      const double step = 1e-8;  // [s]
      const Slope narrow = difference(step);
      const Slope wide = difference(2.0 * step);
      for (int group = 2; group < 5; ++group) {
        const auto part = [&](const Eigen::VectorXd& of) {
          return of.segment(group * layout.lanes(), layout.rollers);
        };
        const Eigen::VectorXd stage = Eigen::Map<const Eigen::VectorXd>(k.data(), narrow.rates.size());
        ++compared;
        if ((part(narrow.rates) - part(wide.rates)).norm() > 1e-5 * part(narrow.rates).norm()) {
          ++kinked;
          continue;
        }
        EXPECT_LT((part(stage) - g * part(narrow.rates)).norm(),
                  kOfDifferences * (g * part(narrow.rates)).norm())
            << "rate " << which << ", group " << group << ", state " << i;
      }
      if ((narrow.reaction - wide.reaction).norm() > 1e-5 * narrow.reaction.norm()) continue;
      const double radius = model.geometry.outer_radius;
      for (int row = 0; row < 3; ++row) {
        if ((row == 2 || which == 2) && land) continue;
        const double found = -port.a[row][which] * rate[which], scale = row < 2 ? 1.0 : radius;
        EXPECT_NEAR(found, g * narrow.reaction[row],
                    kOfDifferences * scale * (g * narrow.reaction.head<2>()).norm() +
                        kOfDifferences * std::abs(g * narrow.reaction[row]))
            << "rate " << which << ", row " << row << ", state " << i;
      }
    }
  }
  EXPECT_LT(kinked, compared / 2);
}

TEST_P(OpenBore, SlopesAreThoseOfTheForce) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  int kinked = 0, compared = 0;
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    VectorBearing vectorised(model, set);
    for (int i = 0; i < kStates; ++i) {
      const Eigen::VectorXd x = shaken(model, i);
      const BoreMotion motion = random_motion(model, x);
      const std::vector<double> padded = vectorised.padded(x);
      std::vector<double> rate(padded.size());
      vectorised.linearise(motion, padded.data(), rate.data());
      const BoreSlopes slopes = vectorised.bore_slopes();
      const auto compare = [&](auto move, double step, const double(&found)[2][2]) {
        for (int k = 0; k < 2; ++k) {
          const auto difference = [&](double by) -> Eigen::Vector2d {
            BoreMotion less = motion, more = motion;
            move(less)[k] -= by;
            move(more)[k] += by;
            const auto force = [&](const BoreMotion& there) {
              return driven_snapshot(model, there, x).on_bore.force;
            };
            return (force(more) - force(less)) / (2.0 * by);
          };
          const Eigen::Vector2d narrow = difference(step), wide = difference(2.0 * step);
          ++compared;
          if ((narrow - wide).norm() > 1e-5 * narrow.norm()) {
            ++kinked;
            continue;
          }
          const Eigen::Vector2d slope = (4.0 * narrow - wide) / 3.0;
          EXPECT_LT((slope - Eigen::Vector2d(found[0][k], found[1][k])).norm(), 2e-6 * slope.norm());
        }
      };
      compare([](BoreMotion& m) -> Eigen::Vector2d& { return m.position; }, 2e-10, slopes.by_position);
      compare([](BoreMotion& m) -> Eigen::Vector2d& { return m.velocity; }, 2e-6, slopes.by_velocity);
    }
  }
  EXPECT_LT(kinked, compared / 3);
}

INSTANTIATE_TEST_SUITE_P(Variants, PortOfBore,
                         testing::Values(Variant{"dry", false, false, false},
                                         Variant{"film", true, false, false},
                                         Variant{"inner_guidance", true, true, false}),
                         [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

INSTANTIATE_TEST_SUITE_P(Variants, OpenBore,
                         testing::Values(Variant{"dry", false, false, false},
                                         Variant{"film", true, false, false},
                                         Variant{"inner_guidance", true, true, false},
                                         Variant{"rough", true, false, true},
                                         // Rollers that touch one another
                                         Variant{"full_complement", true, false, true, true}),
                         [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

}  // namespace
}  // namespace orbearing::bearing::vectorised::driven_bore_test

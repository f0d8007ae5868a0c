// The linear law fitted to a bearing's motion: planted laws come back.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "coupling/analysis/one_way.hpp"

namespace orbearing::analysis {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using gearset::dynamics::AffineBearing;
using system::BoreSample;

constexpr double kMeshFrequency = 16000.0;  // [rad/s]
constexpr int kBoreSamples = 20000;
constexpr double kBoreInterval = 7e-7;  // [s]  no divisor of the period: some 36 of them in all, and a bit

AffineBearing planted_law() {
  AffineBearing law{.force = {120.0, -40.0}};
  law.stiffness << 2.1e8, 1.2e7, -0.4e7, 1.9e8;
  law.damping << 300.0, -60.0, 20.0, 420.0;
  return law;
}

// Expected law before the fit.
AffineBearing expected_law() {
  return {.stiffness = 2.3e8 * Matrix2d::Identity(), .damping = 200.0 * Matrix2d::Identity()};
}

// Ellipses of three orders about a mean place, at `time`.
BoreSample bore_orbit(double time) {
  BoreSample sample{.time = time, .weight = kBoreInterval, .position = {4e-6, -2e-6}};
  const double radial[] = {1.0e-6, 1.5e-6, 0.2e-6}, tangential[] = {2.0e-6, 0.3e-6, 0.4e-6};
  for (int order = 1; order <= 3; ++order) {
    const double w = order * kMeshFrequency, angle = w * time + 0.7 * order, a = radial[order - 1],
                 b = tangential[order - 1];
    sample.position += Vector2d(a * std::cos(angle), b * std::sin(angle + 0.3));
    sample.velocity += w * Vector2d(-a * std::sin(angle), b * std::cos(angle + 0.3));
  }
  return sample;
}

Vector2d law_force(const AffineBearing& law, const BoreSample& at) {
  return law.force - law.stiffness * at.position - law.damping * at.velocity;
}

TEST(AffineFit, ReturnsALinearBearingToRoundOff) {
  AffineFit fit(kMeshFrequency, 3);
  for (int i = 0; i < kBoreSamples; ++i) {
    BoreSample sample = bore_orbit(i * kBoreInterval);
    sample.force = law_force(planted_law(), sample);
    fit.add(sample);
  }
  const FittedBearing found = fit.law(expected_law(), expected_law());
  const double round_off = 1e-9;  // forces of 1e3 N over sums of 2e4 of them, orbits that are half a line
  EXPECT_LT((found.bearing.stiffness - planted_law().stiffness).norm(),
            round_off * planted_law().stiffness.norm());
  EXPECT_LT((found.bearing.damping - planted_law().damping).norm(), round_off * planted_law().damping.norm());
  EXPECT_LT((found.bearing.force - planted_law().force).norm(), 1e-7 * planted_law().force.norm());
  EXPECT_LT(found.residual, round_off);
  EXPECT_LT(fit.law(expected_law(), planted_law()).stiffness_change, round_off);
  EXPECT_LT(fit.law(expected_law(), planted_law()).damping_change, round_off);
  AffineBearing stiffer = planted_law();
  stiffer.stiffness *= 1.02;
  EXPECT_NEAR(fit.law(expected_law(), stiffer).stiffness_change, 0.02, round_off);
  // Each change is that of its own law.
  EXPECT_LT(fit.law(expected_law(), stiffer).damping_change, round_off);
  AffineBearing damped = planted_law();
  damped.damping *= 1.05;
  EXPECT_NEAR(fit.law(expected_law(), damped).damping_change, 0.05, round_off);
  EXPECT_LT(fit.law(expected_law(), damped).stiffness_change, round_off);
}

// Rollers add forces of their own, to which the bore's mass responds with motion out of all proportion to the
// law; a fit of forces over motion, sample by sample, finds something between the law and that mass.
TEST(AffineFit, DoesNotTakeTheBoresMassForTheBearing) {
  const double mass = 0.04, own = 0.37 * kMeshFrequency, shake = 60.0;  // [kg], [rad/s], [N]
  const AffineBearing law = planted_law();
  AffineFit fit(kMeshFrequency, 3);
  Eigen::Matrix2d over = Matrix2d::Zero(), square = Matrix2d::Zero();
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 5.0);  // [N]
  for (int i = 0; i < kBoreSamples; ++i) {
    const double time = i * kBoreInterval;
    BoreSample sample = bore_orbit(time);
    // (stiffness - mass w^2) x = shake, damping aside
    const Matrix2d dynamic = law.stiffness - mass * own * own * Matrix2d::Identity();
    const Vector2d way = dynamic.inverse() * Vector2d(shake, 2.0 * shake);
    sample.position += way * std::cos(own * time);
    sample.velocity -= own * way * std::sin(own * time);
    sample.force = law_force(law, sample) + std::cos(own * time) * Vector2d(shake, 2.0 * shake) +
                   Vector2d(noise(engine), noise(engine));
    fit.add(sample);
    const Vector2d moved = sample.position - Vector2d(4e-6, -2e-6);
    over -= sample.force * moved.transpose();
    square += moved * moved.transpose();
  }
  const FittedBearing found = fit.law(expected_law(), expected_law());
  // Noise of 5 N over 2e4 samples leaves 0.05 N of harmonics of some 400 N; the shaking's leakage into the
  // orders over 36 periods is its share of 120 N over 36 pi.
  const double left = 5e-3;
  EXPECT_LT((found.bearing.stiffness - law.stiffness).norm(), left * law.stiffness.norm());
  // The same force is so much damping at the least of the frequencies.
  EXPECT_LT((found.bearing.damping - law.damping).norm(), left * law.stiffness.norm() / kMeshFrequency);
  EXPECT_GT((over * square.inverse() - law.stiffness).norm(), 4.0 * left * law.stiffness.norm());
}

// Motion along a line gives no information on forces under motion across it: the expected law remains.
TEST(AffineFit, KeepsWhatIsExpectedWhereNothingMoves) {
  AffineFit fit(kMeshFrequency, 1);
  const AffineBearing law = planted_law();
  for (int i = 0; i < kBoreSamples; ++i) {
    const double time = i * kBoreInterval;
    BoreSample sample{.time = time,
                      .weight = kBoreInterval,
                      .position = {1e-6 * std::cos(kMeshFrequency * time), 0.0},
                      .velocity = {-1e-6 * kMeshFrequency * std::sin(kMeshFrequency * time), 0.0}};
    sample.force = law_force(law, sample);
    fit.add(sample);
  }
  const FittedBearing found = fit.law(expected_law(), expected_law());
  EXPECT_LT((found.bearing.stiffness.col(0) - law.stiffness.col(0)).norm(), 1e-6 * law.stiffness.norm());
  EXPECT_LT((found.bearing.stiffness.col(1) - expected_law().stiffness.col(1)).norm(),
            1e-6 * law.stiffness.norm());
  EXPECT_LT((found.bearing.damping.col(1) - expected_law().damping.col(1)).norm(), 1e-6 * law.damping.norm());
}

// A bore that swings by `a` [m] along one axis, under `law`.
void swing(AffineFit& fit, const AffineBearing& law, const Vector2d& a) {
  for (int i = 0; i < kBoreSamples; ++i) {
    const double angle = kMeshFrequency * i * kBoreInterval;
    BoreSample sample{.time = i * kBoreInterval,
                      .weight = kBoreInterval,
                      .position = std::cos(angle) * a,
                      .velocity = -kMeshFrequency * std::sin(angle) * a};
    sample.force = law_force(law, sample);
    fit.add(sample);
  }
}

// Two motions together give what neither shows: fewer runs are sufficient.
TEST(AffineFit, KnowsFromTwoMotionsWhatNoneOfThemShows) {
  AffineFit fit(kMeshFrequency, 1);
  const AffineBearing law = planted_law();
  swing(fit, law, {1e-6, 0.0});
  fit.begin_motion();
  swing(fit, law, {0.0, 2e-6});
  const FittedBearing found = fit.law(expected_law(), law);
  EXPECT_LT((found.bearing.stiffness - law.stiffness).norm(), 1e-6 * law.stiffness.norm());
  EXPECT_LT((found.bearing.damping - law.damping).norm(), 1e-6 * law.damping.norm());
  EXPECT_LT(found.residual, 1e-6);
}

// Two motions under laws that differ by a tenth: the law lies between, two thirds of the way to the last,
// which alone gives the change.
TEST(AffineFit, CountsTheChangeOfTheLastMotionAlone) {
  AffineFit fit(kMeshFrequency, 1);
  AffineBearing before = planted_law(), after = before;
  after.stiffness *= 1.1;
  after.damping *= 1.1;
  swing(fit, before, {1e-6, 1e-6});
  fit.begin_motion();
  swing(fit, after, {1e-6, 1e-6});
  const FittedBearing found = fit.law(before, before);
  const Vector2d along(1.0, 1.0);
  EXPECT_NEAR((found.bearing.stiffness * along).norm() / (before.stiffness * along).norm(), 1.0 + 0.2 / 3.0,
              1e-3);
  EXPECT_NEAR(found.stiffness_change, 0.1 / 1.1, 1e-3);
  EXPECT_NEAR(found.damping_change, 0.1 / 1.1, 1e-3);
}

TEST(AffineFit, HasNoDampersThatGiveEnergy) {
  AffineFit fit(kMeshFrequency, 1);
  AffineBearing law = planted_law();
  law.damping << 300.0, 80.0, 20.0, -90.0;
  swing(fit, law, {1e-6, 0.0});
  fit.begin_motion();
  swing(fit, law, {0.0, 1e-6});
  const Matrix2d found = fit.law(expected_law(), law).bearing.damping;
  const Matrix2d even = 0.5 * (found + found.transpose()),
                 planted = 0.5 * (law.damping + law.damping.transpose());
  EXPECT_NEAR(even.determinant() / even.squaredNorm(), 0.0, 1e-6);
  EXPECT_GT(even.trace(), 0.0);
  EXPECT_NEAR(found(0, 1) - found(1, 0), law.damping(0, 1) - law.damping(1, 0), 1e-3);  // does no work
  // By Mohr's circle the nearest is off by the eigenvalue that is negative, no more.
  const double negative =
      0.5 * planted.trace() - std::hypot(0.5 * (planted(0, 0) - planted(1, 1)), planted(0, 1));
  ASSERT_LT(negative, 0.0);
  EXPECT_NEAR((even - planted).norm(), -negative, 1e-3);
}

}  // namespace
}  // namespace orbearing::analysis

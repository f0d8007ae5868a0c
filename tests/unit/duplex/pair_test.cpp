// A pair's stiffness is the slope of its equilibrium; its limits by arrangement and preload.
#include "bearing/duplex/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/duplex/shaft.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::duplex::pair_test {
namespace {

constexpr double kDegree = 0.017453292519943295;

Bearing angular_contact(double degrees) {
  Bearing bearing{.elements = Balls{.count = 20, .diameter = 14.288e-3, .contact_angle = degrees * kDegree},
                  .pitch_diameter = 125.25e-3};
  bearing.inner.osculation = bearing.outer.osculation = 0.525;
  return bearing;
}

Pair preloaded(Arrangement arrangement, double preload, double degrees = 15.0) {
  Pair pair{.bearing = angular_contact(degrees), .arrangement = arrangement, .levers = {29e-3, 24e-3}};
  pair.approach = approach_under(pair.bearing, preload);
  return pair;
}

constexpr Arrangement kAll[] = {Arrangement::face_to_face, Arrangement::back_to_back, Arrangement::tandem};

// Forces on the shaft where it has moved by `change`, tilts as angles.
Eigen::Vector<double, 5> force_at(const Pair& pair, const PairState& state,
                                  const Eigen::Vector<double, 5>& change) {
  Pair placed = pair;
  if (pair.arrangement == Arrangement::tandem) placed.approach = 0.0;
  const equilibrium::RowGroup row(rows_of(placed));
  const Eigen::Vector<double, 5> arms(1.0, 1.0, 1.0, row.lever(), row.lever());
  const equilibrium::RingPosition position =
      equilibrium::position_of(state.ring, row.lever()) + arms.asDiagonal() * change;
  return arms.asDiagonal() * equilibrium::row_forces(row, position).force;
}

TEST(DuplexPair, EveryEntryOfTheStiffnessIsASlopeOfTheForces) {
  constexpr double tolerance = 1e-6;  // of the geometric mean of both diagonals; truncation is step^2
  for (const Arrangement arrangement : kAll) {
    const Pair pair = preloaded(arrangement, 1270.0);
    const PairState state = balance_pair(pair, {.radial = 300.0, .axial = 200.0, .moment = 3.0});
    ASSERT_TRUE(state.ring.report.converged);
    const Stiffness& k = state.ring.stiffness;
    for (int j = 0; j < 5; ++j) {
      const double step = j < 3 ? 2e-9 : 4e-8;
      const Eigen::Vector<double, 5> change = Eigen::Vector<double, 5>::Unit(j) * step;
      const Eigen::Vector<double, 5> slope =
          (force_at(pair, state, -change) - force_at(pair, state, change)) / (2.0 * step);
      for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(slope[i], k(i, j), tolerance * std::sqrt(k(i, i) * k(j, j)))
            << i << " " << j << " arrangement " << static_cast<int>(arrangement);
    }
  }
}

// Reciprocity: a displacement by a force elsewhere is the same the other way round.
TEST(DuplexPair, StiffnessIsSymmetric) {
  for (const Arrangement arrangement : kAll) {
    const Stiffness k =
        balance_pair(preloaded(arrangement, 540.0), {.radial = 200.0, .moment_across = 2.0}).ring.stiffness;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) EXPECT_NEAR(k(i, j), k(j, i), 1e-12 * std::sqrt(k(i, i) * k(j, j)));
  }
}

TEST(DuplexPair, StiffnessFollowsFromItsRowsForAnyLevers) {
  for (const Arrangement arrangement : kAll) {
    Pair pair = preloaded(arrangement, 540.0);
    const PairState one = balance_pair(pair);
    pair.levers = {41e-3, 12e-3};
    const PairState other = balance_pair(pair);
    EXPECT_TRUE(pair_stiffness(one.rows, arrangement, pair.levers).isApprox(other.ring.stiffness, 1e-9));
  }
}

TEST(DuplexPair, BackToBackIsStifferInTilt) {
  const Stiffness back = balance_pair(preloaded(Arrangement::back_to_back, 1270.0)).ring.stiffness;
  const Stiffness face = balance_pair(preloaded(Arrangement::face_to_face, 1270.0)).ring.stiffness;
  EXPECT_GT(back(3, 3), 5.0 * face(3, 3));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(back(i, i), face(i, i), 1e-9 * face(i, i));
}

TEST(DuplexPair, PreloadPressesEachRow) {
  constexpr double preload = 2550.0;
  for (const Arrangement arrangement : kAll) {
    const PairState state = balance_pair(preloaded(arrangement, preload));
    for (const int first : {0, 20}) {
      double along = 0.0;
      for (int j = first; j < first + 20; ++j)
        along += state.ring.contact_load[j] * std::sin(state.ring.contact_angle[j]);
      EXPECT_NEAR(along, preload, 1e-6 * preload);
    }
  }
}

TEST(DuplexPair, ContactAngleGrowsWithPreload) {
  double before = 15.0 * kDegree;
  for (const double preload : {540.0, 1270.0, 2550.0}) {
    const double angle = balance_pair(preloaded(Arrangement::face_to_face, preload)).ring.contact_angle[0];
    EXPECT_GT(angle, before + 0.3 * kDegree);
    before = angle;
  }
}

// Both rows of a tandem share what one would bear alone, at the same displacement.
TEST(DuplexPair, TandemCarriesTwice) {
  constexpr double load = 3000.0;
  Pair tandem = preloaded(Arrangement::tandem, 0.0);
  const PairState state = balance_pair(tandem, {.axial = 2.0 * load});
  EXPECT_NEAR(state.ring.axial, approach_under(tandem.bearing, load), 1e-12);
}

// Rows pressed against each other give way less than one row does, and not at all in the first place.
TEST(DuplexPair, PreloadStiffens) {
  const PairState light = balance_pair(preloaded(Arrangement::face_to_face, 540.0), {.axial = 300.0});
  const PairState heavy = balance_pair(preloaded(Arrangement::face_to_face, 2550.0), {.axial = 300.0});
  EXPECT_LT(heavy.ring.axial, light.ring.axial);
  EXPECT_GT(heavy.ring.axial, 0.0);
}

// Hertz: normal stiffness is proportional to the cube root of the load, so all stiffness depends on the
// preload.
TEST(DuplexPair, StiffnessVanishesWithThePreload) {
  const Stiffness none = balance_pair(preloaded(Arrangement::face_to_face, 0.0)).ring.stiffness;
  EXPECT_NEAR(none.norm(), 0.0, 1e-6);
  const double little = balance_pair(preloaded(Arrangement::face_to_face, 1e-3)).ring.stiffness(0, 0);
  const double less = balance_pair(preloaded(Arrangement::face_to_face, 1e-6)).ring.stiffness(0, 0);
  EXPECT_NEAR(little / less, 10.0, 0.01);
}

TEST(DuplexPair, ANegativePreloadIsRefused) {
  EXPECT_REFUSED(std::invalid_argument, "pair 1", approach_under(angular_contact(15.0), -1.0));
}

// Closed sums over evenly spaced balls: cos^2 and sin^2 make Z/2 each.
TEST(LinearPair, MeetsItsClosedFormulas) {
  const Bearing bearing = angular_contact(30.0);
  const PressedRow row = pressed_row(bearing, approach_under(bearing, 2750.0));
  const double first = 15e-3, second = 17e-3, s = std::sin(row.angle), c = std::cos(row.angle);
  const Stiffness k = linear_stiffness(row, {first, second});
  const double z = 20.0, n = row.normal_stiffness, r = row.groove_circle;
  const double e_1 = r * s - first * c, e_2 = r * s + second * c;
  constexpr double round_off = 1e-12;
  EXPECT_NEAR(k(0, 0), z * n * c * c, round_off * k(0, 0));
  EXPECT_NEAR(k(2, 2), 2.0 * z * n * s * s, round_off * k(2, 2));
  EXPECT_NEAR(k(3, 3), 0.5 * z * n * (e_1 * e_1 + e_2 * e_2), round_off * k(3, 3));
  EXPECT_NEAR(k(4, 4), k(3, 3), round_off * k(3, 3));
  EXPECT_NEAR(k(0, 3), 0.5 * z * n * c * (e_1 + e_2), round_off * k(0, 0));
  EXPECT_NEAR(k(0, 1), 0.0, round_off * k(0, 0));
  EXPECT_NEAR(r, 0.5 * 125.25e-3 + 0.025 * 14.288e-3 * std::cos(30.0 * kDegree), 1e-12);
  EXPECT_NEAR(20.0 * row.load * s, 2750.0, 1e-6 * 2750.0);
}

// As printed, both rows approach with one sign: the stiffness of a tandem without its geometric part.
TEST(LinearPair, IsATandemWithoutItsGeometricStiffness) {
  Pair pair = preloaded(Arrangement::tandem, 1270.0);
  const PressedRow row = pressed_row(pair.bearing, pair.approach);
  const Stiffness whole = balance_pair(pair).ring.stiffness, linear = linear_stiffness(row, pair.levers);
  const double approach = 1.5 * row.load / row.normal_stiffness;  // Q = c delta^1.5, K = 1.5 c delta^0.5
  const double length = 0.05 * 14.288e-3 + approach;              // of groove centres
  const double s = std::sin(row.angle);
  EXPECT_NEAR(whole(0, 0) - linear(0, 0), 20.0 * row.load / length * s * s, 1e-6 * whole(0, 0));
}

}  // namespace
}  // namespace orbearing::bearing::duplex::pair_test

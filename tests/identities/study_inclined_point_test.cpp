// Planets on rows of inclined rollers in a point of the drivetrain: by the half turn that maps one row onto
// the other, and by the load that both rows of a barrel bearing share.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/analysis/operating_point.hpp"
#include "mechanics/constants.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_inclined_point_test {
namespace {

using constants::degree;

constexpr double kTwoSearches =
    1e-6;  // relative: both rows end within 1e-9 of the force, lives go with p = 4

// Without shifts both meshes push radially by equal forces: the load on the bearings is tangential, along y,
// and so is the axis of the moment of helical teeth. Nothing else acts.
PlanetaryDrivetrain inclined_reducer(double helix) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.set.ring_teeth = 81;
  drivetrain.set.sun_shift = drivetrain.set.ring_shift = 0.0;
  drivetrain.set.helix_angle = helix;
  drivetrain.dynamics.inertia = {
      .own_orbit = false, .coriolis = false, .carrier_centrifugal = false, .euler = false};
  drivetrain.cage_positions = 4;
  return drivetrain;
}

PlanetaryDrivetrain on_tapered_pair() {
  PlanetaryDrivetrain drivetrain = inclined_reducer(20.0 * degree);
  drivetrain.bearing.rollers().laminae = 20;
  drivetrain.rows = {.type = bearing::PlanetBearingType::tapered_roller,
                     .contact_angle = 15.0 * degree,
                     .distance = 14e-3,
                     .preload = 300.0};
  return drivetrain;
}

// Half a turn about the load's direction maps each row onto the other, end for end. Both have equal lives,
// and so do all rollers taken together as those of one row, if their laminae are numbered from the same end.
TEST(InclinedPoint, BothRowsOfAPairAreOneAfterHalfATurn) {
  const PlanetaryDrivetrain drivetrain = on_tapered_pair();
  const PointResult found = evaluate(drivetrain, derive(drivetrain));
  ASSERT_LT(std::abs(found.radial_mesh_load), 1e-9 * found.tangential_load);
  ASSERT_GT(std::abs(found.overturning_moment), 1.0);
  ASSERT_EQ(found.seats.size(), 2u);
  const SeatResult &first = found.seats[0], &second = found.seats[1];
  EXPECT_NEAR(first.load / second.load, 1.0, kTwoSearches);
  EXPECT_NEAR(first.axial_load / second.axial_load, 1.0, kTwoSearches);
  EXPECT_NEAR(first.life_hours / second.life_hours, 1.0, kTwoSearches);
  EXPECT_NEAR(found.life_hours / first.life_hours, 1.0, kTwoSearches);
  for (double bearing::rating::RatedHours::*life : bearing::rating::kRatedHours) {
    if (std::isnan(first.rated_hours.*life)) continue;
    EXPECT_NEAR(second.rated_hours.*life / (first.rated_hours.*life), 1.0, kTwoSearches);
    EXPECT_NEAR(found.rating.hours.*life / (first.rated_hours.*life), 1.0, kTwoSearches);
  }
  // There is a difference: the moment loads the ends of the rollers unequally.
  ASSERT_TRUE(found.laminae.has_value());
  const Eigen::Map<const Eigen::ArrayXXd> loads(found.laminae->outer_load.data(), 20,
                                                static_cast<Eigen::Index>(found.distribution.angle.size()));
  EXPECT_GT(std::abs(loads.row(19).maxCoeff() / loads.row(0).maxCoeff() - 1.0), 0.1);
}

// Rows of a barrel bearing push against each other along the axis: under a radial load nothing is left, and
// the equivalent load is that load. Each row for itself pushes.
TEST(InclinedPoint, RowsOfABarrelBearingHoldTheirAxialLoads) {
  PlanetaryDrivetrain drivetrain = inclined_reducer(0.0);
  drivetrain.bearings_per_planet = 1;
  drivetrain.rows = {.type = bearing::PlanetBearingType::spherical_roller, .contact_angle = 10.0 * degree};
  const PointResult found = evaluate(drivetrain, derive(drivetrain));
  ASSERT_EQ(found.seats.size(), 1u);
  EXPECT_LT(found.seats[0].axial_load, kTwoSearches * found.seats[0].load);
  EXPECT_NEAR(found.rating.lives.dynamic_load / found.tangential_load, 1.0, kTwoSearches);
  PlanetaryDrivetrain pair = on_tapered_pair();
  pair.set.helix_angle = 0.0;
  pair.bearing.rollers().laminae = 0;
  pair.rows.preload = 0.0;
  // Half of the rollers carry: 1.26 F_r tan(alpha) of each row [NSKE728]; of fifteen rollers a little more or
  // less.
  const SeatResult row = evaluate(pair, derive(pair)).seats.at(0);
  EXPECT_NEAR(row.axial_load / (row.load * std::tan(15.0 * degree)), 1.26, 0.03);
}

}  // namespace
}  // namespace orbearing::analysis::study_inclined_point_test

#include "bearing/equilibrium/quasi_static.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "bearing/contact/line_contact.hpp"
#include "tests/messages.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::quasi_static_test {
namespace {

using example_bearings::bearing_209;
using example_bearings::planet_bearing;
using example_bearings::planet_motion;
using example_bearings::rpm;
using example_bearings::static_load;

constexpr double kSolved = 1e-9;          // of the load: the solver accepts no more than this
constexpr double kPublishedCosine = 0.005;  // the limit of the sun side is printed as -0.23

QuasiStaticOptions options() {
  return {};
}

TEST(QuasiStaticState, OneRollerUnderTheLoadCarriesItAll) {
  Bearing bearing = bearing_209();
  bearing.radial_clearance = 1e-3;
  // The ring moves along the load, so that the roller opposite to it is squeezed.
  const QuasiStaticState state = quasi_static_state(bearing, static_load(-100.0), options(), 0.0);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  EXPECT_NEAR(state.outer_load[0], 100.0, 100.0 * kSolved);
  EXPECT_EQ(state.outer_load.tail(13).maxCoeff(), 0.0);
  const double approach =
      2.0 * roller_race_contact(bearing.contact_law, bearing.rollers().length).approach(100.0);
  EXPECT_NEAR(state.displacement.x(), -(0.5e-3 + approach), 1e-3 * kSolved);
}

TEST(QuasiStaticState, InterferenceAloneLoadsAllRollersAlike) {
  Bearing bearing = bearing_209();
  bearing.radial_clearance = -20e-6;
  const QuasiStaticState state = quasi_static_state(bearing, static_load(0.0), options(), 0.1);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  // 10 um on the radius, shared by two contacts.
  const double load = roller_race_contact(bearing.contact_law, bearing.rollers().length).load(5e-6);
  for (Eigen::Index j = 0; j < 14; ++j) EXPECT_NEAR(state.outer_load[j], load, load * kSolved);
}

TEST(QuasiStaticState, InterferenceKeepsAllRollersLoadedUnderASmallLoad) {
  Bearing bearing = bearing_209();
  bearing.radial_clearance = -20e-6;
  const QuasiStaticState state = quasi_static_state(bearing, static_load(1000.0), options(), 0.0);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  EXPECT_GT(state.outer_load.minCoeff(), 0.0);
  EXPECT_GT(state.outer_load[7], state.outer_load[0]);
}

TEST(QuasiStaticState, NothingActsOnAnUnloadedBearingAtRest) {
  Bearing bearing = bearing_209();
  for (const double clearance : {0.0, 40e-6}) {
    bearing.radial_clearance = clearance;
    const QuasiStaticState state = quasi_static_state(bearing, static_load(0.0), options(), 0.0);
    EXPECT_TRUE(state.report.converged) << state.report.message;
    EXPECT_EQ(state.outer_load.maxCoeff(), 0.0);
    EXPECT_EQ(state.inner_load.maxCoeff(), 0.0);
  }
}

// Unloaded rollers of the planet bearing at 6000 rpm: r (theta' + Omega)^2 + Omega^2 r_c cos theta changes
// its sign at cos theta = -0.23. Without the Coriolis term r (theta'^2 + Omega^2) exceeds Omega^2 r_c
// everywhere.
TEST(QuasiStaticState, RollersOnTheSunSideRestOnThePinOnlyByCoriolis) {
  Bearing bearing = planet_bearing();
  bearing.radial_clearance = 1e-3;  // nearly all rollers are unloaded
  OperatingPoint point = planet_motion(rpm(6000.0));
  point.bore_load = {0.0, 1000.0};
  for (double first = 0.0; first < 0.42; first += 0.01) {
    for (const bool coriolis : {true, false}) {
      QuasiStaticOptions choice = options();
      choice.inertia.coriolis = coriolis;
      const QuasiStaticState state = quasi_static_state(bearing, point, choice, first);
      ASSERT_TRUE(state.report.converged) << state.report.message;
      for (Eigen::Index j = 0; j < 15; ++j) {
        const bool squeezed = state.inner_load[j] > 0.0 && state.outer_load[j] > 0.0;
        const double cosine = std::cos(state.angle[j]);
        if (squeezed || std::abs(cosine + 0.23) < kPublishedCosine) continue;
        EXPECT_EQ(state.inner_load[j] > 0.0, coriolis && cosine < -0.23) << "cos theta " << cosine;
      }
    }
  }
}

TEST(QuasiStaticBearing, GathersCageAnglesByPosition) {
  const Bearing bearing = planet_bearing();
  QuasiStaticOptions choice = options();
  choice.cage_positions = 3;
  choice.first_roller = 0.05;
  const QuasiStaticResult all = quasi_static_bearing(bearing, static_load(2000.0, 1.0), choice);
  ASSERT_EQ(all.angle.size(), 45);
  const QuasiStaticState second = quasi_static_state(bearing, static_load(2000.0, 1.0), choice, all.angle[1]);
  for (Eigen::Index roller = 0; roller < 15; ++roller) {
    EXPECT_NEAR(all.angle[1 + 3 * roller], second.angle[roller], 1e-14);
    EXPECT_EQ(all.outer_load[1 + 3 * roller], second.outer_load[roller]);
    EXPECT_EQ(all.inner_load[1 + 3 * roller], second.inner_load[roller]);
  }
  EXPECT_TRUE(all.report.converged);
}

TEST(QuasiStaticBearing, CageAndHalfTheRollersHangOnTheRingThatGuidesThem) {
  Bearing bearing = planet_bearing();
  OperatingPoint point = planet_motion(rpm(6000.0));
  point.bore_load = {100.0, 1000.0};
  const BearingGeometry geometry = geometry_of(bearing);
  const double thrown = (geometry.cage_mass + 7.5 * geometry.element_mass) * point.carrier.speed *
                        point.carrier.speed * point.carrier.orbit_radius;
  const QuasiStaticResult outside = quasi_static_bearing(bearing, point, options());
  EXPECT_NEAR(outside.total_bore_load.x(), 100.0 + thrown, 1e-10);
  EXPECT_NEAR(outside.total_bore_load.y(), 1000.0, 1e-10);
  bearing.cage.guidance = Race::inner;
  EXPECT_EQ(quasi_static_bearing(bearing, point, options()).total_bore_load, point.bore_load);
}

TEST(QuasiStaticState, SaysWhyWhereItFindsNoBalance) {
  Bearing bearing = bearing_209();
  bearing.radial_clearance = std::numeric_limits<double>::quiet_NaN();
  const QuasiStaticState state = quasi_static_state(bearing, static_load(1000.0), options(), 0.0);
  EXPECT_FALSE(state.report.converged);
  EXPECT_SAID("races without balance", state.report.message);
}

TEST(QuasiStaticBearing, RefusesWhatIsNotFinite) {
  const Bearing bearing = planet_bearing();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    OperatingPoint point = static_load(1000.0);
    const auto run = [&] { quasi_static_bearing(bearing, point, options()); };
    for (double* value :
         {&point.bore_load.x(), &point.bore_load.y(), &point.carrier.speed, &point.carrier.acceleration,
          &point.carrier.orbit_radius, &point.inner_speed, &point.outer_speed}) {
      const double kept = *value;
      *value = bad;
      EXPECT_REFUSED(std::invalid_argument, "operating point", run());
      *value = kept;
    }
    EXPECT_NO_THROW(run());
  }
}

}  // namespace
}  // namespace orbearing::bearing::quasi_static_test

// Quasi-static points of a case that states the bearings of its carrier: lives of the bearings over a
// revolution are those of the plane where nothing deflects or tilts, and hold on finer steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/life/rating_record.hpp"

namespace orbearing::app::carrier_point_test {
namespace {

using analysis::BearingOverRevolution;
using analysis::CarrierRevolution;

const std::vector<std::string> kHeld{"gearset.carrier.bearing_positions=[-60 mm, 60 mm]",
                                     "gearset.carrier.bearing_stiffness=[5e8 N/m, 5e8 N/m]"};

ResolvedCase case_of(const std::string& name, std::vector<std::string> settings) {
  settings.insert(settings.end(), kHeld.begin(), kHeld.end());
  return read_point(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

CarrierRevolution revolution_of(const ResolvedCase& in, const analysis::RevolutionOptions& options = {}) {
  const analysis::NamedSet set = bearing_sets(in).front();
  return analysis::carrier_revolution(set.drivetrain, set.geometry, options);
}

// Spur gears, no weight, no clearance, no rotor: all bearings carry the loads of the plane model, all the
// time.
TEST(CarrierPoint, LivesOfACentredCarrierAreThoseOfThePlane) {
  for (const bool cut : {false, true}) {
    std::vector<std::string> settings{"gearset.carrier.gravity=0 m/s2"};
    if (cut) settings.emplace_back("bearing.laminae=30");
    const ResolvedCase in = case_of("reducer_150kW", settings);
    const analysis::PointResult point = analysis::evaluate(bearing_sets(in));
    ASSERT_TRUE(point.carrier);
    ASSERT_EQ(point.carrier->bearings.size(), 8u);
    for (const BearingOverRevolution& one : point.carrier->bearings) {
      EXPECT_NEAR(one.largest / point.planet_load, 1.0, 1e-8);
      EXPECT_NEAR(one.least / point.planet_load, 1.0, 1e-8);
      EXPECT_NEAR(one.life_hours / point.life_hours, 1.0, 1e-6);
      EXPECT_NEAR(one.rated_hours.basic / point.rating.hours.basic, 1.0, 1e-6);
      EXPECT_NEAR(one.rated_hours.reference / point.rating.hours.reference, 1.0, 1e-6);
      EXPECT_NEAR(one.static_safety / point.rating.lives.static_safety(), 1.0, 1e-8);
      EXPECT_NEAR(one.static_load / point.rating.lives.static_load, 1.0, 1e-8);
      EXPECT_NEAR(one.largest_pressure / point.contact_pressure, 1.0, 1e-7);
    }
  }
}

// Without weight, bearings on a bending pin share its load as in the plane, whose rollers are nonlinear
// springs: the shortest life within a fifth, the largest load within 6 %. With a separate spring for each
// they would carry equal loads.
TEST(CarrierPoint, BearingsOnAPinThatBendsShareAsInThePlane) {
  for (const int bearings : {3, 4}) {
    const ResolvedCase in = case_of(
        "wind_stage_750kW",
        {"gearset.carrier.gravity=0 m/s2", "gearset.helix_angle=0 deg",
         "gearset.carrier.bearing_clearance=[0 um, 0 um]", "gearset.carrier.rotor_moment=[0 N.m, 0 N.m]",
         "gearset.face_width=400 mm", "bearing.per_planet=" + std::to_string(bearings)});
    const analysis::PointResult point = analysis::evaluate(bearing_sets(in));
    ASSERT_TRUE(point.carrier);
    const auto hours = [](const analysis::SeatResult& seat) { return seat.rated_hours.basic; };
    const double shortest = hours(*std::ranges::min_element(point.seats, {}, hours));
    EXPECT_NEAR(point.carrier->worst().rated_hours.basic / shortest, 1.0, 0.2);
    EXPECT_GT(point.carrier->largest_share(), 1.2);
  }
}

TEST(CarrierPoint, ACaseWithoutBearingsOfTheCarrierHasNone) {
  const ResolvedCase in = read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", {});
  EXPECT_FALSE(analysis::evaluate(bearing_sets(in)).carrier);
  // Nor has one whose planets bend.
  EXPECT_FALSE(bearing_sets(case_of("reducer_150kW", {"gearset.planet_rim=elastic"}))
                   .front()
                   .drivetrain.carrier_mounting);
}

const std::vector<std::string> kSagging{"gearset.carrier.bearing_clearance=[80 um, 80 um]",
                                        "gearset.carrier.rotor_force=[0 N, -2000 N, 0 N]",
                                        "gearset.carrier.rotor_moment=[150 N.m, 0 N.m]"};

// Planets at equal steps require one step; pin errors of zero require the whole revolution.
TEST(CarrierPoint, PlanetsThatAreAlikeMeetTheSameLoadsInTurn) {
  const ResolvedCase in = case_of("reducer_150kW", kSagging);
  const analysis::NamedSet set = bearing_sets(in).front();
  analysis::PlanetaryDrivetrain unlike = set.drivetrain;
  unlike.gear_set = [&] {
    auto bodies = set.drivetrain.gear_set();
    bodies.pin_error = Eigen::Matrix2Xd::Zero(2, bodies.planets);
    return bodies;
  };
  const CarrierRevolution alike = analysis::carrier_revolution(set.drivetrain, set.geometry),
                          each = analysis::carrier_revolution(unlike, set.geometry);
  ASSERT_EQ(alike.load.rows(), each.load.rows());
  EXPECT_GT(alike.load.maxCoeff() / alike.load.minCoeff(), 1.05);
  EXPECT_LT((alike.load - each.load).abs().maxCoeff(), 1e-7 * each.load.maxCoeff());
  for (std::size_t b = 0; b < each.bearings.size(); ++b) {
    EXPECT_EQ(alike.bearings[b].planet, each.bearings[b].planet);
    EXPECT_NEAR(alike.bearings[b].position, each.bearings[b].position, 1e-12);
    EXPECT_NEAR(alike.bearings[b].rated_hours.basic / each.bearings[b].rated_hours.basic, 1.0, 1e-6);
    // Rollers are computed at some angles, at other ones for the unequal planets.
    EXPECT_NEAR(alike.bearings[b].life_hours / each.bearings[b].life_hours, 1.0, 1e-3);
  }
  for (std::size_t m = 0; m < each.meshes.size(); ++m) {
    EXPECT_NEAR(alike.meshes[m].largest / each.meshes[m].largest, 1.0, 1e-7);
    EXPECT_NEAR(alike.meshes[m].mean / each.meshes[m].mean, 1.0, 1e-7);
    EXPECT_NEAR(alike.meshes[m].face_load / each.meshes[m].face_load, 1.0, 1e-7);
  }
  EXPECT_NEAR(alike.mesh_load_factor / each.mesh_load_factor, 1.0, 1e-7);
  EXPECT_NEAR(alike.carrier_bearings[0].largest / each.carrier_bearings[0].largest, 1.0, 1e-6);
}

TEST(CarrierPoint, LivesHoldOnFinerSteps) {
  for (const std::string name : {"reducer_150kW", "wind_stage_750kW"}) {
    const ResolvedCase in =
        name == "reducer_150kW"
            ? case_of(name, kSagging)
            : read_point(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", {"bearing.laminae=10"});
    const CarrierRevolution coarse = revolution_of(in),
                            fine = revolution_of(in, {.angles = 144, .life_step = 3});
    EXPECT_NEAR(coarse.largest_share() / fine.largest_share(), 1.0, 2e-3);
    using One = BearingOverRevolution;
    EXPECT_NEAR(coarse.most_loaded(&One::largest_pressure).largest_pressure /
                    fine.most_loaded(&One::largest_pressure).largest_pressure,
                1.0, 5e-3);
    for (std::size_t b = 0; b < fine.bearings.size(); ++b) {
      EXPECT_NEAR(coarse.bearings[b].rated_hours.basic / fine.bearings[b].rated_hours.basic, 1.0, 5e-3);
      EXPECT_NEAR(coarse.bearings[b].rated_hours.reference / fine.bearings[b].rated_hours.reference, 1.0,
                  1e-2);
    }
  }
}

// The row shows the worst of all bearings.
TEST(CarrierPoint, TheRowShowsTheWorstBearing) {
  const analysis::PointResult point = analysis::evaluate(bearing_sets(case_of("reducer_150kW", kSagging)));
  described::Record record;
  analysis::describe_row(record, point);
  const auto value = [&](const std::string& name) {
    return std::get<described::Numbers>(record.entry(name).content).values.front();
  };
  const auto shortest = [&](const auto& life) {
    return life(*std::ranges::min_element(point.carrier->bearings, {}, life));
  };
  EXPECT_EQ(value("carrier_L10h"),
            shortest([](const BearingOverRevolution& b) { return b.rated_hours.basic; }));
  EXPECT_EQ(value("carrier_L10rh"),
            shortest([](const BearingOverRevolution& b) { return b.rated_hours.reference; }));
  EXPECT_EQ(value("carrier_life_h"), shortest([](const BearingOverRevolution& b) { return b.life_hours; }));
  EXPECT_EQ(value("carrier_load_share"), point.carrier->load.maxCoeff() / point.carrier->expected_load);
  EXPECT_LT(value("carrier_L10h"), value("L10h"));
  const auto most = [&](const auto& load) {
    return load(*std::ranges::max_element(point.carrier->bearings, {}, load));
  };
  const double largest = most([](const BearingOverRevolution& b) { return b.largest; });
  EXPECT_EQ(value("carrier_P0_N"), largest);
  EXPECT_NEAR(value("carrier_S0") * largest / point.rating.lives.static_capacity, 1.0, 1e-12);
  EXPECT_EQ(value("carrier_contact_pressure_max_MPa"),
            most([](const BearingOverRevolution& b) { return b.largest_pressure; }));
  EXPECT_GT(value("carrier_contact_pressure_max_MPa"), point.contact_pressure);
  EXPECT_LT(value("carrier_S0"), value("S0"));
}

}  // namespace
}  // namespace orbearing::app::carrier_point_test

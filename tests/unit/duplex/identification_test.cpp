// Identification finds the constants that frequencies were made with.
#include "bearing/duplex/identification.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/duplex/pair.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::duplex::identification_test {
namespace {

constexpr double kFound = 1e-6;  // relative; the search ends where residuals are round-off
const Cylinder kCylinder{.diameter = 0.1, .density = 7850.0};

Bearing angular_contact(double degrees) {
  Bearing bearing{
      .elements = Balls{.count = 20, .diameter = 14.288e-3, .contact_angle = degrees * 0.017453292519943295},
      .pitch_diameter = 125.25e-3};
  bearing.inner.osculation = bearing.outer.osculation = 0.525;
  return bearing;
}

Observation nonlinear(double degrees, double preload) {
  Pair pair{.bearing = angular_contact(degrees)};
  pair.approach = approach_under(pair.bearing, preload);
  const PairState state = balance_pair(pair);
  return {{}, [rows = state.rows](const RowLevers& levers) {
            return pair_stiffness(rows, Arrangement::face_to_face, levers);
          }};
}

Observation linear(double degrees, double preload) {
  const Bearing bearing = angular_contact(degrees);
  return {{}, [row = pressed_row(bearing, approach_under(bearing, preload))](const RowLevers& levers) {
            return linear_stiffness(row, levers);
          }};
}

void measure(Observation& pair, const Shaft& shaft, const std::optional<Housing>& housing,
             TiltPlanes planes) {
  const PairModes modes = modes_of(pair.stiffness(shaft.levers), shaft, housing, planes);
  for (std::size_t i = 0; i < 5; ++i) pair.frequency[i] = modes[i].frequency;
}

void expect_recovered(double lever, const std::optional<Housing>& housing) {
  const double mass = 9.3, inertia = cylinder_inertia(mass, kCylinder.diameter, kCylinder.density);
  const Shaft planted{mass, {lever, lever}, inertia, inertia};
  std::vector<Observation> pairs{nonlinear(15.0, 540.0), nonlinear(15.0, 1270.0), nonlinear(15.0, 2550.0)};
  for (Observation& pair : pairs) measure(pair, planted, housing, TiltPlanes::physical);
  const Identified found = identify_cylinder(pairs, kCylinder, 12e-3, housing);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.shaft.mass, mass, kFound * mass);
  EXPECT_NEAR(found.shaft.levers.first, lever, kFound * lever);
  EXPECT_NEAR(found.shaft.inertia_y, inertia, 10.0 * kFound * inertia);
  EXPECT_LT(found.root_mean_square, kFound);
}

TEST(DuplexIdentification, RecoversPlantedMassAndLever) {
  expect_recovered(27.5e-3, {});
  expect_recovered(14e-3, {});  // the other side of where the lines of contact meet
  expect_recovered(55e-3, {});
}

TEST(DuplexIdentification, RecoversThemBesideAFreeHousing) {
  expect_recovered(27.5e-3, Housing{.mass = 25.0, .inertia = 0.15});
}

TEST(DuplexIdentification, RecoversFiveConstantsOfTheLinearFormulas) {
  const Shaft planted{9.4, {15.2e-3, 16.9e-3}, 0.047, 0.0455};
  std::vector<Observation> pairs{linear(15.0, 540.0), linear(15.0, 2550.0), linear(30.0, 840.0)};
  for (Observation& pair : pairs) measure(pair, planted, {}, TiltPlanes::literature_variant);
  const Identified found =
      identify_all(pairs, {8.0, {14e-3, 18e-3}, 0.05, 0.05}, TiltPlanes::literature_variant);
  constexpr double flat = 1e-4;  // levers and inertias nearly make up for each other
  EXPECT_NEAR(found.shaft.mass, 9.4, flat * 9.4);
  EXPECT_NEAR(found.shaft.levers.first, 15.2e-3, flat * 15.2e-3);
  EXPECT_NEAR(found.shaft.levers.second, 16.9e-3, flat * 16.9e-3);
  EXPECT_NEAR(found.shaft.inertia_x, 0.047, flat * 0.047);
  EXPECT_NEAR(found.shaft.inertia_y, 0.0455, flat * 0.0455);
}

// Bearings cannot be closer than they are wide.
TEST(DuplexIdentification, KeepsTheLeastLever) {
  const double lever = 14e-3;
  const double inertia = cylinder_inertia(9.3, kCylinder.diameter, kCylinder.density);
  std::vector<Observation> pairs{nonlinear(15.0, 540.0), nonlinear(15.0, 2550.0)};
  for (Observation& pair : pairs)
    measure(pair, {9.3, {lever, lever}, inertia, inertia}, {}, TiltPlanes::physical);
  EXPECT_GE(identify_cylinder(pairs, kCylinder, 20e-3).shaft.levers.first, 20e-3 * (1.0 - 1e-12));
}

TEST(DuplexIdentification, WithoutObservationsIsRefused) {
  EXPECT_REFUSED(std::invalid_argument, "identification 1", identify_cylinder({}, kCylinder, 12e-3));
  std::vector<Observation> pairs{nonlinear(15.0, 540.0)};
  EXPECT_REFUSED(std::invalid_argument, "identification 2",
                 identify_cylinder(pairs, kCylinder, 12e-3));  // frequencies of 0 Hz
}

}  // namespace
}  // namespace orbearing::bearing::duplex::identification_test

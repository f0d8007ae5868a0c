#include "gearset/checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/messages.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::checks_test {
namespace {

bool mentions(const Warnings& warnings, const std::string& position, const std::string& text) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) {
    return warning.key == position && warning.text.find(text) != std::string::npos;
  });
}

std::string listing(const Warnings& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += warning.key + ": " + warning.text + "\n";
  return text;
}

TEST(AssemblyProblems, AreNoneForSoundSets) {
  for (const PlanetarySet& set : all_sets()) EXPECT_EQ(listing(assembly_problems(set)), "");
}

struct Mistake {
  std::string position;
  std::string text;
  std::function<void(PlanetarySet&)> make;
};

TEST(AssemblyProblems, NameThePositionAndWhatIsRequired) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Mistake> mistakes{
      {"gearset.teeth.sun", "found 0", [](PlanetarySet& s) { s.sun_teeth = 0; }},
      {"gearset.teeth.planet", "found -3", [](PlanetarySet& s) { s.planet_teeth = -3; }},
      {"gearset.teeth.ring", "at least 1", [](PlanetarySet& s) { s.ring_teeth = 0; }},
      {"gearset.planets", "at least 1", [](PlanetarySet& s) { s.planets = 0; }},
      {"gearset.planets", "divisor of sun + ring teeth = 116", [](PlanetarySet& s) { s.planets = 3; }},
      {"gearset.planets", "neighbours", [](PlanetarySet& s) { s.planets = 29; }},
      {"gearset.module", "positive", [](PlanetarySet& s) { s.module = 0.0; }},
      {"gearset.face_width", "positive", [=](PlanetarySet& s) { s.face_width = infinity; }},
      {"gearset.profile_shift.sun", "between -2 and 2", [](PlanetarySet& s) { s.sun_shift = 26.18; }},
      {"gearset.profile_shift.ring", "between -2 and 2",
       [](PlanetarySet& s) { s.ring_shift = std::nan(""); }},
      {"gearset.profile_shift", "centre distance", [](PlanetarySet& s) { s.ring_teeth = 59; }},
      {"gearset.profile_shift", "flanks that cross",
       [](PlanetarySet& s) { s = {12, 24, 60, 4, 3e-3, {}, 1.0, 0.3, 28e-3, 0.0}; }},
      {"gearset.profile_shift", "no path of contact in the sun mesh",
       [](PlanetarySet& s) { s = {30, 30, 90, 2, 2e-3, {}, -1.5, -0.9, 20e-3, 0.0}; }},
      {"gearset.root_fillet_radius", "0.47", [](PlanetarySet& s) { s.rack.root_fillet_radius = 0.5; }},
      {"gearset.addendum", "point", [](PlanetarySet& s) { s.rack.addendum = 2.0; }},
      {"gearset.clearance", "not negative", [](PlanetarySet& s) { s.rack.clearance = -0.1; }},
      {"gearset.pressure_angle", "45 deg", [](PlanetarySet& s) { s.rack.pressure_angle = 20.0; }},
      {"bearing.outside_diameter", "55.744 mm", [](PlanetarySet& s) { s.planet_bore = 56e-3; }}};
  for (const Mistake& mistake : mistakes) {
    PlanetarySet set = reducer();
    mistake.make(set);
    const Warnings problems = assembly_problems(set);
    EXPECT_TRUE(mentions(problems, mistake.position, mistake.text))
        << mistake.position << " / " << mistake.text << " not in:\n"
        << listing(problems);
    EXPECT_SAID("assembly problems", listing(problems));
  }
}

TEST(AssemblyProblems, AreAllReportedAtOnce) {
  PlanetarySet set = reducer();
  set.module = -1.0;
  set.planets = 0;
  EXPECT_EQ(assembly_problems(set).size(), 2U);
}

TEST(ToothWarnings, NameUndercutAndInterferenceOfTheReducer) {
  const Warnings warnings = tooth_warnings(working_geometry(reducer()));
  EXPECT_TRUE(mentions(warnings, "gearset.profile_shift", "planet is undercut")) << listing(warnings);
  EXPECT_TRUE(
      mentions(warnings, "gearset.profile_shift", "tips of the ring reach below the planet's base circle"));
  EXPECT_FALSE(mentions(warnings, "gearset.profile_shift", "sun is undercut"));
}

TEST(ToothWarnings, AreNoneForTheOtherReadingOfTheReducer) {
  EXPECT_EQ(listing(tooth_warnings(working_geometry(gai_sets(-1.0).front()))), "");
}

struct Fault {
  int planet_teeth;
  double sun_shift, ring_shift;  // [module]
  std::string text;
};

TEST(ToothWarnings, NameTheFault) {
  const std::vector<Fault> faults{{30, -0.9, 0.9, "the sun is undercut"},
                                  {30, -1.5, -0.7, "contact ratio of the sun mesh"},
                                  {10, -1.4, -0.2, "contact ratio of the ring mesh"},
                                  {30, -1.5, -0.7, "tips of the planet interfere with the roots of the sun"},
                                  {30, -1.5, -0.7, "tips of the sun interfere with the roots of the planet"},
                                  {30, -1.5, -0.7, "tips of the sun reach below the planet's form circle"},
                                  {20, -1.4, 0.9, "tips of the planet reach below the sun's form circle"},
                                  {20, 0.0, 0.0, "tips of the ring reach below the planet's form circle"}};
  for (const Fault& fault : faults) {
    const int ring_teeth = 30 + 2 * fault.planet_teeth;
    const PlanetarySet set{30, fault.planet_teeth, ring_teeth,       2,     2e-3,
                           {}, fault.sun_shift,    fault.ring_shift, 20e-3, 0.0};
    const Warnings warnings = tooth_warnings(working_geometry(set));
    EXPECT_TRUE(mentions(warnings, "gearset.profile_shift", fault.text)) << fault.text << " not in:\n"
                                                                         << listing(warnings);
  }
}

TEST(ToothWarnings, NameTheTeethThatMakeAnUnusualShiftOfThePlanet) {
  const auto said = [](int ring_teeth) {
    const PlanetarySet set{18, 33, ring_teeth, 3, 3e-3, {}, 0.0, 0.0, 40e-3, 62e-3};
    return listing(tooth_warnings(working_geometry(set)));
  };
  const std::string text = said(87);
  for (const char* part :
       {"gearset.teeth", "profile shift 0.7246", "18, 33 and 87 teeth", "= 84 teeth", "of 14.1 deg"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " not in:\n" << text;
  for (const int usual : {84, 86}) EXPECT_EQ(said(usual).find("usual range"), std::string::npos) << usual;
}

TEST(ToothWarnings, AllowTipsThatJustTouchTheRoots) {
  PlanetarySet set = standard_set();
  set.rack.clearance = 0.0;
  set.rack.root_fillet_radius = 0.0;
  for (const double shift : {-0.5, -0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    set.sun_shift = shift;
    set.ring_shift = -shift;
    EXPECT_EQ(listing(tooth_warnings(working_geometry(set))).find("interfere with"), std::string::npos)
        << shift;
  }
}

TEST(ToothWarnings, NameARingTipInsideItsBaseCircle) {
  const PlanetarySet set{12, 9, 30, 3, 2e-3, {}, 0.0, 0.0, 20e-3, 0.0};
  EXPECT_TRUE(
      mentions(tooth_warnings(working_geometry(set)), "gearset.profile_shift", "inside its base circle"));
}

// A ring with few teeth more than its planet, made by hand, since no sun would fit beside such a planet.
WorkingGeometry close_pair(int planet_teeth, int ring_teeth) {
  WorkingGeometry geometry = working_geometry(standard_set());
  geometry.planet = make_external_tooth(planet_teeth, 0.0, 2e-3, {});
  geometry.ring = make_ring_tooth(ring_teeth, 0.0, 2e-3, {});
  geometry.centre_distance = geometry.ring.pitch_radius - geometry.planet.pitch_radius;
  geometry.ring_mesh.working_pressure_angle = geometry.ring.pressure_angle;
  return geometry;
}

// Turns the pair until the planet's leading tip corner crosses the ring's tip circle on its way out, and
// measures the gap to the ring tooth ahead of it, without the formula's angles.
double measured_gap(const WorkingGeometry& g) {
  const double corner = half_thickness_angle(g.planet, g.planet.tip_radius);
  const double step = 1e-5;  // [rad]
  for (double turn = 0.0; turn < 2.0; turn += step) {
    const double angle = turn + corner;
    const double x = g.centre_distance + g.planet.tip_radius * std::cos(angle);
    const double y = g.planet.tip_radius * std::sin(angle);
    if (turn == 0.0 || std::hypot(x, y) > g.ring.tip_radius) continue;
    const double ring_turn = turn * g.planet.teeth / g.ring.teeth;
    const double into_space = std::atan2(y, x) - ring_turn;
    const double tooth = std::numbers::pi / g.ring.teeth;
    return g.ring.tip_radius * (tooth - half_thickness_angle(g.ring, g.ring.tip_radius) - into_space);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(RingTipClearance, IsWhatTurningThePairShows) {
  constexpr double of_one_step = 2e-5 * 0.1;  // [m] two steps of the turning angle on a radius below 0.1 m
  for (const int ring_teeth : {56, 60, 70}) {
    const WorkingGeometry pair = close_pair(50, ring_teeth);
    EXPECT_NEAR(ring_tip_clearance(pair), measured_gap(pair), of_one_step) << ring_teeth;
  }
}

TEST(RingTipClearance, IsNegativeForAPlanetNearlyAsLargeAsTheRing) {
  EXPECT_TRUE(mentions(tooth_warnings(close_pair(50, 54)), "gearset.profile_shift", "foul each other"));
  EXPECT_FALSE(mentions(tooth_warnings(close_pair(50, 70)), "gearset.profile_shift", "foul each other"));
}

}  // namespace
}  // namespace orbearing::gearset::checks_test

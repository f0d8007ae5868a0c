// Begin of contact in both meshes of a planet, measured on drawn teeth.
//
//      sun           planet, axis of a tooth      ring       The planet turns clockwise by steps; at each,
//     (-a, 0)  )    (0, 0)  at the angle theta  )            sun and ring are turned up to its flanks, and
//                                                            the pairs of teeth that touch are counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gearset/involute.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::mesh_phase_drawing_test {
namespace {

constexpr double pi = std::numbers::pi;

// One mesh on the drawing: the teeth of the planet near `facing`, against a wheel about (-a, 0).
template <typename Tooth>
struct Drawing {
  const ExternalTooth& planet;
  const Tooth& wheel;
  double a;            // [m]
  double facing;       // [rad]  where the wheel lies, seen from the planet
  double flank;        // +1: the planet's anticlockwise flank touches
  double wheel_flank;  // +1: the wheel's tooth touches with its anticlockwise flank
  double wheel_sense;  // +1: the wheel's teeth follow each other in the sense of the planet's
  double least, most;  // [m]  radii of the wheel's involute
};

// How far the wheel can be turned towards a point of the planet's flank, in the sense that closes the gap.
template <typename Tooth>
double gap_at(const Drawing<Tooth>& d, double axis, double tangent) {
  const double radius = std::hypot(d.planet.base_radius, tangent);
  const double angle = axis + d.flank * half_thickness_angle(d.planet, radius);
  const double x = radius * std::cos(angle) + d.a, y = radius * std::sin(angle);
  const double on_wheel = std::hypot(x, y);
  if (on_wheel < d.least || on_wheel > d.most) return std::numeric_limits<double>::infinity();
  return d.wheel_flank * std::atan2(y, x) - half_thickness_angle(d.wheel, on_wheel);
}

// The least over the flank of the planet's tooth whose axis is at `axis`: by points, then by golden section
// about the least one.
template <typename Tooth>
double gap(const Drawing<Tooth>& d, double axis) {
  constexpr int points = 60, sections = 45;
  constexpr double golden = 0.618033988749895;
  const double foot = tangent_length(d.planet.base_radius, d.planet.form_radius);
  const double step = (tangent_length(d.planet.base_radius, d.planet.tip_radius) - foot) / points;
  const auto at = [&](double position) { return gap_at(d, axis, foot + step * position); };
  double position = 0.0;
  for (int i = 1; i <= points; ++i)
    if (at(i) < at(position)) position = i;
  double low = std::max(position - 1.0, 0.0), high = std::min(position + 1.0, double(points)),
         least = at(position);
  for (int i = 0; i < sections; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const double at_a = at(a), at_b = at(b);
    least = std::min({least, at_a, at_b});
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  return least;
}

template <typename Tooth>
int touching(const Drawing<Tooth>& d, double theta) {
  const double pitch = 2.0 * pi / d.planet.teeth;
  const double touch = 1e-11 / d.a;  // [rad]
  std::vector<double> gaps;
  double least = std::numeric_limits<double>::infinity();
  const int nearest = static_cast<int>(std::lround((d.facing - theta) / pitch));
  for (int k = nearest - 3; k <= nearest + 3; ++k) {
    const double turn = d.wheel_flank * d.wheel_sense * k * 2.0 * pi / d.wheel.teeth;
    gaps.push_back(gap(d, theta + k * pitch) - turn);
    least = std::min(least, gaps.back());
  }
  int count = 0;
  for (const double g : gaps) count += g < least + touch;
  return count;
}

// When, in periods of the planet's clockwise turning, one more pair touches than just before.
template <typename Tooth>
double contact_begins(const Drawing<Tooth>& d) {
  const auto count = [&d](double time) { return touching(d, -2.0 * pi * time / d.planet.teeth); };
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    double before = double(i) / steps, after = double(i + 1) / steps;
    const int few = count(before);
    if (count(after) <= few) continue;
    for (int halving = 0; halving < 10; ++halving) {
      const double middle = 0.5 * (before + after);
      (count(middle) > few ? after : before) = middle;
    }
    return 0.5 * (before + after);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Lag of the ring mesh on the drawing; `sun_drives` with the sun turning anticlockwise.
double drawn_lag(const WorkingGeometry& g, bool sun_drives) {
  const double side = sun_drives ? 1.0 : -1.0;
  const Drawing<ExternalTooth> sun{
      g.planet, g.sun, g.centre_distance, pi, side, side, -1.0, g.sun.form_radius, g.sun.tip_radius};
  const Drawing<RingTooth> ring{g.planet,
                                g.ring,
                                g.centre_distance,
                                0.0,
                                -side,
                                side,
                                1.0,
                                std::max(g.ring.tip_radius, g.ring.base_radius),
                                g.ring.root_radius};
  return contact_begins(ring) - contact_begins(sun);
}

// Error of the drawing: contact is recognised by a gap of 1e-11 m between flanks whose radii differ like 1/(1
// m): sqrt(2e-11 m * 1 m) = 4 um of some 6 mm, and half of the last step.
constexpr double of_the_drawing = 1e-3;  // [mesh period]

TEST(MeshPhase, OfRingAndSunMeshIsThatOfDrawnTeeth) {
  for (const PlanetarySet& set : all_sets()) {
    for (const bool sun_drives : {true, false}) {
      const double lag = meshes_of(set, {.sun_drives = sun_drives}).ring_lag.front();
      const double drawn = drawn_lag(working_geometry(set), sun_drives);
      SCOPED_TRACE(testing::Message()
                   << set.sun_teeth << "/" << set.planet_teeth << "/" << set.ring_teeth << " shift "
                   << set.sun_shift << " sun drives " << sun_drives << ": " << lag << " drawn " << drawn);
      EXPECT_NEAR(std::remainder(lag - drawn, 1.0), 0.0, of_the_drawing);
    }
  }
}

// Both meshes of a planet lag equally behind those of the first planet: the condition of assembly.
TEST(MeshPhase, OfSunAndRingMeshShiftTogetherFromPlanetToPlanet) {
  for (const PlanetarySet& set : all_sets()) {
    for (const bool anticlockwise : {true, false}) {
      const PlanetaryMeshes meshes = meshes_of(set, {.sun_anticlockwise = anticlockwise});
      for (std::size_t n = 0; n < meshes.sun_lag.size(); ++n)
        EXPECT_NEAR(std::remainder(meshes.ring_lag[n] - meshes.ring_lag[0] - meshes.sun_lag[n], 1.0), 0.0,
                    1e-9);
    }
  }
}

}  // namespace
}  // namespace orbearing::gearset::mesh_phase_drawing_test

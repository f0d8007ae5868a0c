// Teeth under load: gaps beside the path of contact, force by deflection and position, transmission error.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "gearset/involute.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"
#include "gearset/mesh/loaded/transmission_error.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::loaded_teeth_test {
namespace {

constexpr double kTable = 2e-5;  // [-]  interpolated stiffness of a pair, fourth order in 1/128 of a period

struct NamedGears {
  std::string name;
  MeshingGears gears;
};

// External meshes with and without undercut, the internal one, both ways of driving, helical teeth.
std::vector<NamedGears> examples() {
  const PlanetaryMeshes forward = meshes_of(reducer()),
                        backward = meshes_of(reducer(), {.sun_drives = false});
  return {{"sun", forward.sun_gears},
          {"ring", forward.ring_gears},
          {"sun driven", backward.sun_gears},
          {"ring driving", backward.ring_gears},
          {"62/62", meshing(example_pair(62, 62))},
          {"30/40", meshing(example_pair(30, 40, 0.2, -0.1))},
          {"standard ring", meshes_of(standard_set()).ring_gears}};
}

MeshModifications modified() {
  return {{8e-6, 2e-3, ReliefForm::linear}, {12e-6, 3e-3, ReliefForm::parabolic}, 10e-6, -6e-6};
}

// Eq. (4).
double gap_near(const MeshingGears& gears, PathEnd end, double distance) {
  const EdgeAtEnd edge = edge_at(gears, end);
  const double base = base_radius(edge.of_first ? gears.first : gears.second);
  const double position = end == PathEnd::begin ? gears.path.begin : gears.path.end;
  const double on_first =
      gears.line_length + (std::holds_alternative<RingTooth>(gears.first.tooth) ? position : -position);
  const double mate = edge.of_first ? position : on_first;
  return edge.tangent * gears.line_length * distance * distance / (2.0 * base * base * mate);
}

// The exact gap tends to a parabola beyond the end of the path; its third order is that of the
// distance over the tangent length of the edge.
TEST(FlankGap, GrowsAsASquareBesideThePath) {
  for (const NamedGears& example : examples())
    for (const PathEnd end : {PathEnd::begin, PathEnd::end}) {
      SCOPED_TRACE(example.name);
      const MeshingGears& gears = example.gears;
      const double sense = end == PathEnd::begin ? -1.0 : 1.0;
      const double from = end == PathEnd::begin ? gears.path.begin : gears.path.end;
      const EdgeAtEnd edge = edge_at(gears, end);
      const double distance = 2e-3 * edge.tangent;
      const double gap = flank_gap(gears, from + sense * distance).gap;
      EXPECT_GT(gap, 0.0);
      EXPECT_NEAR(gap / gap_near(gears, end, distance), 1.0, 6.0 * distance / edge.tangent);
    }
}

// The points of a drawn flank, turned until the two teeth touch: a brute-force count of the same gap.
double drawn_gap(const MeshingGears& gears, double position) {
  const double base = base_radius(gears.second), first = base_radius(gears.first);
  const auto& tooth = std::get<ExternalTooth>(gears.second.tooth);
  const auto& mate = std::get<ExternalTooth>(gears.first.tooth);
  const auto point = [](double radius, double angle) {
    return Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
  };
  const auto inv = [](double t, double r) { return t / r - std::atan(t / r); };
  double least = 1.0;
  constexpr int points = 4000;
  const double foot = tangent_length(mate.base_radius, mate.form_radius),
               tip = tangent_length(mate.base_radius, mate.tip_radius);
  for (int i = 0; i <= points; ++i) {
    const double t = std::lerp(foot, tip, double(i) / points);
    const Eigen::Vector2d own =
        point(std::hypot(first, t), (gears.line_length - position) / first - inv(t, first));
    const Eigen::Vector2d at = Eigen::Vector2d(first + base, gears.line_length) - own;
    if (at.norm() > tooth.tip_radius || at.norm() < tooth.form_radius) continue;
    const double tangent = std::sqrt(at.squaredNorm() - base * base);
    const double flank = position / base - inv(tangent, base);
    least = std::min(least, base * (std::atan2(at.y(), at.x()) - flank));
  }
  return least;
}

// Whole flanks against each other, both ways: no other point is closer than the edge.
TEST(FlankGap, IsTheLeastOfAllPointsOfBothFlanks) {
  const MeshingGears gears = meshing(example_pair(62, 62));
  for (const double share : {0.05, 0.15, 0.3}) {
    const double position = gears.path.begin - share * gears.base_pitch;
    EXPECT_NEAR(flank_gap(gears, position).gap, drawn_gap(gears, position),
                1e-9);  // the drawing ends at the tip
  }
}

// Under 18 um of deflection the tip corner touches 0.11 of a period early.
TEST(FlankGap, IsEighteenMicrometresATenthOfAPeriodBeforeTheSunMeshOfTheReducer) {
  const MeshingGears gears = meshes_of(reducer()).sun_gears;
  const double position = contact_begin(gears) - 0.11 * contact_direction(gears) * gears.base_pitch;
  EXPECT_NEAR(1e6 * flank_gap(gears, position).gap, 18.0, 1.0);  // its two digits
}

// The tip takes over from the foot of an undercut flank without a step.
TEST(FlankGap, IsContinuousWhereTheTipTakesOver) {
  const MeshingGears gears = meshes_of(reducer()).sun_gears;  // its planet is undercut
  ASSERT_TRUE(std::get<ExternalTooth>(gears.second.tooth).undercut);
  const double position = tip_takes_over(gears, PathEnd::begin);
  ASSERT_LT(position, gears.path.begin);
  constexpr double beside = 1e-11;  // [m]
  const FlankGap before = flank_gap(gears, position + beside), after = flank_gap(gears, position - beside);
  EXPECT_NEAR(before.gap, after.gap, 1e-10);  // edges cross: the gap grows about as fast as they move on
  EXPECT_NE(before.first, after.first);
}

// A convex problem: all gaps close, no slice pulls, and the force is the slope of the stored energy.
TEST(LoadedTeeth, ForceIsTheSlopeOfItsEnergy) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const NamedGears& example : examples())
    for (const MeshModifications& by : {MeshModifications{}, modified()}) {
      SCOPED_TRACE(example.name);
      const LoadedTeeth teeth = tooth_pairs(example.gears, by, 7).teeth;
      double stored = 0.0;
      for (int i = 0; i < 200; ++i) {
        const double position = 3.0 * share(engine) - 1.0, approach = 60e-6 * share(engine);
        const double step = 1e-10, turn = 1e-6;
        const ToothForce now = teeth.at(position, approach);
        const ToothForce more = teeth.at(position, approach + step),
                         less = teeth.at(position, approach - step);
        stored = std::max(stored, now.energy);
        EXPECT_GE(now.force, 0.0);
        EXPECT_GE(more.force, less.force);
        EXPECT_NEAR((more.energy - less.energy) / (2.0 * step), now.force, 1e-3 + 1e-5 * now.force);
        EXPECT_GE(more.force - less.force + 1e-6, 2.0 * step * std::min(more.stiffness, less.stiffness));
        EXPECT_LE(more.force - less.force - 1e-6, 2.0 * step * std::max(more.stiffness, less.stiffness));
        const double change =
            (teeth.at(position + turn, approach).energy - teeth.at(position - turn, approach).energy) /
            (2.0 * turn);
        EXPECT_NEAR(change, now.energy_by_phase, 3e-4 * (std::abs(change) + stored));
      }
    }
}

// Against a search that is independent of the law: of all deflections of the teeth the one of least energy.
TEST(LoadedTeeth, EnergyIsTheLeastOneOfAllDeflections) {
  const LoadedTeeth teeth = tooth_pairs(meshing(example_pair(62, 62)), modified(), 5).teeth;
  for (const double position : {0.1, 0.5, 0.95})
    for (const double approach : {5e-6, 20e-6, 50e-6}) {
      const ToothForce now = teeth.at(position, approach);
      double least = 1.0;
      constexpr int steps = 20000;
      for (int i = 0; i < steps; ++i) {
        const double own = approach * i / steps, bodies = approach - own;
        double energy = 0.5 * bodies * bodies / teeth.shared();
        for (const FaceSlice& slice : teeth.slices())
          for (double progress = position + std::ceil(teeth.begin() - position); progress < teeth.end();
               ++progress) {
            const double at = (progress - teeth.begin()) / (teeth.end() - teeth.begin());
            const double closed = std::max(0.0, own - teeth.gap().value(at) - slice.gap);
            energy += 0.5 * teeth.stiffness().value(at) / static_cast<double>(teeth.slices().size()) *
                      closed * closed;
          }
        least = std::min(least, energy);
      }
      EXPECT_NEAR(now.energy, least, 1e-6 * least);  // square of the search's step
      EXPECT_LE(now.energy, least * (1.0 + 1e-12));
    }
}

// Light load: pairs in the path carry, all others none. Bodies give way once for all of them.
TEST(LoadedTeeth, AreAsStiffAsThePairsInThePathUnderALightLoad) {
  for (const NamedGears& example : examples()) {
    SCOPED_TRACE(example.name);
    const MeshingGears& gears = example.gears;
    const LoadedTeeth teeth = tooth_pairs(gears).teeth;
    const double ratio = gears.path.length() / gears.base_pitch, shared = teeth.shared();
    for (int i = 1; i < 40; ++i) {
      const double position = i / 40.0;
      if (std::abs(position - (ratio - std::floor(ratio))) < 0.03 || position > 0.97 || position < 0.03)
        continue;
      double own = 0.0;
      for (double progress = position; progress < ratio; ++progress)
        own += 1.0 / (pair_compliance(gears, contact_begin(gears) +
                                                 contact_direction(gears) * gears.base_pitch * progress)
                          .sum() -
                      shared);
      const double expected = 1.0 / (shared + 1.0 / own);
      EXPECT_NEAR(teeth.at(position, 1e-12).stiffness, expected, kTable * expected);
    }
  }
}

// One pair by itself is as stiff as in the step-like mesh; two of 62/62 are up to a fifth softer (the
// step-like mesh is too stiff by up to 20 % in double contact at 62/62, by 3 % at the sun).
TEST(LoadedTeeth, CountTheBodiesOnceForAllPairs) {
  const auto too_stiff = [](const MeshingGears& gears, double position) {
    return mesh_stiffness_at(gears, position) / tooth_pairs(gears).teeth.at(position, 1e-12).stiffness - 1.0;
  };
  const MeshingGears alike = meshing(example_pair(62, 62)), sun = meshes_of(reducer()).sun_gears;
  EXPECT_NEAR(too_stiff(alike, 0.9), 0.0, 1e-5);  // single contact
  EXPECT_NEAR(too_stiff(sun, 0.8), 0.0, 1e-5);
  double most = 0.0, most_sun = 0.0;
  for (double position = 0.05; position < 0.65; position += 0.05) {
    most = std::max(most, too_stiff(alike, position));
    most_sun = std::max(most_sun, too_stiff(sun, position));
  }
  EXPECT_NEAR(most, 0.20, 0.03);
  EXPECT_NEAR(most_sun, 0.03, 0.015);
}

// A ring sheared between its edges, by quadrature instead of the closed form.
TEST(LoadedTeeth, TorsionOfABodyIsThatOfAShearedRing) {
  for (const MeshGear& gear : {meshing(example_pair(62, 62)).first, meshes_of(reducer()).ring_gears.first}) {
    const double base = base_radius(gear), width = gear.face_width, modulus = gear.material.shear_modulus();
    const double low = std::min(gear.body.body_radius, gear.body.root_radius),
                 high = std::max(gear.body.body_radius, gear.body.root_radius);
    double turn = 0.0;  // [rad/N]
    constexpr int rings = 20000;
    for (int i = 0; i < rings; ++i) {
      const double radius = std::lerp(low, high, (i + 0.5) / rings), torque = base;
      const double stress = torque / (2.0 * M_PI * radius * radius * width);
      turn += stress / modulus / radius * (high - low) / rings;
    }
    EXPECT_NEAR(body_torsion(gear), base * turn, 1e-7 * base * turn);
  }
}

// Under 900 N a spring of 900 N / (5 + 2 cos f + 0.5 sin 3 f) um approaches by that sum.
TEST(TransmissionError, HasTheAmplitudesOfItsHarmonics) {
  constexpr double turn = 2.0 * 3.14159265358979323846, force = 900.0;
  const PeriodicCurve spring(
      [](double position) {
        return force /
               (1e-6 * (5.0 + 2.0 * std::cos(turn * position) + 0.5 * std::sin(3.0 * turn * position)));
      },
      {}, 4000);
  const TransmissionError error = transmission_error(spring, force);
  constexpr double sampled = 1e-10;  // [m]  of a cubic between 4000 knots
  EXPECT_NEAR(error.mean, 5e-6, sampled);
  ASSERT_EQ(error.harmonics.size(), static_cast<std::size_t>(transmission_orders));
  for (std::size_t order = 1; order <= error.harmonics.size(); ++order)
    EXPECT_NEAR(error.harmonics[order - 1], order == 1 ? 2e-6 : order == 3 ? 0.5e-6 : 0.0, sampled) << order;
}

// Perfect involutes have no error without load; under a light one it follows the step-like stiffness.
TEST(TransmissionError, OfPerfectInvolutesVanishesWithTheLoad) {
  for (const NamedGears& example : examples()) {
    SCOPED_TRACE(example.name);
    const LoadedTeeth teeth = tooth_pairs(example.gears).teeth;
    EXPECT_EQ(transmission_error(teeth, 0.0).peak_to_peak, 0.0);
    const TransmissionError light = transmission_error(teeth, 1.0);
    EXPECT_LT(light.peak_to_peak, 20e-9);  // 1 N on some 1e8 N/m
    for (const double force : {500.0, 6000.0})
      for (int i = 0; i < transmission_samples; i += 37) {
        const double position = (i + 0.5) / transmission_samples;
        const double approach = transmission_error(teeth, force).curve[static_cast<std::size_t>(i)];
        EXPECT_NEAR(teeth.at(position, approach).force, force, 1e-9 * force);
      }
  }
}

// Tip relief alone: the error without load is that of the flanks, in closed form for one gear.
TEST(TransmissionError, WithoutLoadIsThatOfTheFlanks) {
  const MeshingGears gears = meshing(example_pair(62, 62));
  const double length = 3e-3, amount = 10e-6;
  const MeshModifications by{{amount, length, ReliefForm::linear}, {amount, length, ReliefForm::linear}};
  const LoadedTeeth teeth = tooth_pairs(gears, by).teeth;
  const double pitch = gears.base_pitch, path = gears.path.length();
  const auto relief = [&](double from_end) { return amount * std::max(0.0, 1.0 - from_end / length); };
  for (double position = 0.05; position < 1.0; position += 0.1) {
    double least = 1.0;
    for (double s = position * pitch; s < path; s += pitch)
      least = std::min(least, relief(s) + relief(path - s));
    EXPECT_NEAR(teeth.approach_under(position, 0.0), least, 1e-12);
  }
}

// At the beginning of contact of a pair, the light load has a step of the stiffness, a heavy one a slope over
// the part of the period that its deflection closes the gaps of.
TEST(TransmissionError, IsSmoothUnderAHeavyLoad) {
  const LoadedTeeth teeth = tooth_pairs(meshing(example_pair(62, 62))).teeth;
  const auto steepest = [&](double force) {  // change of the error over 1/720 of a period, of its whole swing
    const TransmissionError error = transmission_error(teeth, force);
    double most = 0.0;
    for (std::size_t i = 1; i < error.curve.size(); ++i)
      most = std::max(most, std::abs(error.curve[i] - error.curve[i - 1]));
    return most / error.peak_to_peak;
  };
  EXPECT_GT(steepest(0.01), 0.5);  // almost all at once
  EXPECT_LT(steepest(2000.0), 0.05);
}

// Helical teeth under a light load: the sum of slices comes to the exact integral over the face, of pairs
// without the bodies that they share.
TEST(LoadedTeeth, OfHelicalTeethTendToTheIntegralAcrossTheFace) {
  GearPair pair = example_pair(30, 40);
  pair.helix_angle = 12.0 * M_PI / 180.0;
  const MeshingGears gears = meshing(pair);
  const double shared = tooth_pairs(gears).teeth.shared();
  const auto section = [&](double fraction) {
    double sum = 0.0;
    for (double progress = fraction; progress < gears.path.length() / gears.base_pitch; ++progress)
      sum += 1.0 / (pair_compliance(
                        gears, contact_begin(gears) + contact_direction(gears) * gears.base_pitch * progress)
                        .sum() -
                    shared);
    return sum;
  };
  const PeriodicCurve exact =
      across_face(PeriodicCurve(section, contact_changes(gears), mesh_samples), gears.overlap_ratio);
  const auto off = [&](int slices) {
    const LoadedTeeth teeth = tooth_pairs(gears, {}, slices).teeth;
    double most = 0.0;
    for (int i = 0; i < 50; ++i) {
      const double position = (i + 0.37) / 50.0, expected = 1.0 / (shared + 1.0 / exact.value(position));
      most = std::max(most, std::abs(teeth.at(position, 1e-12).stiffness / expected - 1.0));
    }
    return most;
  };
  // A slice of a pair that is counted or not: at most one at each end, of some 1.6 pairs.
  for (const int slices : {8, 16, 32}) EXPECT_LT(off(slices), 1.3 / slices);
}

// The table between its samples against the geometry itself.
TEST(ToothPairs, TablesHoldTheGeometryBetweenTheirSamples) {
  for (const NamedGears& example : examples()) {
    SCOPED_TRACE(example.name);
    const MeshingGears& gears = example.gears;
    const LoadedTeeth teeth = tooth_pairs(gears, modified()).teeth;
    const MeshModifications by = modified();
    double largest = 0.0, stiffness = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double share = (i + 0.5) / 1000.0;
      const double progress = std::lerp(teeth.begin(), teeth.end(), share);
      const FlankGap touch =
          flank_gap(gears, contact_begin(gears) + contact_direction(gears) * gears.base_pitch * progress);
      const double gap = touch.gap + relief_at(gears.first, by.first, touch.first) +
                         relief_at(gears.second, by.second, touch.second);
      largest = std::max(largest, std::abs(teeth.gap().value(share) - gap));
      const double all = hertz_compliance(gears.face_width, {}) +
                         gear_compliance(gears.first, touch.first).sum() +
                         gear_compliance(gears.second, touch.second).sum() - teeth.shared();
      stiffness = std::max(stiffness, std::abs(teeth.stiffness().value(share) * all - 1.0));
    }
    EXPECT_LT(largest, 20e-9);  // [m]  a thousandth of typical deflections
    EXPECT_LT(stiffness, 1e-3);
  }
}

// Eq. (10) of gearset/mesh/loaded/README.md, from the tip into the tooth: outward of a gear, inward of a
// ring.
TEST(ToothPairs, ReliefGrowsTowardsTheTip) {
  const MeshingGears gears = meshes_of(reducer()).ring_gears;
  const auto& planet = std::get<ExternalTooth>(gears.second.tooth);
  const auto& ring = std::get<RingTooth>(gears.first.tooth);
  const double tip = tangent_length(planet.base_radius, planet.tip_radius);
  const double ring_tip = tangent_length(ring.base_radius, std::max(ring.tip_radius, ring.base_radius));
  const TipRelief linear{20e-6, 2e-3, ReliefForm::linear}, parabolic{20e-6, 2e-3, ReliefForm::parabolic};
  for (const auto& [share, expected] :
       {std::pair{0.0, 1.0}, {0.25, 0.75}, {0.5, 0.5}, {1.0, 0.0}, {2.0, 0.0}}) {
    const double from_tip = share * 2e-3;
    EXPECT_NEAR(relief_at(gears.second, linear, tip - from_tip), 20e-6 * expected, 1e-18);
    EXPECT_NEAR(relief_at(gears.second, parabolic, tip - from_tip), 20e-6 * expected * expected, 1e-18);
    EXPECT_NEAR(relief_at(gears.first, parabolic, ring_tip + from_tip), 20e-6 * expected * expected, 1e-18);
  }
}

// If roots are as deep as the rack cuts them no tip reaches a fillet. Short planet teeth on shallow roots
// leave the ring's tip no room: under load it touches their trochoid, the sooner the less clearance there is.
TEST(EdgeWarnings, TellWhereATipReachesAFillet) {
  const auto teeth_of = [](const PlanetarySet& one) { return set_teeth(one, meshes_of(one)); };
  EXPECT_TRUE(edge_warnings(teeth_of(reducer()), 1000.0).empty());
  PlanetarySet set = standard_set();
  set.planet_teeth = 37;
  set.ring_teeth = 104;
  const SetTeeth default_value = teeth_of(set);
  EXPECT_FALSE(std::isfinite(default_value.ring.sound));
  EXPECT_TRUE(edge_warnings(default_value, 10000.0).empty());
  set.planet_heights = {.addendum = 0.8, .clearance = 0.1};
  set.ring_heights.addendum = 1.0;
  const SetTeeth deeper = teeth_of(set);
  set.planet_heights.clearance = 0.02;
  const SetTeeth shallow = teeth_of(set);
  EXPECT_FALSE(std::isfinite(shallow.sun.sound));
  EXPECT_GT(shallow.ring.sound, 5e-6);
  EXPECT_LT(shallow.ring.sound, 30e-6);
  EXPECT_GT(deeper.ring.sound, 2.0 * shallow.ring.sound);
  EXPECT_TRUE(edge_warnings(shallow, 1000.0).empty());
  EXPECT_TRUE(edge_warnings(deeper, 10000.0).empty());
  const Warnings warnings = edge_warnings(shallow, 10000.0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings.front().text, testing::HasSubstr("ring and planet"));
}

}  // namespace
}  // namespace orbearing::gearset::loaded_teeth_test

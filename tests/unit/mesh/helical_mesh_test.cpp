// Stiffness of helical meshes, by slices and by the standard.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearset/mesh/iso6336.hpp"
#include "gearset/mesh/mesh_stiffness.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::helical_mesh_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180.0;

GearPair helical_pair(int first, int second, double helix, double face_width = 20e-3) {
  GearPair pair = example_pair(first, second);
  pair.helix_angle = helix;
  pair.face_width = face_width;
  return pair;
}

// Face width for the overlap ratio `overlap`.
double width_for(double overlap, double module, double helix) {
  return overlap * pi * module / std::sin(helix);
}

double swing(const MeshStiffness& mesh) {
  return (mesh.curve.largest() - mesh.curve.least()) / mesh.curve.mean();
}

// Slices of equal width, each with the stiffness of its middle: their sum goes to the integral, with 1/n
// since the stiffness of a slice jumps.
TEST(HelicalMesh, IsTheLimitOfItsSlices) {
  const MeshingGears gears = meshing(helical_pair(62, 62, 15.0 * degree));
  const PeriodicCurve section([&](double f) { return mesh_stiffness_at(gears, f); }, contact_changes(gears),
                              96);
  const MeshStiffness mesh = mesh_stiffness(gears);
  ASSERT_GT(mesh.overlap_ratio, 0.5);
  const auto by_slices = [&](double fraction, int slices) {
    double sum = 0.0;
    for (int i = 0; i < slices; ++i)
      sum += section.value(fraction + mesh.overlap_ratio * ((i + 0.5) / slices - 0.5)) / slices;
    return sum;
  };
  const double jump = section.largest() - section.least();
  for (const int slices : {10, 100, 1000, 10000})
    for (const double fraction : {0.03, 0.21, 0.4, 0.67, 0.9})
      EXPECT_NEAR(mesh.curve.value(fraction), by_slices(fraction, slices), 1.5 * jump / slices)
          << slices << " slices at " << fraction;
  EXPECT_NEAR(mesh.curve.mean() / section.mean(), 1.0, 1e-7);  // that of the table
}

// The variation over the period decreases as the overlap grows, and is zero where the face is a whole axial
// pitch.
TEST(HelicalMesh, VariesLessTheLargerItsOverlap) {
  const double helix = 15.0 * degree;
  double before = swing(mesh_stiffness(meshing(helical_pair(62, 62, helix, 1e-9))));
  for (const double overlap : {0.1, 0.3, 0.5, 0.8, 0.95}) {
    const MeshStiffness mesh =
        mesh_stiffness(meshing(helical_pair(62, 62, helix, width_for(overlap, 2e-3, helix))));
    EXPECT_NEAR(mesh.overlap_ratio, overlap, 1e-12);
    EXPECT_LT(swing(mesh), before) << overlap;
    before = swing(mesh);
  }
  for (const double overlap : {1.0, 2.0})
    EXPECT_LT(swing(mesh_stiffness(meshing(helical_pair(62, 62, helix, width_for(overlap, 2e-3, helix))))),
              1e-12);
  EXPECT_LT(swing(mesh_stiffness(meshing(helical_pair(62, 62, helix, width_for(1.02, 2e-3, helix))))), 0.02);
}

TEST(HelicalMesh, GoesToTheSpurMesh) {
  const MeshStiffness spur = mesh_stiffness(meshing(example_pair(62, 62)));
  for (const double helix : {1e-12, 1e-7, -1e-6}) {
    const MeshStiffness slight = mesh_stiffness(meshing(helical_pair(62, 62, helix)));
    EXPECT_NEAR(slight.contact_ratio / spur.contact_ratio, 1.0, 1e-9);
    EXPECT_NEAR(slight.curve.mean() / spur.curve.mean(), 1.0, 1e-9) << helix;
    for (const double fraction : {0.1, 0.3, 0.5, 0.7, 0.95})  // away from the ramps instead of the jumps
      EXPECT_NEAR(slight.curve.value(fraction) / spur.curve.value(fraction), 1.0, 1e-9) << helix;
  }
}

// The tooth of a gear with ever more teeth becomes that of a rack, which is a prism: under a load along its
// whole length it deflects as its normal section does, c_n per length. Its length is b/cos(helix), the force
// F/cos(base helix), and the displacement in the transverse section that along the normal over cos(base
// helix).
TEST(HelicalMesh, OfARackIsThatOfItsNormalSection) {
  const double helix = 25.0 * degree, width = 20e-3;
  const int teeth = 200000;
  const double base = base_helix_angle(20.0 * degree, helix);
  const auto compliance = [&](double angle) {
    const ExternalTooth tooth = make_external_tooth(teeth, 0.0, 2e-3, {}, angle);
    const ToothLoad load = tooth_load(tooth, tooth.base_radius * std::tan(tooth.pressure_angle));
    return tooth_compliance(tooth, load, width, {});
  };
  const BeamCompliance spur = compliance(0.0), helical = compliance(helix);
  const double expected = std::cos(helix) / std::pow(std::cos(base), 2);
  constexpr double curved = 1e-3;  // what is left of the gear's radius
  EXPECT_NEAR(helical.bending / spur.bending, expected, curved);
  EXPECT_NEAR(helical.shear / spur.shear, expected, curved);
  EXPECT_NEAR(helical.axial / spur.axial, expected, curved);
}

// By hand, term by term: a root that is thinner and longer by cos(helix), under a force across of
// 1/cos(helix).
TEST(HelicalMesh, HasTheFoundationOfItsNormalSection) {
  const double helix = 25.0 * degree, c = std::cos(helix);
  FoundationBody body{.root_radius = 30e-3, .half_angle = 0.05, .body_radius = 15e-3};
  const ToothLoad load{.contact_radius = 33e-3, .force_angle = 0.4, .axis_radius = 32e-3};
  const auto both = [&](const FoundationCoefficients& one) {
    body.helix_angle = 0.0;
    const double spur = foundation_compliance(one, body, load, 20e-3, {});
    body.helix_angle = helix;
    return foundation_compliance(one, body, load, 20e-3, {}) / spur;
  };
  EXPECT_NEAR(both({.moment = 1.0}), 1.0 / (c * c * c), 1e-12);
  EXPECT_NEAR(both({.cross = 1.0}), 1.0 / (c * c), 1e-12);
  EXPECT_NEAR(both({.shear = 1.0}), 1.0 / c, 1e-12);
}

TEST(HelicalMesh, HasTheHertzianLineOfItsNormalSection) {
  const double helix = 25.0 * degree, base = base_helix_angle(20.0 * degree, helix);
  const MeshingGears gears = meshing(helical_pair(30, 40, helix));
  const double line = 20e-3 / std::cos(base);
  EXPECT_NEAR(pair_compliance(gears, pitch_point(gears)).hertz,
              hertz_compliance(line, {}) / std::pow(std::cos(base), 2), 1e-18);
}

// The standard has no bore and means gears of one piece; a bore changes the stiffness of both in the same way
// at any helix. Half the root circle is the default of a sun.
constexpr double kBore = 0.5;

// The mean against ISO 6336 with helix within 10 %.
TEST(HelicalMesh, AgreesWithTheStandardOnItsMean) {
  for (const auto& [first, second] : {std::pair{62, 62}, {30, 40}, {21, 39}}) {
    for (const double angle : {0.0, 7.5, 15.0, 25.0, 30.0}) {
      GearPair pair = helical_pair(first, second, angle * degree);
      pair.bore = kBore * 2.0 * pair_geometry(pair).gears[0].root_radius;
      const PairGeometry geometry = pair_geometry(pair);
      const Iso6336Stiffness standard = iso6336_stiffness(
          {first, second, 0.0, 0.0, pair.rack, geometry.contact_ratio, {}, pair.helix_angle});
      EXPECT_TRUE(standard.in_range);
      const double ours = mesh_stiffness(meshing(pair)).curve.mean() / pair.face_width;
      RecordProperty("ratio", std::to_string(ours / standard.mesh));
      EXPECT_NEAR(ours / standard.mesh, 1.0, 0.10) << first << "/" << second << " at " << angle << " deg";
    }
  }
}

// By hand: virtual teeth and cos(helix).
TEST(HelicalMesh, OfTheStandardIsThatOfVirtualTeeth) {
  const double helix = 20.0 * degree, base = std::asin(std::sin(helix) * std::cos(20.0 * degree));
  const double virtual_teeth = 30.0 / (std::pow(std::cos(base), 2) * std::cos(helix));
  const Iso6336Stiffness found = iso6336_stiffness({30, 0, 0.0, 0.0, {}, 1.5, {}, -helix});
  EXPECT_NEAR(1e9 / found.theoretical_single, 0.04723 + 0.15551 / virtual_teeth, 1e-12);
  const Iso6336Stiffness spur = iso6336_stiffness({30, 0, 0.0, 0.0, {}, 1.5, {}});
  EXPECT_NEAR((found.single / found.theoretical_single) / (spur.single / spur.theoretical_single),
              std::cos(helix), 1e-12);
  EXPECT_FALSE(iso6336_stiffness({30, 0, 0.0, 0.0, {}, 1.5, {}, 31.0 * degree}).in_range);
}

TEST(PeriodicCurveIntegral, IsThatOfItsCubics) {
  const PeriodicCurve curve([](double f) { return f < 0.3 ? 1.0 + f * f : 2.0 - f; }, {0.0, 0.3}, 40);
  const auto primitive = [](double f) {  // from 0 on, within the first period
    return f < 0.3 ? f + f * f * f / 3.0 : 0.309 + 2.0 * (f - 0.3) - 0.5 * (f * f - 0.09);
  };
  const double whole = primitive(1.0);
  EXPECT_NEAR(curve.integral(0.1, 0.2), primitive(0.2) - primitive(0.1), 1e-9);
  EXPECT_NEAR(curve.integral(0.1, 0.9), primitive(0.9) - primitive(0.1), 1e-9);
  EXPECT_NEAR(curve.integral(-0.4, 0.1), whole - primitive(0.6) + primitive(0.1), 1e-9);
  EXPECT_NEAR(curve.integral(-2.4, 3.1), 5.0 * whole + (whole - primitive(0.6) + primitive(0.1)), 1e-8);
  EXPECT_NEAR(curve.integral(0.2, 0.2 + 1e-9) / 1e-9, 1.04, 1e-6);
  EXPECT_EQ(curve.integral(0.7, 0.7), 0.0);
  EXPECT_EQ(PeriodicCurve::constant(3.0).integral(-1.5, 1.0), 7.5);
}

}  // namespace
}  // namespace orbearing::gearset::helical_mesh_test

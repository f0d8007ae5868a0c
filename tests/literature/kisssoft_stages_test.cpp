// Two planetary stages of a 5 MW gearbox as a commercial program reports them [Reboucas2021]: spur gears of
// steel with ISO 53 profile A, c' and c_gamma-alpha of ISO 6336-1, method B.
#include <gtest/gtest.h>

#include <algorithm>

#include "gearset/mesh/iso6336.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset::kisssoft_stages_test {
namespace {

constexpr double published_shift = 0.5e-4;      // [module]  half of the last digit
constexpr double published_stiffness = 0.5e-3;  // [N/(mm um)]
constexpr double published_contact_ratio = 0.5e-3;
constexpr double unit = 1e9;  // [Pa] of 1 N/(mm um)

// The web factor printed for all four meshes, for webs of a quarter of the face width; method B is used
// without one here, for gears of one piece.
constexpr double web_factor = 0.862;
constexpr double published_web_factor = 0.5e-3;

struct ReportedMesh {
  double contact_ratio;
  double single;  // [N/(mm um)]  c'
  double mesh;    // [N/(mm um)]  c_gamma-alpha
};

struct ReportedStage {
  PlanetarySet set;  // the ring's shift is printed with the other sign
  double planet_shift;
  ReportedMesh sun;
  ReportedMesh ring;
};

constexpr BasicRack profile_a{};

const ReportedStage stages[] = {
    {{19, 17, 56, 3, 45e-3, profile_a, 0.6170, 0.5013, 491e-3, 0.0},
     0.8021,
     {1.115, 12.362, 13.426},
     {1.278, 13.289, 16.063}},
    {{18, 36, 93, 3, 21e-3, profile_a, 0.3890, -0.1171, 550e-3, 0.0},
     0.5039,
     {1.370, 12.240, 15.640},
     {1.618, 14.053, 20.563}},
};

Iso6336Stiffness of_sun_mesh(const ReportedStage& stage) {
  return iso6336_stiffness({stage.set.sun_teeth,
                            stage.set.planet_teeth,
                            stage.set.sun_shift,
                            stage.planet_shift,
                            stage.set.rack,
                            stage.sun.contact_ratio,
                            {}});
}

Iso6336Stiffness of_ring_mesh(const ReportedStage& stage) {
  return iso6336_stiffness({stage.set.planet_teeth,
                            0,
                            stage.planet_shift,
                            -stage.set.ring_shift,
                            stage.set.rack,
                            stage.ring.contact_ratio,
                            {}});
}

// Both meshes closed at one centre distance give the planet the shift that is printed; the shifts of sun and
// ring are known to half a digit each, and it follows each of them by less than one to one.
TEST(KisssoftStages, PlanetShift) {
  for (const ReportedStage& stage : stages)
    EXPECT_NEAR(working_geometry(stage.set).planet_shift, stage.planet_shift, 3.0 * published_shift);
}

TEST(KisssoftStages, OneWebFactorExplainsAllMeshes) {
  std::vector<double> ratios;
  for (const ReportedStage& stage : stages) {
    ratios.push_back(stage.sun.single * unit / of_sun_mesh(stage).single);
    ratios.push_back(stage.ring.single * unit / of_ring_mesh(stage).single);
  }
  // Each is known to half a digit of its c'.
  const double spread = 2.0 * published_stiffness / 12.240;
  const auto [least, largest] = std::minmax_element(ratios.begin(), ratios.end());
  EXPECT_LT(*largest - *least, spread);
  for (const double ratio : ratios) EXPECT_NEAR(ratio, web_factor, published_web_factor);
}

TEST(KisssoftStages, MeshStiffnessFollowsTheContactRatio) {
  const auto expect_mean = [](const Iso6336Stiffness& ours, const ReportedMesh& published) {
    EXPECT_NEAR(ours.mesh / ours.single, published.mesh / published.single,
                0.75 * published_contact_ratio + 2.0 * published_stiffness / published.single);
  };
  for (const ReportedStage& stage : stages) {
    expect_mean(of_sun_mesh(stage), stage.sun);
    expect_mean(of_ring_mesh(stage), stage.ring);
  }
}

}  // namespace
}  // namespace orbearing::gearset::kisssoft_stages_test

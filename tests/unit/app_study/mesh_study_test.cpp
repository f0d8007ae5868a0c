#include "app/study/mesh_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/validation_table.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::mesh_study_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

ResolvedCase pair_case(const std::vector<std::string>& settings = {}) {
  return read_case(ORBEARING_SOURCE_DIR "/cases/mesh_62_62/case.yaml", settings);
}

std::vector<std::string> pair_mistakes(const std::string& setting) {
  try {
    pair_case({setting});
  } catch (const BadInput& error) {
    return error.messages;
  }
  return {};
}

TEST(GearPairCase, TellsWhatDoesNotFit) {
  EXPECT_THAT(pair_mistakes("pair.teeth=[20]"), Contains(HasSubstr("pair.teeth: a list of 1; 2 values")));
  EXPECT_THAT(pair_mistakes("pair.profile_shift=[0, 0, 0]"),
              Contains(HasSubstr("pair.profile_shift: a list of 3")));
  EXPECT_THAT(pair_mistakes("pair.bore=130 mm"),
              Contains(HasSubstr("pair.bore: found a bore of 130.000 mm")));
  EXPECT_THAT(pair_mistakes("pair.teeth=[4, 20]"), Contains(HasSubstr("at least 5")));
  EXPECT_THAT(pair_mistakes("pair.root_fillet_radius=0.6"), Contains(HasSubstr("fits on the rack's tip")));
  EXPECT_THAT(pair_mistakes("gearset.planets=4"), Contains(HasSubstr("gear-pair does not use")));
}

double mean(const ResolvedCase& in) {
  return mesh_study(in).meshes.front().stiffness.curve.mean();  // [N/m]
}

TEST(GearPairCase, MayLeaveOutRackAndShifts) {
  const ResolvedCase short_case = parse_case(R"(name: small
source: made up
model: gear-pair
pair:
  teeth: [62, 62]
  module: 2 mm
  face_width: 20 mm
  bore: 35 mm
)",
                                             "case.yaml", {});
  EXPECT_EQ(mean(short_case), mean(pair_case()));
}

// Meshes are kept for points that share them, and for no others.
TEST(MeshStudy, KeptMeshesAreThoseOfTheirOwnCase) {
  const auto sun_mean = [](const std::vector<std::string>& settings) {
    return planetary_meshes_of(shipped(settings)).sun.curve.mean();
  };
  const double mean = sun_mean({});
  EXPECT_EQ(sun_mean({"input.speed=3000 rpm", "input.power=10 kW", "bearing.radial_clearance=5 um"}), mean);
  EXPECT_NEAR(sun_mean({"material.youngs_modulus=412 GPa"}) / mean, 2.0,
              1e-9);  // round-off of the quadrature
  for (const char* other : {"material.poisson_ratio=0.2", "gearset.face_width=26 mm", "gearset.module=3.2 mm",
                            "gearset.root_fillet_radius=0.3", "gearset.sun_bore_ratio=0.3",
                            "bearing.outside_diameter=45 mm", "gearset.profile_shift.sun=0.27"})
    EXPECT_NE(sun_mean({other}), mean) << other;
  const auto first_lag = [](const std::vector<std::string>& settings) {
    return planetary_meshes_of(shipped(settings)).ring_lag.front();
  };
  EXPECT_NE(first_lag({"input.member=carrier"}), first_lag({}));  // the other flanks carry
  EXPECT_EQ(sun_mean({}), mean);
}

TEST(MeshStudy, FollowsTheSettings) {
  const double as_stated = mean(pair_case());
  EXPECT_NEAR(mean(pair_case({"pair.face_width=40 mm"})), 2.0 * as_stated, 1e-9 * as_stated);
  EXPECT_NEAR(mean(pair_case({"material.youngs_modulus=103 GPa"})), 0.5 * as_stated, 1e-9 * as_stated);
}

TEST(MeshStudy, StandardStiffnessOfAPairDoesNotDependOnTheOrderOfItsGears) {
  const auto single = [](const std::string& teeth) {
    return mesh_study(pair_case({"pair.teeth=" + teeth, "pair.bore=20 mm"})).meshes.front().standard.single;
  };
  EXPECT_EQ(single("[30, 20]"), single("[20, 30]"));
}

// The shift of the ring, positive outward in a case, is -x_2 in the standard's formula.
TEST(MeshStudy, StandardStiffnessOfARingMeshFeelsTheRingsShift) {
  const MeshStudy study = mesh_study(shipped());
  constexpr double ring_shift = 0.4146;
  const double planet_shift = gearset::working_geometry(drivetrain_of(shipped()).set).planet_shift;
  const double without =
      gearset::iso6336_stiffness({22, 0, planet_shift, 0.0, {}, 1.6, {}}).theoretical_single;
  EXPECT_NEAR(1e9 / study.meshes[7].standard.theoretical_single,
              1e9 / without + 0.00193 * ring_shift + 0.00182 * ring_shift * ring_shift, 1e-12);
}

TEST(MeshStudy, OfAModelWithoutMeshesIsRefused) {
  EXPECT_THROW(mesh_study(parse_case(bearing_case, "case.yaml", {})), BadInput);
}

TEST(MeshStudy, OfASetHasAMeshForEachPlanetAndWheel) {
  const MeshStudy study = mesh_study(shipped());
  ASSERT_EQ(study.meshes.size(), 8U);
  EXPECT_EQ(study.meshes[0].name, "sun-planet 1");
  EXPECT_EQ(study.meshes[7].name, "ring-planet 4");
  EXPECT_EQ(study.meshes[0].phase, 0.0);
  EXPECT_NEAR(study.meshes[1].phase, 0.25, 1e-12);
  EXPECT_THAT(study.warnings, Contains(HasSubstr("Sainsot")));
}

// With the sun held and the ring driving, the sun rotates backwards relative to the carrier: phases run the
// other way.
TEST(MeshStudy, TurnsPhasesWithTheSun) {
  const MeshStudy study = mesh_study(shipped({"gearset.fixed=sun", "input.member=ring"}));
  EXPECT_NEAR(study.meshes[1].phase, 0.75, 1e-12);
}

TEST(MeshStudy, FeelsTheBodiesOfSunAndRing) {
  const double sun = mesh_study(shipped()).meshes[0].stiffness.curve.mean();
  const double ring = mesh_study(shipped()).meshes[4].stiffness.curve.mean();
  EXPECT_GT(mesh_study(shipped({"gearset.sun_bore_ratio=0.7"})).meshes[0].stiffness.curve.mean(), sun);
  EXPECT_GT(mesh_study(shipped({"gearset.ring_outside_ratio=1.05"})).meshes[4].stiffness.curve.mean(), ring);
}

TEST(MeshesJson, HoldsTheKeysOfTheContract) {
  Record record;
  describe(record, mesh_study(pair_case()));
  const nlohmann::ordered_json meshes = json_of(record).at("meshes");
  ASSERT_EQ(meshes.size(), 1U);
  const nlohmann::ordered_json& mesh = meshes[0];
  for (const char* key : {"contact_ratio", "mean_N_per_m", "min_N_per_m", "max_N_per_m", "phase"})
    EXPECT_TRUE(mesh.at(key).is_number()) << key;
  for (const char* key :
       {"bending_N_per_m", "shear_N_per_m", "axial_N_per_m", "foundation_N_per_m", "hertz_N_per_m"})
    EXPECT_GT(mesh.at("at_pitch_point").at(key).get<double>(), 0.0) << key;
  double sum = 0.0;
  for (const auto& point : mesh.at("curve")) {
    EXPECT_GE(point.at(1).get<double>(), mesh.at("min_N_per_m").get<double>());
    EXPECT_LE(point.at(1).get<double>(), mesh.at("max_N_per_m").get<double>());
    sum += point.at(1).get<double>();
  }
  const double of_the_jumps = 0.5 / 200.0;  // half a step of the curve, times a jump less than the mean
  const double mean = mesh.at("mean_N_per_m").get<double>();
  EXPECT_NEAR(sum / static_cast<double>(mesh.at("curve").size()), mean, of_the_jumps * mean);
}

ValidationOptions meshes_alone() {
  ValidationOptions options;
  options.result_of = [](const std::string&, const std::string&, const ResolvedCase& in) {
    Record record;
    describe(record, mesh_study(in));
    return json_of(record);
  };
  return options;
}

TEST(PairValidationTable, TakesASettingIntoItsRow) {
  const ExpectedFile expected{.published = {{.source = "made up",
                                             .quantity = "mesh:/meshes/0/iso6336/c_th_N_per_mm_um",
                                             .meaning = "",
                                             .value = 15.7227,
                                             .tolerance = 1e-4,
                                             .settings = {"pair.teeth=[30, 20]"}},
                                            {.source = "made up",
                                             .quantity = "mesh:/meshes/0/contact_ratio",
                                             .meaning = "",
                                             .value = 2.0,
                                             .tolerance = 1e-3}}};
  const ValidationTable table = validation_table_of(pair_case(), expected, meshes_alone());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].verdict, "reproduced");
  EXPECT_EQ(table.rows[0].reading, "pair.teeth=[30, 20]");
  EXPECT_EQ(table.rows[1].verdict, "missed");
}

TEST(PairValidationTable, OfTheShippedCaseReproducesAll) {
  const std::string file = ORBEARING_SOURCE_DIR "/cases/mesh_62_62/case.yaml";
  const ValidationTable table =
      validation_table_of(pair_case(), read_expected(expected_beside(file)), meshes_alone());
  EXPECT_EQ(table.rows.size(), 17U);
  for (const ValidationRow& row : table.rows)
    EXPECT_EQ(row.verdict, "reproduced") << row.published.quantity << row.reading;
}

}  // namespace
}  // namespace orbearing::app::mesh_study_test

// Contents of a report: resonances that were computed, published numbers of the same case, missing points of
// a sweep.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/case/drivetrain_reader.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/report_data.hpp"
#include "app/study/resonance_lines.hpp"
#include "app/study/sweep_study.hpp"
#include "app/units.hpp"
#include "gearset/working_geometry.hpp"
#include "tests/messages.hpp"

namespace orbearing::app::report_truth_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ResolvedCase reducer(const std::vector<std::string>& settings = {}) {
  return read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

/// At the speed of a resonance a harmonic of the mesh frequency is a natural frequency there.
TEST(Resonance, MeetsItsModeAtItsOwnSpeed) {
  const ResolvedCase resolved = reducer().without_sweep();
  const std::vector<Resonance> found = resonances(resolved, 4000.0, 9000.0);
  ASSERT_FALSE(found.empty());
  for (const Resonance& resonance : found) {
    const diagnosis::ModesAtSpeed there = modes_at_rpm(resolved, resonance.speed * kRpm);
    double nearest = 1e9;
    for (const diagnosis::NamedFrequency& mode : there.modes)
      if (mode.name == resonance.mode)
        nearest = std::min(nearest, std::abs(mode.frequency - resonance.frequency) / resonance.frequency);
    constexpr double solved = 1e-8;  // of the search, and of the equilibrium of the stiffness
    EXPECT_LT(nearest, solved) << resonance.mode << " at " << resonance.speed * kRpm << " rpm";
    EXPECT_NEAR(resonance.harmonic * there.mesh_frequency / resonance.frequency, 1.0, solved);
  }
}

ResolvedCase gears() {
  return parse_case(R"(name: gears alone
source: none
model: planetary-drivetrain
input: {power: 150 kW, speed: 18000 rpm}
gearset:
  planets: 3
  teeth: {sun: 36, planet: 22, ring: 81}
  profile_shift: {sun: 0.2, ring: 0.3}
  module: 3 mm
  face_width: 28 mm
  dynamics: {observed_periods: 2, settling_periods: 100}
)",
                    "gears.yaml");
}

constexpr double kAtTheRoot = 1e-4;  // [deg]  where the flank runs round, of the last digit of a radius

// Half the tooth's angle at each radius of its flank, whichever way the flank was made.
template <class Tooth>
void expect_flank_of(const Tooth& tooth, const nlohmann::ordered_json& gear) {
  ASSERT_EQ(gear["radius_mm"].size(), gear["half_angle_deg"].size());
  ASSERT_GT(gear["radius_mm"].size(), 10U);
  for (std::size_t i = 0; i < gear["radius_mm"].size(); ++i) {
    const double inside =
        std::clamp(1e-3 * gear["radius_mm"][i].get<double>(), std::min(tooth.root_radius, tooth.tip_radius),
                   std::max(tooth.root_radius, tooth.tip_radius));
    EXPECT_NEAR(gear["half_angle_deg"][i].get<double>(), kDegree * half_thickness_angle(tooth, inside),
                kAtTheRoot)
        << gear["name"] << " at " << gear["radius_mm"][i] << " mm";
  }
}

TEST(GearReport, FlanksAreThoseOfTheTeeth) {
  const ResolvedCase in = gears();
  const gearset::WorkingGeometry geometry =
      gearset::working_geometry(with_bore(stated_drivetrain(in).single()));
  const nlohmann::ordered_json pairs = gear_report(in, {18000.0})["tooth_pairs"];
  expect_flank_of(geometry.sun, pairs[0]["gears"][0]);
  expect_flank_of(geometry.planet, pairs[0]["gears"][1]);
  expect_flank_of(geometry.planet, pairs[1]["gears"][0]);
  expect_flank_of(geometry.ring, pairs[1]["gears"][1]);
}

/// Differences from the published case are named, as they are written; points that are computed are not
/// inputs, and another unit is not another value.
TEST(PublishedComparison, NamesChangedInputs) {
  const auto changed = [](const std::vector<std::string>& settings) {
    return changed_inputs(reducer(settings), reducer());
  };
  EXPECT_THAT(changed({}), IsEmpty());
  EXPECT_THAT(
      changed({"gearset.face_width=0.028 m", "input.speed=3000 rpm", "sweep={input.speed: [1000 rpm]}"}),
      IsEmpty());
  EXPECT_THAT(changed({"input.power=75 kW", "bearing.rollers=12"}),
              ElementsAre("input.power: 75 kW (published: 150 kW)", "bearing.rollers: 12 (published: 15)"));
  EXPECT_THAT(changed({"bearing.laminae=30"}), ElementsAre("bearing.laminae: 30 (published: not stated)"));
}

TEST(PublishedComparison, OfAChangedCaseNothingIsCompared) {
  const PublishedComparison same =
      published_comparison(reducer({"sweep={input.speed: [3000 rpm, 9000 rpm]}"}));
  EXPECT_FALSE(same.table.rows.empty());
  for (const ValidationRow& row : same.table.rows) {  // on the published grid of speeds, whatever was swept
    if (row.published.quantity != "peak_speed_rpm") continue;
    EXPECT_DOUBLE_EQ(row.ours.value(), 6000.0);
  }
  const PublishedComparison other = published_comparison(reducer({"input.power=75 kW"}));
  EXPECT_THAT(other.table.rows, IsEmpty());
  EXPECT_EQ(other.changed.size(), 1U);
}

/// The rows of a sweep as its manifest has them.
Manifest manifest_of(const ResolvedCase& resolved, const std::vector<std::size_t>& points) {
  const SweepRequest request = sweep_request(resolved, "quasi-static");
  Manifest manifest{.header = request.header};
  for (const std::size_t point : points)
    manifest.entries[point] = {point_file_name(point), "",
                               sweep_row(request.evaluate(point), request.header)};
  return manifest;
}

TEST(MissingPoints, AreNamed) {
  const ResolvedCase resolved = reducer({"sweep={input.speed: [3000 rpm, 6000 rpm, 9000 rpm]}"});
  Manifest whole = manifest_of(resolved, {0, 1, 2});
  EXPECT_TRUE(missing_points(resolved, whole).none());
  EXPECT_TRUE(missing_json(missing_points(resolved, whole), whole).is_null());
  whole.header->refined = true;  // yet no point was added
  EXPECT_TRUE(missing_points(resolved, whole).peak_unfinished);
  Manifest part = manifest_of(resolved, {0, 2});
  part.header->shard = Shard{1, 2};
  const MissingPoints missing = missing_points(resolved, part);
  EXPECT_THAT(missing.labels, ElementsAre("input.speed = 6000 rpm"));
  EXPECT_THAT(
      missing_text(missing, part),
      HasSubstr("1 of 3 points of the sweep are missing (this is shard 1/2): input.speed = 6000 rpm; merge"));
  EXPECT_EQ(missing_json(missing, part)["found"], 2);
}

/// An unknown fidelity is reported as such, and not as "map::at".
TEST(Fidelity, AnUnknownNameIsRefused) {
  EXPECT_REFUSED(BadInput, "fidelity", fidelity_of("crown"));
}

}  // namespace
}  // namespace orbearing::app::report_truth_test

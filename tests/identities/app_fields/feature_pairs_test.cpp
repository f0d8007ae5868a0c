// Combined features: for every two of them a change of the case with a known correct result. Each feature has
// changes that leave a case with it unchanged:
//   uneven planets    each planet takes the pin of the one before it: the planets' results go round
//   helical teeth     the drivetrain in a mirror across its axis: forces along it turn round, lives do not
//   several sets      a set in front is the set alone, and the one behind it is that set on its own shaft
//   oil               the life by cleanliness is added to the others, which stay; all together by its own
//   computed tilt     the mirror again, with the bearings of a planet in reverse order
//   load spectrum     a bin in two halves, and both bins in the other order; damage adds up
//   elastic rim       the stiffer its material, the nearer it is to a rigid one, and nearly with its modulus
//   laminae           the mirror again, with profiles in reverse; straight ones are as whole contacts
//   defect            the same vibration, since it does not depend on the other; or it is mirrored, or bends
//                     as above; in the set in front it is that of the set alone
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "tests/identities/app_fields/analysis_results.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::feature_pairs_test {
namespace {

using fields_test::indented;
using fields_test::kBearing;
using testing::HasSubstr;

using Values = std::map<std::string, std::string>;  // by path, without the set's prefix

enum Feature { uneven, helical, several, oil, tilt, spectrum, rim, laminae, defect, feature_count };
const char* const names[] = {"uneven",   "helical", "several", "oil",   "tilt",
                             "spectrum", "rim",     "laminae", "defect"};

using Features = std::set<Feature>;

// All planets mesh in phase, so that they may change places.
const std::string kGears = R"(gearset:
  planets: 4
  teeth: {sun: 36, planet: 22, ring: 80}
  module: 3 mm
  profile_shift: {sun: 0.2, ring: 0.3}
  face_width: 28 mm
)";

// Powers of the spectrum's bins; the first is that of the case.
constexpr double kPower = 30.0, kLess = 24.0;          // [kW]
constexpr double kSpeed = 18000.0, kSlower = 12000.0;  // [rpm]

std::string text_of(bool several_sets, double power, double speed) {
  const std::string head = fmt::format(
      "name: pairs\nsource: none\nmodel: planetary-drivetrain\ninput: {{power: {} kW, speed: {} rpm}}\n",
      power, speed);
  if (!several_sets) return head + kGears + kBearing;
  const std::string set = indented(kGears) + indented(kBearing);
  return head +
         "shafts:\n  input: [motor, first.sun]\n  middle: [first.carrier, second.sun]\n"
         "  output: [second.carrier, load]\n  housing: [ground, first.ring, second.ring]\n"
         "sets:\n  first:\n" +
         set + "  second:\n" + set;
}

Values values_of(const Features& features) {
  const auto has = [&](Feature one) { return features.contains(one); };
  Values values{{"bearing.profile.kind", has(laminae) ? "table" : "straight"}};
  if (has(uneven)) values["gearset.dynamics.pin_error.tangential"] = "[3 um, 0 um, 1 um, 0 um]";
  if (has(helical)) values["gearset.helix_angle"] = "12 deg";
  if (has(oil)) values.insert({{"lubricant.grade", "ISO VG 220"}, {"life.cleanliness", "high"}});
  if (has(laminae))
    values.insert({{"bearing.laminae", "10"},
                   {"bearing.profile.x", "[-2.8 mm, 0 mm, 2.8 mm]"},
                   {"bearing.profile.drops", "[8 um, 0 um, 3 um]"}});
  if (has(laminae) && !has(tilt)) values["bearing.misalignment.planet_tilt"] = "0.4 mrad";
  if (has(tilt))
    values.insert({{"bearing.laminae", "10"},
                   {"bearing.per_planet", "2"},
                   {"bearing.tilt_state", "computed"},
                   {"bearing.clearance_differences", "[4 um, 0 um]"}});
  if (has(spectrum))
    values["spectrum"] = fmt::format(
        "[{{power: {} kW, speed: {} rpm, share: 0.25}}, {{power: {} kW, speed: {} rpm, share: 0.75}}]",
        kPower, kSpeed, kLess, kSlower);
  if (has(rim)) values["gearset.planet_rim"] = "elastic";
  if (has(defect))
    values.insert({{"defect.race", "outer"},
                   {"defect.width", "0.3 mm"},
                   {"defect.depth", "0.1 mm"},
                   {"signal.sampling_rate", "60 kHz"},
                   {"signal.carrier_revolutions", "0.2"},
                   {"signal.carrier_settling", "0.02"},
                   {"simulation.length_error", "2e-6 mm"}});
  return values;
}

// In a mirror across the axis of the drivetrain.
Values mirrored(Values values) {
  const auto put = [&](const char* path, const char* value) {
    if (values.contains(path)) values[path] = value;
  };
  put("gearset.helix_angle", "-12 deg");
  put("bearing.clearance_differences", "[0 um, 4 um]");
  put("bearing.profile.drops", "[3 um, 0 um, 8 um]");
  put("bearing.misalignment.planet_tilt", "-0.4 mrad");
  return values;
}

// Settings where the case is one of the set `set`, or of a single set.
std::vector<std::string> settings_of(const Values& values, const std::string& set) {
  std::vector<std::string> settings;
  for (const auto& [path, value] : values) {
    const Field* field = find_field(path);
    const bool of_set = !set.empty() && field != nullptr && in_each_set(*field);
    settings.push_back((of_set ? set_prefix(set) : "") + path + "=" + value);
  }
  return settings;
}

ResolvedCase resolved(const Values& values, bool several_sets = false, double power = kPower,
                      double speed = kSpeed) {
  return parse_case(text_of(several_sets, power, speed), "pairs.yaml",
                    settings_of(values, several_sets ? "first" : ""));
}

analysis::PointResult point(const ResolvedCase& in) {
  return analysis::evaluate(bearing_sets(in));
}

double number(const analysis::PointResult& result, const std::string& column) {
  return number_named({}, sweep_row(result, {}), column);
}

void expect_equal(double a, double b, const std::string& what, double within = 1e-9) {
  if (std::isnan(a) && std::isnan(b)) return;  // neither has it
  EXPECT_NEAR(a, b, within * std::abs(b)) << what;
}

// Columns in which no place along the axis and no sense of rotation shows.
const std::vector<std::string> kLives{"life_h", "system_life_h", "L10mh", "system_L10mh"};
const std::vector<std::string> kScalars{"planet_load_N",           "inner_load_max_N", "inner_load_rms_N",
                                        "outer_load_max_N",        "film_inner_um",    "film_outer_um",
                                        "contact_pressure_max_MPa"};

void expect_like(const analysis::PointResult& a, const analysis::PointResult& b, double within) {
  for (const std::vector<std::string>* columns : {&kLives, &kScalars})
    for (const std::string& column : *columns)
      expect_equal(number(a, column), number(b, column), column, within);
}

// Lives under the spectrum and points of its bins.
double life_under_spectrum(const ResolvedCase& in, const char* key) {
  SweepRequest request = sweep_request(in, "quasi-static");
  request.quiet = true;
  const SweepOutcome outcome = run_sweep(request);
  const nlohmann::ordered_json json = spectrum_json(outcome.header, outcome.spectra);
  return json.contains(key) && json[key].is_number() ? json[key].get<double>() : std::nan("");
}

// Iterations end where displacements no longer change, and the mirror takes them in another order.
constexpr double kSearched = 1e-6;

void check_mirror(const Values& values) {
  const analysis::PointResult here = point(resolved(values)), there = point(resolved(mirrored(values)));
  expect_like(here, there, kSearched);
  for (const char* along : {"axial_mesh_force_N", "overturning_moment_N_m", "sun_thrust_N"})
    expect_equal(number(here, along), -number(there, along), along);
  ASSERT_EQ(here.seats.size(), there.seats.size());
  const std::size_t per_planet =
      here.planets.empty() ? here.seats.size() : here.seats.size() / here.planets.size();
  for (std::size_t k = 0; k < here.seats.size(); ++k) {
    const analysis::SeatResult &one = here.seats[k],
                               &other = there.seats[k + per_planet - 1 - 2 * (k % per_planet)];
    expect_equal(one.life_hours, other.life_hours, "life of a bearing", kSearched);
    EXPECT_LT((one.tilt + other.tilt).norm(), 1e-5 * one.tilt.norm());
  }
}

// All planets push the sun along the axis, each by what it gets from it.
void check_thrust(const analysis::PointResult& result, int planets) {
  expect_equal(number(result, "sun_thrust_N"), -planets * number(result, "axial_mesh_force_N"), "thrust");
}

void check_rotation(const Values& values) {
  const analysis::PointResult here = point(resolved(values));
  Values turned = values;
  turned["gearset.dynamics.pin_error.tangential"] = "[0 um, 3 um, 0 um, 1 um]";
  const analysis::PointResult there = point(resolved(turned));
  expect_like(here, there, kSearched);
  ASSERT_EQ(here.planets.size(), 4u);
  ASSERT_EQ(there.planets.size(), 4u);
  EXPECT_GT(here.planets[1].load_share, 1.01 * here.planets[0].load_share);  // its pin does not lag
  double modified = 0.0, basic = 0.0;
  for (std::size_t n = 0; n < 4; ++n) {
    const analysis::PlanetResult &one = here.planets[n], &next = there.planets[(n + 1) % 4];
    // A share may be none but for round-off.
    constexpr double round_off = 1e-14;
    EXPECT_NEAR(one.load_share, next.load_share, kSearched * std::abs(next.load_share) + round_off);
    expect_equal(one.life_hours, next.life_hours, "life", kSearched);
    expect_equal(one.rated_hours.modified, next.rated_hours.modified, "modified life", kSearched);
    for (std::size_t k = 0; k < here.seats.size() / 4; ++k)
      expect_equal(here.seats[here.seats.size() / 4 * n + k].life_hours,
                   there.seats[here.seats.size() / 4 * ((n + 1) % 4) + k].life_hours, "life of a bearing",
                   kSearched);
    basic = n == 0 ? one.life_hours : bearing::combined_life(basic, one.life_hours);
    modified = n == 0 ? one.rated_hours.modified : bearing::combined_life(modified, one.rated_hours.modified);
  }
  // System life: none of all bearings may fail; bearings side by side differ where they tilt.
  if (!here.seats.empty()) basic = here.seats.front().life_hours;
  for (std::size_t k = 1; k < here.seats.size(); ++k)
    basic = bearing::combined_life(basic, here.seats[k].life_hours);
  expect_equal(number(here, "system_life_h"), basic, "all planets");
  if (here.rating.lives.oil)
    expect_equal(number(here, "system_L10mh"), modified, "all planets by cleanliness");
  if (values.contains("gearset.helix_angle")) {
    check_thrust(here, 4);
    Values even = values;
    even.erase("gearset.dynamics.pin_error.tangential");
    expect_equal(number(here, "sun_thrust_N"), number(point(resolved(even)), "sun_thrust_N"),
                 "thrust of unlike planets", 1e-6);
  }
}

void check_oil(const Values& values) {
  Values dry = values;
  for (const char* path : {"lubricant.grade", "life.cleanliness"}) dry.erase(path);
  const ResolvedCase oiled = resolved(values);
  dry["lubricant.viscosity"] = oiled.given("lubricant.viscosity");  // the same films
  dry["lubricant.pressure_viscosity"] = oiled.given("lubricant.pressure_viscosity");
  const analysis::PointResult with = point(oiled), without = point(resolved(dry));
  for (const char* column : {"life_h", "system_life_h", "inner_load_max_N", "film_inner_um"})
    expect_equal(number(with, column), number(without, column), column, 1e-12);
  EXPECT_FALSE(without.rating.lives.oil);
  ASSERT_TRUE(with.rating.lives.oil);
  // Equal bearings have the combined life of their own modified lives.
  if (with.planets.empty() && with.seats.empty())
    expect_equal(number(with, "system_L10mh"), bearing::system_life(number(with, "L10mh"), 4), "of four");
  if (!with.seats.empty()) {
    const double planet =
        bearing::combined_life(with.seats[0].rated_hours.modified, with.seats[1].rated_hours.modified);
    expect_equal(number(with, "system_L10mh"), bearing::system_life(planet, 4), "of eight");
  }
}

// 1/L = sum of shares over the lives of the points.
void check_spectrum(Values values) {
  const std::vector<const char*> keys{"life_h", "system_life_h", "L10mh", "system_L10mh"};
  const ResolvedCase whole = resolved(values);
  Values halves = values, alone = values;
  halves["spectrum"] = fmt::format(
      "[{{power: {2} kW, speed: {3} rpm, share: 0.375}}, {{power: {0} kW, speed: {1} rpm, share: 0.25}}, "
      "{{power: {2} kW, speed: {3} rpm, share: 0.375}}]",
      kPower, kSpeed, kLess, kSlower);
  const ResolvedCase split = resolved(halves);
  alone.erase("spectrum");
  const analysis::PointResult first = point(resolved(alone)),
                              second = point(resolved(alone, false, kLess, kSlower));
  for (const char* key : keys) {
    SCOPED_TRACE(key);
    const double life = life_under_spectrum(whole, key);
    const double a = number(first, key), b = number(second, key);
    if (std::isnan(a)) continue;
    EXPECT_NEAR(life_under_spectrum(split, key) / life, 1.0, 1e-12);
    EXPECT_NEAR(life * (0.25 / a + 0.75 / b), 1.0, 1e-9);
  }
}

// A rim of a stiffer material, and of one four times as stiff: contacts of Palmgren have no modulus.
void check_rim(const Values& values) {
  double limit = 0.0;  // of a rigid rim, whose teeth and pins have the same modulus
  const auto beyond_rigid = [&](const char* modulus) {
    Values elastic = values;
    elastic["material.youngs_modulus"] = modulus;
    Values rigid = elastic;
    rigid.erase("gearset.planet_rim");
    limit = number(point(resolved(rigid)), "inner_load_max_N");
    return number(point(resolved(elastic)), "inner_load_max_N") - limit;
  };
  const double one = beyond_rigid("250 GPa"), other = beyond_rigid("1000 GPa");
  EXPECT_GT(std::abs(one), 1e-4 * limit);
  // One over the modulus were it small: a rim of 250 GPa bends so far that rollers share its load anew.
  EXPECT_GT(other / one, 0.25);
  EXPECT_LT(other / one, 0.4);
}

// Straight laminae at no tilt bear as the whole contact does.
void check_laminae(Values values) {
  if (values.contains("bearing.tilt_state")) return;  // which has no effect on whole contacts
  for (const char* path : {"bearing.profile.x", "bearing.profile.drops", "bearing.misalignment.planet_tilt"})
    values.erase(path);
  values["bearing.profile.kind"] = "straight";
  const analysis::PointResult cut = point(resolved(values));
  values.erase("bearing.laminae");
  const analysis::PointResult whole = point(resolved(values));
  for (const char* column : {"inner_load_max_N", "outer_load_rms_N", "film_inner_um",
                             "contact_pressure_max_MPa", "life_h", "system_life_h"})
    expect_equal(number(cut, column), number(whole, column), column, 1e-5);
}

// The set in front has the input of a single one; behind its carrier the other has it at that speed.
void check_sets(const Values& values) {
  const analysis::PointResult chain = point(resolved(values, true));
  ASSERT_EQ(chain.sets.size(), 2u);
  const analysis::PointResult alone = point(resolved(values));
  Values plain;  // of the second set; what all sets share stays
  for (const auto& [path, value] : values)
    if (const Field* field = find_field(path); field != nullptr && !in_each_set(*field)) plain[path] = value;
  plain.erase("spectrum");
  const double rpm = chain.sets[0].carrier_speed * 30.0 / 3.14159265358979323846;
  const analysis::PointResult behind = point(resolved(plain, false, kPower, rpm));
  const analysis::PointResult* const single[] = {&alone, &behind};
  for (std::size_t i = 0; i < 2; ++i) {
    expect_equal(chain.sets[i].life_hours, number(*single[i], "life_h"), "life", 1e-8);
    expect_equal(chain.sets[i].planet_load, number(*single[i], "planet_load_N"), "load", 1e-8);
    if (chain.sets[i].rating.lives.oil)
      expect_equal(chain.sets[i].rating.hours.modified, number(*single[i], "L10mh"), "modified life", 1e-8);
  }
  for (const char* column : {"system_life_h", "system_L10mh"})
    expect_equal(number(chain, column), bearing::combined_life(number(alone, column), number(behind, column)),
                 column, 1e-8);
}

std::string vibration(const Values& values) {
  const ResolvedCase in = resolved(values);
  require_used(in, AnalysisId::planet_defect);
  return json_of(record_of(vibration_of_scratched_set(scratched_set_of(in)))).dump();
}

double level(const Values& values, bool several_sets = false) {
  return vibration_of_scratched_set(scratched_set_of(resolved(values, several_sets))).vibration.largest_load;
}

constexpr double kMoved = 1e-3;  // [-]  steps of the motion are those of its tolerance

// Inputs without effect on the vibration leave it unchanged, to the last bit.
void check_defect(Feature other, Values values) {
  Values changed = values;
  if (other == uneven) changed["gearset.dynamics.pin_error.radial"] = "[0 um, 0 um, 0 um, 0 um]";
  if (other == spectrum) changed.erase("spectrum");
  if (other == oil) {
    changed.erase("life.cleanliness");
    for (const char* path : {"lubricant.viscosity", "lubricant.pressure_viscosity"})
      changed[path] = resolved(values).given(path);
    changed.erase("lubricant.grade");
  }
  if (other == helical || other == laminae) {
    const double here = level(values), there = level(mirrored(values));
    expect_equal(here, there, "largest load", kMoved);
    return;
  }
  if (other == several) {  // the set in front has the input of a single one
    values["defect.set"] = "first";
    return expect_equal(level(values, true), level(changed), "largest load", kMoved);
  }
  if (other == tilt) {  // sound, the first bearing carries more with less clearance than the second
    values["defect.race"] = changed["defect.race"] = "none";
    values["bearing.clearance_differences"] = "[0 um, 30 um]";
    changed["bearing.clearance_differences"] = "[30 um, 0 um]";
    EXPECT_GT(level(values), 1.1 * level(changed));
    return;
  }
  if (other == rim) {
    changed["gearset.planet_rim"] = "rigid";
    EXPECT_NE(vibration(values), vibration(changed));
    return;
  }
  EXPECT_EQ(vibration(values), vibration(changed));
}

std::string refusal_of(const Features& features) {
  try {
    Values values = values_of(features);
    if (features.contains(several) && features.contains(defect)) values["defect.set"] = "first";
    const ResolvedCase in = resolved(values, features.contains(several));
    require_used(in, features.contains(defect) ? AnalysisId::planet_defect : AnalysisId::quasi_static);
    return "";
  } catch (const BadInput& error) {
    return error.what();
  }
}

class FeaturePair : public testing::TestWithParam<std::pair<Feature, Feature>> {};

TEST_P(FeaturePair, KeepsWhatBothKeep) {
  const auto [one, other] = GetParam();
  const Features features{one, other};
  ASSERT_EQ(refusal_of(features), "");
  Values values = values_of(features);
  if (other == defect) return check_defect(one, values);
  if (features.contains(several)) {
    if (features.contains(spectrum)) {
      Values alone = values;
      alone.erase("spectrum");
      const double a = number(point(resolved(alone, true)), "system_life_h");
      const double b = number(point(resolved(alone, true, kLess, kSlower)), "system_life_h");
      EXPECT_NEAR(life_under_spectrum(resolved(values, true), "system_life_h") * (0.25 / a + 0.75 / b), 1.0,
                  1e-9);
      return;
    }
    return check_sets(values);
  }
  if (features.contains(uneven)) check_rotation(values);
  if (features.contains(helical) || features.contains(tilt) || features.contains(laminae))
    check_mirror(values);
  if (features.contains(helical)) check_thrust(point(resolved(values)), 4);
  if (features.contains(oil)) check_oil(values);
  if (features.contains(spectrum)) check_spectrum(values);
  if (features.contains(rim)) check_rim(values);
  if (features.contains(laminae)) check_laminae(values);
}

std::vector<std::pair<Feature, Feature>> all_pairs() {
  std::vector<std::pair<Feature, Feature>> pairs;
  for (int one = 0; one < feature_count; ++one)
    for (int other = one + 1; other < feature_count; ++other)
      pairs.emplace_back(static_cast<Feature>(one), static_cast<Feature>(other));
  return pairs;
}

std::string pair_name(const testing::TestParamInfo<std::pair<Feature, Feature>>& pair) {
  return std::string(names[pair.param.first]) + "_and_" + names[pair.param.second];
}

INSTANTIATE_TEST_SUITE_P(AllPairs, FeaturePair, testing::ValuesIn(all_pairs()), pair_name);

// The film is least where the load is largest: by which power of it, is one for all ways to change the load.
TEST(LeastFilm, FollowsTheLargestLoadAlone) {
  const auto exponent = [](const Values& values, double power) {
    const analysis::PointResult plain = point(resolved({})), other = point(resolved(values, false, power));
    return std::log(number(other, "film_inner_um") / number(plain, "film_inner_um")) /
           std::log(number(other, "inner_load_max_N") / number(plain, "inner_load_max_N"));
  };
  constexpr double radii = 0.1;  // of the exponent: a clearance changes the radii of the contacts, too
  const double by_power = exponent({}, 1.5 * kPower);
  EXPECT_NEAR(exponent({{"bearing.radial_clearance", "25 um"}}, kPower) / by_power, 1.0, radii);
  EXPECT_NEAR(exponent({{"bearing.radial_clearance", "0 um"}}, 1.1 * kPower) / by_power, 1.0, radii);
}

// A pin inclined outward tilts its bearings in that plane, one inclined ahead in the other, and the file of
// the point has both under the names of its variables.
TEST(TiltsOfAFile, HaveTheirDirections) {
  const auto tilts = [](const char* direction) {
    const ResolvedCase in = resolved({{"bearing.laminae", "10"},
                                      {"bearing.tilt_state", "computed"},
                                      {std::string("support.pin_inclination.") + direction, "0.03 deg"}});
    const PointContent content = point_content(sweep_request(in, "quasi-static").header, 0, {}, point(in));
    std::pair<double, double> found;
    for (const NamedArray& array : content.arrays) {
      if (array.name == "bearing_tilt_x") found.first = array.values.at(0);
      if (array.name == "bearing_tilt_y") found.second = array.values.at(0);
    }
    return found;
  };
  const analysis::PointResult point_of_one =
      point(resolved({{"bearing.laminae", "10"},
                      {"bearing.tilt_state", "computed"},
                      {"support.pin_inclination.radial", "0.03 deg"}}));
  const auto outward = tilts("radial"), ahead = tilts("tangential");
  EXPECT_EQ(outward.first, point_of_one.seats.at(0).tilt.x());
  EXPECT_EQ(outward.second, point_of_one.seats.at(0).tilt.y());
  EXPECT_GT(std::abs(outward.first), 2.0 * std::abs(outward.second));
  EXPECT_GT(std::abs(ahead.second), 2.0 * std::abs(ahead.first));
}

// Three planets of which the last and the first are closest: which gap is the last one depends on where the
// count begins.
TEST(GapsOfPlanets, TheLastOneCountsAsTheOthers) {
  const auto refusal = [](const char* angles) -> std::string {
    try {
      resolved({{"gearset.planets", "3"}, {"gearset.planet_angles", angles}});
      return "";
    } catch (const BadInput& error) {
      return error.what();
    }
  };
  const double step = 360.0 / 116.0;  // [deg]  at which teeth fit
  const auto locations = [&](int second, int third) {
    return fmt::format("[0 deg, {:.4f} deg, {:.4f} deg]", second * step, third * step);
  };
  const std::string near_first = refusal(locations(14, 65).c_str()),
                    near_last = refusal(locations(51, 102).c_str());
  EXPECT_THAT(near_first, HasSubstr("neighbours must not touch"));
  EXPECT_EQ(near_last, near_first);
  EXPECT_EQ(refusal(locations(38, 77).c_str()), "");
}

}  // namespace
}  // namespace orbearing::app::feature_pairs_test

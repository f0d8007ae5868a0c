#include "app/study/crown/crown_study.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/units.hpp"
#include "bearing/profile/profile.hpp"

namespace orbearing::app {

namespace {

using nlohmann::ordered_json;
using namespace analysis::crowning;
using bearing::Race;
using bearing::profile::Profile;

constexpr int kMapDrops = 33, kMapTilts = 17, kFrontDrops = 17, kProfilePoints = 201;

// A profile under the name that the pictures give it.
struct Named {
  std::string name;
  Profile made;
};

struct Stage {
  const CrownRequest& request;
  CrownProblem problem;
  RollerPressure pressure;
  double advised_drop;       // [m]
  std::vector<Named> chief;  // straight, the standard's, the recommended
};

Profile advised_profile(const CrownProblem& problem, const ordered_json& advice) {
  const ProfileFamily family = family_in(problem, advice.at("profile"));
  const double share =
      advice.contains("crowned_share") ? advice.at("crowned_share").get<double>() : default_share(family);
  return profile_of(family, {1e-6 * advice.at("drop_um").get<double>(), share});
}

// With the drops that the study extended.
CrownRequest as_studied(CrownRequest request, const ordered_json& result) {
  constexpr double round_off = 1e-9, micro = 1e-6;
  double greatest = 0.0;  // [um]
  for (const ordered_json& point : result.at("points"))
    greatest = std::max(greatest, point.at("drop_um").get<double>());
  while (request.drops.back() < (1.0 - round_off) * micro * greatest)
    for (double& drop : request.drops) drop *= 2.0;
  return request;
}

Stage stage_of(const CrownRequest& request, const ordered_json& result) {
  const CrownProblem problem = problem_of(request);
  const ordered_json& advice = result.at("recommended");
  return {request,
          problem,
          RollerPressure(problem),
          1e-6 * advice.at("drop_um").get<double>(),
          {{"straight", bearing::profile::Straight{}},
           {"ISO/TS 16281", bearing::profile::Iso16281{problem.bearing.rollers().length,
                                                       problem.bearing.rollers().diameter, 1.0}},
           {advice.at("profile").get<std::string>() + ", recommended", advised_profile(problem, advice)}}};
}

std::vector<double> even(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
  return values;
}

template <class Values>
std::vector<double> scaled(const Values& values, double factor) {
  std::vector<double> out(values.begin(), values.end());
  for (double& value : out) value *= factor;
  return out;
}

ordered_json drawn_profile(const Named& profile, double length) {
  const std::vector<double> x = even(-0.5 * length, 0.5 * length, kProfilePoints);
  std::vector<double> drops;
  for (const double position : x) drops.push_back(1e6 * bearing::profile::drop(profile.made, position));
  return {{"profile", profile.name}, {"x_mm", scaled(x, 1e3)}, {"drop_um", drops}};
}

// Every kind, as deep as the recommended.
std::vector<Named> all_kinds(const Stage& stage) {
  std::vector<Named> kinds{stage.chief.front()};
  for (const std::string& name : family_names()) {
    const ProfileFamily family = family_in(stage.problem, name);
    kinds.push_back({name, profile_of(family, {std::max(stage.advised_drop, 1e-7), default_share(family)})});
  }
  return kinds;
}

// The duty whose bore load is greatest: where pressures are read.
std::size_t heaviest(const CrownProblem& problem) {
  const auto found = std::ranges::max_element(problem.duties, {},
                                              [](const Duty& duty) { return duty.point.bore_load.norm(); });
  return static_cast<std::size_t>(found - problem.duties.begin());
}

// Tilt [mrad] that is stated; null where it is computed.
ordered_json shown_tilt(const Stage& stage, double tilt) {
  if (stage.request.computes_tilt()) return nullptr;
  return 1e3 * tilt;
}

ordered_json pressure_curve(const Stage& stage, const Named& profile, double tilt) {
  const DutyLoads loads =
      loads_at(stage.problem, profile.made, lean_by(stage.problem, tilt), heaviest(stage.problem));
  const WorstRoller roller = worst_roller(stage.problem, loads, Race::inner);
  const auto found = stage.pressure.on(Race::inner, profile.made, roller.load, roller.tilt);
  return {{"profile", profile.name},
          {"tilt_mrad", shown_tilt(stage, tilt)},
          {"load_N", roller.load},
          {"x_mm", scaled(found.x, 1e3)},
          {"pressure_MPa", scaled(found.pressure, 1e-6)},
          {"peak_pressure_MPa", 1e-6 * found.peak_pressure},
          {"edge_ratio", found.edge_ratio}};
}

ordered_json pressure_curves(const Stage& stage) {
  ordered_json curves = ordered_json::array();
  std::vector<double> tilts{0.0};
  if (stage.request.tilts.back() > 0.0) tilts.push_back(stage.request.tilts.back());
  for (const double tilt : tilts)
    for (const Named& profile : all_kinds(stage)) curves.push_back(pressure_curve(stage, profile, tilt));
  return curves;
}

// Pressure along every roller of the load zone on the inner race of one bearing, at one cage angle out of
// four.
ordered_json zone_of(const Stage& stage, const Named& profile, double tilt, std::size_t bearing) {
  const DutyLoads all =
      loads_at(stage.problem, profile.made, lean_by(stage.problem, tilt), heaviest(stage.problem));
  const bearing::QuasiStaticResult& loads = all.bearings[bearing];
  const double half = 0.5 * stage.problem.bearing.rollers().length;
  ordered_json rows = ordered_json::array();
  std::vector<double> x;
  const std::size_t step = std::max<std::size_t>(1, loads.states.size() / 4);
  for (std::size_t s = 0; s < loads.states.size(); s += step)
    for (std::size_t j = 0; j < loads.states[s].rollers.size(); ++j) {
      const auto& roller = loads.states[s].rollers[j];
      std::vector<double> pressure;
      if (roller.inner.load > 1.0) {
        const auto found = stage.pressure.on(Race::inner, profile.made, roller.inner.load,
                                             roller.inner_end_displacement / half);
        pressure = scaled(found.pressure, 1e-6);
        x = scaled(found.x, 1e3);
      }
      rows.push_back({{"angle_deg", kDegree * loads.states[s].angle[static_cast<Eigen::Index>(j)]},
                      {"pressure_MPa", pressure}});
    }
  ordered_json zone{{"profile", profile.name}, {"tilt_mrad", shown_tilt(stage, tilt)}};
  if (stage.request.computes_tilt()) zone["bearing"] = bearing + 1;
  zone.update({{"x_mm", x}, {"places", rows}});
  return zone;
}

// Straight and best: without and with the greatest tilt that is stated, or the first and the last bearing of
// a planet.
ordered_json zones(const Stage& stage) {
  ordered_json all = ordered_json::array();
  const std::size_t last = stage.problem.seat ? stage.problem.seat->positions.size() - 1 : 0;
  const double most = stage.request.tilts.back();
  for (const Named& profile : {stage.chief.front(), stage.chief.back()}) {
    all.push_back(zone_of(stage, profile, 0.0, 0));
    if (last > 0 || most > 0.0) all.push_back(zone_of(stage, profile, most, last));
  }
  return all;
}

ordered_json rows_of(const Eigen::ArrayXXd& values) {
  ordered_json rows = ordered_json::array();
  for (const auto row : values.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

ordered_json life_map(const Stage& stage, const ordered_json& optimum) {
  const std::string name = optimum.at("profile");
  const ProfileFamily family = family_in(stage.problem, name);
  const double share =
      optimum.contains("crowned_share") ? optimum.at("crowned_share").get<double>() : default_share(family);
  const double asked =
      stage.request.computes_tilt() ? stage.request.tolerance.tilt : stage.request.tilts.back();
  const double most = std::max(1.25 * asked, stage.request.computes_tilt() ? 0.5e-3 : 1e-3);
  const std::vector<double> drops = even(0.0, stage.request.drops.back(), kMapDrops);
  const std::vector<double> tilts = even(0.0, most, kMapTilts);
  std::vector<Profile> profiles;
  for (const double drop : drops) profiles.push_back(profile_of(family, {drop, share}));
  return {{"profile", name},
          {"drop_um", scaled(drops, 1e6)},
          {"tilt_mrad", scaled(tilts, 1e3)},
          {"governing_life_h", rows_of(life_grid(stage.problem, profiles, tilts, 0))},
          {"drop_tolerance_um", 1e6 * stage.request.tolerance.drop},
          {"tilt_tolerance_mrad", 1e3 * stage.request.tolerance.tilt}};
}

ordered_json front_of(const Stage& stage, const std::string& name) {
  const ProfileFamily family = family_in(stage.problem, name);
  std::vector<double> drops = even(0.0, stage.request.drops.back(), kFrontDrops);
  std::vector<Profile> profiles;
  for (const double drop : drops) profiles.push_back(profile_of(family, {drop, default_share(family)}));
  const auto points = crown_grid(stage.problem, stage.pressure, profiles, drops, stage.request.tilts, 0, {});
  ordered_json front{{"profile", name}, {"points", ordered_json::array()}};
  for (const WorstOfTilts& one : worst_of_tilts(points, stage.request.tilts.size()))
    if (std::isfinite(one.life_hours))
      front["points"].push_back({{"drop_um", 1e6 * one.drop},
                                 {"governing_life_h", one.life_hours},
                                 {"peak_pressure_MPa", 1e-6 * one.peak_pressure},
                                 {"efficient", one.efficient}});
  return front;
}

ordered_json fronts(const Stage& stage) {
  ordered_json all = ordered_json::array();
  for (const std::string& name : family_names()) all.push_back(front_of(stage, name));
  return all;
}

// Life at each swept speed alone.
ordered_json speed_curves(const Stage& stage, const std::vector<double>& speeds) {
  ordered_json all = ordered_json::array();
  std::vector<double> tilts{0.0};
  if (stage.request.tilts.back() > 0.0) tilts.push_back(stage.request.tilts.back());
  std::vector<CrownProblem> problems;
  for (const double speed : speeds)
    problems.push_back(crown_problem(stage.request.drivetrain, stage.request.geometry, {{speed, 1.0, {}}},
                                     stage.request.method, stage.request.laminae));
  for (const double tilt : tilts)
    for (const Named& profile : stage.chief) {
      std::vector<double> lives;
      for (const CrownProblem& problem : problems)
        lives.push_back(life_hours(problem, profile.made, lean_by(problem, tilt)));
      all.push_back({{"profile", profile.name},
                     {"tilt_mrad", shown_tilt(stage, tilt)},
                     {"speed_rpm", scaled(speeds, kRpm)},
                     {"governing_life_h", lives}});
    }
  return all;
}

}  // namespace

ordered_json crown_figures(const ResolvedCase& resolved, const CrownRequest& request,
                           const ordered_json& result) {
  const CrownRequest studied = as_studied(request, result);
  const Stage stage = stage_of(studied, result);
  const bearing::CylindricalRollers& rollers = stage.problem.bearing.rollers();
  ordered_json profiles = ordered_json::array();
  for (const Named& profile : stage.chief) profiles.push_back(drawn_profile(profile, rollers.length));
  for (const Named& profile : all_kinds(stage))
    if (profile.name != "straight") profiles.push_back(drawn_profile(profile, rollers.length));
  return {{"roller_length_mm", 1e3 * rollers.length},
          {"roller_diameter_mm", 1e3 * rollers.diameter},
          {"profiles", profiles},
          {"pressure_speed_rpm", kRpm * stage.problem.duties[heaviest(stage.problem)].speed},
          {"pressure", pressure_curves(stage)},
          {"zone", zones(stage)},
          {"map", life_map(stage, result.at("optimum"))},
          {"fronts", fronts(stage)},
          {"speeds", speed_curves(stage, swept_speeds(resolved))}};
}

}  // namespace orbearing::app

#include "app/study/ball_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/case/ball_case.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/results/json_number.hpp"
#include "app/study/stiffness_output.hpp"
#include "app/study/static_ratings.hpp"
#include "app/units.hpp"
#include "bearing/contact/point_contact.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/static_bearing.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/ball_failure.hpp"
#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using bearing::balls::BallPowerLoss;

constexpr double kPerMillion = 1e-6;  // of revolutions

struct CauseOfHeat {
  const char* name;
  const char* meaning;
  double BallPowerLoss::*power;
};

constexpr CauseOfHeat causes_of_heat[] = {
    {"sliding", "sliding in the middle of the ellipses of contact", &BallPowerLoss::sliding},
    {"differential_slip", "because ellipses are curved (Heathcote)", &BallPowerLoss::differential},
    {"spin", "turning about the normals of the contacts", &BallPowerLoss::spin},
    {"rolling", "shear of the oil at the inlets", &BallPowerLoss::rolling},
    {"contact_damping", "in the race contacts", &BallPowerLoss::damping},
    {"cage", "pockets and lands of the cage", &BallPowerLoss::cage},
    {"churning", "drag and churning of the oil-air mixture", &BallPowerLoss::churning}};

Json heat_by_cause(const BallPowerLoss& loss) {
  Json heat{{"total", loss.total()}};
  for (const CauseOfHeat& cause : causes_of_heat) heat[cause.name] = loss.*cause.power;
  return heat;
}

std::vector<std::string> warnings_of_balls(const BallStudy& study, const bearing::balls::BallDuty& duty,
                                           const system::BallRunOptions& options) {
  std::vector<std::string> warnings;
  const double observed_from = options.duration * (1.0 - options.observed);
  if (duty.inner.duration() > observed_from)
    warnings.push_back(
        fmt::format("the means are taken while the shaft still speeds up, until {:.4g} s; observed from "
                    "{:.4g} s on",
                    duty.inner.duration(), observed_from));
  if (!study.run.slip_settling)
    warnings.push_back(fmt::format(
        "the slip of the cage has not settled: within the last third of the run it leaves the band of {:.3g} % of the "
        "cage's kinematic speed about its mean (simulation.settling_band); a longer simulation.duration may show its end",
        100.0 * options.settling_band));
  return warnings;
}

// Of the largest loads while observed.
double largest_pressure(const bearing::Bearing& bearing, const system::BallMeans& means) {
  const bearing::equilibrium::BallRow row(bearing);
  return std::max(point_pressure(row.contact(bearing::Race::inner), means.inner_load_max).pressure,
                  point_pressure(row.contact(bearing::Race::outer), means.outer_load_max).pressure);
}

}  // namespace

bool is_ball_run(const ResolvedCase& resolved) {
  return resolved.model() == ball_motion;
}

BallStudy ball_study(const ResolvedCase& in, const std::function<void(double)>& progress) {
  const bearing::Bearing bearing = bearing_of(in);
  const bearing::balls::BallDuty duty = ball_duty_of(in);
  const system::BallRunOptions options = ball_run_options_of(in);
  const bearing::rating::BearingRating rating = bearing::rating::bearing_rating(bearing, stated_ratings_of(in));
  const bearing::rating::RatingCondition condition = rating_condition_of(in, bearing);
  const bearing::rating::Ratings& ratings = rating.ratings;
  BallStudy study;
  study.dynamic_capacity = ratings.dynamic_capacity;
  const system::HeatParameters heat = heat_of(in);
  const auto reached = [&](double time) {
    if (progress) progress(time / options.duration);
  };
  study.run = heat.on
                  ? system::run_heated_balls(bearing, ball_motion_of(in), duty, ratings.contacts, options,
                                             heat, study.warming, reached)
                  : system::run_balls(bearing, ball_motion_of(in), duty, ratings.contacts, options, reached);
  if (!study.run.completed)
    throw ComputationFailed(fmt::format("{}: {}", in.text("name"), study.run.message));
  const double inner = duty.inner.speed_at(options.duration), outer = duty.outer.speed_at(options.duration);
  study.rolling_cage_speed = kinematic_cage_speed(geometry_of(bearing), inner, outer);
  const double turning = bearing.motions.inner == bearing::RaceMotion::turning ? inner : outer;
  const system::BallMeans& means = study.run.means;
  study.turning_speed = turning;
  study.lives = bearing::rating::rating_lives(rating, condition, means.equivalent);
  study.largest_pressure = largest_pressure(bearing, means);
  study.life_hours = bearing::hours(means.life.bearing, turning);
  study.life_with_balls_hours =
      bearing::hours(bearing::rating::life_of_both(means.life.bearing, means.balls_life), turning);
  const bearing::Bearing running =
      study.warming.empty() ? bearing : system::warm_bearing(bearing, heat, study.warming.back().temperature);
  study.radial_clearance = running.radial_clearance;
  const bearing::equilibrium::RingState balance =
      bearing::equilibrium::balance_bearing(running, {.speeds = {inner, outer}}, ring_load_of(in));
  if (balance.report.converged) study.stiffness = bearing::equilibrium::stiffness_by_axes(balance);
  study.warnings = warnings_of_balls(study, duty, options);
  return study;
}

// Temperatures of the steady state; null where they are stated.
Json temperatures(const BallStudy& study) {
  if (study.warming.empty()) return nullptr;
  Json by_body;
  for (int i = 0; i < system::kWarmBodies; ++i)
    by_body[system::kWarmBodyNames[i]] = study.warming.back().temperature[i];
  return by_body;
}

Json ball_json(const BallStudy& study) {
  const system::BallMeans& m = study.run.means;
  const auto race = [](double rms, double most, double angle, double film, double life) {
    return Json{{"load_rms_N", rms},
                {"load_max_N", most},
                {"contact_angle_deg", kDegree * angle},
                {"central_film_um", 1e6 * film},
                {"life_Mrev", number_or_null(kPerMillion * life)}};
  };
  Json object;
  for (const auto& [name, value] : life_values(study.all_lives())) object[name] = number_or_null(value);
  object.update(Json{
          {"life_with_balls_h", number_or_null(study.life_with_balls_hours)},
          {"slip_settling_s", study.run.slip_settling ? Json(*study.run.slip_settling) : Json(nullptr)},
          {"cage_impact_max_N", study.run.pocket_load_max},
          {"cage_slip", m.cage_slip},
          {"heat_W", heat_by_cause(m.loss)},
          {"temperature_C", temperatures(study)},
          {"running_clearance_um", 1e6 * study.radial_clearance},
          {"friction_torque_N_mm", 1e3 * m.inner_torque},
          {"cage_speed_rpm", kRpm * m.cage_speed},
          {"inner", race(m.inner_load_rms, m.inner_load_max, m.inner_angle, m.inner_film, m.life.inner)},
          {"outer", race(m.outer_load_rms, m.outer_load_max, m.outer_angle, m.outer_film, m.life.outer)},
          {"balls_life_Mrev", number_or_null(kPerMillion * m.balls_life)},
          {"dynamic_capacity_N", study.dynamic_capacity},
          {"stiffness", study.stiffness ? stiffness_json(*study.stiffness) : Json(nullptr)},
          {"steps", study.run.report.steps},
          {"life_table", lives_record(value_by_name(life_values(study.all_lives())),
                                      {bearing::rating::RollingElement::ball})}});
  return object;
}

std::string ball_text(const BallStudy& study) {
  const system::BallMeans& m = study.run.means;
  std::string text = lives_text(value_by_name(life_values(study.all_lives())),
                                {bearing::rating::RollingElement::ball});
  text += fmt::format("life_h with failures of the balls {:.5g} h\n\n", study.life_with_balls_hours);
  text += fmt::format("cage: slip {:.3g} %, ", 100.0 * m.cage_slip);
  text += study.run.slip_settling ? fmt::format("settled after {:.3g} s, ", *study.run.slip_settling)
                                  : "not settled, ";
  text += fmt::format("largest impact of a ball {:.3g} N\n", study.run.pocket_load_max);
  text += fmt::format("friction torque {:.4g} N mm\n\n", 1e3 * m.inner_torque);
  text += fmt::format("{:<8} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "race", "rms load [N]", "largest [N]",
                      "angle [deg]", "film [um]", "life [Mrev]");
  text +=
      fmt::format("{:<8} {:>12.5g} {:>12.5g} {:>12.4g} {:>12.3g} {:>12.5g}\n", "inner", m.inner_load_rms,
                  m.inner_load_max, kDegree * m.inner_angle, 1e6 * m.inner_film, kPerMillion * m.life.inner);
  text +=
      fmt::format("{:<8} {:>12.5g} {:>12.5g} {:>12.4g} {:>12.3g} {:>12.5g}\n\n", "outer", m.outer_load_rms,
                  m.outer_load_max, kDegree * m.outer_angle, 1e6 * m.outer_film, kPerMillion * m.life.outer);
  text += fmt::format("{:<20} {:>12}\n", "heat", "[W]");
  for (const CauseOfHeat& cause : causes_of_heat)
    text += fmt::format("{:<20} {:>12.4g}  {}\n", cause.name, m.loss.*cause.power, cause.meaning);
  text += fmt::format("{:<20} {:>12.4g}\n", "total", m.loss.total());
  if (study.warming.empty()) return text;
  text += fmt::format("\n{:<20} {:>12}\n", "steady temperature", "[degC]");
  for (int i = 0; i < system::kWarmBodies; ++i)
    text += fmt::format("{:<20} {:>12.4g}\n", system::kWarmBodyNames[i], study.warming.back().temperature[i]);
  text += fmt::format("radial clearance at these temperatures {:.4g} um\n", 1e6 * study.radial_clearance);
  return text;
}

PointContent ball_content(const BallStudy& study) {
  const system::BallSeries& s = study.run.series;
  const system::BallMeans& m = study.run.means;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  PointContent content;
  content.add_dimension("time", s.time.size());
  const auto over_time = [&](const char* name, const char* units, const char* meaning,
                             const std::vector<double>& values) {
    content.add(name, {"time"}, units, meaning, values);
  };
  over_time("time", "s", "from the start of the run", s.time);
  over_time("cage_slip", "1", "1 - speed of the cage over that of pure rolling", s.cage_slip);
  over_time("cage_speed", "rad s-1", "about its axis", s.cage_speed);
  over_time("inner_speed", "rad s-1", "of the inner ring", s.inner_speed);
  over_time("cage_x", "m", "place of the cage's centre along the radial load", s.cage_x);
  over_time("cage_y", "m", "place of the cage's centre across the radial load", s.cage_y);
  over_time("pocket_load", "N", "largest load of a ball on the cage since the sample before", s.pocket_load);
  over_time("friction_torque", "N m", "that the drive of the inner ring gives", s.torque);
  over_time("inner_x", "m", "place of the inner ring along the radial load", s.inner_x);
  over_time("inner_y", "m", "place of the inner ring across the radial load", s.inner_y);
  over_time("inner_z", "m", "place of the inner ring along the axis", s.inner_z);
  over_time("first_ball_angle", "rad", "of the first ball from the radial load", s.first_angle);
  over_time("first_ball_inner_load", "N", "of the first ball on the inner race", s.first_inner);
  over_time("first_ball_outer_load", "N", "of the first ball on the outer race", s.first_outer);
  for (const CauseOfHeat& cause : causes_of_heat)
    content.add_each(std::string("heat_") + cause.name, {"time"}, "W", cause.meaning, s.loss, cause.power);
  if (!study.warming.empty()) {
    content.add_dimension("warming", study.warming.size());
    content.add_each("warming_time", {"warming"}, "s", "since the cold start", study.warming,
                     &system::WarmState::time);
    for (int i = 0; i < system::kWarmBodies; ++i)
      content.add_each(std::string("temperature_") + system::kWarmBodyNames[i], {"warming"}, "degC",
                       "on the way to the steady state", study.warming,
                       [&](const system::WarmState& state) { return state.temperature[i]; });
  }
  const auto one_number = [&](const char* name, const char* units, const char* meaning, double value) {
    content.add(name, units, meaning, std::isfinite(value) ? value : none);
  };
  one_number("life", "h", "of the bearing by Lundberg and Palmgren, from true passages", study.life_hours);
  for (const auto& [name, value] : life_values(study.all_lives()))
    if (name.ends_with("h") && name != "life_h") one_number(name.c_str(), "h", "of the bearing, by the standards", value);
  one_number("life_with_balls", "h", "of the bearing where its balls may fail too",
             study.life_with_balls_hours);
  one_number("mean_cage_slip", "1", "over the observed time", m.cage_slip);
  one_number("mean_heat", "W", "over the observed time", m.loss.total());
  one_number("slip_settling", "s", "last time at which the slip leaves its band about the mean of the last third",
             study.run.slip_settling.value_or(none));
  one_number("cage_impact_max", "N", "largest load of a ball on the cage", study.run.pocket_load_max);
  return content;
}

}  // namespace orbearing::app

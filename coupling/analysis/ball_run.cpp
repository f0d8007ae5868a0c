#include "coupling/analysis/ball_run.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/contact/point_contact.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/row_group.hpp"
#include "bearing/friction/oil_supply.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

using described::each;
using described::Record;
using mechanics::significant;
namespace dimension = described::dimension;
using bearing::balls::BallPowerLoss;

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

std::vector<std::string> warnings_of_balls(const BallRun& study, const bearing::balls::BallDuty& duty,
                                           const system::BallRunOptions& options) {
  std::vector<std::string> warnings;
  const double observed_from = options.duration * (1.0 - options.observed);
  if (duty.inner.duration() > observed_from)
    warnings.push_back("the means include the run-up of the shaft, until " +
                       significant(duty.inner.duration(), 4) + " s; observed from " +
                       significant(observed_from, 4) + " s on");
  if (!study.run.slip_settling)
    warnings.push_back(
        "the slip of the cage has not settled. Within the last third of the run it leaves the band of " +
        significant(100.0 * options.settling_band, 3) +
        " % of the cage's kinematic speed about its mean (simulation.settling_band). Increase "
        "simulation.duration");
  return warnings;
}

// Pressure under the largest contact loads of the observed time.
double largest_pressure(const bearing::Bearing& bearing, const system::BallMeans& means) {
  const bearing::equilibrium::BallRow row(bearing);
  return std::max(point_pressure(row.contact(bearing::Race::inner), means.inner_load_max).pressure,
                  point_pressure(row.contact(bearing::Race::outer), means.outer_load_max).pressure);
}

}  // namespace

bearing::balls::BallDuty ball_duty(const BallsInTime& in) {
  using bearing::balls::RingDrive;
  const double speed = in.loaded.rotation.shaft_speed, acceleration = in.simulation.shaft_acceleration;
  const bearing::equilibrium::RingLoad& load = in.loaded.load;
  bearing::balls::BallDuty duty;
  duty.inner = acceleration > 0.0 ? RingDrive{0.0, std::copysign(acceleration, speed), speed}
                                  : RingDrive::steady(speed);
  duty.outer = RingDrive::steady(in.loaded.rotation.outer_speed);
  // A tilt moves the ring forward where x or y is positive: its axis leans the other way.
  duty.on_inner = {{load.radial, 0.0, load.axial, -load.moment, -load.moment_across}};
  return duty;
}

BallRun run_of_balls(const BallsInTime& in, const std::function<void(double)>& progress) {
  const bearing::Bearing bearing = rotating_bearing(in.loaded);
  const bearing::balls::BallDuty duty = ball_duty(in);
  system::BallRunOptions options = in.simulation.options;
  options.first_ball = bearing.first_element;
  const bearing::rating::BearingRating rating =
      bearing::rating::bearing_rating(bearing, in.loaded.capacities.ratings());
  const bearing::rating::RatingCondition condition = rating_condition(in.loaded);
  const bearing::rating::Ratings& ratings = rating.ratings;
  BallRun study;
  study.dynamic_capacity = ratings.dynamic_capacity;
  study.governing = governing_life(in.loaded);
  const system::HeatParameters& heat = in.simulation.heat;
  const auto reached = [&](double time) {
    if (progress) progress(time / options.duration);
  };
  const bearing::balls::MotionParameters& motion = in.simulation.motion;
  study.run = heat.on ? system::run_heated_balls(bearing, motion, duty, ratings.contacts, options, heat,
                                                 study.warming, reached)
                      : system::run_balls(bearing, motion, duty, ratings.contacts, options, reached);
  if (!study.run.completed) throw NoResult(study.run.message);
  const double inner = duty.inner.speed_at(options.duration), outer = duty.outer.speed_at(options.duration);
  const double rotating = bearing.motions.inner == bearing::RaceMotion::rotating ? inner : outer;
  const system::BallMeans& means = study.run.means;
  study.rotating_speed = rotating;
  study.lives = bearing::rating::rating_lives(rating, condition, means.equivalent);
  study.largest_pressure = largest_pressure(bearing, means);
  study.life_hours = bearing::hours(means.life.bearing, rotating);
  study.life_with_balls_hours =
      bearing::hours(bearing::rating::life_of_both(means.life.bearing, means.balls_life), rotating);
  const bearing::Bearing running =
      study.warming.empty() || heat.model == system::HeatModel::oil
          ? bearing
          : system::warm_bearing(bearing, heat, study.warming.back().temperature);
  study.radial_clearance = running.radial_clearance;
  const bearing::equilibrium::RingState balance =
      bearing::equilibrium::balance_bearing(running, {.speeds = {inner, outer}}, in.loaded.load);
  if (balance.report.converged) study.stiffness = bearing::equilibrium::stiffness_by_axes(balance);
  if (motion.drag.on)
    study.oil_share = bearing::friction::supplied(bearing, motion, inner - outer).drag.oil_share;
  const double rolling = means.loss.rolling / std::abs(inner - outer);
  const bool isothermal = motion.race.inlet_heating == bearing::motion::InletHeating::none;
  study.friction_by_standards =
      friction_by_standards(in.loaded,
                            {.speed = std::abs(inner - outer),
                             .torque = means.friction_torque,
                             .rolling = rolling,
                             .isothermal = isothermal ? rolling : 0.0,
                             .viscosity = motion.lubricant.viscosity / density_of_oil(motion.drag)},
                            ratings.static_capacity);
  study.warnings = warnings_of_balls(study, duty, options);
  return study;
}

namespace {

void describe_races(Record& record, const system::BallMeans& m) {
  const auto of_race = [&](const std::string& race, double rms, double most, double angle, double film,
                           double life) {
    record.child(race, "means over the observed time", m, [&](Record& one, const system::BallMeans&) {
      one.value("load_rms_N", dimension::force, "of a ball", rms);
      one.value("load_max_N", dimension::force, "largest of a ball", most);
      one.value("contact_angle_deg", dimension::angle, "mean", angle);
      one.value("central_film_um", dimension::small_length, "mean", film);
      one.value("life_Mrev", dimension::revolutions, "by Lundberg and Palmgren", life);
    });
  };
  of_race("inner", m.inner_load_rms, m.inner_load_max, m.inner_angle, m.inner_film, m.life.inner);
  of_race("outer", m.outer_load_rms, m.outer_load_max, m.outer_angle, m.outer_film, m.life.outer);
}

void describe_heat(Record& record, const system::BallMeans& means) {
  const BallPowerLoss& loss = means.loss;
  std::vector<std::string> names{"total"};
  std::vector<double> powers{loss.total()};
  for (const CauseOfHeat& cause : causes_of_heat) {
    names.emplace_back(cause.name);
    powers.push_back(loss.*cause.power);
  }
  record.array("heat_W", dimension::heat, "over the observed time", {{"cause", names}}, powers);
  record.value("mean_heat", dimension::heat, "over the observed time", loss.total()).in_files_alone = true;
  record.value("heat_error_W", dimension::heat,
               "half of the interval that holds the mean heat with 95 %, by ten parts of the observed time",
               means.heat_error);
}

// Temperatures of the steady state; none where they are stated.
void describe_temperatures(Record& record, const std::vector<system::WarmState>& warming) {
  const std::vector<std::string> bodies(std::begin(system::kWarmBodyNames), std::end(system::kWarmBodyNames));
  const char* meaning = "of the steady state";
  if (warming.empty())
    record.nothing("temperature_C", meaning);
  else
    record.array("temperature_C", dimension::temperature, meaning, {{"body", bodies}},
                 warming.back().temperature);
}

void describe_warming(Record& record, const std::vector<system::WarmState>& warming) {
  if (warming.empty()) return;
  record.series("warming_time", dimension::time, "since the cold start", {"warming"},
                each(warming, &system::WarmState::time));
  for (int i = 0; i < system::kWarmBodies; ++i)
    record.series(std::string("temperature_") + system::kWarmBodyNames[i], dimension::temperature,
                  "on the way to the steady state", {"warming"},
                  each(warming, [i](const system::WarmState& state) { return state.temperature[i]; }));
}

void describe_series(Record& record, const system::BallSeries& s) {
  const auto over_time = [&](const char* name, const described::Dimension& of, const char* meaning,
                             const std::vector<double>& values) {
    record.series(name, of, meaning, {"time"}, values);
  };
  over_time("time", dimension::time, "from the start of the run", s.time);
  over_time("cage_slip", dimension::ratio, "1 - speed of the cage over that of pure rolling", s.cage_slip);
  over_time("cage_speed", dimension::spin, "about its axis", s.cage_speed);
  over_time("inner_speed", dimension::spin, "of the inner ring", s.inner_speed);
  over_time("cage_x", dimension::length, "position of the cage's centre along the radial load", s.cage_x);
  over_time("cage_y", dimension::length, "position of the cage's centre across the radial load", s.cage_y);
  over_time("pocket_load", dimension::force, "largest load of a ball on the cage since the sample before",
            s.pocket_load);
  over_time("friction_torque", dimension::torque, "that the drive of the inner ring gives", s.torque);
  over_time("inner_x", dimension::length, "position of the inner ring along the radial load", s.inner_x);
  over_time("inner_y", dimension::length, "position of the inner ring across the radial load", s.inner_y);
  over_time("inner_z", dimension::length, "position of the inner ring along the axis", s.inner_z);
  over_time("first_ball_angle", dimension::angle, "of the first ball from the radial load", s.first_angle);
  over_time("first_ball_inner_load", dimension::force, "of the first ball on the inner race", s.first_inner);
  over_time("first_ball_outer_load", dimension::force, "of the first ball on the outer race", s.first_outer);
  for (const CauseOfHeat& cause : causes_of_heat)
    over_time((std::string("heat_") + cause.name).c_str(), dimension::heat, cause.meaning,
              each(s.loss, cause.power));
}

}  // namespace

void describe(Record& record, const BallRun& study) {
  const system::BallMeans& m = study.run.means;
  describe(record, study.all_lives());
  record.value("life_with_balls_h", dimension::hours, "life with failures of the balls included",
               study.life_with_balls_hours);
  record.value("slip_settling_s", dimension::time,
               "last time at which the slip leaves its band about the mean of the last third",
               study.run.slip_settling);
  record.value("cage_impact_max_N", dimension::force, "largest load of a ball on the cage",
               study.run.pocket_load_max);
  record.value("cage_slip", dimension::ratio, "over the observed time", m.cage_slip).variable =
      "mean_cage_slip";
  record.value("cage_slip_error", dimension::ratio,
               "half of the interval that holds the mean slip with 95 %, by ten parts of the observed time",
               m.cage_slip_error);
  describe_heat(record, m);
  describe_temperatures(record, study.warming);
  record.value("oil_share", dimension::ratio, "of oil in the free volume, where it is stirred",
               study.oil_share);
  record.value("running_clearance_um", dimension::small_length, "at the temperatures of the run",
               study.radial_clearance);
  record
      .value("friction_torque_N_mm", dimension::small_torque,
             "mean friction torque: losses over the rotation of one ring against "
             "the other",
             m.friction_torque)
      .variable = "mean_friction_torque";
  if (study.friction_by_standards)
    record.child("friction_by_standards", "by formulas of others", *study.friction_by_standards);
  record.value("cage_speed_rpm", dimension::angular_speed, "over the observed time", m.cage_speed).variable =
      "mean_cage_speed";
  describe_races(record, m);
  record.value("balls_life_Mrev", dimension::revolutions, "of the balls alone", m.balls_life);
  record.value("dynamic_capacity_N", dimension::force, "C_r", study.dynamic_capacity);
  if (study.stiffness)
    record.array("stiffness", {},
                 "of the static equilibrium at the final speeds: x, y, z, tilt about x, tilt about y; SI",
                 {"freedom", "freedom_beside"}, *study.stiffness);
  else
    record.nothing("stiffness", "none: no static equilibrium");
  record.value("steps", "of the integration", study.run.report.steps);
  record.child("life_table", "comparison of lives", study.life_table()).detail = true;
  record.value("film_inner_um", dimension::small_length, "mean central film on the inner race", m.inner_film)
      .detail = true;
  record.value("film_outer_um", dimension::small_length, "mean central film on the outer race", m.outer_film)
      .detail = true;
  describe_series(record, study.run.series);
  describe_warming(record, study.warming);
}

}  // namespace orbearing::analysis

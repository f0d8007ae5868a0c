#include "coupling/study/crowning/crown_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/equilibrium/drop_gradient.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/modified_life.hpp"

namespace orbearing::study::crowning {

namespace {

using bearing::laminae::LaminaBearing;
using bearing::laminae::LaminaResult;
using bearing::profile::Profile;

void require_whole(const std::vector<SpectrumPoint>& spectrum) {
  double sum = 0.0;
  bool turns = false;
  for (const SpectrumPoint& point : spectrum) {
    if (!(point.share >= 0.0))
      throw std::invalid_argument("spectrum: found a negative share of time; at least 0 is required");
    sum += point.share;
    turns = turns || (point.speed > 0.0 && point.share > 0.0);
  }
  if (!turns) throw std::invalid_argument("spectrum: all time is at rest; a speed above 0 is required");
  if (std::abs(sum - 1.0) > 1e-9)
    throw std::invalid_argument("spectrum: the shares of time add up to " + std::to_string(sum) +
                                "; 1 is required");
}

LaminaResult balanced(const LaminaBearing& bearing, const CrownProblem& problem, double tilt,
                      std::size_t duty) {
  LaminaResult loads =
      bearing::laminae::quasi_static_laminae(bearing, tilted(problem.duties[duty], tilt), problem.options);
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  return loads;
}

// Of one duty.
CrownLife duty_life(const CrownProblem& problem, const LaminaBearing& bearing,
                    const std::vector<DropSlope>& slopes, double tilt, std::size_t duty) {
  const LaminaResult loads = balanced(bearing, problem, tilt, duty);
  const bearing::life::LogLife life =
      log_life(problem.ratings[duty], loads.inner_lamina_load, loads.outer_lamina_load);
  const bearing::laminae::DropGradient by_drops =
      bearing::laminae::drop_gradient(bearing, tilted(problem.duties[duty], tilt), problem.options, loads,
                                      life.by_inner_load, life.by_outer_load);
  CrownLife result{.log_hours = std::log(duty_hours(problem, loads, duty))};
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const auto lamina = static_cast<Eigen::Index>(k);
    const double by_lamina_drop = by_drops.inner[lamina] + by_drops.outer[lamina];
    result.by_drop += by_lamina_drop * slopes[k].by_drop;
    result.by_share += by_lamina_drop * slopes[k].by_share;
  }
  return result;
}

std::vector<DropSlope> lamina_slopes(const LaminaBearing& bearing, const ProfileFamily& family,
                                     const Crown& crown) {
  std::vector<DropSlope> slopes;
  for (const double place : bearing.contact(bearing::Race::inner).places())
    slopes.push_back(drop_slope(family, crown, place * bearing.half_length()));
  return slopes;
}

}  // namespace

CrownProblem crown_problem(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const std::vector<SpectrumPoint>& spectrum, LifeMeasure measure, int laminae) {
  require_whole(spectrum);
  CrownProblem problem{.bearing = drivetrain.bearing,
                       .options = quasi_static_options(drivetrain),
                       .rated = drivetrain.rated,
                       .lambda = drivetrain.lambda};
  problem.bearing.rollers().laminae = laminae;
  for (const SpectrumPoint& at : spectrum) {
    if (at.speed <= 0.0 || at.share <= 0.0) continue;
    PlanetaryDrivetrain there = drivetrain;
    if (at.power) there.drive.power = *at.power;
    DrivetrainGeometry geometry_there = geometry;
    turn_at(at.speed, there, geometry_there);
    there.misalignment.planet_tilt = 0.0;  // it is what a study varies
    problem.duties.push_back(
        {at.speed, at.share, bearing_duty(there, geometry_there).point, there.bearing.radial_clearance});
    problem.ratings.push_back(lamina_rating(problem.bearing, measure, drivetrain.lambda));
  }
  return problem;
}

CrownProblem one_duty(const CrownProblem& problem, std::size_t duty) {
  CrownProblem one = problem;
  one.duties = {problem.duties[duty]};
  one.ratings = {problem.ratings[duty]};
  one.duties.front().share = 1.0;
  return one;
}

LaminaBearing lamina_bearing(const CrownProblem& problem, const Profile& profile, std::size_t duty) {
  bearing::Bearing bearing = problem.bearing;
  bearing.radial_clearance = problem.duties[duty].radial_clearance;
  bearing.rollers().profile = profile;
  return LaminaBearing(bearing);
}

bearing::OperatingPoint tilted(const Duty& duty, double tilt) {
  bearing::OperatingPoint point = duty.point;
  if (tilt != 0.0) point.bore_tilt += tilt * point.bore_load.normalized();
  return point;
}

LaminaResult loads_at(const CrownProblem& problem, const Profile& profile, double tilt, std::size_t duty) {
  return balanced(lamina_bearing(problem, profile, duty), problem, tilt, duty);
}

double duty_hours(const CrownProblem& problem, const LaminaResult& loads, std::size_t duty) {
  const double revolutions =
      lamina_life(problem.ratings[duty], loads.inner_lamina_load, loads.outer_lamina_load).bearing;
  return bearing::hours(revolutions, turning_speed(problem.bearing, problem.duties[duty].point));
}

double modified_duty_hours(const CrownProblem& problem, const LaminaResult& loads, std::size_t duty) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!problem.rated) return none;
  const double speed = turning_speed(problem.bearing, problem.duties[duty].point);
  const auto oil = bearing::rating::oil_condition(problem.rated->oil, speed, problem.bearing.pitch_diameter);
  const auto modified =
      bearing::rating::modified_life(problem.bearing, problem.lambda, problem.rated->ratings, oil,
                                     {.whole = {}, .laminae = loads.inner_lamina_load.pow(4)},
                                     {.whole = {}, .laminae = loads.outer_lamina_load.pow(4)});
  return modified ? problem.rated->reliability_factor * bearing::hours(modified->life.bearing, speed) : none;
}

double life_hours(const CrownProblem& problem, const Profile& profile, double tilt) {
  Eigen::ArrayXd hours(static_cast<Eigen::Index>(problem.duties.size()));
  for (std::size_t duty = 0; duty < problem.duties.size(); ++duty)
    hours[static_cast<Eigen::Index>(duty)] =
        duty_hours(problem, loads_at(problem, profile, tilt, duty), duty);
  return life_of_duties(problem, hours);
}

double life_of_duties(const CrownProblem& problem, const Eigen::Ref<const Eigen::ArrayXd>& hours) {
  const Eigen::Index duties = hours.size();
  Eigen::ArrayXd shares(duties + 1), lives(duties + 1);
  for (Eigen::Index duty = 0; duty < duties; ++duty)
    shares[duty] = problem.duties[static_cast<std::size_t>(duty)].share;
  shares[duties] = std::max(0.0, 1.0 - shares.head(duties).sum());
  lives << hours, std::numeric_limits<double>::infinity();
  return bearing::rating::spectrum_life(shares, lives);
}

// L = 1/sum(s_i/L_i): d ln L = sum of the duties' d ln L_i, weighted by the part of life each uses up.
CrownLife crown_life(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                     double tilt) {
  const Profile profile = profile_of(family, crown);
  const std::vector<DropSlope> slopes = lamina_slopes(lamina_bearing(problem, profile, 0), family, crown);
  CrownLife sum;
  double used = 0.0;
  for (std::size_t duty = 0; duty < problem.duties.size(); ++duty) {
    const CrownLife one = duty_life(problem, lamina_bearing(problem, profile, duty), slopes, tilt, duty);
    const double part = problem.duties[duty].share * std::exp(-one.log_hours);
    used += part;
    sum.by_drop += part * one.by_drop;
    sum.by_share += part * one.by_share;
  }
  return {-std::log(used), sum.by_drop / used, sum.by_share / used};
}

}  // namespace orbearing::study::crowning

#include "coupling/analysis/crowning/crown_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/geometry.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/profile/profile.hpp"
#include "coupling/analysis/rated_bearing.hpp"

namespace orbearing::analysis::crowning {

namespace {

namespace profile = bearing::profile;
using profile::Profile;

[[noreturn]] void throw_no_drop(const std::string& kind) {
  throw std::invalid_argument("profile: found " + kind + "; required: a kind with a free drop");
}

Profile shape_of(const std::string& kind, const bearing::Bearing& bearing, double load) {
  const double l = bearing.rollers().length;
  const profile::DesignLoad design = bearing::design_under(bearing, load);
  if (kind == "chamfer") return profile::Chamfer{l, 0.1 * l, 1e-6};
  if (kind == "circular") return profile::CircularCrown{l, 1e-6};
  if (kind == "straight-circular") return profile::StraightCircular{l, 0.6 * l, 1e-6};
  if (kind == "lundberg") return profile::lundberg_for(design);
  if (kind == "johns-gohar") return profile::johns_gohar_for(design);
  if (kind == "iso16281") return profile::Iso16281{l, bearing.rollers().diameter, 1.0};
  if (kind == "fujiwara-kawase") {
    const double end = profile::drop(profile::johns_gohar_for(design), 0.5 * l);
    return profile::fujiwara_kawase_for(design, 1.0, 0.6, end);
  }
  throw_no_drop(kind);
}

Profile with_share(Profile shape, double length, double share) {
  if (auto* chamfer = std::get_if<profile::Chamfer>(&shape))
    chamfer->chamfer_length = 0.5 * length * share;
  else if (auto* circular = std::get_if<profile::StraightCircular>(&shape))
    circular->straight_length = length * (1.0 - share);
  else if (auto* logarithmic = std::get_if<profile::FujiwaraKawase>(&shape))
    logarithmic->crowned_fraction = share;
  return shape;
}

double station_of(const ProfileFamily& family) {
  return profile::kDropPosition * 0.5 * family.length;
}

}  // namespace

std::vector<std::string> family_names() {
  return {"chamfer",     "circular", "straight-circular", "lundberg",
          "johns-gohar", "iso16281", "fujiwara-kawase"};
}

ProfileFamily family_of(const std::string& kind, const bearing::Bearing& bearing, double load) {
  return {shape_of(kind, bearing, load), bearing.rollers().length};
}

ProfileFamily family_like(const Profile& made, const bearing::Bearing& bearing) {
  const std::string kind = profile::kind(made);
  const std::vector<std::string> names = family_names();
  if (std::find(names.begin(), names.end(), kind) == names.end()) throw_no_drop(kind);
  return {made, bearing.rollers().length};
}

bool has_share(const ProfileFamily& family) {
  return std::holds_alternative<profile::Chamfer>(family.shape) ||
         std::holds_alternative<profile::StraightCircular>(family.shape) ||
         std::holds_alternative<profile::FujiwaraKawase>(family.shape);
}

double default_share(const ProfileFamily& family) {
  if (const auto* chamfer = std::get_if<profile::Chamfer>(&family.shape))
    return chamfer->chamfer_length / (0.5 * family.length);
  if (const auto* circular = std::get_if<profile::StraightCircular>(&family.shape))
    return 1.0 - circular->straight_length / family.length;
  if (const auto* logarithmic = std::get_if<profile::FujiwaraKawase>(&family.shape))
    return logarithmic->crowned_fraction;
  return 1.0;
}

Profile profile_of(const ProfileFamily& family, const Crown& crown) {
  return profile::with_drop(with_share(family.shape, family.length, crown.share), station_of(family),
                            crown.drop);
}

double reference_drop(const bearing::Bearing& bearing) {
  return profile::drop(profile::Iso16281{bearing.rollers().length, bearing.rollers().diameter, 1.0},
                       profile::kDropPosition * 0.5 * bearing.rollers().length);
}

namespace {

using bearing::QuasiStaticResult;
using bearing::laminae::LaminaBearing;
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

// Each search starts from the equilibrium of `near`, the loads of nearly the same profile.
QuasiStaticResult balanced_near(const QuasiStaticResult& near, const LaminaBearing& bearing,
                                const bearing::OperatingPoint& point,
                                const bearing::QuasiStaticOptions& options) {
  QuasiStaticResult loads = empty_result(bearing, point, options);
  for (std::size_t i = 0; i < near.states.size(); ++i) {
    const auto position = static_cast<Eigen::Index>(i);
    put_position(bearing, quasi_static_state(bearing, point, options, loads.angle[position], &near.states[i]),
                 position, options.cage_positions, loads);
  }
  return loads;
}

QuasiStaticResult balanced(const LaminaBearing& bearing, const CrownProblem& problem, const Lean& lean,
                           std::size_t duty, const DutyLoads* near) {
  const bearing::OperatingPoint point = tilted(problem.duties[duty], lean);
  QuasiStaticResult loads = near ? balanced_near(near->bearings.front(), bearing, point, problem.options)
                                 : bearing::quasi_static_bearing(bearing, point, problem.options);
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  return loads;
}

}  // namespace

CrownProblem crown_problem(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const std::vector<SpectrumPoint>& spectrum, LifeMethod method, int laminae) {
  require_whole(spectrum);
  CrownProblem problem{
      .bearing = drivetrain.bearing, .options = quasi_static_options(drivetrain), .rated = drivetrain.rated};
  if (drivetrain.seats.tilt == TiltState::computed) problem.seat = planet_seat(drivetrain);
  problem.bearing.rollers().laminae = laminae;
  problem.rating = bearing::rating::bearing_rating(problem.bearing, problem.rated.stated);
  problem.rating.on_too_few_laminae = false;  // of the profiles that are studied, not of the case's
  problem.contacts = bearing::life::lamina_rating(problem.bearing, drivetrain.reduction_factor);
  if (method == LifeMethod::iso16281)
    problem.governing = bearing::rating::governing_life(method, problem.rated.oil.has_value());
  for (const SpectrumPoint& at : spectrum) {
    if (at.speed <= 0.0 || at.share <= 0.0) continue;
    PlanetaryDrivetrain there = drivetrain;
    if (at.power) there.drive.power = *at.power;
    DrivetrainGeometry geometry_there = geometry;
    turn_at(at.speed, there, geometry_there);
    there.misalignment.planet_tilt = 0.0;  // it is what a study varies
    const BearingDuty duty = bearing_duty(there, geometry_there);
    problem.duties.push_back(
        {at.speed, at.share, duty.point, there.bearing.radial_clearance, duty.gears.overturning_moment});
  }
  return problem;
}

CrownProblem one_duty(const CrownProblem& problem, std::size_t duty) {
  CrownProblem one = problem;
  one.duties = {problem.duties[duty]};
  one.duties.front().share = 1.0;
  return one;
}

namespace {

bearing::Bearing crowned(const CrownProblem& problem, const Profile& profile, std::size_t duty) {
  bearing::Bearing bearing = problem.bearing;
  bearing.radial_clearance = problem.duties[duty].radial_clearance;
  bearing.rollers().profile = profile;
  return bearing;
}

// All bearings side by side on a pin that leans.
DutyLoads planet_loads(const CrownProblem& problem, const Profile& profile, const Lean& lean,
                       std::size_t duty) {
  PlanetSeat seat = *problem.seat;
  seat.pin_inclination += lean;
  const Duty& at = problem.duties[duty];
  bearing::laminae::PlanetOnPinResult found =
      tilting_planet(planet_on(seat, crowned(problem, profile, duty)), at.point,
                     Eigen::Vector2d(at.overturning_moment, 0.0), problem.options);
  DutyLoads loads{.bearings = std::move(found.bearings)};
  double sum = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < loads.bearings.size(); ++k) {
    loads.tilt = std::max(loads.tilt, found.bearing_tilt[k].norm());
    const double load = loads.bearings[k].total_bore_load.norm();
    sum += load;
    largest = std::max(largest, load);
  }
  loads.load_share = largest * static_cast<double>(loads.bearings.size()) / sum;
  return loads;
}

Eigen::ArrayXXd mean_of(const std::vector<QuasiStaticResult>& bearings,
                        Eigen::ArrayXXd QuasiStaticResult::*loads) {
  std::vector<Eigen::ArrayXXd> all;
  for (const QuasiStaticResult& one : bearings) all.push_back(one.*loads);
  return mean_by_damage(all);
}

}  // namespace

Eigen::ArrayXXd mean_by_damage(const std::vector<Eigen::ArrayXXd>& loads) {
  if (loads.size() == 1) return loads.front();
  Eigen::ArrayXXd sum = loads.front().pow(4);
  for (std::size_t k = 1; k < loads.size(); ++k) sum += loads[k].pow(4);
  return (sum / static_cast<double>(loads.size())).pow(0.25);
}

Eigen::ArrayXXd DutyLoads::inner_lamina_load() const {
  return mean_of(bearings, &QuasiStaticResult::inner_lamina_load);
}

Eigen::ArrayXXd DutyLoads::outer_lamina_load() const {
  return mean_of(bearings, &QuasiStaticResult::outer_lamina_load);
}

Lean lean_by(const CrownProblem& problem, double angle) {
  return problem.seat ? Lean(0.0, angle) : Lean(angle, 0.0);
}

LaminaBearing lamina_bearing(const CrownProblem& problem, const Profile& profile, std::size_t duty) {
  return LaminaBearing(crowned(problem, profile, duty));
}

bearing::OperatingPoint tilted(const Duty& duty, const Lean& lean) {
  bearing::OperatingPoint point = duty.point;
  if (lean.isZero(0.0)) return point;
  const Eigen::Vector2d along = point.bore_load.normalized();
  point.bore_tilt += lean.x() * along + lean.y() * Eigen::Vector2d(-along.y(), along.x());
  return point;
}

DutyLoads loads_at(const CrownProblem& problem, const Profile& profile, const Lean& lean, std::size_t duty,
                   const DutyLoads* near) {
  if (problem.seat) return planet_loads(problem, profile, lean, duty);
  DutyLoads loads{.bearings = {balanced(lamina_bearing(problem, profile, duty), problem, lean, duty, near)}};
  loads.tilt = tilted(problem.duties[duty], lean).bore_tilt.norm();
  return loads;
}

namespace {

bearing::rating::RatedHours rated_hours_of(const CrownProblem& problem,
                                           const bearing::rating::BearingRating& rating,
                                           const Eigen::ArrayXXd& inner, const Eigen::ArrayXXd& outer,
                                           std::size_t duty) {
  using namespace bearing::rating;
  const bearing::OperatingPoint& point = problem.duties[duty].point;
  const double speed = rotating_speed(problem.bearing, point);
  const double load =
      bearing::total_bore_load(problem.bearing, geometry_of(problem.bearing), point, problem.options.inertia)
          .norm();
  const RatingCondition condition =
      rating_condition(problem.rated, load, load, speed, problem.bearing.pitch_diameter);
  const auto means = bearing::life::means_of_loads(problem.bearing.motions, inner, outer);
  return hours_at(rating_lives(rating, condition, means), speed);
}

}  // namespace

DutyHours lives_at(const CrownProblem& problem, const DutyLoads& loads, std::size_t duty) {
  const Eigen::ArrayXXd inner = loads.inner_lamina_load(), outer = loads.outer_lamina_load();
  const double revolutions = lamina_life(problem.contacts, inner, outer).bearing;
  return {bearing::hours(revolutions, rotating_speed(problem.bearing, problem.duties[duty].point)),
          rated_hours_of(problem, problem.rating, inner, outer, duty)};
}

double duty_hours(const CrownProblem& problem, const DutyLoads& loads, std::size_t duty) {
  const DutyHours lives = lives_at(problem, loads, duty);
  return bearing::rating::hours_of(problem.governing, lives.lundberg_palmgren, lives.rated);
}

double hours_without_riser(const CrownProblem& problem, const Eigen::ArrayXXd& inner,
                           const Eigen::ArrayXXd& outer, std::size_t duty) {
  using bearing::rating::Life;
  bearing::rating::BearingRating rating = problem.rating;
  rating.laminae = bearing::life::lamina_rating(rating.ratings.contacts, static_cast<int>(inner.rows()),
                                                problem.bearing.motions);
  const Life life = problem.governing == Life::lundberg_palmgren ? Life::reference : problem.governing;
  return hours_of(life, bearing::rating::kNotRated, rated_hours_of(problem, rating, inner, outer, duty));
}

double life_hours(const CrownProblem& problem, const Profile& profile, const Lean& lean) {
  return life_of_duties(problem, [&](std::size_t duty) {
    return duty_hours(problem, loads_at(problem, profile, lean, duty), duty);
  });
}

double life_of_duties(const CrownProblem& problem, const std::function<double(std::size_t duty)>& hours) {
  const auto duties = static_cast<Eigen::Index>(problem.duties.size());
  Eigen::ArrayXd shares(duties + 1), lives(duties + 1);
  for (Eigen::Index i = 0; i < duties; ++i) {
    const auto duty = static_cast<std::size_t>(i);
    shares[i] = problem.duties[duty].share;
    lives[i] = hours(duty);
  }
  shares[duties] = std::max(0.0, 1.0 - shares.head(duties).sum());
  lives[duties] = std::numeric_limits<double>::infinity();
  return bearing::rating::spectrum_life(shares, lives);
}

bearing::rating::RatedHours life_of_duties(const CrownProblem& problem,
                                           const std::vector<bearing::rating::RatedHours>& hours) {
  using bearing::rating::RatedHours;
  RatedHours all;
  for (const auto life : bearing::rating::kRatedHours)
    if (std::ranges::none_of(hours, [&](const RatedHours& of) { return std::isnan(of.*life); }))
      all.*life = life_of_duties(problem, [&](std::size_t duty) { return hours[duty].*life; });
  return all;
}

// Central differences, whose searches start where those of the crown itself ended.
CrownLife crown_life(const CrownProblem& problem, const ProfileFamily& family, const Crown& crown,
                     const Lean& lean) {
  constexpr double drop_step = 1e-11;  // [m]
  constexpr double share_step = 1e-6;  // [-]
  std::vector<DutyLoads> here(problem.duties.size());
  const auto log_hours = [&](const Crown& at, bool beside) {
    const Profile profile = profile_of(family, at);
    return std::log(life_of_duties(problem, [&](std::size_t duty) {
      DutyLoads loads = loads_at(problem, profile, lean, duty, beside ? &here[duty] : nullptr);
      const double hours = duty_hours(problem, loads, duty);
      if (!beside) here[duty] = std::move(loads);
      return hours;
    }));
  };
  const double now = log_hours(crown, false);
  const auto slope = [&](double drop, double share) {
    const Crown less{std::max(crown.drop - drop, 0.0), crown.share - share};
    const Crown more{crown.drop + drop, crown.share + share};
    return (log_hours(more, true) - log_hours(less, true)) /
           (more.drop - less.drop + more.share - less.share);
  };
  return {.log_hours = now,
          .by_drop = slope(drop_step, 0.0),
          .by_share = has_share(family) ? slope(0.0, share_step) : 0.0};
}

}  // namespace orbearing::analysis::crowning

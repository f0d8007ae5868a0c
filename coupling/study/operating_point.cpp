#include "coupling/study/operating_point.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/contact/line_contact.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/level_pitch.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/life/modified_life.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/cosim/planetary_coupling.hpp"
#include "coupling/study/bearing_tangent.hpp"
#include "coupling/study/driven_setups.hpp"
#include "coupling/study/load_sharing.hpp"
#include "coupling/study/mesh_excitation.hpp"
#include "coupling/study/tilting_planet.hpp"
#include "coupling/system/monolithic.hpp"

namespace orbearing::study {

namespace {

using bearing::Race;
using bearing::vectorised::LevelPitch;

std::vector<double> as_vector(const Eigen::ArrayXd& array) {
  return {array.begin(), array.end()};
}

// The film is a result whether or not it takes part in the approach.
double least_film(const bearing::Film& film, double load) {
  return film.cap() > 0.0 ? film.least(load) : std::numeric_limits<double>::quiet_NaN();
}

// Of revolutions of the race that turns relative to the load.
double hours_of(const bearing::BearingLife& life, const PlanetaryDrivetrain& drivetrain,
                const BearingDuty& duty) {
  return bearing::hours(life.bearing, turning_speed(drivetrain.bearing, duty.point));
}

std::vector<double> as_vector(const Eigen::ArrayXXd& array) {
  return {array.data(), array.data() + array.size()};
}

using bearing::motion::RaceStatistics;
using bearing::motion::WindowStatistics;

RaceResult race_result(const RaceStatistics& race) {
  return {.load_max = race.load_max,
          .load_rms = race.load_rms,
          .least_film = race.least_film,
          .lamina_load_max = race.lamina_load_max};
}

// Every place of the quasi-static bearing is passed alike, under one load.
RaceStatistics race_means(const Eigen::ArrayXd& loads, const bearing::Film& film) {
  return {.load_rms = std::sqrt(loads.square().mean()),
          .load_max = loads.maxCoeff(),
          .mean_load = loads,
          .passages = Eigen::ArrayXd::Ones(loads.size()),
          .damage = loads.square().square(),
          .least_film = least_film(film, loads.maxCoeff())};
}

void put_laminae(const Eigen::ArrayXXd& loads, RaceStatistics& means) {
  means.lamina_damage = loads.square().square();
  means.lamina_load_max = loads.maxCoeff();
}

// One bearing of one planet, at rest in the carrier's frame.
struct QuasiStaticBearing {
  Eigen::ArrayXd angle;      // [rad]  (places)
  Eigen::ArrayXd race_form;  // [m]    (places)  of an elastic outer race; else empty
  WindowStatistics means;
  std::optional<bearing::laminae::LaminaResult> laminae;
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  // [rad]  of the bore, of laminae
};

// Loads by place of either model.
template <class Loads>
QuasiStaticBearing bearing_under(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 const BearingDuty& duty, const Loads& loads) {
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  const bearing::RollerContacts rolling =
      bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, duty.point.inner_speed,
                                duty.point.outer_speed, drivetrain.lubricant);
  QuasiStaticBearing result{.angle = loads.angle};
  if (!duty.point.outer_race.is_rigid()) result.race_form = loads.race_form;
  result.means.inner = race_means(loads.inner_load, rolling.inner.film());
  result.means.outer = race_means(loads.outer_load, rolling.outer.film());
  return result;
}

QuasiStaticBearing of_laminae(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                              const BearingDuty& duty, bearing::laminae::LaminaResult loads,
                              const Eigen::Vector2d& tilt) {
  QuasiStaticBearing result = bearing_under(drivetrain, geometry, duty, loads);
  put_laminae(loads.inner_lamina_load, result.means.inner);
  put_laminae(loads.outer_lamina_load, result.means.outer);
  result.laminae = std::move(loads);
  result.tilt = tilt;
  return result;
}

LaminaRecord record_of(const bearing::laminae::LaminaBearing& cut, const QuasiStaticBearing& bearing) {
  const bearing::laminae::LaminaResult& loads = *bearing.laminae;
  return {.lamina_place = as_vector(Eigen::ArrayXd(cut.half_length() * cut.contact(Race::inner).places())),
          .inner_load = as_vector(loads.inner_lamina_load),
          .outer_load = as_vector(loads.outer_lamina_load),
          .roller_tilt = as_vector(loads.roller_tilt),
          .bore_tilt = bearing.tilt,
          .moment = loads.moment};
}

// The bearings of planets at rest, planet by planet.
class BearingsAtRest {
 public:
  BearingsAtRest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry)
      : drivetrain_(drivetrain), geometry_(geometry), options_(quasi_static_options(drivetrain)) {
    // One instruction set everywhere, so that points are equal to the last bit on all machines of a sweep.
    if (drivetrain.bearing.rollers().laminae == 0) return;
    cut_.emplace(drivetrain.bearing, mechanics::InstructionSet::baseline);
    if (drivetrain.seats.tilt != TiltState::computed) level_ = LevelPitch::of(drivetrain.bearing, options_);
  }

  /// All bearings of a planet: one where they are alike.
  std::vector<QuasiStaticBearing> of(const BearingDuty& duty) {
    if (drivetrain_.seats.tilt == TiltState::computed) return on_their_pin(duty);
    std::vector<QuasiStaticBearing> one;
    one.push_back(
        cut_ ? of_laminae(drivetrain_, geometry_, duty, loads_of_laminae(duty), duty.point.bore_tilt)
             : bearing_under(drivetrain_, geometry_, duty,
                             bearing::quasi_static_bearing(drivetrain_.bearing, duty.point, options_)));
    return one;
  }

  std::optional<LaminaRecord> record_of_laminae(const QuasiStaticBearing& bearing) const {
    if (!cut_) return std::nullopt;
    return record_of(*cut_, bearing);
  }

 private:
  std::vector<QuasiStaticBearing> on_their_pin(const BearingDuty& duty) const {
    bearing::laminae::PlanetOnPinResult planet = tilting_planet(drivetrain_, duty);
    std::vector<QuasiStaticBearing> all;
    for (std::size_t k = 0; k < planet.bearings.size(); ++k)
      all.push_back(
          of_laminae(drivetrain_, geometry_, duty, std::move(planet.bearings[k]), planet.bearing_tilt[k]));
    return all;
  }

  bearing::laminae::LaminaResult loads_of_laminae(const BearingDuty& duty) {
    if (level_ && LevelPitch::holds(duty.point))
      if (auto loads = level_->laminae_under(*cut_, duty.point, duty.near.get())) return *std::move(loads);
    return bearing::laminae::quasi_static_laminae(*cut_, duty.point, options_);
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  bearing::QuasiStaticOptions options_;
  std::optional<bearing::laminae::LaminaBearing> cut_;
  std::optional<LevelPitch> level_;
};

// The one life of all fidelities; `powers` where they are known.
bearing::BearingLife life_under_means(const PlanetaryDrivetrain& drivetrain, const WindowStatistics& means,
                                      const bearing::life::LaminaMeans* powers = nullptr) {
  return bearing::motion::life_under(drivetrain.bearing, drivetrain.reduction_factor, damage_of(means.inner),
                                     damage_of(means.outer), powers);
}

bearing::rating::OilCondition oil_of(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                                     const WindowStatistics& means) {
  bearing::rating::StatedOil oil = drivetrain.rated->oil;
  if (drivetrain.rated->roughness)
    oil.viscosity_ratio = bearing::rating::viscosity_ratio_of_film(
        std::min(means.inner.least_film, means.outer.least_film), *drivetrain.rated->roughness);
  return bearing::rating::oil_condition(oil, turning_speed(drivetrain.bearing, duty.point),
                                        drivetrain.bearing.pitch_diameter);
}

// Of one bearing; the system's life follows where its planets are known.
struct LifeRecord {
  bearing::BearingLife life;  // [rev]
  std::optional<ModifiedRecord> modified;
};

ModifiedRecord modified_record(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                               const WindowStatistics& means, const bearing::life::LaminaMeans& powers) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const bearing::rating::OilCondition oil = oil_of(drivetrain, duty, means);
  ModifiedRecord record{oil.viscosity_ratio, oil.contamination_factor, none, none, none, none, none};
  const auto modified = bearing::rating::modified_life(drivetrain.bearing, drivetrain.reduction_factor,
                                                       drivetrain.rated->ratings, oil, powers);
  if (!modified) return record;
  const double reliability = drivetrain.rated->reliability_factor;
  record.life_modification = modified->factor;
  record.inner_life = reliability * modified->life.inner;
  record.outer_life = reliability * modified->life.outer;
  record.life_hours = reliability * hours_of(modified->life, drivetrain, duty);
  return record;
}

// Both lives take the same means of the loads' powers.
LifeRecord lives_under_means(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                             const WindowStatistics& means) {
  if (!drivetrain.rated) return {life_under_means(drivetrain, means), std::nullopt};
  const bearing::life::LaminaMeans powers =
      bearing::motion::means_of(drivetrain.bearing.motions, damage_of(means.inner), damage_of(means.outer));
  return {life_under_means(drivetrain, means, &powers), modified_record(drivetrain, duty, means, powers)};
}

void put_life(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty, const WindowStatistics& means,
              PointResult& result) {
  const auto [life, modified] = lives_under_means(drivetrain, duty, means);
  const int bearings = drivetrain.set.planets * drivetrain.bearings_per_planet;
  result.inner.life = life.inner;
  result.outer.life = life.outer;
  result.life_hours = hours_of(life, drivetrain, duty);
  result.system_life_hours = bearing::system_life(result.life_hours, bearings);
  result.modified = modified;
  if (result.modified)
    result.modified->system_life_hours = bearing::system_life(result.modified->life_hours, bearings);
}

// Bearings of which none may fail: the product law over unlike lives.
double life_together(const std::vector<double>& lives) {
  double together = lives.front();
  for (std::size_t i = 1; i < lives.size(); ++i) together = bearing::combined_life(together, lives[i]);
  return together;
}

// What the rollers do to the bore, mean over time [N].
Eigen::Vector2d mean_bore_force(const RaceStatistics& outer, const Eigen::ArrayXd& angle, int rollers) {
  const Eigen::ArrayXd load = outer.mean_load * outer.passages;
  return rollers * Eigen::Vector2d((load * angle.cos()).mean(), (load * angle.sin()).mean());
}

// Planet by planet, from the means of one bearing of each.
void put_planets(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty, const Eigen::ArrayXd& angle,
                 const std::vector<WindowStatistics>& means, PointResult& result) {
  double tangential = 0.0;
  for (const WindowStatistics& one : means) {
    const Eigen::Vector2d force = mean_bore_force(one.outer, angle, drivetrain.bearing.rollers().count);
    const auto [life, modified] = lives_under_means(drivetrain, duty, one);
    result.planets.push_back({.load_share = force.y(),
                              .load = force.norm(),
                              .life_hours = hours_of(life, drivetrain, duty),
                              .modified_life_hours = modified ? modified->life_hours : 0.0});
    tangential += force.y() / static_cast<double>(means.size());
  }
  for (PlanetResult& planet : result.planets) planet.load_share /= tangential;
}

double system_life_of(const std::vector<PlanetResult>& planets, int bearings_per_planet,
                      double PlanetResult::*hours) {
  std::vector<double> lives;
  for (const PlanetResult& planet : planets)
    lives.push_back(bearing::system_life(planet.*hours, bearings_per_planet));
  return life_together(lives);
}

// Of unlike planets.
void put_system_life(const PlanetaryDrivetrain& drivetrain, PointResult& result) {
  const int per_planet = drivetrain.bearings_per_planet;
  result.system_life_hours = system_life_of(result.planets, per_planet, &PlanetResult::life_hours);
  if (result.modified)
    result.modified->system_life_hours =
        system_life_of(result.planets, per_planet, &PlanetResult::modified_life_hours);
}

std::size_t shortest_lived(const std::vector<PlanetResult>& planets) {
  const auto shortest = std::min_element(
      planets.begin(), planets.end(),
      [](const PlanetResult& a, const PlanetResult& b) { return a.life_hours < b.life_hours; });
  return static_cast<std::size_t>(shortest - planets.begin());
}

// Bearing by bearing of a planet whose tilt is computed: their means, and tilts of bore against pin.
void put_seats(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty, const Eigen::ArrayXd& angle,
               const std::vector<WindowStatistics>& means, const std::vector<Eigen::Vector2d>& tilts,
               PointResult& result) {
  const std::vector<double> places = axial_places(drivetrain);
  std::vector<double> lives, modified_lives;
  for (std::size_t k = 0; k < means.size(); ++k) {
    const auto [life, modified] = lives_under_means(drivetrain, duty, means[k]);
    lives.push_back(hours_of(life, drivetrain, duty));
    modified_lives.push_back(modified ? modified->life_hours : 0.0);
    result.seats.push_back(
        {.place = places[k],
         .load = mean_bore_force(means[k].outer, angle, drivetrain.bearing.rollers().count).norm(),
         .tilt = tilts[k],
         .life_hours = lives.back(),
         .modified_life_hours = modified_lives.back()});
  }
  result.system_life_hours = bearing::system_life(life_together(lives), drivetrain.set.planets);
  if (result.modified)
    result.modified->system_life_hours =
        bearing::system_life(life_together(modified_lives), drivetrain.set.planets);
}

PointResult quasi_static_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const std::vector<BearingDuty>& duties) {
  BearingsAtRest at_rest(drivetrain, geometry);
  std::vector<QuasiStaticBearing> bearings;
  std::vector<WindowStatistics> means;
  for (const BearingDuty& duty : duties)
    for (QuasiStaticBearing& one : at_rest.of(duty)) {
      means.push_back(std::move(one.means));
      bearings.push_back(std::move(one));
    }
  const WindowStatistics all = system::pooled(means);
  PointResult result;
  result.inner = race_result(all.inner);
  result.outer = race_result(all.outer);
  const Eigen::ArrayXd& angle = bearings.front().angle;
  result.distribution = {as_vector(angle), as_vector(all.inner.mean_load), as_vector(all.outer.mean_load),
                         as_vector(bearings.front().race_form)};
  put_life(drivetrain, duties.front(), all, result);
  if (drivetrain.seats.tilt == TiltState::computed) {
    std::vector<Eigen::Vector2d> tilts;
    for (const QuasiStaticBearing& one : bearings) tilts.push_back(one.tilt);
    put_seats(drivetrain, duties.front(), angle, means, tilts, result);
  } else if (duties.size() > 1) {
    put_planets(drivetrain, duties.front(), angle, means, result);
    put_system_life(drivetrain, result);
  }
  const std::size_t shown = result.planets.empty() ? 0 : shortest_lived(result.planets);
  result.laminae = at_rest.record_of_laminae(bearings[shown]);
  return result;
}

DynamicRecord record_of(const system::SteadyStateResult& run) {
  return {.steady = run.steady,
          .roller_slip = 1.0 - run.statistics.mean_spin / run.rolling.spin,
          .friction_moment = run.statistics.bore_friction_moment,
          .loss = run.statistics.loss,
          .series = run.series,
          .run = run.report,
          .final_state = run.final_state,
          .layout = run.layout};
}

Eigen::ArrayXd place_angles(Eigen::Index places) {
  const double step = boost::math::double_constants::two_pi / static_cast<double>(places);
  return Eigen::ArrayXd::LinSpaced(places, 0.0, step * static_cast<double>(places - 1));
}

LoadDistribution distribution_of(const WindowStatistics& means) {
  const Eigen::ArrayXd angles = place_angles(means.inner.mean_load.size());
  Eigen::ArrayXd form = Eigen::ArrayXd::Zero(means.mean_waves.size() > 0 ? angles.size() : 0);
  if (form.size() > 0) bearing::add_form(means.mean_waves, 1.0, angles, form);
  return {as_vector(angles), as_vector(means.inner.mean_load), as_vector(means.outer.mean_load),
          as_vector(form)};
}

// A run-up has no speed at which the bearing could be fitted: its gears stay on the tangent.
OneWayRun motion_of(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                    const BearingDuty& duty, const GearsOnTangent& gears) {
  if (drivetrain.run_up.acceleration == 0.0) return run_one_way(drivetrain, geometry, duty, gears);
  return {
      system::run_up(drivetrain.bearing, duty.point, dynamics_parameters(drivetrain, geometry, duty, gears),
                     drivetrain.steady_state, drivetrain.run_up.duration),
      std::nullopt};
}

OneWayRun motion_from(const Eigen::VectorXd& start, const PlanetaryDrivetrain& drivetrain,
                      const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const Eigen::Index required =
      bearing_model(drivetrain.bearing, duty.point, bearing_dynamics(drivetrain, geometry)).layout.size();
  if (start.size() != required)
    throw std::invalid_argument("state to start from: found " + std::to_string(start.size()) +
                                " variables; required: " + std::to_string(required) + ", those of " +
                                std::to_string(drivetrain.bearing.rollers().count) + " rollers");
  return run_one_way(drivetrain, geometry, duty, gears_on_tangent(drivetrain, geometry), start);
}

// The life in hours of a run-up is that at its mean speed.
BearingDuty mean_duty(const PlanetaryDrivetrain& drivetrain, BearingDuty duty) {
  const RunUp& run_up = drivetrain.run_up;
  if (run_up.acceleration == 0.0) return duty;
  const double mean = 1.0 + 0.5 * run_up.acceleration * run_up.duration / drivetrain.drive.speed;
  for (double* speed : {&duty.point.inner_speed, &duty.point.outer_speed}) *speed *= mean;
  return duty;
}

PointResult dynamic_point(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                          const system::SteadyStateResult& run) {
  if (!run.completed) throw std::runtime_error(run.message);
  PointResult result;
  result.inner = race_result(run.statistics.inner);
  result.outer = race_result(run.statistics.outer);
  result.dynamic = record_of(run);
  if (drivetrain.bearing.has_cage())
    result.cage_slip = run.orbit_slip();
  else
    result.dynamic->orbit_slip = run.orbit_slip();
  result.distribution = distribution_of(run.statistics);
  put_life(drivetrain, mean_duty(drivetrain, duty), run.statistics, result);
  return result;
}

PointResult driven_point(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                         const OneWayRun& run) {
  PointResult result = dynamic_point(drivetrain, duty, run.bearing);
  result.dynamic->one_way = run.fit;
  return result;
}

// Of unlike planets or bearings: their loads as passages of one bearing, the series and the end of the
// first's motion.
system::SteadyStateResult together(const std::vector<system::SteadyStateResult>& runs,
                                   const std::vector<WindowStatistics>& means) {
  system::SteadyStateResult all = runs.front();
  all.statistics = system::pooled(means);
  for (const system::SteadyStateResult& run : runs) all.steady = all.steady && run.steady;
  return all;
}

// Of a planet whose tilt is computed, all its bearings, each under its own load.
PointResult seated_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                         const BearingDuty& duty, const GearsOnTangent& gears) {
  std::vector<system::SteadyStateResult> runs;
  std::vector<WindowStatistics> means;
  std::vector<Eigen::Vector2d> tilts;
  for (const SeatedBearing& one : seated_bearings(drivetrain, geometry, duty)) {
    runs.push_back(motion_of(one.drivetrain, one.geometry, one.duty, gears).bearing);
    if (!runs.back().completed) throw std::runtime_error(runs.back().message);
    means.push_back(runs.back().statistics);
    tilts.push_back(one.duty.point.bore_tilt);
  }
  PointResult result = dynamic_point(drivetrain, duty, together(runs, means));
  put_seats(drivetrain, mean_duty(drivetrain, duty), place_angles(means.front().outer.mean_load.size()),
            means, tilts, result);
  return result;
}

PointResult one_way_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const std::vector<BearingDuty>& duties) {
  const GearsOnTangent gears = gears_on_tangent(drivetrain, geometry);
  if (drivetrain.seats.tilt == TiltState::computed)
    return seated_point(drivetrain, geometry, duties.front(), gears);
  if (duties.size() == 1)
    return driven_point(drivetrain, duties.front(), motion_of(drivetrain, geometry, duties.front(), gears));
  std::vector<system::SteadyStateResult> runs;
  std::vector<WindowStatistics> means;
  for (const BearingDuty& duty : duties) {
    runs.push_back(motion_of(drivetrain, geometry, duty, gears).bearing);
    if (!runs.back().completed) throw std::runtime_error(runs.back().message);
    means.push_back(runs.back().statistics);
  }
  PointResult result = dynamic_point(drivetrain, duties.front(), together(runs, means));
  put_planets(drivetrain, mean_duty(drivetrain, duties.front()),
              place_angles(means.front().outer.mean_load.size()), means, result);
  put_system_life(drivetrain, result);
  return result;
}

// The bearings of each planet, taken together. Planet by planet.
std::vector<WindowStatistics> by_planet(const std::vector<WindowStatistics>& bearings, int per_planet) {
  std::vector<WindowStatistics> planets;
  for (auto first = bearings.begin(); first != bearings.end(); first += per_planet)
    planets.push_back(system::pooled({first, first + per_planet}));
  return planets;
}

system::SteadyStateResult run_coupled(const PlanetaryDrivetrain& drivetrain,
                                      const DrivetrainGeometry& geometry,
                                      const bearing::OperatingPoint& point, Fidelity fidelity,
                                      CoupledRecord& record) {
  const double inner = point.inner_speed, outer = point.outer_speed;
  const system::RollingSpeeds rolling{bearing::kinematic_cage_speed(geometry.bearing, inner, outer),
                                      bearing::kinematic_roller_spin(geometry.bearing, inner, outer)};
  const system::CoupledSetup setup = coupled_setup(drivetrain, geometry);
  if (fidelity == Fidelity::monolithic) {
    system::Monolithic motion(setup);
    motion.initialize(0.0);
    return run_to_steady_state(motion, rolling, drivetrain.steady_state);
  }
  cosim::CoSimulatedMotion motion(setup, drivetrain.exchange,
                                  sample_interval(rolling, drivetrain.steady_state));
  const system::SteadyStateResult run = run_to_steady_state(motion, rolling, drivetrain.steady_state);
  record.energy_residual = motion.exchange().absolute_residual / motion.exchange().passed;
  record.window = run.duration / static_cast<double>(motion.exchange().windows);
  return run;
}

PointResult coupled_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const BearingDuty& duty, Fidelity fidelity) {
  CoupledRecord record;
  const system::SteadyStateResult run = run_coupled(drivetrain, geometry, duty.point, fidelity, record);
  PointResult result = dynamic_point(drivetrain, duty, run);
  for (const WindowStatistics& one : run.bearings)
    record.bearing_life_hours.push_back(hours_of(life_under_means(drivetrain, one), drivetrain, duty));
  put_planets(drivetrain, duty, place_angles(run.statistics.outer.mean_load.size()),
              by_planet(run.bearings, drivetrain.bearings_per_planet), result);
  put_system_life(drivetrain, result);
  result.system_life_hours = life_together(record.bearing_life_hours);
  result.coupled = record;
  return result;
}

// Of the duties, whatever the bearing's model, mean over unlike planets: the total on the bore holds what
// reaches it through the cage.
void put_loads(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
               const std::vector<BearingDuty>& duties, PointResult& result) {
  result.input_speed = drivetrain.drive.speed;
  result.carrier_speed = duties.front().gears.carrier_speed;
  const double part = 1.0 / static_cast<double>(duties.size());
  for (const BearingDuty& duty : duties) {
    const Eigen::Vector2d total =
        bearing::total_bore_load(drivetrain.bearing, geometry.bearing, duty.point, drivetrain.inertia);
    const double radial = duty.gears.radial_force / drivetrain.bearings_per_planet;
    result.planet_load += part * total.norm();
    result.tangential_load += part * duty.gears.tangential_force / drivetrain.bearings_per_planet;
    result.radial_mesh_load += part * radial;
    result.centrifugal_load += part * (total.x() - radial);
    result.axial_mesh_force += part * duty.gears.axial_force;
    result.overturning_moment += part * duty.gears.overturning_moment;
    result.sun_thrust += part * duty.gears.sun_thrust;
  }
}

// The load [N] that the whole roller would carry were it loaded all along as where it is loaded most.
double largest_even_load(const RaceResult& race, int laminae) {
  return race.lamina_load_max > 0.0 ? laminae * race.lamina_load_max : race.load_max;
}

double largest_pressure(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                        const PointResult& result) {
  const auto pressure = [&](Race race, const RaceResult& loads) {
    return bearing::hertz_pressure(largest_even_load(loads, drivetrain.bearing.rollers().laminae),
                                   bearing::equivalent_radius(geometry.bearing, race),
                                   drivetrain.bearing.rollers().length, drivetrain.bearing.material);
  };
  return std::max(pressure(Race::inner, result.inner), pressure(Race::outer, result.outer));
}

PointResult completed(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const std::vector<BearingDuty>& duties, PointResult result) {
  put_loads(drivetrain, geometry, duties, result);
  result.contact_pressure = largest_pressure(drivetrain, geometry, result);
  result.radial_clearance = drivetrain.bearing.radial_clearance;
  result.caged = drivetrain.bearing.has_cage();
  return result;
}

}  // namespace

bearing::motion::DynamicsParameters dynamics_parameters(const PlanetaryDrivetrain& drivetrain,
                                                        const DrivetrainGeometry& geometry,
                                                        const BearingDuty& duty,
                                                        const GearsOnTangent& gears) {
  bearing::motion::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  parameters.excitation = excitation_of(gears.run, drivetrain, duty, gears.tangent, parameters.bore_mass);
  parameters.driving.ramp = drivetrain.run_up.acceleration / drivetrain.drive.speed;
  return parameters;
}

PointResult evaluate(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     Fidelity fidelity) {
  const std::vector<BearingDuty> duties = planet_duties(drivetrain, geometry);
  const auto point = [&] {
    if (fidelity == Fidelity::quasi_static) return quasi_static_point(drivetrain, geometry, duties);
    if (fidelity == Fidelity::dynamic) return one_way_point(drivetrain, geometry, duties);
    return coupled_point(drivetrain, geometry, duties.front(), fidelity);
  };
  return completed(drivetrain, geometry, duties, point());
}

PointResult evaluate_from(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const Eigen::VectorXd& start) {
  if (drivetrain.uneven_planets)
    throw std::invalid_argument(
        "state to start from: found one, and planets that load unevenly, where each has its own; required: "
        "planets that carry alike, or points that start from their quasi-static states");
  if (drivetrain.seats.tilt == TiltState::computed)
    throw std::invalid_argument(
        "state to start from: found one, and a planet whose tilt is computed, where each bearing has its "
        "own; "
        "required: a stated tilt, or points that start from their quasi-static states");
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  return completed(drivetrain, geometry, {duty},
                   driven_point(drivetrain, duty, motion_from(start, drivetrain, geometry, duty)));
}

}  // namespace orbearing::study

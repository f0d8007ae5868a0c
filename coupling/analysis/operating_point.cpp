#include "coupling/analysis/operating_point.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/contact/line_contact.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/analysis/driven_setups.hpp"
#include "coupling/analysis/light_load.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/mesh_excitation.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "coupling/analysis/rated_bearing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "coupling/cosim/planetary_coupling.hpp"
#include "coupling/system/monolithic.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

using bearing::Race;

constexpr double kRollerSlope = bearing::rating::weibull_slope(bearing::rating::RollingElement::roller);

using Rating = PlanetBearingRating;

std::vector<double> as_vector(const Eigen::ArrayXd& array) {
  return {array.begin(), array.end()};
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

// `means` of one bearing, or of unlike ones under `loads` [N] as passages of one.
void put_life(const Rating& rating, const WindowStatistics& means, const std::vector<double>& loads,
              PointResult& result) {
  const Rating::Lives lives =
      rating.of(means, mean_by_basic_life(loads), *std::max_element(loads.begin(), loads.end()));
  const PlanetaryDrivetrain& drivetrain = rating.drivetrain();
  const int bearings = drivetrain.set.planets * drivetrain.bearings_per_planet;
  result.inner.life = lives.life.inner;
  result.outer.life = lives.life.outer;
  result.life = lives.life.bearing;
  result.life_hours = lives.hours;
  result.system_life_hours = bearing::system_life(result.life_hours, bearings);
  result.rating = {lives.rating, lives.rated_hours,
                   bearing::rating::hours_of_equal(lives.rated_hours, bearings, kRollerSlope)};
  result.life_method = drivetrain.rated.method;
}

// Bearings of which none may fail: the product law over unlike lives.
double life_together(const std::vector<double>& lives) {
  double together = lives.front();
  for (std::size_t i = 1; i < lives.size(); ++i) together = bearing::combined_life(together, lives[i]);
  return together;
}

// Mean force of the rollers on the bore [N].
Eigen::Vector2d mean_bore_force(const RaceStatistics& outer, const Eigen::ArrayXd& angle, int rollers) {
  const Eigen::ArrayXd load = outer.mean_load * outer.passages;
  return rollers * Eigen::Vector2d((load * angle.cos()).mean(), (load * angle.sin()).mean());
}

// Loads [N] of bearings as their rollers carry, whose mean force is that of `duty`. A couple between bearings
// of a planet adds to the loads of all of them: their mean is then larger than the load of the mean force.
std::vector<double> shared_loads(const Rating& rating, const BearingDuty& duty,
                                 const std::vector<WindowStatistics>& means, const Eigen::ArrayXd& angle) {
  std::vector<Eigen::Vector2d> forces;
  Eigen::Vector2d rest = -rating.load_vector_of(duty);  // of friction and damping, alike for all
  for (const WindowStatistics& one : means) {
    forces.push_back(mean_bore_force(one.outer, angle, rating.drivetrain().bearing.rollers().count));
    rest -= forces.back() / static_cast<double>(means.size());
  }
  std::vector<double> loads;
  for (const Eigen::Vector2d& force : forces) loads.push_back((force + rest).norm());
  return loads;
}

// System life of bearings of which none may fail, and of `alike` such groups.
void put_system_life(const std::vector<double>& lives, const std::vector<bearing::rating::RatedHours>& rated,
                     int alike, PointResult& result) {
  result.system_life_hours = bearing::system_life(life_together(lives), alike);
  result.rating.system_hours = bearing::rating::hours_of_equal(
      bearing::rating::hours_together(rated, kRollerSlope), alike, kRollerSlope);
}

// Planet by planet, from the means of one bearing of each and the load on its bore [N].
void put_planets(const Rating& rating, const Eigen::ArrayXd& angle,
                 const std::vector<WindowStatistics>& means, const std::vector<double>& loads,
                 PointResult& result) {
  const int per_planet = rating.drivetrain().bearings_per_planet;
  double tangential = 0.0;
  std::vector<double> together;
  std::vector<bearing::rating::RatedHours> rated;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const Eigen::Vector2d force =
        mean_bore_force(means[i].outer, angle, rating.drivetrain().bearing.rollers().count);
    const Rating::Lives lives = rating.of(means[i], loads[i]);
    result.planets.push_back({.load_share = force.y(),
                              .load = force.norm(),
                              .life_hours = lives.hours,
                              .rated_hours = lives.rated_hours});
    tangential += force.y() / static_cast<double>(means.size());
    together.push_back(bearing::system_life(lives.hours, per_planet));
    rated.push_back(bearing::rating::hours_of_equal(lives.rated_hours, per_planet, kRollerSlope));
  }
  for (PlanetResult& planet : result.planets) planet.load_share /= tangential;
  put_system_life(together, rated, 1, result);
}

template <class Results>
std::size_t shortest_lived(const Results& results) {
  const auto shortest = std::ranges::min_element(results, {}, [](const auto& one) { return one.life_hours; });
  return static_cast<std::size_t>(shortest - results.begin());
}

// All bearings that were computed: of each duty those of its planet where their tilt is computed, else one.
struct Bearings {
  std::vector<WindowStatistics> means;
  std::vector<Eigen::Vector2d> tilts;  // [rad]  of bore against pin
};

// Bearing by bearing of planets whose tilt is computed, and the loads on their bores [N]; of one planet where
// all are alike, else planet by planet.
void put_seats(const Rating& rating, const Bearings& bearings, const std::vector<double>& loads,
               PointResult& result) {
  const PlanetaryDrivetrain& drivetrain = rating.drivetrain();
  const std::vector<double> positions = axial_positions(drivetrain);
  std::vector<double> lives;
  std::vector<bearing::rating::RatedHours> rated;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Rating::Lives one = rating.of(bearings.means[k], loads[k]);
    lives.push_back(one.hours);
    rated.push_back(one.rated_hours);
    result.seats.push_back({.position = positions[k % positions.size()],
                            .load = loads[k],
                            .tilt = bearings.tilts[k],
                            .life_hours = one.hours,
                            .rated_hours = one.rated_hours});
  }
  put_system_life(lives, rated, loads.size() > positions.size() ? 1 : drivetrain.set.planets, result);
}

// The bearings of each planet, taken together. Planet by planet.
std::vector<WindowStatistics> by_planet(const std::vector<WindowStatistics>& bearings, int per_planet) {
  std::vector<WindowStatistics> planets;
  for (auto first = bearings.begin(); first != bearings.end(); first += per_planet)
    planets.push_back(system::pooled({first, first + per_planet}));
  return planets;
}

std::vector<double> loads_of(const Rating& rating, const std::vector<BearingDuty>& duties) {
  std::vector<double> loads;
  for (const BearingDuty& duty : duties) loads.push_back(rating.load_of(duty));
  return loads;
}

std::optional<LaminaRecord> record_of_laminae(const bearing::laminae::LaminaBearing& bearing,
                                              const QuasiStaticBearing& one) {
  if (!bearing.is_cut()) return std::nullopt;
  const Eigen::ArrayXd positions = bearing.half_length() * bearing.contact(Race::inner).positions();
  return LaminaRecord{.lamina_position = as_vector(positions),
                      .inner_load = as_vector(one.loads.inner_lamina_load),
                      .outer_load = as_vector(one.loads.outer_lamina_load),
                      .roller_tilt = as_vector(one.loads.roller_tilt),
                      .bore_tilt = one.tilt,
                      .moment = one.loads.moment};
}

// Loads [N] of the bearings of planets whose tilt is computed: in each planet as their rollers carry.
std::vector<double> seat_loads(const Rating& rating, const std::vector<BearingDuty>& duties,
                               const std::vector<WindowStatistics>& means, const Eigen::ArrayXd& angle) {
  const PlanetaryDrivetrain& drivetrain = rating.drivetrain();
  std::vector<double> loads;
  auto first = means.begin();
  for (const BearingDuty& duty : duties) {
    const std::vector<double> of_planet =
        shared_loads(rating, duty, {first, first + drivetrain.bearings_per_planet}, angle);
    loads.insert(loads.end(), of_planet.begin(), of_planet.end());
    first += drivetrain.bearings_per_planet;
  }
  return loads;
}

// Loads and lives of all of them, together those of `all`. Each unlike planet whose tilt is computed has the
// life of its bearings taken together.
void put_bearings(const Rating& rating, const std::vector<BearingDuty>& duties, const Eigen::ArrayXd& angle,
                  const Bearings& bearings, const WindowStatistics& all, PointResult& result) {
  const PlanetaryDrivetrain& drivetrain = rating.drivetrain();
  const bool seated = drivetrain.seats.tilt == TiltState::computed;
  const std::vector<double> loads =
      seated ? seat_loads(rating, duties, bearings.means, angle) : loads_of(rating, duties);
  put_life(rating, all, loads, result);
  const int per_planet = seated ? drivetrain.bearings_per_planet : 1;
  std::vector<double> of_planets;
  for (auto first = loads.begin(); first != loads.end(); first += per_planet)
    of_planets.push_back(mean_by_basic_life({first, first + per_planet}));
  if (duties.size() > 1)
    put_planets(rating, angle, by_planet(bearings.means, per_planet), of_planets, result);
  if (seated) put_seats(rating, bearings, loads, result);
}

PointResult quasi_static_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const std::vector<BearingDuty>& duties) {
  BearingsAtRest at_rest(drivetrain, geometry);
  std::vector<QuasiStaticBearing> resting;
  Bearings bearings;
  for (const BearingDuty& duty : duties)
    for (QuasiStaticBearing& one : at_rest.of(duty)) {
      bearings.means.push_back(std::move(one.means));
      bearings.tilts.push_back(one.tilt);
      resting.push_back(std::move(one));
    }
  const WindowStatistics all = system::pooled(bearings.means);
  PointResult result;
  result.inner = race_result(all.inner);
  result.outer = race_result(all.outer);
  const Eigen::ArrayXd& angle = resting.front().loads.angle;
  result.distribution = {as_vector(angle), as_vector(all.inner.mean_load), as_vector(all.outer.mean_load),
                         as_vector(resting.front().loads.race_form)};
  put_bearings(Rating(drivetrain, geometry, duties.front()), duties, angle, bearings, all, result);
  const std::size_t shown = result.planets.empty() ? 0
                            : result.seats.empty() ? shortest_lived(result.planets)
                                                   : shortest_lived(result.seats);
  result.laminae = record_of_laminae(at_rest.bearing(), resting[shown]);
  return result;
}

DynamicRecord record_of(const system::SteadyStateResult& run) {
  return {{.steady = run.steady,
           .roller_slip = 1.0 - run.statistics.mean_spin / run.rolling.spin,
           .friction_moment = run.statistics.bore_friction_moment,
           .vibration_power = run.statistics.vibration_power,
           .loss = run.statistics.loss},
          run.series,
          run.report,
          run.final_state,
          run.layout,
          std::nullopt};
}

Eigen::ArrayXd position_angles(Eigen::Index positions) {
  const double step = constants::two_pi / static_cast<double>(positions);
  return Eigen::ArrayXd::LinSpaced(positions, 0.0, step * static_cast<double>(positions - 1));
}

LoadDistribution distribution_of(const WindowStatistics& means) {
  const Eigen::ArrayXd angles = position_angles(means.inner.mean_load.size());
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

// But for lives: of one bearing, or of unlike ones as passages of one.
PointResult dynamic_point(const PlanetaryDrivetrain& drivetrain, const system::SteadyStateResult& run) {
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
  return result;
}

PointResult driven_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                         const BearingDuty& duty, const OneWayRun& run) {
  const Rating rating(drivetrain, geometry, mean_duty(drivetrain, duty));
  PointResult result = dynamic_point(drivetrain, run.bearing);
  put_life(rating, run.bearing.statistics, {rating.load_of(duty)}, result);
  result.dynamic->one_way = run.fit;
  result.dynamic->one_way_load_difference = run.load_difference;
  return result;
}

// One bearing of each duty; where the tilt of planets is computed all of them, each under its own load.
std::vector<SeatedBearing> bearings_to_drive(const PlanetaryDrivetrain& drivetrain,
                                             const DrivetrainGeometry& geometry,
                                             const std::vector<BearingDuty>& duties) {
  std::vector<SeatedBearing> all;
  if (drivetrain.seats.tilt != TiltState::computed) {
    for (const BearingDuty& duty : duties) all.push_back({drivetrain, geometry, duty});
    return all;
  }
  const PlanetSeat seat = seat_of_each(drivetrain, geometry);
  for (const BearingDuty& duty : duties)
    for (SeatedBearing& one : seated_bearings(seat, drivetrain, geometry, duty))
      all.push_back(std::move(one));
  return all;
}

// Unlike bearings: their loads as passages of one bearing, the series and the end of the first's motion.
PointResult one_way_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const std::vector<BearingDuty>& duties) {
  const GearsOnTangent gears = gears_on_tangent(drivetrain, geometry);
  if (duties.size() == 1 && drivetrain.seats.tilt != TiltState::computed)
    return driven_point(drivetrain, geometry, duties.front(),
                        motion_of(drivetrain, geometry, duties.front(), gears));
  system::SteadyStateResult all;
  Bearings bearings;
  for (const SeatedBearing& one : bearings_to_drive(drivetrain, geometry, duties)) {
    system::SteadyStateResult run = motion_of(one.drivetrain, one.geometry, one.duty, gears).bearing;
    if (!run.completed) throw std::runtime_error(run.message);
    const bool steady = run.steady && (bearings.means.empty() || all.steady);
    bearings.means.push_back(run.statistics);
    bearings.tilts.push_back(one.duty.point.bore_tilt);
    if (bearings.means.size() == 1) all = std::move(run);
    all.steady = steady;
  }
  all.statistics = system::pooled(bearings.means);
  const Rating rating(drivetrain, geometry, mean_duty(drivetrain, duties.front()));
  PointResult result = dynamic_point(drivetrain, all);
  put_bearings(rating, duties, position_angles(all.statistics.outer.mean_load.size()), bearings,
               all.statistics, result);
  return result;
}

system::SteadyStateResult run_coupled(const PlanetaryDrivetrain& drivetrain,
                                      const DrivetrainGeometry& geometry,
                                      const bearing::OperatingPoint& point, Fidelity fidelity,
                                      CoupledRecord& record) {
  const double inner = point.inner_speed, outer = point.outer_speed;
  const system::RollingSpeeds rolling{bearing::kinematic_cage_speed(geometry.bearing, inner, outer),
                                      bearing::kinematic_roller_spin(geometry.bearing, inner, outer)};
  const system::CoupledSetup setup = coupled_setup(drivetrain, geometry);
  const system::SteadyStateOptions options =
      with_window(drivetrain.steady_state, drivetrain.dynamics.gravity, point.carrier.speed);
  if (fidelity == Fidelity::monolithic) {
    system::Monolithic motion(setup);
    motion.initialize(0.0);
    return run_to_steady_state(motion, rolling, options);
  }
  cosim::CoSimulatedMotion motion(setup, drivetrain.exchange, sample_interval(rolling, options));
  const system::SteadyStateResult run = run_to_steady_state(motion, rolling, options);
  record.energy_residual = motion.exchange().absolute_residual / motion.exchange().passed;
  record.window = run.duration / static_cast<double>(motion.exchange().windows);
  return run;
}

PointResult coupled_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const BearingDuty& duty, Fidelity fidelity) {
  CoupledRecord record;
  const system::SteadyStateResult run = run_coupled(drivetrain, geometry, duty.point, fidelity, record);
  const Rating rating(drivetrain, geometry, mean_duty(drivetrain, duty));
  const Eigen::ArrayXd angle = position_angles(run.statistics.outer.mean_load.size());
  const auto loads_under = [&](const std::vector<WindowStatistics>& means) {
    return shared_loads(rating, duty, means, angle);
  };
  const std::vector<double> loads = loads_under(run.bearings);
  PointResult result = dynamic_point(drivetrain, run);
  put_life(rating, run.statistics, loads, result);
  const std::vector<WindowStatistics> planets = by_planet(run.bearings, drivetrain.bearings_per_planet);
  put_planets(rating, angle, planets, loads_under(planets), result);
  std::vector<bearing::rating::RatedHours> rated;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Rating::Lives lives = rating.of(run.bearings[i], loads[i]);
    record.bearing_life_hours.push_back(lives.hours);
    rated.push_back(lives.rated_hours);
  }
  put_system_life(record.bearing_life_hours, rated, 1, result);
  result.coupled = record;
  return result;
}

// In time. If the bore moves with its gears, they are solved together; if that fails, the bearing is driven
// one way.
PointResult moving_point(const PlanetaryDrivetrain& stated, const DrivetrainGeometry& geometry,
                         const std::vector<BearingDuty>& duties, Fidelity fidelity) {
  const MeansAtRest at_rest = means_at_rest(stated, geometry, duties);
  const PlanetaryDrivetrain drivetrain = with_error_of_load(stated, at_rest);
  const std::optional<double> drag =
      drag_over_traction(drivetrain, geometry, duties.front(), at_rest.front());
  const auto point = [&]() -> PointResult {
    if (fidelity != Fidelity::dynamic) return coupled_point(drivetrain, geometry, duties.front(), fidelity);
    if (moves_with_its_gears(drivetrain, drag.value_or(0.0))) try {
        return coupled_point(drivetrain, geometry, duties.front(), Fidelity::monolithic);
      } catch (const std::runtime_error&) {  // its row states which of both it is
      }
    return one_way_point(drivetrain, geometry, duties);
  };
  PointResult result = point();
  result.dynamic->drag_over_traction = drag;
  result.dynamic->drag_slip = slip_by_drag(drivetrain, geometry, duties.front(), at_rest.front());
  return result;
}

// Loads of the duties, for any model of the bearing, mean over unlike planets. The total on the bore includes
// the load through the cage.
void put_loads(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
               const std::vector<BearingDuty>& duties, PointResult& result) {
  result.input_speed = drivetrain.drive.speed;
  result.carrier_speed = duties.front().gears.carrier_speed;
  const double part = 1.0 / static_cast<double>(duties.size());
  for (const BearingDuty& duty : duties) {
    const Eigen::Vector2d total = bore_load_with_cage(drivetrain, geometry, duty.point);
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

double largest_pressure(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                        const PointResult& result) {
  const int laminae = drivetrain.bearing.rollers().laminae;
  return largest_hertz_pressure(drivetrain, geometry, result.inner.largest_even_load(laminae),
                                result.outer.largest_even_load(laminae));
}

PointResult completed(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const std::vector<BearingDuty>& duties, PointResult result) {
  put_loads(drivetrain, geometry, duties, result);
  if (drivetrain.rows.is_cylindrical())
    result.contact_pressure = largest_pressure(drivetrain, geometry, result);
  result.radial_clearance = drivetrain.bearing.radial_clearance;
  result.rim_over_module = geometry.rim_over_module;
  result.caged = drivetrain.bearing.has_cage();
  return result;
}

PointResult completed_in_motion(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                const std::vector<BearingDuty>& duties, PointResult result) {
  result = completed(drivetrain, geometry, duties, std::move(result));
  if (is_rated_on_laminae(drivetrain))
    result.contact_pressure =
        pressure_along_the_roller(drivetrain, geometry, result.inner.load_max, result.outer.load_max);
  return result;
}

// The lives by the standards of the same bearings, cut into laminae, replace those of whole contacts.
template <class Unlike>
void take_rated_hours(const std::vector<Unlike>& rated, std::vector<Unlike>& of) {
  for (std::size_t k = 0; k < of.size(); ++k) of[k].rated_hours = rated[k].rated_hours;
}

PointResult rated_by(const PointResult& cut, PointResult whole) {
  whole.rating = cut.rating;
  whole.contact_pressure = cut.contact_pressure;
  take_rated_hours(cut.planets, whole.planets);
  take_rated_hours(cut.seats, whole.seats);
  return whole;
}

PointResult inclined(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  return completed(drivetrain, geometry, {duty}, inclined_point(drivetrain, geometry, duty));
}

PointResult cylindrical_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                const std::vector<BearingDuty>& duties) {
  return completed(drivetrain, geometry, duties, quasi_static_point(drivetrain, geometry, duties));
}

// Loads are those of whole contacts; lives by the standards and the pressure are those of laminae.
PointResult cylindrical_at_rest_rated(const PlanetaryDrivetrain& drivetrain,
                                      const DrivetrainGeometry& geometry, std::vector<BearingDuty> duties) {
  PointResult whole = cylindrical_at_rest(drivetrain, geometry, duties);
  if (!is_rated_on_laminae(drivetrain)) return whole;
  for (BearingDuty& duty : duties) duty.near.reset();  // of whole contacts
  return rated_by(cylindrical_at_rest(cut_for_rating(drivetrain), geometry, duties), std::move(whole));
}

void require_cylindrical_beyond_rest(const PlanetaryDrivetrain& drivetrain, Fidelity fidelity) {
  if (fidelity == Fidelity::quasi_static && !drivetrain.uneven_planets && drivetrain.rim == PlanetRim::rigid)
    return;
  throw std::logic_error(
      "bearing.type: found " + std::string(described::text_of(drivetrain.rows.type)) +
      "; required: cylindrical-roller in motion, with an elastic rim and where planets carry unlike loads");
}

}  // namespace

bool moves_with_its_gears(const PlanetaryDrivetrain& drivetrain, double drag_over_traction) {
  const bool moving = drivetrain.gear_set && !drivetrain.in_arrangement &&
                      drivetrain.run_up.acceleration == 0.0 && drivetrain.seats.tilt != TiltState::computed;
  return moving && (!drivetrain.bearing.has_cage() || drag_over_traction > kLightLoad);
}

bearing::rating::Life governing_life(const PointResult& result) {
  return bearing::rating::governing_life(result.life_method, result.rating.lives.oil.has_value());
}

double governing_hours(const PointResult& result) {
  return bearing::rating::hours_of(governing_life(result), result.life_hours, result.rating.hours);
}

bearing::motion::DynamicsParameters dynamics_parameters(const PlanetaryDrivetrain& drivetrain,
                                                        const DrivetrainGeometry& geometry,
                                                        const BearingDuty& duty,
                                                        const GearsOnTangent& gears) {
  bearing::motion::DynamicsParameters parameters = bearing_dynamics_of(duty, drivetrain, geometry);
  parameters.excitation = excitation_of(gears.run, drivetrain, duty, gears.tangent, parameters.bore_mass);
  parameters.driving.ramp = drivetrain.run_up.acceleration / drivetrain.drive.speed;
  return parameters;
}

PointResult evaluate(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     Fidelity fidelity) {
  if (!drivetrain.rows.is_cylindrical()) {
    require_cylindrical_beyond_rest(drivetrain, fidelity);
    PointResult whole = inclined(drivetrain, geometry);
    if (!is_rated_on_laminae(drivetrain)) return whole;
    return rated_by(inclined(cut_for_rating(drivetrain), geometry), std::move(whole));
  }
  const std::vector<BearingDuty> duties = planet_duties(drivetrain, geometry);
  if (fidelity != Fidelity::quasi_static)
    return completed_in_motion(drivetrain, geometry, duties,
                               moving_point(drivetrain, geometry, duties, fidelity));
  PointResult at_rest = cylindrical_at_rest_rated(drivetrain, geometry, duties);
  if (drivetrain.carrier_mounting) at_rest.carrier = carrier_revolution(drivetrain, geometry);
  return at_rest;
}

double gain_by_stiffer_rim(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           double factor) {
  if (!geometry.rim) return 0.0;
  gearset::rim::RimInfluence rim = *geometry.rim;
  rim.race /= factor;
  for (gearset::rim::RaceForm* form : {&rim.by_sun, &rim.by_ring}) {
    form->cosine /= factor;
    form->sine /= factor;
  }
  rim.meshes /= factor;
  DrivetrainGeometry stiffer = geometry;
  stiffer.rim = std::make_shared<const gearset::rim::RimInfluence>(std::move(rim));
  return evaluate(drivetrain, stiffer).life_hours / evaluate(drivetrain, geometry).life_hours - 1.0;
}

PointResult evaluate_from(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const Eigen::VectorXd& start) {
  if (!drivetrain.rows.is_cylindrical()) require_cylindrical_beyond_rest(drivetrain, Fidelity::dynamic);
  if (moves_with_its_gears(drivetrain, 0.0))
    throw std::invalid_argument(
        "state to start from: found one, and bearings without cage, which are solved together with their "
        "gears; required: a cage, or points that start from their quasi-static states");
  if (drivetrain.uneven_planets)
    throw std::invalid_argument(
        "state to start from: found one, and planets that load unevenly, where each has its own; required: "
        "planets with equal loads, or points that start from their quasi-static states");
  if (drivetrain.seats.tilt == TiltState::computed)
    throw std::invalid_argument(
        "state to start from: found one, and a planet whose tilt is computed, where each bearing has its "
        "own; "
        "required: a stated tilt, or points that start from their quasi-static states");
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const PlanetaryDrivetrain following =
      with_error_of_load(drivetrain, means_at_rest(drivetrain, geometry, {duty}));
  return completed_in_motion(
      following, geometry, {duty},
      driven_point(following, geometry, duty, motion_from(start, following, geometry, duty)));
}

}  // namespace orbearing::analysis

#include "coupling/study/operating_point.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/dynamics/layout.hpp"
#include "bearing/laminae/lamina_bearing.hpp"
#include "bearing/life/lamina_life.hpp"
#include "bearing/line_contact.hpp"
#include "bearing/lundberg_palmgren.hpp"
#include "bearing/race_equilibrium.hpp"
#include "coupling/integration/run_up.hpp"
#include "coupling/study/coupled_motion.hpp"
#include "coupling/study/mesh_ripple.hpp"
#include "coupling/study/two_way.hpp"

namespace orbearing::study {

namespace {

using bearing::Race;

std::vector<double> as_vector(const Eigen::ArrayXd& array) {
  return {array.begin(), array.end()};
}

// The film is a result whether or not it takes part in the approach.
double least_film(const bearing::Film& film, double load) {
  return film.cap() > 0.0 ? film.least(load) : std::numeric_limits<double>::quiet_NaN();
}

// The load stands still in the carrier frame, and with it the pin; the bore turns under it.
constexpr Race kStanding = Race::inner;

void put_life(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
              const bearing::BearingLife& life, PointResult& result) {
  result.inner.life = life.inner;
  result.outer.life = life.outer;
  result.life_hours = bearing::hours(life.bearing, duty.point.outer_speed);
  result.system_life_hours =
      bearing::system_life(result.life_hours, drivetrain.set.planets * drivetrain.bearings_per_planet);
}

RaceResult race_result(const Eigen::ArrayXd& loads, const bearing::Film& film) {
  return {.load_max = loads.maxCoeff(),
          .load_rms = std::sqrt(loads.square().mean()),
          .least_film = least_film(film, loads.maxCoeff())};
}

bearing::QuasiStaticOptions quasi_static_options(const PlanetaryDrivetrain& drivetrain) {
  bearing::QuasiStaticOptions options{.inertia = drivetrain.inertia,
                                      .cage_positions = drivetrain.cage_positions};
  if (drivetrain.film_in_approach) options.film = drivetrain.lubricant;
  options.film_approach = drivetrain.film_approach;
  return options;
}

std::vector<double> as_vector(const Eigen::ArrayXXd& array) {
  return {array.data(), array.data() + array.size()};
}

// Whole contacts are cut into one lamina, which carries all of the load.
Eigen::ArrayXXd inner_pieces(const bearing::QuasiStaticResult& loads) {
  return loads.inner_load.transpose();
}
Eigen::ArrayXXd outer_pieces(const bearing::QuasiStaticResult& loads) {
  return loads.outer_load.transpose();
}
const Eigen::ArrayXXd& inner_pieces(const bearing::laminae::LaminaResult& loads) {
  return loads.inner_lamina_load;
}
const Eigen::ArrayXXd& outer_pieces(const bearing::laminae::LaminaResult& loads) {
  return loads.outer_lamina_load;
}

// Loads by place of either model.
template <class Loads>
PointResult point_of_loads(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const BearingDuty& duty, const Loads& loads) {
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  const bearing::RollerContacts rolling =
      bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, duty.point.inner_speed,
                                duty.point.outer_speed, drivetrain.lubricant);
  PointResult result;
  result.inner = race_result(loads.inner_load, rolling.inner.film());
  result.outer = race_result(loads.outer_load, rolling.outer.film());
  result.distribution = {as_vector(loads.angle), as_vector(loads.inner_load), as_vector(loads.outer_load)};
  const bearing::life::LaminaRating rating =
      bearing::life::lamina_rating(drivetrain.bearing, bearing::life::race_motions(duty.point),
                                   bearing::life::LifeMeasure::lundberg_palmgren, drivetrain.lambda);
  put_life(drivetrain, duty, lamina_life(rating, inner_pieces(loads), outer_pieces(loads)), result);
  return result;
}

// One instruction set everywhere, so that points are equal to the last bit on all machines of a sweep.
PointResult lamina_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                         const BearingDuty& duty) {
  const bearing::laminae::LaminaBearing cut(drivetrain.bearing, bearing::fast::InstructionSet::baseline);
  const bearing::laminae::LaminaResult loads =
      bearing::laminae::quasi_static_laminae(cut, duty.point, quasi_static_options(drivetrain));
  PointResult result = point_of_loads(drivetrain, geometry, duty, loads);
  const Eigen::ArrayXd places = cut.half_length() * cut.contact(Race::inner).places();
  result.laminae = {.lamina_place = as_vector(places),
                    .inner_load = as_vector(loads.inner_lamina_load),
                    .outer_load = as_vector(loads.outer_lamina_load),
                    .roller_tilt = as_vector(loads.roller_tilt),
                    .bore_tilt = duty.point.bore_tilt,
                    .moment = loads.moment};
  return result;
}

PointResult quasi_static_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const BearingDuty& duty) {
  if (drivetrain.bearing.laminae > 0) return lamina_point(drivetrain, geometry, duty);
  return point_of_loads(
      drivetrain, geometry, duty,
      bearing::quasi_static_bearing(drivetrain.bearing, duty.point, quasi_static_options(drivetrain)));
}

RaceResult race_result(const bearing::dynamics::RaceStatistics& race) {
  return {.load_max = race.load_max, .load_rms = race.load_rms, .least_film = race.least_film};
}

DynamicRecord record_of(const integration::SteadyStateResult& run) {
  return {.steady = run.steady,
          .roller_slip = 1.0 - run.statistics.mean_spin / run.kinematic_spin,
          .friction_moment = run.statistics.bore_friction_moment,
          .loss = run.statistics.loss,
          .series = run.series,
          .run = run.report,
          .final_state = run.final_state};
}

LoadDistribution distribution_of(const bearing::dynamics::WindowStatistics& means) {
  const Eigen::Index places = means.inner.mean_load.size();
  const double step = boost::math::double_constants::two_pi / static_cast<double>(places);
  const Eigen::ArrayXd angle = Eigen::ArrayXd::LinSpaced(places, 0.0, step * static_cast<double>(places - 1));
  return {as_vector(angle), as_vector(means.inner.mean_load), as_vector(means.outer.mean_load)};
}

integration::SteadyStateResult motion_of(const PlanetaryDrivetrain& drivetrain,
                                         const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const bearing::dynamics::DynamicsParameters parameters = dynamics_parameters(drivetrain, geometry, duty);
  if (parameters.driving.growth == 0.0)
    return integration::run_to_steady_state(drivetrain.bearing, duty.point, parameters,
                                            drivetrain.steady_state);
  return integration::run_up(drivetrain.bearing, duty.point, parameters, drivetrain.steady_state,
                             drivetrain.run_up.duration);
}

integration::SteadyStateResult motion_from(const Eigen::VectorXd& start,
                                           const PlanetaryDrivetrain& drivetrain,
                                           const DrivetrainGeometry& geometry, const BearingDuty& duty) {
  const Eigen::Index required = bearing::dynamics::StateLayout{drivetrain.bearing.rollers}.size();
  if (start.size() != required)
    throw std::invalid_argument("state to start from: found " + std::to_string(start.size()) +
                                " variables; required: " + std::to_string(required) + ", those of " +
                                std::to_string(drivetrain.bearing.rollers) + " rollers");
  return integration::run_to_steady_state_from(start, drivetrain.bearing, duty.point,
                                               dynamics_parameters(drivetrain, geometry, duty),
                                               drivetrain.steady_state);
}

// The life in hours of a run-up is that at its mean speed.
BearingDuty mean_duty(const PlanetaryDrivetrain& drivetrain, BearingDuty duty) {
  const RunUp& run_up = drivetrain.run_up;
  if (run_up.acceleration != 0.0)
    duty.point.outer_speed *= 1.0 + 0.5 * run_up.acceleration * run_up.duration / drivetrain.drive.speed;
  return duty;
}

PointResult dynamic_point(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
                          const integration::SteadyStateResult& run) {
  if (!run.completed) throw std::runtime_error(run.message);
  PointResult result;
  result.inner = race_result(run.statistics.inner);
  result.outer = race_result(run.statistics.outer);
  result.cage_slip = run.cage_slip();
  result.distribution = distribution_of(run.statistics);
  result.dynamic = record_of(run);
  put_life(drivetrain, mean_duty(drivetrain, duty),
           bearing::dynamics::dynamic_life(drivetrain.bearing, drivetrain.lambda, kStanding, run.statistics),
           result);
  return result;
}

// Bearings of which none may fail: the product law over unlike lives.
double life_together(const std::vector<double>& lives) {
  double together = lives.front();
  for (std::size_t i = 1; i < lives.size(); ++i) together = bearing::combined_life(together, lives[i]);
  return together;
}

PointResult two_way_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const BearingDuty& duty, Fidelity fidelity) {
  const bearing::OperatingPoint& point = duty.point;
  const double cage_speed =
      bearing::kinematic_cage_speed(geometry.bearing, point.inner_speed, point.outer_speed);
  const std::unique_ptr<cosim::CoupledMotion> motion =
      coupled_motion(drivetrain, geometry, fidelity, sample_interval(cage_speed, drivetrain.steady_state));
  const TwoWayMeans run =
      run_two_way(*motion, cage_speed,
                  bearing::kinematic_roller_spin(geometry.bearing, point.inner_speed, point.outer_speed),
                  drivetrain.steady_state);
  PointResult result = dynamic_point(drivetrain, duty, run.pooled);
  TwoWayRecord record{.exchange = motion->report()};
  for (const bearing::dynamics::WindowStatistics& one : run.bearings)
    record.bearing_life_hours.push_back(bearing::hours(
        bearing::dynamics::dynamic_life(drivetrain.bearing, drivetrain.lambda, kStanding, one).bearing,
        point.outer_speed));
  if (fidelity == Fidelity::co_simulated) {
    record.energy_residual = record.exchange.energy_residual / record.exchange.energy_passed;
    record.window = run.duration / static_cast<double>(record.exchange.windows);
  }
  result.system_life_hours = life_together(record.bearing_life_hours);
  result.two_way = record;
  return result;
}

// Of the duty, whatever the bearing's model: the total on the bore holds what reaches it through the cage.
void put_loads(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
               const BearingDuty& duty, PointResult& result) {
  Eigen::Vector2d total = duty.point.bore_load;
  if (drivetrain.bearing.cage.guidance == Race::outer)
    total += bearing::load_through_cage(drivetrain.bearing, geometry.bearing, duty.point.carrier,
                                        drivetrain.inertia);
  result.input_speed = drivetrain.drive.speed;
  result.carrier_speed = duty.gears.carrier_speed;
  result.planet_load = total.norm();
  result.tangential_load = duty.gears.tangential_force / drivetrain.bearings_per_planet;
  result.radial_mesh_load = duty.gears.radial_force / drivetrain.bearings_per_planet;
  result.centrifugal_load = total.x() - result.radial_mesh_load;
}

// The load [N] that the whole roller would carry were it loaded all along as where it is loaded most.
double largest_even_load(double roller_load, const std::vector<double>* lamina_loads, int laminae) {
  return lamina_loads ? laminae * *std::max_element(lamina_loads->begin(), lamina_loads->end()) : roller_load;
}

double largest_pressure(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                        const PointResult& result) {
  const auto pressure = [&](Race race, double load, const std::vector<double>* lamina_loads) {
    return bearing::hertz_pressure(largest_even_load(load, lamina_loads, drivetrain.bearing.laminae),
                                   bearing::equivalent_radius(geometry.bearing, race),
                                   drivetrain.bearing.roller_length, drivetrain.bearing.material);
  };
  const LaminaRecord* cut = result.laminae ? &*result.laminae : nullptr;
  return std::max(pressure(Race::inner, result.inner.load_max, cut ? &cut->inner_load : nullptr),
                  pressure(Race::outer, result.outer.load_max, cut ? &cut->outer_load : nullptr));
}

PointResult completed(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty, PointResult result) {
  put_loads(drivetrain, geometry, duty, result);
  result.contact_pressure = largest_pressure(drivetrain, geometry, result);
  return result;
}

}  // namespace

bearing::dynamics::DynamicsParameters bearing_dynamics(const PlanetaryDrivetrain& drivetrain,
                                                       const DrivetrainGeometry& geometry) {
  bearing::dynamics::DynamicsParameters parameters = drivetrain.dynamics;
  parameters.inertia = drivetrain.inertia;
  parameters.lubricant = drivetrain.lubricant;
  parameters.race.film_in_approach = drivetrain.film_in_approach;
  parameters.race.film_approach = drivetrain.film_approach;
  parameters.bore_mass = geometry.planet_mass / drivetrain.bearings_per_planet;
  return parameters;
}

bearing::dynamics::DynamicsParameters dynamics_parameters(const PlanetaryDrivetrain& drivetrain,
                                                          const DrivetrainGeometry& geometry,
                                                          const BearingDuty& duty) {
  bearing::dynamics::DynamicsParameters parameters = bearing_dynamics(drivetrain, geometry);
  parameters.ripple = mesh_ripple(drivetrain, geometry, duty);
  parameters.driving.growth = drivetrain.run_up.acceleration / drivetrain.drive.speed;
  return parameters;
}

PointResult evaluate(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     Fidelity fidelity) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  if (fidelity == Fidelity::quasi_static)
    return completed(drivetrain, geometry, duty, quasi_static_point(drivetrain, geometry, duty));
  if (fidelity != Fidelity::dynamic)
    return completed(drivetrain, geometry, duty, two_way_point(drivetrain, geometry, duty, fidelity));
  const integration::SteadyStateResult run = motion_of(drivetrain, geometry, duty);
  return completed(drivetrain, geometry, duty, dynamic_point(drivetrain, duty, run));
}

PointResult evaluate_from(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const Eigen::VectorXd& start) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const integration::SteadyStateResult run = motion_from(start, drivetrain, geometry, duty);
  return completed(drivetrain, geometry, duty, dynamic_point(drivetrain, duty, run));
}

}  // namespace orbearing::study

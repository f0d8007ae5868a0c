#include "coupling/study/operating_point.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/lundberg_palmgren.hpp"
#include "bearing/race_equilibrium.hpp"

namespace orbearing::study {

namespace {

using bearing::Race;

std::vector<double> as_vector(const Eigen::ArrayXd& array) { return {array.begin(), array.end()}; }

// The film is a result whether or not it takes part in the approach.
double least_film(const bearing::Film& film, double load) {
  return film.cap() > 0.0 ? film.least(load) : std::numeric_limits<double>::quiet_NaN();
}

RaceResult race_result(const Eigen::ArrayXd& loads, double life, const bearing::Film& film) {
  return {.load_max = loads.maxCoeff(),
          .load_rms = std::sqrt(loads.square().mean()),
          .life = life,
          .least_film = least_film(film, loads.maxCoeff())};
}

void put_loads(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty, const Eigen::Vector2d& total,
               PointResult& result) {
  const double bearings = drivetrain.bearings_per_planet;
  result.input_speed = drivetrain.drive.speed;
  result.carrier_speed = duty.gears.carrier_speed;
  result.planet_load = total.norm();
  result.tangential_load = duty.gears.tangential_force / bearings;
  result.radial_mesh_load = duty.gears.radial_force / bearings;
  result.centrifugal_load = total.x() - result.radial_mesh_load;
}

void put_lives(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty,
               const bearing::QuasiStaticResult& loads, PointResult& result) {
  // The load stands still in the carrier frame, and with it the pin; the bore turns under it.
  const bearing::BearingLife life = bearing::lundberg_palmgren_life(
      drivetrain.bearing, drivetrain.lambda, Race::inner, loads.inner_load, loads.outer_load);
  const bearing::RollerContacts rolling =
      bearing::rolling_contacts(drivetrain.bearing, bearing::geometry_of(drivetrain.bearing),
                                duty.point.inner_speed, duty.point.outer_speed, drivetrain.lubricant);
  result.inner = race_result(loads.inner_load, life.inner, rolling.inner.film());
  result.outer = race_result(loads.outer_load, life.outer, rolling.outer.film());
  result.life_hours = bearing::hours(life.bearing, duty.point.outer_speed);
  result.system_life_hours =
      bearing::system_life(result.life_hours, drivetrain.set.planets * drivetrain.bearings_per_planet);
}

}  // namespace

PointResult evaluate(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) {
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  bearing::QuasiStaticOptions options{.inertia = drivetrain.inertia, .cage_positions = drivetrain.cage_positions};
  if (drivetrain.film_in_approach) options.film = drivetrain.lubricant;
  const bearing::QuasiStaticResult loads = bearing::quasi_static_bearing(drivetrain.bearing, duty.point, options);
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  PointResult result;
  put_loads(drivetrain, duty, loads.total_bore_load, result);
  put_lives(drivetrain, duty, loads, result);
  result.distribution = {as_vector(loads.angle), as_vector(loads.inner_load), as_vector(loads.outer_load)};
  return result;
}

}  // namespace orbearing::study

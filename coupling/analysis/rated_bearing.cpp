#include "coupling/analysis/rated_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/contact/heated_film.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/units.hpp"
#include "coupling/analysis/tilting_planet.hpp"

namespace orbearing::analysis {

// The film is a result whether or not it takes part in the approach.
double least_film_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          bearing::Race race, const bearing::Film& film, double load) {
  if (!(film.cap() > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const auto heating = bearing::FilmHeating::of(drivetrain.dynamics.race, drivetrain.dynamics.lubricant);
  return film.least(load) * heating.share(bearing::film_contact(drivetrain.bearing, geometry.bearing, race,
                                                                drivetrain.dynamics.lubricant),
                                          load, std::exp(film.log_speed()));
}

namespace {

using bearing::motion::RaceStatistics;
using bearing::motion::WindowStatistics;
using bearing::vectorised::AlignedPitch;

// Every position of the quasi-static bearing has equal passages, under one load.
RaceStatistics race_means(const Eigen::ArrayXd& loads, double least_film) {
  return {.load_rms = std::sqrt(loads.square().mean()),
          .load_max = loads.maxCoeff(),
          .mean_load = loads,
          .passages = Eigen::ArrayXd::Ones(loads.size()),
          .damage = loads.square().square(),
          .least_film = least_film};
}

void put_laminae(const Eigen::ArrayXXd& loads, RaceStatistics& means) {
  means.lamina_damage = loads.square().square();
  means.lamina_load_max = loads.maxCoeff();
}

QuasiStaticBearing bearing_under(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 const BearingDuty& duty, bearing::QuasiStaticResult loads,
                                 const Eigen::Vector2d& tilt) {
  if (!loads.report.converged) throw std::runtime_error(loads.report.message);
  const bearing::RollerContacts rolling =
      bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, duty.point.inner_speed,
                                duty.point.outer_speed, drivetrain.dynamics.lubricant);
  WindowStatistics means;
  const auto means_on = [&](bearing::Race race, const bearing::Film& film, const Eigen::ArrayXd& load) {
    return race_means(load, least_film_at_rest(drivetrain, geometry, race, film, load.maxCoeff()));
  };
  means.inner = means_on(bearing::Race::inner, rolling.inner.film(), loads.inner_load);
  means.outer = means_on(bearing::Race::outer, rolling.outer.film(), loads.outer_load);
  if (drivetrain.bearing.rollers().laminae > 0) {
    put_laminae(loads.inner_lamina_load, means.inner);
    put_laminae(loads.outer_lamina_load, means.outer);
  }
  if (duty.point.outer_race.is_rigid()) loads.race_form.resize(0);
  return {std::move(loads), std::move(means), tilt};
}

}  // namespace

BearingsAtRest::BearingsAtRest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry)
    : drivetrain_(drivetrain),
      geometry_(geometry),
      options_(quasi_static_options(drivetrain)),
      bearing_(drivetrain.bearing) {
  if (drivetrain.seats.tilt == TiltState::computed)
    seat_ = seat_of_each(drivetrain, geometry);
  else
    level_ = AlignedPitch::of(drivetrain.bearing, options_);
}

std::vector<QuasiStaticBearing> BearingsAtRest::of(const BearingDuty& duty) {
  std::vector<QuasiStaticBearing> all;
  if (!seat_) {
    all.push_back(one(duty));
    return all;
  }
  bearing::laminae::PlanetOnPinResult planet = tilting_planet(*seat_, drivetrain_, duty);
  for (std::size_t k = 0; k < planet.bearings.size(); ++k)
    all.push_back(
        bearing_under(drivetrain_, geometry_, duty, std::move(planet.bearings[k]), planet.bearing_tilt[k]));
  return all;
}

QuasiStaticBearing BearingsAtRest::one(const BearingDuty& duty) {
  return bearing_under(drivetrain_, geometry_, duty, loads_under(duty), duty.point.bore_tilt);
}

bearing::QuasiStaticResult BearingsAtRest::loads_under(const BearingDuty& duty) {
  if (level_ && AlignedPitch::holds(duty.point))
    if (auto loads = level_->under(bearing_, duty.point, duty.near.get())) return *std::move(loads);
  return bearing::quasi_static_bearing(bearing_, duty.point, options_);
}

double largest_hertz_pressure(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                              double inner_load, double outer_load) {
  const auto pressure = [&](bearing::Race race, double load) {
    return bearing::hertz_pressure(load, bearing::equivalent_radius(geometry.bearing, race),
                                   drivetrain.bearing.rollers().length, drivetrain.bearing.material);
  };
  return std::max(pressure(bearing::Race::inner, inner_load), pressure(bearing::Race::outer, outer_load));
}

bearing::rating::RatingCondition rating_condition(const RatedBearing& rated, double load, double largest_load,
                                                  double speed, double pitch_diameter) {
  bearing::rating::RatingCondition condition{.dynamic_load = load,
                                             .static_load = largest_load,
                                             .oil = std::nullopt,
                                             .reliability_factor = rated.reliability_factor};
  if (rated.oil && speed != 0.0)
    condition.oil = bearing::rating::oil_condition(*rated.oil, speed, pitch_diameter);
  return condition;
}

bool is_rated_on_laminae(const PlanetaryDrivetrain& drivetrain) {
  const bool in_lines =
      drivetrain.rows.is_cylindrical() || drivetrain.rows.type == bearing::PlanetBearingType::tapered_roller;
  if (!in_lines || drivetrain.bearing.rollers().laminae > 0) return false;
  return !std::holds_alternative<bearing::profile::Straight>(drivetrain.bearing.rollers().profile);
}

PlanetaryDrivetrain cut_for_rating(PlanetaryDrivetrain drivetrain) {
  drivetrain.bearing.rollers().laminae = bearing::rating::kLeastRatedLaminae;
  return drivetrain;
}

namespace {

// [N]  (laminae)  of a whole contact under `load` [N], as its profile has it in static equilibrium.
Eigen::ArrayXd distributed(const bearing::laminae::LaminaContact& contact, double load) {
  return contact.loads(bearing::laminae::approach_under(contact, load), 0.0);
}

// Loads of laminae in motion, whose contacts are whole: that of each bin is distributed along the roller.
bearing::life::LaminaMeans along_the_roller(const bearing::laminae::LaminaBearing& bearing,
                                            const bearing::RaceMotions& motions,
                                            const WindowStatistics& means) {
  const auto of = [&](bearing::Race race, const RaceStatistics& loads) -> Eigen::ArrayXXd {
    const bearing::laminae::LaminaContact& contact = bearing.contact(race);
    Eigen::ArrayXXd powers(contact.laminae(), loads.damage.size());
    for (Eigen::Index bin = 0; bin < loads.damage.size(); ++bin) {
      powers.col(bin) = distributed(contact, std::pow(loads.damage[bin], 0.25)).pow(4);
    }
    return powers;
  };
  return bearing::life::lamina_means(motions, of(bearing::Race::inner, means.inner),
                                     of(bearing::Race::outer, means.outer));
}

}  // namespace

double pressure_along_the_roller(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double inner_load, double outer_load) {
  const bearing::laminae::LaminaBearing cut(cut_for_rating(drivetrain).bearing);
  const auto even_load = [&](bearing::Race race, double load) {
    const bearing::laminae::LaminaContact& contact = cut.contact(race);
    return load > 0.0 ? static_cast<double>(contact.laminae()) * distributed(contact, load).maxCoeff() : 0.0;
  };
  return largest_hertz_pressure(drivetrain, geometry, even_load(bearing::Race::inner, inner_load),
                                even_load(bearing::Race::outer, outer_load));
}

bearing::rating::RatedHours hours_at(const bearing::rating::RatingLives& lives, double speed) {
  using bearing::kInfinity;
  if (speed == 0.0) return {kInfinity, kInfinity, kInfinity, kInfinity};
  return bearing::rating::rated_hours(lives, speed);
}

PlanetBearingRating::Lives PlanetBearingRating::of(const WindowStatistics& means, double load,
                                                   double largest_load) const {
  const bearing::life::LaminaMeans powers =
      bearing::motion::means_of(drivetrain_.bearing.motions, damage_of(means.inner), damage_of(means.outer));
  // The one life of all fidelities.
  const auto rating = bearing::life::lamina_rating(drivetrain_.bearing, drivetrain_.reduction_factor);
  Lives lives{.life = bearing::life::life_of_means(rating, powers)};
  lives.hours = bearing::hours(lives.life.bearing, speed_);
  RatedBearing rated = drivetrain_.rated;
  if (rated.oil && rated.roughness)
    rated.oil->viscosity_ratio = bearing::rating::viscosity_ratio_of_film(
        std::min(means.inner.least_film, means.outer.least_film), *rated.roughness);
  lives.rating = bearing::rating::rating_lives(
      geometry_.rating,
      rating_condition(rated, load, largest_load, speed_, drivetrain_.bearing.pitch_diameter),
      laminae_ ? along_the_roller(*laminae_, drivetrain_.bearing.motions, means) : powers);
  lives.rated_hours = hours_at(lives.rating, speed_);
  return lives;
}

double mean_by_basic_life(const std::vector<double>& loads) {
  const double p = bearing::rating::life_exponent(bearing::rating::RollingElement::roller);
  if (loads.size() == 1) return loads.front();
  const double largest = *std::max_element(loads.begin(), loads.end());
  if (!(largest > 0.0)) return largest;
  double sum = 0.0;
  for (const double load : loads) sum += std::pow(load / largest, p);
  return largest * std::pow(sum / static_cast<double>(loads.size()), 1.0 / p);
}

}  // namespace orbearing::analysis

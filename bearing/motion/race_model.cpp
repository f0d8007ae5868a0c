#include "bearing/motion/race_model.hpp"

#include <cmath>

#include "bearing/contact/published_film.hpp"

namespace orbearing::bearing::motion {

namespace {

constexpr double kPublishedSpeed =
    1.0;  // [m/s]  that turns the damping of Eq. (9) of [Gai2025] into a stiffness

LineContact elastic_contact(const Bearing& bearing, const RaceContactParameters& given) {
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  if (given.damping_law == DampingLaw::approach_speed) return elastic;
  return LineContact(elastic.constant() * (1.0 + given.damping * kPublishedSpeed));
}

// The subtracted film moves the race away from the rollers.
double radius_of_race(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                      Race race, const DynamicsParameters& parameters) {
  const bool inner = race == Race::inner;
  const double radius = inner ? geometry.inner_radius : geometry.outer_radius;
  const RaceContactParameters& given = parameters.race;
  if (!given.film_in_approach || given.film_approach == FilmApproach::added) return radius;
  const PublishedFilm film = published_film(bearing, geometry, parameters.lubricant, point.inner_speed,
                                            point.outer_speed, point.bore_load.norm());
  return inner ? radius - film.inner : radius + film.outer;
}

}  // namespace

RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters) {
  const RaceContactParameters& given = parameters.race;
  const FilmContact film = film_contact(bearing, geometry, race, parameters.lubricant);
  RaceModel model;
  model.side = race == Race::inner ? -1.0 : 1.0;
  model.radius = radius_of_race(bearing, geometry, point, race, parameters);
  model.stiffness = elastic_contact(bearing, given).constant();
  model.log_stiffness = std::log(model.stiffness);
  model.damping = given.damping_law == DampingLaw::approach_speed ? given.damping : 0.0;
  model.entrainment_scale = given.entrainment_scale;
  model.film = given.film_in_approach && given.film_approach == FilmApproach::added &&
               parameters.lubricant.viscosity > 0.0;
  model.film_law = FilmLaw<double>::of(film);
  model.squeezed = given.squeeze;
  if (given.squeeze) model.squeeze = SqueezeFilm<double>::of(film, given.roughness);
  set_film_powers(model);
  model.friction = FrictionLaws<double>::of(given, film);
  model.form = bearing.ring(race).form;
  return model;
}

double entrainment_speed(double rolling, double scale) {
  return std::sqrt(rolling * rolling + scale * scale);
}

double race_load(const vectorised::RaceLaws& race, double approach, double entrainment) {
  const double elastic =
      race.film ? elastic_approach(race.film_law, race.log_stiffness, approach, std::log(entrainment)).value
                : approach;
  return LineContact(race.stiffness).load(elastic);
}

double race_energy(const vectorised::RaceLaws& race, double elastic_approach, double entrainment) {
  if (elastic_approach <= 0.0) return 0.0;
  const LineContact elastic(race.stiffness);
  const double film =
      race.film ? race.film_law.energy(elastic.load(elastic_approach), std::log(entrainment)) : 0.0;
  return elastic.energy(elastic_approach) + film;
}

// The energy is Q delta less the integral of delta(Q, u) over Q, so that its slope at constant approach is
// that of the integral of the film over the load.
double race_energy_slope(const vectorised::RaceLaws& race, double elastic_approach, double entrainment) {
  if (elastic_approach <= 0.0 || !race.film) return 0.0;
  const auto log_speed = logarithm(mechanics::variable<0>(entrainment));
  return film_integral(race.film_law, LineContact(race.stiffness).load(elastic_approach), log_speed).by<0>();
}

}  // namespace orbearing::bearing::motion

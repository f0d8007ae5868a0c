#include "bearing/motion/race_model.hpp"

#include "bearing/contact/printed_film.hpp"

namespace orbearing::bearing::motion {

namespace {

constexpr double kPrintedSpeed =
    1.0;  // [m/s]  that turns the damping of Eq. (9) of [Gai2025] into a stiffness

LineContact elastic_contact(const Bearing& bearing, const RaceContactParameters& given) {
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  if (given.damping_law == DampingLaw::approach_speed) return elastic;
  return LineContact(elastic.constant() * (1.0 + given.damping * kPrintedSpeed));
}

// The subtracted film moves the race away from the rollers.
RaceSide race_side(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                   Race race, const DynamicsParameters& parameters) {
  const bool inner = race == Race::inner;
  const RaceSide side = inner ? RaceSide{-1.0, geometry.inner_radius} : RaceSide{1.0, geometry.outer_radius};
  const RaceContactParameters& given = parameters.race;
  if (!given.film_in_approach || given.film_approach == FilmApproach::added) return side;
  const PrintedFilm film = printed_film(bearing, geometry, parameters.lubricant, point.inner_speed,
                                        point.outer_speed, point.bore_load.norm());
  return {side.side, side.radius + side.side * (inner ? film.inner : film.outer)};
}

}  // namespace

RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters) {
  const RaceContactParameters& given = parameters.race;
  const LineContact elastic = elastic_contact(bearing, given);
  const FilmContact film = film_contact(bearing, geometry, race, parameters.lubricant);
  const bool film_added = given.film_in_approach && given.film_approach == FilmApproach::added;
  return {.side = race_side(bearing, geometry, point, race, parameters),
          .roller_radius = geometry.element_radius,
          .damping = given.damping_law == DampingLaw::approach_speed ? given.damping : 0.0,
          .entrainment_scale = given.entrainment_scale,
          .load = film_added ? RaceLoadLaw(elastic, film) : RaceLoadLaw(elastic),
          .squeeze = given.squeeze ? std::optional(RaceSqueeze{SqueezeFilm<double>::of(film, given.roughness),
                                                               FilmLaw<double>::of(film)})
                                   : std::nullopt,
          .friction = FrictionLaws<double>::of(given, film),
          .form = bearing.ring(race).form};
}

}  // namespace orbearing::bearing::motion

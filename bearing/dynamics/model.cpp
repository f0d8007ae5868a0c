#include "bearing/dynamics/model.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace orbearing::bearing::dynamics {

namespace {

using boost::math::double_constants::two_pi;

void require(bool holds, const char* name, double found, const char* required) {
  if (holds) return;
  std::ostringstream text;
  text << name << ": found " << found << "; required: " << required;
  throw std::invalid_argument(text.str());
}

void check(const CylindricalRollerBearing& bearing, const RollerBearingGeometry& geometry,
           const DynamicsParameters& parameters) {
  require(bearing.rollers >= 2, "rollers", bearing.rollers, "at least 2");
  require(geometry.roller_mass > 0.0, "mass of a roller [kg]", geometry.roller_mass, "more than 0");
  require(geometry.cage_mass > 0.0, "mass of the cage [kg]", geometry.cage_mass,
          "more than 0; give the cage's diameters, width and density");
  require(geometry.inner_ring_mass > 0.0, "mass of the pin ring [kg]", geometry.inner_ring_mass,
          "more than 0; give a bore smaller than the inner race");
  require(parameters.bore_mass > 0.0 || geometry.outer_ring_mass > 0.0, "mass of the bore [kg]",
          parameters.bore_mass, "more than 0");
  require(parameters.support.stiffness > 0.0, "support stiffness [N/m]", parameters.support.stiffness,
          "more than 0");
  require(parameters.cage.pocket_clearance >= 0.0, "pocket clearance [m]", parameters.cage.pocket_clearance,
          "0 or more");
  require(parameters.cage.largest_eccentricity > 0.0 && parameters.cage.largest_eccentricity < 1.0,
          "largest eccentricity of the cage [-]", parameters.cage.largest_eccentricity, "between 0 and 1");
  require(parameters.race.sliding_scale > 0.0, "sliding scale [m/s]", parameters.race.sliding_scale,
          "more than 0");
  require(parameters.race.entrainment_scale > 0.0, "entrainment scale [m/s]",
          parameters.race.entrainment_scale, "more than 0");
  const bool needs_oil =
      parameters.race.film_in_approach || parameters.race.traction == TractionLaw::limiting_shear;
  require(!needs_oil || parameters.lubricant.viscosity > 0.0, "viscosity of the oil [Pa s]",
          parameters.lubricant.viscosity, "more than 0 for a film or for limiting shear");
}

RaceModel race_model(const CylindricalRollerBearing& bearing, const RollerBearingGeometry& geometry,
                     Race race, const DynamicsParameters& parameters) {
  const RaceContactParameters& given = parameters.race;
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.roller_length);
  const FilmContact film = film_contact(bearing, geometry, race, parameters.lubricant);
  const RaceSide side =
      race == Race::inner ? RaceSide{-1.0, geometry.inner_radius} : RaceSide{1.0, geometry.outer_radius};
  return {.side = side,
          .roller_radius = geometry.roller_radius,
          .damping = given.damping,
          .entrainment_scale = given.entrainment_scale,
          .with_rolling_resistance = given.rolling_resistance,
          .load = given.film_in_approach ? RaceLoadLaw(elastic, film) : RaceLoadLaw(elastic),
          .traction = TractionCurve(given, film),
          .rolling = RollingResistance(film)};
}

PocketModel pocket_model(const RollerBearingGeometry& geometry, const DynamicsParameters& parameters) {
  const CageParameters& cage = parameters.cage;
  return {.half_clearance = 0.5 * cage.pocket_clearance,
          .stiffness = cage.pocket_stiffness,
          .damping = cage.pocket_damping,
          .friction = cage.pocket_friction,
          .sliding_scale = parameters.race.sliding_scale,
          .roller_radius = geometry.roller_radius};
}

GuidanceModel guidance_model(const CylindricalRollerBearing& bearing, const DynamicsParameters& parameters) {
  const CageParameters& given = parameters.cage;
  GuidanceModel model;
  model.present = given.guide_diameter > 0.0;
  if (!model.present) return model;
  const bool outside = bearing.cage.guidance == Race::outer;
  const double cage_diameter = outside ? bearing.cage.outer_diameter : bearing.cage.inner_diameter;
  const double side_width = 0.5 * (bearing.cage.width - bearing.roller_length);
  model.side = outside ? 1.0 : -1.0;
  model.clearance = 0.5 * model.side * (given.guide_diameter - cage_diameter);
  model.cage_radius = 0.5 * cage_diameter;
  model.land_width = given.land_width > 0.0 ? given.land_width : side_width;
  model.lands = given.lands;
  model.viscosity = parameters.lubricant.viscosity;
  model.film = given.guidance_film;
  model.largest_eccentricity = given.largest_eccentricity;
  model.stiffness = given.touch_down_stiffness;
  model.damping = given.touch_down_damping;
  model.friction = given.touch_down_friction;
  model.sliding_scale = parameters.race.sliding_scale;
  require(model.clearance > 0.0, "radial clearance of cage and land [m]", model.clearance,
          "more than 0; the guide diameter lies outside an outer-guided cage and inside an inner-guided one");
  require(model.land_width > 0.0, "width of the cage's land [m]", model.land_width,
          "more than 0; give it, or a cage wider than the rollers");
  return model;
}

std::vector<Vector2> pocket_directions(int rollers) {
  std::vector<Vector2> directions;
  for (int j = 0; j < rollers; ++j)
    directions.emplace_back(std::cos(two_pi * j / rollers), std::sin(two_pi * j / rollers));
  return directions;
}

void set_drag(const CylindricalRollerBearing& bearing, const OilDragParameters& given, BearingModel& model) {
  if (!given.on) return;
  const double density = given.oil_share * given.oil_density;
  const double cage_radius = 0.25 * (bearing.cage.inner_diameter + bearing.cage.outer_diameter);
  model.orbit_drag =
      translation_drag(density, given.drag_coefficient, bearing.roller_diameter, bearing.roller_length);
  model.spin_drag =
      churning_drag(density, given.churning_coefficient, model.geometry.roller_radius, bearing.roller_length);
  model.cage_drag = churning_drag(density, given.churning_coefficient, cage_radius, bearing.cage.width);
}

PinSupport pin_support(const SupportParameters& given, double moving_mass) {
  return {given.stiffness, 2.0 * given.damping_ratio * std::sqrt(given.stiffness * moving_mass)};
}

}  // namespace

BearingModel bearing_model(const CylindricalRollerBearing& bearing, const OperatingPoint& point,
                           const DynamicsParameters& parameters) {
  const RollerBearingGeometry geometry = geometry_of(bearing);
  check(bearing, geometry, parameters);
  const double bore_mass = parameters.bore_mass > 0.0 ? parameters.bore_mass : geometry.outer_ring_mass;
  BearingModel model{.layout = {bearing.rollers},
                     .geometry = geometry,
                     .point = point,
                     .frame = carrier_frame(point.carrier, parameters.inertia),
                     .roller = {geometry.roller_mass, geometry.roller_inertia},
                     .cage = {geometry.cage_mass, geometry.cage_inertia},
                     .bore_mass = bore_mass,
                     .pin_mass = geometry.inner_ring_mass,
                     .inner = race_model(bearing, geometry, Race::inner, parameters),
                     .outer = race_model(bearing, geometry, Race::outer, parameters),
                     .inner_film = film_contact(bearing, geometry, Race::inner, parameters.lubricant),
                     .outer_film = film_contact(bearing, geometry, Race::outer, parameters.lubricant),
                     .pocket = pocket_model(geometry, parameters),
                     .pocket_direction = pocket_directions(bearing.rollers),
                     .guidance = guidance_model(bearing, parameters),
                     .guiding_race = bearing.cage.guidance,
                     .support = pin_support(parameters.support, bore_mass + geometry.inner_ring_mass),
                     .orbit_drag = {},
                     .spin_drag = {},
                     .cage_drag = {},
                     .ripple = parameters.ripple};
  set_drag(bearing, parameters.drag, model);
  return model;
}

Vector2 bore_load(const BearingModel& model, double time) {
  const MeshRipple& ripple = model.ripple;
  const double along_y = ripple.amplitude * std::sin(ripple.angular_frequency * time + ripple.phase);
  return {model.point.bore_load.x(), model.point.bore_load.y() + along_y};
}

Vector2 bore_load_slope(const BearingModel& model, double time) {
  const MeshRipple& ripple = model.ripple;
  const double speed = ripple.amplitude * ripple.angular_frequency;
  return {0.0, speed * std::cos(ripple.angular_frequency * time + ripple.phase)};
}

}  // namespace orbearing::bearing::dynamics

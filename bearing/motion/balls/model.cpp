#include "bearing/motion/balls/ball_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/contact/point_contact.hpp"
#include "bearing/default_design.hpp"
#include "bearing/geometry.hpp"
#include "bearing/motion/cage_and_oil.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::balls {

namespace {

using constants::pi;
using constants::two_pi;
using mechanics::require;

// Radius of the ball and the race in the direction of rolling, that of the race where it is touched.
double rolling_radius(const Bearing& bearing, Race race) {
  const double gamma = slenderness(bearing), diameter = bearing.balls().diameter;
  return 0.5 * diameter * (race == Race::inner ? 1.0 - gamma : 1.0 + gamma);
}

struct RollingLaw {
  double factor = 0.0;  // [N m]  2 R_x F_1
  PointRolling law;
};

// F_R/(E' R_x^2) = c k^e G^g U^m W^n.
struct PowerLaw {
  double factor, axis_ratio, material, speed, load;

  // ln of it at 1 m/s and 1 N.
  double log_at_one(const OiledPoint& oil) const {
    const double area = oil.modulus * oil.rolling_radius * oil.rolling_radius;
    return std::log(factor) + axis_ratio * std::log(oil.axis_ratio) +
           material * std::log(oil.pressure_viscosity * oil.modulus) +
           speed * std::log(oil.viscosity / (oil.modulus * oil.rolling_radius)) - load * std::log(area);
  }
};

// 2 R_x F_R with F_R = 2.86 E' R_x^2 k^0.348 G^0.022 U^0.66 W^0.47 [Houpert1987].
RollingLaw regression(const OiledPoint& oil) {
  const double area = oil.modulus * oil.rolling_radius * oil.rolling_radius;
  return {2.0 * oil.rolling_radius * 2.86 * area * std::pow(oil.axis_ratio, 0.348) *
              std::pow(oil.pressure_viscosity * oil.modulus, 0.022) *
              std::pow(oil.viscosity / (oil.modulus * oil.rolling_radius), 0.66) * std::pow(1.0 / area, 0.47),
          {}};
}

// Fitted to points that film/reynolds computes: docs/reynolds.md. Without pressure-viscosity only the first.
RollingLaw computed(const OiledPoint& oil) {
  constexpr PowerLaw rigid{0.405, 0.240, 0.0, 0.5, 0.5}, elastic{36.1, 0.781, -0.200, 0.750, 0.349};
  constexpr double blend = 3.0;
  const double one = rigid.log_at_one(oil);
  RollingLaw found{
      2.0 * oil.rolling_radius * oil.modulus * oil.rolling_radius * oil.rolling_radius * std::exp(one),
      {.speed = rigid.speed, .load = rigid.load}};
  if (oil.pressure_viscosity > 0.0)
    found.law = {.speed = rigid.speed,
                 .load = rigid.load,
                 .blend = blend,
                 .log_ratio = blend * (one - elastic.log_at_one(oil)),
                 .ratio_speed = blend * (rigid.speed - elastic.speed),
                 .ratio_load = blend * (rigid.load - elastic.load)};
  return found;
}

RollingLaw rolling_law(const OiledPoint& oil, const MotionParameters& given) {
  if (oil.viscosity <= 0.0 || !given.race.rolling_resistance) return {};
  return given.ellipse.rolling == BallRolling::houpert ? regression(oil) : computed(oil);
}

// beta eta/k of contact/inlet_heating.hpp; 0: isothermal. [s^2/m^2]
double inlet_heating(const MotionParameters& given) {
  if (given.race.inlet_heating == motion::InletHeating::none) return 0.0;
  return given.race.viscosity_slope * given.lubricant.viscosity / given.race.oil_conductivity;
}

// Squeeze film between ball and groove, which lies round the ball across the direction of rolling.
PointSqueezeFilm squeeze_film(const MotionParameters& given, double rolling_radius, double ball_radius,
                              double groove_radius) {
  if (!given.race.squeeze) return {};
  require(given.lubricant.viscosity > 0.0, "viscosity of the oil [Pa s]", given.lubricant.viscosity,
          "more than 0 for the squeeze of films");
  require(given.race.roughness > 0.0, "roughness of ball and race [m]", given.race.roughness,
          "more than 0 for squeezed films");
  const double across = 1.0 / (1.0 / ball_radius - 1.0 / groove_radius);
  return {RigidPointFilm::between(given.lubricant.viscosity, rolling_radius, across, ball_radius, ball_radius,
                                  given.race.roughness)};
}

GrooveNumbers groove(const Bearing& bearing, Race race, const MotionParameters& given) {
  const Balls& balls = bearing.balls();
  const double osculation = bearing.ring(race).osculation;
  require(osculation > 0.5, "osculation", osculation, "groove radius over ball diameter above 0.5");
  const double groove_radius = osculation * balls.diameter;
  const PointContact contact = point_contact(
      ball_race_curvature(race, balls.diameter, bearing.pitch_diameter, groove_radius, balls.contact_angle),
      bearing.material);
  const PointPressure at_one = point_pressure(contact, 1.0);
  const double play = groove_radius - 0.5 * balls.diameter;
  const double inward = race == Race::inner ? 1.0 : -1.0;  // from the ball to the groove's centre
  const OiledPoint oil{.viscosity = given.lubricant.viscosity,
                       .pressure_viscosity = given.lubricant.pressure_viscosity,
                       .rolling_radius = rolling_radius(bearing, race),
                       .axis_ratio = contact.ellipse.axis_ratio,
                       .modulus = contact.modulus};
  const RollingLaw rolling = rolling_law(oil, given);
  return {.centre_radius = 0.5 * bearing.pitch_diameter +
                           inward * (play * std::cos(balls.contact_angle) - 0.25 * bearing.radial_clearance),
          .centre_axial = inward * play * std::sin(balls.contact_angle),
          .play = play,
          .stiffness = contact.constant,
          .damping = given.race.damping,
          .across = at_one.major,
          .along = at_one.minor,
          .pressure = at_one.pressure,
          .curvature = (2.0 * osculation + 1.0) / (2.0 * osculation * balls.diameter),
          .rolling_radius = oil.rolling_radius,
          .rolling_factor = given.race.rolling_share * rolling.factor,
          .rolling = rolling.law,
          .inlet_heating = inlet_heating(given),
          .central_film = PointFilmLaw::central(oil),
          .least_film = PointFilmLaw::least(oil),
          .squeeze = squeeze_film(given, oil.rolling_radius, 0.5 * balls.diameter, groove_radius)};
}

// Ball in a hole of the cage: Hertz between unlike materials, the hole hollow about its axis and straight
// along it.
double pocket_stiffness(const Bearing& bearing, double play) {
  const double ball = bearing.balls().diameter, hole = ball + 2.0 * play;
  const double sum = 4.0 / ball - 2.0 / hole;
  const PointCurvature curvature{.sum = sum, .difference = (2.0 / hole) / sum};
  constexpr double cage_poisson_ratio = 0.35;
  const CageMaterial& cage = default_cage_material(bearing.cage.density);
  const double of_cage = cage.youngs_modulus / (1.0 - cage_poisson_ratio * cage_poisson_ratio);
  const double both = 2.0 / (1.0 / bearing.material.plane_strain_modulus() + 1.0 / of_cage);
  return point_contact(curvature, {.youngs_modulus = both, .poisson_ratio = 0.0}).constant;
}

// The pocket is straight along the cage's radius, as far as its wall is high, and hollow round the ball.
RigidPointFilm pocket_oil(const Bearing& bearing, const MotionParameters& given, double play) {
  if (given.cage.pocket_film == motion::PocketFilm::none) return {};
  const double radius = 0.5 * bearing.balls().diameter;
  require(given.lubricant.viscosity > 0.0, "viscosity of the oil [Pa s]", given.lubricant.viscosity,
          "more than 0 for a film in the pockets");
  const double wall = 0.5 * (bearing.cage.outer_diameter - bearing.cage.inner_diameter);
  return RigidPointFilm::between(given.lubricant.viscosity, radius, radius * (radius + play) / play,
                                 0.5 * wall, radius, given.cage.pocket_roughness);
}

PocketNumbers pocket(const Bearing& bearing, const MotionParameters& given) {
  const double play = 0.5 * given.cage.pocket_clearance;
  require(play > 0.0, "pocket clearance [m]", given.cage.pocket_clearance, "more than 0");
  require(given.pocket.straight >= 0.0, "straight part of a pocket [m]", given.pocket.straight, "0 or more");
  return {.play = play,
          .half_straight = 0.5 * given.pocket.straight,
          .stiffness = pocket_stiffness(bearing, play),
          .damping = given.cage.pocket_damping,
          .friction = given.cage.pocket_friction,
          .sliding_scale = given.race.sliding_scale,
          .film = pocket_oil(bearing, given, play)};
}

// One land at each end of the cage.
LandNumbers lands(const Bearing& bearing, const MotionParameters& given) {
  std::optional<motion::GuidingLands> one =
      motion::guiding_lands(bearing, given.cage, 1, given.lubricant.viscosity, given.race.sliding_scale);
  if (!one) return {};
  one->law.stiffness *= 0.5;
  return {.present = true,
          .on_outer = bearing.cage.guidance == Race::outer,
          .offset = 0.5 * (bearing.cage.width - one->width),
          .law = one->law};
}

// [-]  of a sphere in a stream of Reynolds numbers from 1e3 to 1e5 [Schlichting2000].
constexpr double kSphereDrag = 0.45;

// Walls are where the grooves are deepest: the balls fill the gap between them.
MixtureNumbers mixture(const Bearing& bearing, const MotionParameters& given, const DragNumbers& at_rest) {
  const motion::OilDragParameters& oil = given.drag;
  const double radius = 0.5 * bearing.pitch_diameter, ball = 0.5 * bearing.balls().diameter;
  require(given.mixture.flow >= 0.0, "flow of oil [m^3/s]", given.mixture.flow, "0 or more");
  return {.carried = given.mixture.motion == OilMotion::carried,
          .count = bearing.balls().count,
          .slenderness = slenderness(bearing),
          .pitch_radius = radius,
          .inner_radius = radius - ball,
          .outer_radius = radius + ball,
          .width = bearing.width,
          .density = oil.oil_share * oil.oil_density,
          .viscosity = given.lubricant.viscosity / oil.oil_density,
          .flow = oil.oil_density * given.mixture.flow,
          .balls = bearing.balls().count * at_rest.translation * radius * radius * radius,
          .cage = at_rest.cage_churning,
          .share = 0.0};
}

// A ball shows the mixture its section, and turns in it with its fifth power, Eqs. (29) and (30) of
// [Chen2026], the latter with the square of the ball's own turning.
DragNumbers drag(const Bearing& bearing, const MotionParameters& parameters) {
  const motion::OilDragParameters& given = parameters.drag;
  if (!given.on) return {};
  const double density = given.oil_share * given.oil_density, diameter = bearing.balls().diameter;
  // Section of the ball outside of the cage, Eq. (29).
  const double height = 0.5 * (bearing.cage.outer_diameter - bearing.cage.inner_diameter);
  const double section = std::max(0.0, 0.25 * pi * diameter * diameter - height * diameter);
  const double cage_radius = 0.25 * (bearing.cage.inner_diameter + bearing.cage.outer_diameter);
  DragNumbers at_rest{.translation = 0.5 * kSphereDrag * density * section,
                      .churning = 0.5 * given.churning_coefficient * density * std::pow(0.5 * diameter, 5),
                      .cage_churning = motion::churning_drag(density, given.churning_coefficient, cage_radius,
                                                             bearing.cage.width)
                                           .coefficient,
                      .mixture = {}};
  at_rest.mixture = mixture(bearing, parameters, at_rest);
  return at_rest;
}

// A hollow cylinder about its own middle.
BodyNumbers hollow(double mass, double inner_radius, double outer_radius, double width) {
  const double squares = inner_radius * inner_radius + outer_radius * outer_radius;
  return {
      .mass = mass, .across = mass * (squares / 4.0 + width * width / 12.0), .polar = 0.5 * mass * squares};
}

BodyNumbers ring_body(const BodyNumbers& own, const RingBodyParameters& given, const char* what) {
  BodyNumbers body = own;
  if (given.held) return {.mass = 0.0, .across = own.across, .polar = own.polar};
  if (given.mass > 0.0) body.mass = given.mass;
  if (given.across > 0.0) body.across = given.across;
  require(body.mass > 0.0 && body.across > 0.0, what, body.mass,
          "more than 0; give its mass, or bore, outside diameter and width of the rings");
  return body;
}

}  // namespace

BallNumbers ball_numbers(const Bearing& bearing, const MotionParameters& given) {
  const Balls& balls = bearing.balls();
  const BearingGeometry geometry = geometry_of(bearing);
  require(balls.count >= 2, "balls", balls.count, "at least 2");
  require(geometry.element_mass > 0.0, "mass of a ball [kg]", geometry.element_mass, "more than 0");
  require(geometry.cage_mass > 0.0, "mass of the cage [kg]", geometry.cage_mass,
          "more than 0; give the cage's diameters, width and density");
  require(!nature_of(given.race.traction).shears_oil || given.lubricant.viscosity > 0.0,
          "viscosity of the oil [Pa s]", given.lubricant.viscosity,
          "more than 0 for a traction model with sheared oil");
  BallNumbers c;
  c.balls = balls.count;
  c.radius = geometry.element_radius;
  c.mass = geometry.element_mass;
  c.inertia = geometry.element_inertia;
  c.pitch_radius = geometry.pitch_radius;
  c.entrainment_scale = given.race.entrainment_scale;
  c.inner = groove(bearing, Race::inner, given);
  c.outer = groove(bearing, Race::outer, given);
  c.shear = ShearParameters::of(given);
  c.points = ellipse_points(given.ellipse.slices, given.ellipse.rows);
  c.pocket = pocket(bearing, given);
  c.land = lands(bearing, given);
  c.drag = drag(bearing, given);
  c.oil_flow = given.mixture.flow;
  c.cage = hollow(geometry.cage_mass, 0.5 * bearing.cage.inner_diameter, 0.5 * bearing.cage.outer_diameter,
                  bearing.cage.width);
  c.cage.polar = geometry.cage_inertia;
  c.inner_ring = ring_body(hollow(geometry.inner_ring_mass, 0.5 * bearing.inner.seat_diameter,
                                  geometry.inner_radius, bearing.width),
                           given.inner, "mass of the inner ring [kg]");
  c.outer_ring = ring_body(hollow(geometry.outer_ring_mass, geometry.outer_radius,
                                  0.5 * bearing.outer.seat_diameter, bearing.width),
                           given.outer, "mass of the outer ring [kg]");
  return c;
}

}  // namespace orbearing::bearing::balls

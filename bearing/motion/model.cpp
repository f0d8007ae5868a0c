#include "bearing/motion/model.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/contact/race_contact.hpp"
#include "bearing/contact/race_form.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::motion {

RaceContactParameters with_limited_scales(const BearingGeometry& geometry, const OperatingPoint& point,
                                          RaceContactParameters given) {
  constexpr double nothing_rolls = 1e-6;  // [m/s]
  const double cage = kinematic_cage_speed(geometry, point.inner_speed, point.outer_speed);
  const double rolling = geometry.inner_radius * std::abs(cage - point.inner_speed);
  const double limit = given.sliding_share * rolling;
  if (limit < nothing_rolls) return given;
  for (double* scale : {&given.sliding_scale, &given.least_sliding_scale, &given.entrainment_scale})
    *scale = std::min(*scale, limit);
  return given;
}

RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters) {
  const RaceContactParameters given = with_limited_scales(geometry, point, parameters.race);
  const FilmContact film = film_contact(bearing, geometry, race, parameters.lubricant);
  RaceModel model;
  model.side = race == Race::inner ? -1.0 : 1.0;
  model.radius = race == Race::inner ? geometry.inner_radius : geometry.outer_radius;
  model.stiffness = roller_race_contact(bearing.contact_law, bearing.rollers().length).constant();
  model.log_stiffness = std::log(model.stiffness);
  model.damping = given.damping;
  model.entrainment_scale = given.entrainment_scale;
  model.film = given.film_in_approach && parameters.lubricant.viscosity > 0.0;
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

ElasticRace moving_waves(ElasticRace race, const RimParameters& parameters) {
  if (race.is_rigid()) return race;
  mechanics::require(parameters.most_order >= 0, "largest order of the waves of a rim", parameters.most_order,
                     "0 or more");
  const Eigen::Index orders = std::min<Eigen::Index>(race.compliance.size(), parameters.most_order + 1);
  for (Eigen::ArrayXd* of_orders : {&race.compliance, &race.cosine, &race.sine, &race.mass})
    of_orders->conservativeResize(std::min(orders, of_orders->size()));
  return race;
}

std::vector<vectorised::RimWave> rim_waves(const ElasticRace& race, const RimParameters& parameters) {
  if (race.is_rigid()) return {};
  mechanics::require(parameters.damping_ratio >= 0.0, "damping ratio of a rim", parameters.damping_ratio,
                     "0 or more");
  mechanics::require(race.mass.size() == race.compliance.size(), "masses of the waves of an elastic race",
                     static_cast<double>(race.mass.size()), "one for each order of a race in motion");
  for (Eigen::Index order = 0; order < race.mass.size(); ++order)
    if (order != 1)
      mechanics::require(race.mass[order] > 0.0, "mass of a wave of an elastic race [kg]", race.mass[order],
                         "more than 0");
  const Eigen::VectorXd stiffness = wave_stiffness(race), mass = waves_of_orders(race, race.mass),
                        at_rest = waves_at_rest(race);
  std::vector<vectorised::RimWave> waves;
  for (Eigen::Index i = 0; i < stiffness.size(); ++i)
    waves.push_back({.stiffness = stiffness[i],
                     .mass = mass[i],
                     .damping = 2.0 * parameters.damping_ratio * std::sqrt(stiffness[i] * mass[i]),
                     .at_rest = at_rest[i]});
  return waves;
}

namespace {

using constants::two_pi;
using mechanics::require;

void check_oil(const DynamicsParameters& parameters) {
  const RaceContactParameters& race = parameters.race;
  const bool pocket_film = parameters.cage.pocket_film == PocketFilm::hydrodynamic;
  const bool mixed = race.lubrication == Lubrication::mixed;
  const bool needs_oil =
      race.film_in_approach || nature_of(race.traction).shears_oil || mixed || pocket_film || race.squeeze;
  require(!needs_oil || parameters.lubricant.viscosity > 0.0, "viscosity of the oil [Pa s]",
          parameters.lubricant.viscosity,
          "more than 0 for a film, its squeeze, friction of sheared oil or mixed lubrication");
  require(!(mixed || race.squeeze) || race.roughness > 0.0, "roughness of roller and race [m]",
          race.roughness, "more than 0 for mixed lubrication and squeezed films");
  require(!mixed || race.boundary_friction >= 0.0, "boundary friction [-]", race.boundary_friction,
          "0 or more");
  require(!pocket_film || parameters.cage.pocket_roughness > 0.0, "roughness of the pocket [m]",
          parameters.cage.pocket_roughness, "more than 0 for a film in the pocket");
}

void check_form(const Bearing& bearing, const BearingGeometry& geometry) {
  for (const auto* form : {&bearing.inner.form, &bearing.outer.form})
    for (const RaceHarmonic& wave : *form) {
      require(wave.order >= 1, "order of a wave of a race", wave.order, "1 or more");
      require(std::abs(wave.amplitude) < geometry.element_radius, "amplitude of a wave of a race [m]",
              wave.amplitude, "less than the radius of a roller");
    }
  const CylindricalRollers& rollers = bearing.rollers();
  require(rollers.diameter_deviation.size() <= static_cast<std::size_t>(rollers.count),
          "number of roller diameter deviations", static_cast<double>(rollers.diameter_deviation.size()),
          "at most one for each roller");
  for (const double deviation : rollers.diameter_deviation)
    require(std::abs(deviation) < geometry.element_radius, "deviation of a roller's diameter [m]", deviation,
            "less than the radius of a roller");
}

// Angle that the rollers take on the pitch circle, all touching.
double angle_taken(const Bearing& bearing) {
  const CylindricalRollers& rollers = bearing.rollers();
  const auto count = static_cast<std::size_t>(rollers.count);
  double taken = 0.0;
  for (std::size_t j = 0; j < count; ++j)
    taken += 2.0 * std::asin((rollers.diameter + 0.5 * (diameter_deviation(bearing, j) +
                                                        diameter_deviation(bearing, (j + 1) % count))) /
                             bearing.pitch_diameter);
  return taken;
}

void check_full_complement(const Bearing& bearing) {
  require(bearing.rollers().count >= 3, "rollers without a cage", bearing.rollers().count, "at least 3");
  const double taken = angle_taken(bearing);
  require(taken <= two_pi, "angle of rollers without a cage on the pitch circle [rad]", taken,
          "at most a full turn; give fewer or smaller rollers");
}

void check(const Bearing& bearing, const BearingGeometry& geometry, const DynamicsParameters& parameters) {
  require(bearing.rollers().count >= 2, "rollers", bearing.rollers().count, "at least 2");
  require(geometry.element_mass > 0.0, "mass of a roller [kg]", geometry.element_mass, "more than 0");
  if (bearing.has_cage())
    require(geometry.cage_mass > 0.0, "mass of the cage [kg]", geometry.cage_mass,
            "more than 0; give the cage's diameters, width and density");
  else
    check_full_complement(bearing);
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
  require(nature_of(parameters.race.traction).of_rollers, "traction model",
          described::text_of(parameters.race.traction), std::string(kRollerLaws.text) + " for rollers");
  check_oil(parameters);
  check_form(bearing, geometry);
  require(std::isfinite(parameters.driving.ramp), "speed ramp [1/s]", parameters.driving.ramp,
          "a finite number");
}

PocketLaw pocket_law(double length, const DynamicsParameters& parameters) {
  const CageParameters& cage = parameters.cage;
  return {.half_clearance = 0.5 * cage.pocket_clearance,
          .stiffness = cage.pocket_stiffness,
          .damping = cage.pocket_damping,
          .friction = {cage.pocket_friction, parameters.race.sliding_scale},
          .viscous = cage.pocket_film == PocketFilm::hydrodynamic
                         ? 2.0 * parameters.lubricant.viscosity * length
                         : 0.0,
          .roughness = cage.pocket_roughness};
}

vectorised::NeighbourConstants neighbours(const Bearing& bearing, const DynamicsParameters& parameters) {
  const RaceContactParameters& race = parameters.race;
  return {.stiffness = roller_race_contact(bearing.contact_law, bearing.rollers().length).constant(),
          .damping = race.damping,
          .friction = {parameters.neighbours.friction, race.sliding_scale}};
}

vectorised::LandConstants land_of(const Bearing& bearing, const DynamicsParameters& parameters) {
  if (!bearing.has_cage()) return {};
  const std::optional<GuidingLands> lands =
      guiding_lands(bearing, parameters.cage, parameters.cage.lands, parameters.lubricant.viscosity,
                    parameters.race.sliding_scale);
  return {.present = lands.has_value(),
          .on_bore = bearing.cage.guidance == Race::outer,
          .law = lands ? lands->law : LandLaw{}};
}

std::vector<Vector2> pocket_directions(int rollers) {
  std::vector<Vector2> directions;
  for (int j = 0; j < rollers; ++j) directions.push_back(direction(two_pi * j / rollers));
  return directions;
}

void set_drag(const Bearing& bearing, const OilDragParameters& given, BearingModel& model) {
  if (!given.on) return;
  const double density = given.oil_share * given.oil_density;
  const double cage_radius = 0.25 * (bearing.cage.inner_diameter + bearing.cage.outer_diameter);
  const CylindricalRollers& rollers = bearing.rollers();
  model.orbit_drag = translation_drag(density, given.drag_coefficient, rollers.diameter, rollers.length);
  model.spin_drag =
      churning_drag(density, given.churning_coefficient, model.geometry.element_radius, rollers.length);
  model.cage_drag = churning_drag(density, given.churning_coefficient, cage_radius, bearing.cage.width);
}

PinSupport pin_support(const SupportParameters& given, double moving_mass) {
  return {given.stiffness, 2.0 * given.damping_ratio * std::sqrt(given.stiffness * moving_mass)};
}

// Radius of each roller less the stated one.
std::vector<double> larger_rollers(const Bearing& bearing) {
  std::vector<double> larger;
  for (std::size_t j = 0; j < static_cast<std::size_t>(bearing.rollers().count); ++j)
    larger.push_back(0.5 * diameter_deviation(bearing, j));
  return larger;
}

laminae::LaminaContact lamina_contact(const CylindricalRollers& rollers, const RaceModel& race,
                                      const profile::Profile& race_profile) {
  return {LineContact(race.stiffness), rollers.length,
          laminae::lamina_drops(rollers.profile, race_profile, rollers.length, rollers.laminae)};
}

std::optional<LaminaRaces> lamina_races(const Bearing& bearing, const BearingModel& model) {
  const CylindricalRollers& rollers = bearing.rollers();
  if (rollers.laminae == 0) return std::nullopt;
  return LaminaRaces(lamina_contact(rollers, model.inner, bearing.inner.profile),
                     lamina_contact(rollers, model.outer, bearing.outer.profile), model.point.bore_tilt);
}

// The carrier's acceleration follows from the ramp of its speed; the planet's Euler load is added to what
// the load on the bore holds.
void set_driving(const InertiaSwitches& inertia, BearingModel& model) {
  CarrierMotion& carrier = model.point.carrier;
  require(carrier.acceleration == 0.0, "acceleration of the carrier [rad/s^2]", carrier.acceleration,
          "0 in a run-up, where it follows from the speed ramp");
  const Vector2 none = Vector2::Zero();
  model.bore_loads.centrifugal = model.bore_mass * inertial_acceleration(model.frame, none, none);
  model.bore_loads.meshes = model.point.bore_load - model.bore_loads.centrifugal;
  carrier.acceleration = model.driving.ramp * carrier.speed;
  model.frame = carrier_frame(carrier, inertia);
  model.bore_loads.euler =
      model.bore_mass * inertial_acceleration(model.frame, none, none) - model.bore_loads.centrifugal;
}

// Cosine and sine of rising multiples of an angle, each from the one before by turning on.
class Multiples {
 public:
  explicit Multiples(double angle) : first_(std::cos(angle), std::sin(angle)) {}
  /// (cosine, sine) of order times the angle; orders must not fall from call to call.
  const Vector2& of(int order) {
    for (; order_ < order; ++order_)
      now_ = {now_.x() * first_.x() - now_.y() * first_.y(), now_.x() * first_.y() + now_.y() * first_.x()};
    return now_;
  }

 private:
  Vector2 first_;
  Vector2 now_{1.0, 0.0};
  int order_ = 0;
};

Vector2 excitation_load(const MeshExcitation& excitation, double angle) {
  Vector2 load = Vector2::Zero();
  Multiples multiples(angle);
  for (const LoadHarmonic& harmonic : excitation.harmonics) {
    const Vector2& turned = multiples.of(harmonic.order);
    load += turned.x() * harmonic.cosine + turned.y() * harmonic.sine;
  }
  return load;
}

// Load on the bore in a run-up; the excitation falls with the meshes' load and quickens with their speed.
Vector2 growing_load(const BearingModel& model, double time) {
  const double ratio = speed_ratio(model.driving, time);
  const double turned = model.excitation.angular_frequency * equivalent_time(model.driving, time);
  const Vector2 meshes = model.bore_loads.meshes + excitation_load(model.excitation, turned);
  return meshes / ratio + model.bore_loads.centrifugal * ratio * ratio + model.bore_loads.euler;
}

Vector2 loads_beside_weight(const BearingModel& model, double time) {
  if (model.driving.ramp != 0.0) return growing_load(model, time);
  if (model.excitation.harmonics.empty()) return model.point.bore_load;
  return model.point.bore_load + excitation_load(model.excitation, model.excitation.angular_frequency * time);
}

}  // namespace

BearingModel bearing_model(const Bearing& bearing, const OperatingPoint& point,
                           const DynamicsParameters& stated) {
  const CylindricalRollers& rollers = bearing.rollers();
  const BearingGeometry geometry = geometry_of(bearing);
  check(bearing, geometry, stated);
  DynamicsParameters parameters = stated;
  parameters.race = with_limited_scales(geometry, point, stated.race);
  OperatingPoint moving = point;
  moving.outer_race = moving_waves(point.outer_race, parameters.rim);
  const double bore_mass = parameters.bore_mass > 0.0 ? parameters.bore_mass : geometry.outer_ring_mass;
  BearingModel model{
      .layout = {.rollers = rollers.count,
                 .waves = wave_count(moving.outer_race),
                 .caged = bearing.has_cage()},
      .geometry = geometry,
      .point = moving,
      .frame = carrier_frame(point.carrier, parameters.inertia),
      .inertia = parameters.inertia,
      .gravity = parameters.gravity,
      .roller = {geometry.element_mass, geometry.element_inertia},
      .cage = {geometry.cage_mass, geometry.cage_inertia},
      .bore_mass = bore_mass,
      .pin_mass = geometry.inner_ring_mass,
      .inner = race_model(bearing, geometry, point, Race::inner, parameters),
      .outer = race_model(bearing, geometry, point, Race::outer, parameters),
      .rim = rim_waves(moving.outer_race, parameters.rim),
      .inner_film = film_contact(bearing, geometry, Race::inner, parameters.lubricant),
      .outer_film = film_contact(bearing, geometry, Race::outer, parameters.lubricant),
      .film_heating = FilmHeating::of(parameters.race, parameters.lubricant),
      .pocket = pocket_law(rollers.length, parameters),
      .neighbours = neighbours(bearing, parameters),
      .radius_deviation = larger_rollers(bearing),
      .pocket_direction = pocket_directions(rollers.count),
      .land = land_of(bearing, parameters),
      .support = pin_support(parameters.support, bore_mass + geometry.inner_ring_mass),
      .orbit_drag = {},
      .spin_drag = {},
      .cage_drag = {},
      .excitation = parameters.excitation,
      .driving = parameters.driving,
      .bore_loads = {},
      .kinematic_cage_speed = kinematic_cage_speed(geometry, point.inner_speed, point.outer_speed)};
  set_drag(bearing, parameters.drag, model);
  model.laminae = lamina_races(bearing, model);
  model.layout.tilting = model.laminae && !model.laminae->upright();
  if (model.driving.ramp != 0.0) set_driving(parameters.inertia, model);
  return model;
}

Vector2 gravity_at(const BearingModel& model, double angle) {
  const double turned = model.gravity.angle + angle;
  return -model.gravity.across * Vector2(std::sin(turned), std::cos(turned));
}

Vector2 weight_on_bore(const BearingModel& model, double time) {
  const double planet = model.gravity.planet_mass;
  return (planet > 0.0 ? planet : model.bore_mass) * gravity_at(model, carrier_angle(model, time));
}

Vector2 bore_load(const BearingModel& model, double time) {
  if (model.gravity.acts()) return loads_beside_weight(model, time) + weight_on_bore(model, time);
  return loads_beside_weight(model, time);
}

Vector2 bore_load_slope(const BearingModel& model, double time) {
  Vector2 slope = Vector2::Zero();
  if (model.gravity.acts()) {  // gravity turns against the carrier
    const Vector2 weight = weight_on_bore(model, time);
    slope = model.point.carrier.speed * Vector2(weight.y(), -weight.x());
  }
  if (model.excitation.harmonics.empty()) return slope;
  Vector2 of_teeth = Vector2::Zero();
  Multiples multiples(model.excitation.angular_frequency * time);
  for (const LoadHarmonic& harmonic : model.excitation.harmonics) {
    const Vector2& turned = multiples.of(harmonic.order);
    of_teeth += harmonic.order * (turned.x() * harmonic.sine - turned.y() * harmonic.cosine);
  }
  return slope + model.excitation.angular_frequency * of_teeth;
}

}  // namespace orbearing::bearing::motion

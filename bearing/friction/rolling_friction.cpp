#include "bearing/friction/rolling_friction.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "bearing/friction/replenishment.hpp"
#include "bearing/geometry.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "bearing/motion/balls/mixture.hpp"
#include "bearing/motion/model.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::friction {

namespace {

constexpr std::array kCauses{&RollingFriction::rolling,
                             &RollingFriction::flooded_rolling,
                             &RollingFriction::isothermal_rolling,
                             &RollingFriction::regression_rolling,
                             &RollingFriction::idle,
                             &RollingFriction::differential_slip,
                             &RollingFriction::spin,
                             &RollingFriction::drag};

}  // namespace

RollingFriction& RollingFriction::operator+=(const RollingFriction& other) {
  for (const auto cause : kCauses) this->*cause += other.*cause;
  return *this;
}

RollingFriction& RollingFriction::operator*=(double factor) {
  for (const auto cause : kCauses) this->*cause *= factor;
  return *this;
}

namespace {

using equilibrium::RingSpeeds;

// Loss of all rollers on one race [W]; `beyond` [N] is the contribution of the inlet beyond its end for each
// roller, 0 without end.
double rolling_loss(const motion::RaceModel& race, double rolling,
                    const Eigen::Ref<const Eigen::ArrayXd>& loads, double beyond = 0.0) {
  if (!race.friction.rolling_resistance) return 0.0;
  const double log_speed = std::log(motion::entrainment_speed(rolling, race.entrainment_scale));
  double loss = 0.0;
  for (const double load : loads) {
    const double resistance = race.friction.inlet(load, rolling, log_speed);
    if (resistance > 0.0) loss += 2.0 * rolling * resistance * ended_inlet_share(beyond / resistance);
  }
  return loss;
}

// One ball on one race at rolling speed `rolling` [m/s].
struct BallContact {
  double load, rolling, spin;
};

// The ellipse of contact slides as a whole such that it pulls the ball neither way.
void add_ellipse(const balls::BallNumbers& c, const balls::GrooveNumbers& groove, const BallContact& at,
                 RollingFriction& sum) {
  const double third = std::cbrt(at.load), turn = at.rolling / groove.rolling_radius;
  const LoadedEllipse<double> ellipse{
      at.load,
      groove.across * third,
      groove.along * third,
      groove.pressure * third,
      std::exp(-groove.central_film.log_film(std::log(at.load), std::log(at.rolling))),
      groove.curvature,
      2.0 * c.radius};
  const auto traction_at = [&](double sliding) {
    Traction<double> traction;
    TractionSlopes<double> none;
    with_shear_law(c.shear.law, [&](const auto& law) {
      add_traction<false>(law, c.shear, c.points, ellipse, {sliding, 0.0, 0.0, turn, at.spin}, traction,
                          none);
    });
    return traction;
  };
  // No point slides faster than that by rolling and spin together.
  const double most = turn * ellipse.across * ellipse.across * (groove.curvature + 0.5 / c.radius) +
                      std::abs(at.spin) * ellipse.across;
  std::uintmax_t steps = 60;
  const auto [below, above] =
      boost::math::tools::toms748_solve([&](double sliding) { return traction_at(sliding).along; }, -most,
                                        most, boost::math::tools::eps_tolerance<double>(30), steps);
  const Traction<double> traction = traction_at(0.5 * (below + above));
  sum.differential_slip += traction.turn_across * turn;
  sum.spin += traction.spin * at.spin;
}

void add_contact(const balls::BallNumbers& c, const balls::GrooveNumbers& groove, const BallContact& at,
                 RollingFriction& sum) {
  if (!(at.load > 0.0) || !(at.rolling > 0.0)) return;
  const double couple =
      groove.rolling_factor * at.rolling * groove.rolling.per_speed(std::log(at.rolling), std::log(at.load));
  const double isothermal = couple * at.rolling / groove.rolling_radius;
  sum.isothermal_rolling += isothermal;
  const double heated =
      groove.inlet_heating > 0.0
          ? isothermal * heated_inlet_share(std::log(groove.inlet_heating * at.rolling * at.rolling))
          : isothermal;
  sum.flooded_rolling += heated;
  sum.rolling += heated;
  add_ellipse(c, groove, at, sum);
}

}  // namespace

namespace {

using motion::InletHeating;

// Rollers and cage in a mixture that is carried round, and the walls of the rings, of which one drags it.
balls::DragNumbers roller_drag(const Bearing& bearing, const BearingGeometry& geometry,
                               const motion::OilDragParameters& given, const Lubricant& oil, double flow) {
  const CylindricalRollers& rollers = bearing.rollers();
  const double density = given.oil_share * given.oil_density, radius = geometry.pitch_radius;
  // Part of a roller outside of the cage, as for balls.
  const double height = 0.5 * (bearing.cage.outer_diameter - bearing.cage.inner_diameter);
  const double bare = std::max(0.0, rollers.diameter - height);
  const double cage_radius = 0.25 * (bearing.cage.inner_diameter + bearing.cage.outer_diameter);
  balls::DragNumbers drag{
      .translation =
          motion::translation_drag(density, given.drag_coefficient, bare, rollers.length).coefficient,
      .churning =
          motion::churning_drag(density, given.churning_coefficient, geometry.element_radius, rollers.length)
              .coefficient,
      .cage_churning =
          motion::churning_drag(density, given.churning_coefficient, cage_radius, bearing.cage.width)
              .coefficient,
      .mixture = {}};
  drag.mixture = {.carried = true,
                  .count = rollers.count,
                  .slenderness = geometry.slenderness,
                  .pitch_radius = radius,
                  .inner_radius = geometry.inner_radius,
                  .outer_radius = geometry.outer_radius,
                  .width = std::max(bearing.width, rollers.length),
                  .density = density,
                  .viscosity = oil.viscosity / given.oil_density,
                  .flow = given.oil_density * flow,
                  .balls = rollers.count * drag.translation * radius * radius * radius,
                  .cage = drag.cage_churning,
                  .share = 0.0};
  return drag;
}

double drag_loss(const Bearing& bearing, const BearingGeometry& geometry, const balls::DragNumbers& drag,
                 const RingSpeeds& speeds) {
  const balls::WallTorques walls = balls::wall_torques(drag.mixture, speeds.inner, speeds.outer);
  const double cage = kinematic_cage_speed(geometry, speeds.inner, speeds.outer);
  const double spin = kinematic_roller_spin(geometry, speeds.inner, speeds.outer);
  const auto power = [](double coefficient, double speed) {
    return motion::QuadraticDrag{coefficient}.power(speed);
  };
  return bearing.rollers().count *
             (power(drag.translation, geometry.pitch_radius * cage) + power(drag.churning, spin)) +
         power(drag.cage_churning, cage) + walls.inner * speeds.inner + walls.outer * speeds.outer;
}

void heat_inlets(double viscosity_slope, motion::RaceContactParameters& race) {
  if (!(viscosity_slope > 0.0)) return;
  race.inlet_heating = InletHeating::goksem_hargreaves;
  race.viscosity_slope = viscosity_slope;
}

}  // namespace

double ended_inlet_share(double far) {
  return std::exp(-far);
}

double oil_layer(const Bearing& bearing, double share) {
  using constants::pi;
  const BearingGeometry g = geometry_of(bearing);
  const CylindricalRollers& rollers = bearing.rollers();
  const Cage& cage = bearing.cage;
  const double width = std::max(bearing.width, rollers.length), radius = 0.5 * rollers.diameter;
  const double of_roller = pi * radius * radius * rollers.length;
  const double of_cage = cage.density > 0.0 ? g.cage_mass / cage.density : 0.0;
  const double volume = pi * (g.outer_radius * g.outer_radius - g.inner_radius * g.inner_radius) * width -
                        rollers.count * of_roller - of_cage;
  const double surface = constants::two_pi * (g.inner_radius + g.outer_radius) * width +
                         rollers.count * constants::two_pi * radius * (rollers.length + radius) +
                         pi * (cage.inner_diameter + cage.outer_diameter) * cage.width;
  return share * volume / surface;
}

RollingFriction roller_friction(const Bearing& bearing, const Eigen::Ref<const Eigen::ArrayXd>& inner_load,
                                const RingSpeeds& speeds, const Lubricant& oil, const Inlets& inlets,
                                const RollerMixture& mixture) {
  motion::DynamicsParameters isothermal;
  isothermal.lubricant = oil;
  isothermal.drag.oil_share = mixture.oil_share;
  motion::DynamicsParameters given = isothermal;
  heat_inlets(inlets.viscosity_slope, given.race);
  const BearingGeometry geometry = geometry_of(bearing);
  const double cage = kinematic_cage_speed(geometry, speeds.inner, speeds.outer);
  const double thrown = geometry.element_mass * geometry.pitch_radius * cage * cage;
  OperatingPoint point;
  point.inner_speed = speeds.inner;
  point.outer_speed = speeds.outer;
  const balls::DragNumbers drag = balls::carried_drag(
      roller_drag(bearing, geometry, given.drag, oil, mixture.flow), speeds.inner, speeds.outer);
  const double layers = 2.0 * oil_layer(bearing, mixture.oil_share), length = bearing.rollers().length;
  const auto loss_on = [&](const motion::DynamicsParameters& laws, bool end, Race race,
                           const Eigen::ArrayXd& loads) {
    const bool inner = race == Race::inner;
    const double speed = inner ? speeds.inner : speeds.outer;
    const double rolling = std::abs(speed - cage) * (inner ? geometry.inner_radius : geometry.outer_radius);
    const double equivalent = equivalent_radius(geometry, race);
    const double begin =
        inlets.end == InletEnd::replenished
            ? inlet_length(equivalent, length,
                           returned_oil(bearing, geometry, race, speeds, drag, mixture.oil_share))
            : std::sqrt(2.0 * equivalent * layers);
    const double beyond = 12.0 * oil.viscosity * rolling * equivalent * length / begin;
    return rolling_loss(motion::race_model(bearing, geometry, point, race, laws), rolling, loads,
                        end ? beyond : 0.0);
  };
  const auto loss = [&](const motion::DynamicsParameters& laws, bool end) {
    return loss_on(laws, end, Race::inner, inner_load) + loss_on(laws, end, Race::outer, inner_load + thrown);
  };
  const bool ended = inlets.end != InletEnd::none;
  motion::DynamicsParameters regression = given;
  regression.race.rolling_law = motion::RollingLaw::goksem_hargreaves;
  return {
      .rolling = inlets.starvation * loss(given, ended),
      .flooded_rolling = loss(given, false),
      .isothermal_rolling = loss(isothermal, false),
      .regression_rolling = inlets.starvation * loss(regression, ended),
      .idle = inlets.starvation *
              loss_on(given, ended, Race::outer,
                      (inner_load > 0.0).select(0.0, Eigen::ArrayXd::Constant(inner_load.size(), thrown))),
      .drag = drag_loss(bearing, geometry, drag, speeds)};
}

RollingFriction ball_friction(const Bearing& bearing, const equilibrium::RingState& balance,
                              const equilibrium::RingLoad& load, const RingSpeeds& speeds,
                              const Lubricant& oil, const Inlets& inlets) {
  balls::MotionParameters given;
  given.lubricant = oil;
  heat_inlets(inlets.viscosity_slope, given.race);
  given.race.traction = TractionLaw::ree_eyring;
  given.ellipse.rolling = balls::BallRolling::reynolds;
  const balls::BallNumbers c = balls::ball_numbers(bearing, given);
  RollingFriction sum;
  for (Eigen::Index j = 0; j < balance.contact_load.size(); ++j) {
    add_contact(c, c.inner,
                {balance.contact_load[j], std::abs(balance.inner_rolling[j]), balance.inner_spin[j]}, sum);
    const double before = sum.rolling;
    add_contact(c, c.outer,
                {balance.outer_load[j], std::abs(balance.outer_rolling[j]), balance.outer_spin[j]}, sum);
    if (!(balance.contact_load[j] > 0.0)) sum.idle += sum.rolling - before;
  }
  balls::BallDuty duty;
  duty.inner = balls::RingDrive::steady(speeds.inner);
  duty.outer = balls::RingDrive::steady(speeds.outer);
  duty.on_inner = {{load.radial, 0.0, load.axial}};
  const balls::BallBearing in_motion(c, duty);
  sum.drag = in_motion.snapshot(0.0, balls::start_state(bearing, in_motion, bearing.first_element).data())
                 .loss.churning;
  return sum;
}

}  // namespace orbearing::bearing::friction

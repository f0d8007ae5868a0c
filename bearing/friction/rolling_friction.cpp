#include "bearing/friction/rolling_friction.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "bearing/geometry.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::bearing::friction {

namespace {

using equilibrium::RingSpeeds;

// Of all rollers on one race [W].
double rolling_loss(const motion::RaceModel& race, double rolling,
                    const Eigen::Ref<const Eigen::ArrayXd>& loads) {
  if (!race.friction.rolling_resistance) return 0.0;
  const double log_speed = std::log(motion::entrainment_speed(rolling, race.entrainment_scale));
  double loss = 0.0;
  for (const double load : loads) loss += 2.0 * rolling * race.friction.inlet(load, rolling, log_speed);
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
  const double couple = groove.rolling_factor * std::pow(at.rolling, balls::kRollingSpeed) *
                        std::pow(at.load, balls::kRollingLoad);
  sum.rolling += couple * at.rolling / groove.rolling_radius;
  add_ellipse(c, groove, at, sum);
}

}  // namespace

RollingFriction roller_friction(const Bearing& bearing, const Eigen::Ref<const Eigen::ArrayXd>& inner_load,
                                const RingSpeeds& speeds, const Lubricant& oil) {
  motion::DynamicsParameters given;
  given.lubricant = oil;
  const BearingGeometry geometry = geometry_of(bearing);
  const double cage = kinematic_cage_speed(geometry, speeds.inner, speeds.outer);
  const double thrown = geometry.element_mass * geometry.pitch_radius * cage * cage;
  OperatingPoint point;
  point.inner_speed = speeds.inner;
  point.outer_speed = speeds.outer;
  const auto loss_on = [&](Race race, double speed, double radius, const Eigen::ArrayXd& loads) {
    return rolling_loss(motion::race_model(bearing, geometry, point, race, given),
                        std::abs(speed - cage) * radius, loads);
  };
  const motion::OilDragParameters& drag = given.drag;
  const double density = drag.oil_share * drag.oil_density;
  const CylindricalRollers& rollers = bearing.rollers();
  const double spin = kinematic_roller_spin(geometry, speeds.inner, speeds.outer);
  return {
      .rolling = loss_on(Race::inner, speeds.inner, geometry.inner_radius, inner_load) +
                 loss_on(Race::outer, speeds.outer, geometry.outer_radius, inner_load + thrown),
      .idle = loss_on(Race::outer, speeds.outer, geometry.outer_radius,
                      (inner_load > 0.0).select(0.0, Eigen::ArrayXd::Constant(inner_load.size(), thrown))),
      .drag =
          rollers.count *
          (motion::translation_drag(density, drag.drag_coefficient, rollers.diameter, rollers.length)
               .power(geometry.pitch_radius * cage) +
           motion::churning_drag(density, drag.churning_coefficient, geometry.element_radius, rollers.length)
               .power(spin))};
}

RollingFriction ball_friction(const Bearing& bearing, const equilibrium::RingState& balance,
                              const equilibrium::RingLoad& load, const RingSpeeds& speeds,
                              const Lubricant& oil) {
  balls::MotionParameters given;
  given.lubricant = oil;
  given.race.traction = motion::TractionLaw::ree_eyring;
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

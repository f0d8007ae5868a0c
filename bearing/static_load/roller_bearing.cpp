#include "bearing/static_load/roller_bearing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "bearing/line_contact.hpp"

namespace orbearing::bearing::static_load {

namespace {

constexpr double kExponent = laminae::LaminaLaw::exponent;

// Approach of ring and ring at one roller, less the clearance, in the middle and by how much more at x = l/2.
struct RollerApproach {
  double middle;  // [m]
  double tip;     // [m]
};

RollerApproach approach_at(const StaticRollers& rollers, Eigen::Index j, const Eigen::Vector4d& place) {
  const double cosine = rollers.cosine[j], sine = rollers.sine[j];
  return {place[0] * cosine + place[1] * sine - 0.5 * rollers.clearance,
          -(place[2] * cosine + place[3] * sine)};
}

// Relief of both contacts of a roller at the middles of its laminae [m].
std::vector<double> drops_of(const CylindricalRollerBearing& in) {
  for (const profile::Profile& profile : {in.roller_profile, in.inner_race_profile, in.outer_race_profile})
    profile::require_sound(profile);
  const double length = in.roller_length;
  std::vector<double> drops =
      laminae::lamina_drops(in.roller_profile, in.inner_race_profile, length, in.laminae);
  const std::vector<double> outer =
      laminae::lamina_drops(in.roller_profile, in.outer_race_profile, length, in.laminae);
  for (std::size_t k = 0; k < drops.size(); ++k) drops[k] += outer[k];
  return drops;
}

// c_L of both contacts in series.
laminae::LaminaLaw law_of(const CylindricalRollerBearing& bearing) {
  const LineContact one = roller_race_contact(bearing.contact_law, bearing.roller_length);
  return {one.constant() * std::pow(2.0, -kExponent)};
}

// The scale of the solution: clearance and relief to be taken up, and twice what one roller alone would give.
double reach_of(const CylindricalRollerBearing& in, const StaticRollers& rollers,
                const Eigen::Vector4d& load) {
  const double elastic = std::pow(load.norm() / law_of(in).constant, 1.0 / kExponent);
  return std::abs(rollers.clearance) + rollers.contact.greatest_drop() + 2.0 * elastic + 1e-6;
}

}  // namespace

StaticRollers static_rollers(const CylindricalRollerBearing& in) {
  if (in.laminae < 1) {
    std::ostringstream text;
    text << "laminae: found " << in.laminae << "; required: at least 1";
    throw std::invalid_argument(text.str());
  }
  const double pitch = boost::math::double_constants::two_pi / in.rollers;
  const Eigen::ArrayXd angles = pitch * Eigen::ArrayXd::LinSpaced(in.rollers, 0.0, in.rollers - 1.0);
  return {.contact = laminae::LaminaContact(law_of(in), in.roller_length, drops_of(in)),
          .clearance = in.radial_clearance,
          .cosine = angles.cos(),
          .sine = angles.sin()};
}

RingForces<4> ring_forces(const StaticRollers& rollers, const Eigen::Vector4d& place) {
  RingForces<4> sum;
  for (Eigen::Index j = 0; j < rollers.cosine.size(); ++j) {
    const RollerApproach at = approach_at(rollers, j, place);
    const laminae::LaminaForce contact = rollers.contact.evaluate(at.middle, at.tip);
    const Eigen::Vector2d load(contact.load, contact.tip_load);
    const Eigen::Matrix2d stiffness =
        (Eigen::Matrix2d() << contact.by_approach, contact.mixed, contact.mixed, contact.by_tip).finished();
    Eigen::Matrix<double, 4, 2> direction = Eigen::Matrix<double, 4, 2>::Zero();
    direction.col(0).head<2>() << rollers.cosine[j], rollers.sine[j];
    direction.col(1).tail<2>() << -rollers.cosine[j], -rollers.sine[j];
    sum.contact_load += contact.load;
    sum.force += direction * load;
    sum.stiffness += direction * stiffness * direction.transpose();
  }
  return sum;
}

double stored_energy(const StaticRollers& rollers, const Eigen::Vector4d& place) {
  double energy = 0.0;
  for (Eigen::Index j = 0; j < rollers.cosine.size(); ++j) {
    const RollerApproach at = approach_at(rollers, j, place);
    energy += rollers.contact.energy(at.middle, at.tip);
  }
  return energy;
}

RollerBearingState static_state(const CylindricalRollerBearing& bearing, const RollerBearingLoad& load) {
  const StaticRollers rollers = static_rollers(bearing);
  const double lever = rollers.contact.half_length();
  BalanceProblem<4> problem;
  problem.load << load.radial, 0.0, load.tilt ? 0.0 : load.moment / lever, 0.0;
  problem.held = {false, false, load.tilt.has_value(), load.tilt.has_value()};
  if (load.tilt) problem.start[2] = lever * std::tan(*load.tilt);
  problem.reach = reach_of(bearing, rollers, problem.load) + std::abs(problem.start[2]);
  const RingBalance<4> found =
      balance(problem, [&](const Eigen::Vector4d& place) { return ring_forces(rollers, place); });
  const Eigen::Vector4d& place = found.place;
  RollerBearingState state{.radial = place[0],
                           .lateral = place[1],
                           .tilt = std::atan(place[2] / lever),
                           .lateral_tilt = std::atan(place[3] / lever),
                           .moment = ring_forces(rollers, place).force[2] * lever};
  state.report = found.report;
  state.lamina_load.resize(rollers.contact.laminae(), rollers.cosine.size());
  for (Eigen::Index j = 0; j < rollers.cosine.size(); ++j) {
    const RollerApproach at = approach_at(rollers, j, place);
    state.lamina_load.col(j) = rollers.contact.loads(at.middle, at.tip).load;
  }
  state.roller_load = state.lamina_load.colwise().sum().transpose();
  return state;
}

}  // namespace orbearing::bearing::static_load

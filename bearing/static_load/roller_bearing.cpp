#include "bearing/static_load/roller_bearing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/line_contact.hpp"

namespace orbearing::bearing::static_load {

namespace {

constexpr double kExponent = 10.0 / 9.0;

// Approach of all laminae of one roller [m]; positive in contact.
Eigen::ArrayXd approaches(const LaminaContacts& contacts, Eigen::Index roller, const Eigen::Vector4d& place) {
  const double cosine = contacts.cosine[roller], sine = contacts.sine[roller];
  const double middle = place[0] * cosine + place[1] * sine;
  const double tip = place[2] * cosine + place[3] * sine;
  return middle - contacts.gap - contacts.place * tip;
}

double lamina_load(double constant, double approach) {
  return approach > 0.0 ? constant * std::pow(approach, kExponent) : 0.0;
}

// The scale of the solution: clearance and relief to be taken up, and twice what one roller alone would give.
double reach_of(const LaminaContacts& contacts, double load) {
  const double whole = contacts.constant * static_cast<double>(contacts.place.size());
  return contacts.gap.abs().maxCoeff() + 2.0 * std::pow(load / whole, 1.0 / kExponent) + 1e-6;
}

}  // namespace

Eigen::ArrayXd lamina_places(int laminae, double length) {
  const double n = laminae;
  return length * (Eigen::ArrayXd::LinSpaced(laminae, 0.5, n - 0.5) / n - 0.5);
}

LaminaContacts lamina_contacts(const LaminaBearing& in) {
  if (in.laminae < 1) {
    std::ostringstream text;
    text << "laminae: found " << in.laminae << "; required: at least 1";
    throw std::invalid_argument(text.str());
  }
  profile::require_sound(in.roller_profile);
  const CylindricalRollerBearing& bearing = in.bearing;
  const double one_contact = roller_race_contact(bearing.contact_law, bearing.roller_length).constant();
  const double both = one_contact * std::pow(2.0, -kExponent);
  const Eigen::ArrayXd places = lamina_places(in.laminae, bearing.roller_length);
  const double pitch = boost::math::double_constants::two_pi / bearing.rollers;
  LaminaContacts contacts{.constant = both / in.laminae, .lever = 0.5 * bearing.roller_length};
  contacts.place = places / contacts.lever;
  contacts.gap = 0.5 * bearing.radial_clearance +
                 2.0 * places.unaryExpr([&](double x) { return profile::drop(in.roller_profile, x); });
  const Eigen::ArrayXd angles =
      pitch * Eigen::ArrayXd::LinSpaced(bearing.rollers, 0.0, bearing.rollers - 1.0);
  contacts.cosine = angles.cos();
  contacts.sine = angles.sin();
  return contacts;
}

RingForces<4> ring_forces(const LaminaContacts& contacts, const Eigen::Vector4d& place) {
  RingForces<4> sum;
  for (Eigen::Index j = 0; j < contacts.cosine.size(); ++j) {
    const Eigen::ArrayXd approach = approaches(contacts, j, place);
    Eigen::Vector2d load = Eigen::Vector2d::Zero();  // on the middle and on the tip
    Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
    for (Eigen::Index k = 0; k < approach.size(); ++k) {
      if (approach[k] <= 0.0) continue;
      const Eigen::Vector2d share(1.0, -contacts.place[k]);
      const double q = lamina_load(contacts.constant, approach[k]);
      load += q * share;
      stiffness += kExponent * q / approach[k] * share * share.transpose();
    }
    Eigen::Matrix<double, 4, 2> direction;
    direction << contacts.cosine[j], 0.0, contacts.sine[j], 0.0, 0.0, contacts.cosine[j], 0.0,
        contacts.sine[j];
    sum.contact_load += load[0];
    sum.force += direction * load;
    sum.stiffness += direction * stiffness * direction.transpose();
  }
  return sum;
}

double stored_energy(const LaminaContacts& contacts, const Eigen::Vector4d& place) {
  double energy = 0.0;
  for (Eigen::Index j = 0; j < contacts.cosine.size(); ++j)
    for (const double approach : approaches(contacts, j, place))
      energy += lamina_load(contacts.constant, approach) * std::max(approach, 0.0) / (kExponent + 1.0);
  return energy;
}

RollerBearingState static_state(const LaminaBearing& bearing, const RollerBearingLoad& load) {
  const LaminaContacts contacts = lamina_contacts(bearing);
  BalanceProblem<4> problem;
  problem.load << load.radial, 0.0, load.tilt ? 0.0 : load.moment / contacts.lever, 0.0;
  problem.held = {false, false, load.tilt.has_value(), load.tilt.has_value()};
  if (load.tilt) problem.start[2] = contacts.lever * std::tan(*load.tilt);
  problem.reach = reach_of(contacts, problem.load.norm()) + std::abs(problem.start[2]);
  const RingBalance<4> found =
      balance(problem, [&](const Eigen::Vector4d& place) { return ring_forces(contacts, place); });
  const Eigen::Vector4d& place = found.place;
  RollerBearingState state{.radial = place[0],
                           .lateral = place[1],
                           .tilt = std::atan(place[2] / contacts.lever),
                           .lateral_tilt = std::atan(place[3] / contacts.lever),
                           .moment = ring_forces(contacts, place).force[2] * contacts.lever};
  state.report = found.report;
  state.lamina_load.resize(contacts.place.size(), contacts.cosine.size());
  for (Eigen::Index j = 0; j < contacts.cosine.size(); ++j)
    state.lamina_load.col(j) = approaches(contacts, j, place).unaryExpr([&](double approach) {
      return lamina_load(contacts.constant, approach);
    });
  state.roller_load = state.lamina_load.colwise().sum().transpose();
  return state;
}

}  // namespace orbearing::bearing::static_load

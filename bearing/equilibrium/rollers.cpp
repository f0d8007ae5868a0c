#include "bearing/equilibrium/rollers.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <vector>

#include "bearing/contact/line_contact.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

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
laminae::LaminaLaw series_law(const CylindricalRollerBearing& bearing) {
  const LineContact one = roller_race_contact(bearing.contact_law, bearing.roller_length);
  return {one.constant() * std::pow(2.0, -laminae::LaminaLaw::exponent)};
}

const CylindricalRollerBearing& with_laminae(const CylindricalRollerBearing& in) {
  mechanics::require(in.laminae >= 1, "laminae", in.laminae, "at least 1");
  return in;
}

}  // namespace

RollerRow::RollerRow(const CylindricalRollerBearing& in, double first_element)
    : contact_(series_law(with_laminae(in)), in.roller_length, drops_of(in)),
      clearance_(in.radial_clearance),
      constant_(series_law(in).constant) {
  const double pitch = boost::math::double_constants::two_pi / in.rollers;
  const Eigen::ArrayXd angle =
      first_element + pitch * Eigen::ArrayXd::LinSpaced(in.rollers, 0.0, in.rollers - 1.0);
  cosine_ = angle.cos();
  sine_ = angle.sin();
}

// Of ring and ring at one roller, less the clearance.
struct RollerRow::Approach {
  double middle;  // [m]
  double tip;     // [m]  by how much more at z = l/2
};

RollerRow::Approach RollerRow::approach_of(Eigen::Index roller, const RingPlace& place) const {
  const double cosine = cosine_[roller], sine = sine_[roller];
  return {place[0] * cosine + place[1] * sine - 0.5 * clearance_, -(place[3] * cosine + place[4] * sine)};
}

// Clearance and relief to be taken up, and twice what one roller alone would give.
double RollerRow::reach(double load) const {
  const double elastic = std::pow(load / constant_, 1.0 / laminae::LaminaLaw::exponent);
  return std::abs(clearance_) + contact_.greatest_drop() + 2.0 * elastic + 1e-6;
}

void RollerRow::add_forces(const RingPlace& place, RingImbalance& sum) const {
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const Approach at = approach_of(j, place);
    const laminae::LaminaForce contact = contact_.evaluate(at.middle, at.tip);
    const Eigen::Vector2d load(contact.load, contact.tip_load);
    const Eigen::Matrix2d stiffness =
        (Eigen::Matrix2d() << contact.by_approach, contact.mixed, contact.mixed, contact.by_tip).finished();
    Eigen::Matrix<double, 5, 2> direction = Eigen::Matrix<double, 5, 2>::Zero();
    direction.col(0).head<2>() << cosine_[j], sine_[j];
    direction.col(1).tail<2>() << -cosine_[j], -sine_[j];
    sum.scale += contact.load;
    sum.force -= direction * load;
    sum.stiffness += direction * stiffness * direction.transpose();
  }
}

void RollerRow::put_loads(const RingPlace& place, RingState& state) const {
  state.lamina_load.resize(contact_.laminae(), cosine_.size());
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const Approach at = approach_of(j, place);
    state.lamina_load.col(j) = contact_.loads(at.middle, at.tip).load;
  }
  state.contact_load = state.lamina_load.colwise().sum().transpose();
  state.contact_angle = Eigen::ArrayXd::Zero(cosine_.size());
}

double RollerRow::stored_energy(const RingPlace& place) const {
  double energy = 0.0;
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const Approach at = approach_of(j, place);
    energy += contact_.energy(at.middle, at.tip);
  }
  return energy;
}

}  // namespace orbearing::bearing::equilibrium

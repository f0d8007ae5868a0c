#include "bearing/equilibrium/rollers.hpp"

#include <cmath>
#include <vector>

#include "bearing/contact/least_approach.hpp"
#include "bearing/contact/line_contact.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

const CylindricalRollers& sound_rollers(const Bearing& bearing) {
  const CylindricalRollers& rollers = bearing.rollers();
  mechanics::require(rollers.laminae >= 1, "laminae", rollers.laminae, "at least 1");
  for (const profile::Profile* profile : {&rollers.profile, &bearing.inner.profile, &bearing.outer.profile})
    profile::require_sound(*profile);
  return rollers;
}

// With the relief of both contacts at the middles of the laminae.
laminae::LaminaContact contact_in_series(const Bearing& bearing) {
  const CylindricalRollers& rollers = sound_rollers(bearing);
  const auto drops_on = [&](const Ring& ring) {
    return laminae::lamina_drops(rollers.profile, ring.profile, rollers.length, rollers.laminae);
  };
  std::vector<double> drops = drops_on(bearing.inner);
  const std::vector<double> outer = drops_on(bearing.outer);
  for (std::size_t k = 0; k < drops.size(); ++k) drops[k] += outer[k];
  const LineContact both = both_in_series(roller_race_contact(bearing.contact_law, rollers.length));
  return {both, rollers.length, drops};
}

}  // namespace

RollerRow::RollerRow(const Bearing& bearing)
    : material_(bearing.material),
      sharpest_radius_(0.5 * bearing.element_diameter() * (1.0 - slenderness(bearing))),
      contact_(contact_in_series(bearing)),
      clearance_(bearing.radial_clearance) {
  const Eigen::ArrayXd angle = element_angles(bearing);
  cosine_ = angle.cos();
  sine_ = angle.sin();
}

Eigen::Vector2d RollerRow::coordinates(Eigen::Index roller, const RingPosition& position) const {
  const double cosine = cosine_[roller], sine = sine_[roller];
  const double approach = position[0] * cosine + position[1] * sine - 0.5 * clearance_;
  return {without_round_off(approach, position.head<2>().norm() + 0.5 * std::abs(clearance_)),
          -(position[3] * cosine + position[4] * sine)};
}

Eigen::Matrix<double, 5, 2> RollerRow::moves(Eigen::Index roller) const {
  Eigen::Matrix<double, 5, 2> all = Eigen::Matrix<double, 5, 2>::Zero();
  all.col(0).head<2>() << cosine_[roller], sine_[roller];
  all.col(1).tail<2>() << -cosine_[roller], -sine_[roller];
  return all;
}

// Clearance and relief to be taken up, and twice the approach of a single loaded roller.
double RollerRow::reach(double load) const {
  return std::abs(clearance_) + contact_.greatest_drop() + 2.0 * contact_.whole().approach(load) + 1e-6;
}

void RollerRow::add_forces(const RingPosition& position, RingImbalance& sum) const {
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const Eigen::Vector2d at = coordinates(j, position);
    const laminae::LaminaForce contact = contact_.evaluate(at[0], at[1]);
    const Eigen::Vector2d load(contact.load, contact.end_load);
    const Eigen::Matrix2d stiffness =
        (Eigen::Matrix2d() << contact.by_approach, contact.mixed, contact.mixed, contact.by_end_displacement)
            .finished();
    const Eigen::Matrix<double, 5, 2> direction = moves(j);
    sum.scale += contact.load;
    sum.force -= direction * load;
    sum.stiffness += direction * stiffness * direction.transpose();
  }
}

void RollerRow::put_loads(const RingPosition& position, RingState& state) const {
  state.lamina_load.resize(contact_.laminae(), cosine_.size());
  for (Eigen::Index j = 0; j < cosine_.size(); ++j) {
    const Eigen::Vector2d at = coordinates(j, position);
    state.lamina_load.col(j) = contact_.loads(at[0], at[1]);
  }
  state.contact_load = state.lamina_load.colwise().sum().transpose();
  const double lamina = 2.0 * contact_.half_length() / static_cast<double>(contact_.laminae());
  state.largest_pressure = hertz_pressure(state.lamina_load.maxCoeff(), sharpest_radius_, lamina, material_);
}

}  // namespace orbearing::bearing::equilibrium

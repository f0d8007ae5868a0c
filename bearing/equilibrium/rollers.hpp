// A row of cylindrical rollers cut into laminae under a static load, without inertia, [ISO16281]. The contact
// law of the bearing is taken for both contacts of a roller in series; its cage, rings and forms play no
// part.
#pragma once

#include <Eigen/Core>

#include "bearing/contact/lamina_contact.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing::equilibrium {

/// Data of the row that are independent of the load: both contacts of a roller as one, and the angles of the
/// rollers. The axial position is free: rollers without flanges bear no axial load.
class RollerRow : public RingRow {
 public:
  /// Throws std::invalid_argument where the elements are no rollers, there are no laminae or a profile has no
  /// meaning.
  explicit RollerRow(const Bearing& bearing);

  double lever() const override { return contact_.half_length(); }
  double reach(double load) const override;
  void add_forces(const RingPosition& position, RingImbalance& sum) const override;
  void put_loads(const RingPosition& position, RingState& state) const override;

  /// Both contacts of a roller as one.
  const laminae::LaminaContact& contact() const { return contact_; }
  /// Approach of the rings at one roller, less the clearance: in the middle, and additionally at z = l/2 [m];
  /// and their derivatives by the position of the ring.
  Eigen::Vector2d coordinates(Eigen::Index roller, const RingPosition& position) const;
  Eigen::Matrix<double, 5, 2> moves(Eigen::Index roller) const;

 private:
  Material material_;
  double sharpest_radius_;          // [m]  equivalent, on the inner race: D (1 - gamma)/2
  laminae::LaminaContact contact_;  // c_L in all, drops of both contacts
  double clearance_;                // [m]  diametral
  Eigen::ArrayXd cosine_;           // (rollers)  of their angles
  Eigen::ArrayXd sine_;
};

}  // namespace orbearing::bearing::equilibrium

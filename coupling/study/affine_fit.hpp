// The linear law that stands best for a bearing as it moved: stiffness, damping and offset by least squares.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/system/steady_state.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::study {

/// A law and how well it holds. Shares are of its forces under the motion at the orders that were fitted.
struct FittedBearing {
  gearset::dynamics::AffineBearing bearing;
  double residual = 0.0;          // [-]  what the law leaves of the whole force
  double stiffness_change = 0.0;  // [-]  of the springs' force, from another law
  double damping_change = 0.0;    // [-]  of the dampers' force
};

/// Gathers the motion of a bore that is driven at multiples of one frequency. Only what follows that
/// frequency counts: motion that the rollers give the bore is answered by the bore's mass, and would draw a
/// fit of forces over motion towards that mass.
class AffineFit {
 public:
  /// @param angular_frequency [rad/s]
  AffineFit(double angular_frequency, int orders);

  void add(const system::BoreSample& sample);

  /// Force = offset - stiffness x position - damping x velocity over all orders and in the mean. `expected`
  /// is what is known beforehand, its stiffness to kExpectedStiffness of the largest, its damping to as much
  /// as it is: it stands where the motion shows no more than its own scatter, as across an orbit that is a
  /// line.
  /// @param before what changes are counted from: along the motion, since nothing is known across it
  FittedBearing law(const gearset::dynamics::AffineBearing& expected,
                    const gearset::dynamics::AffineBearing& before) const;

  static constexpr double kExpectedStiffness = 0.2;  // [-]

 private:
  using Row = Eigen::Matrix<double, 1, 6>;  // position, velocity, force
  struct Order {
    Row cosine = Row::Zero(), sine = Row::Zero();
    double cosine_weight = 0.0, sine_weight = 0.0;
  };

  double angular_frequency_;
  std::vector<Order> orders_;
  Row sum_ = Row::Zero();
  double weight_ = 0.0;
};

}  // namespace orbearing::study

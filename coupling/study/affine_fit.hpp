// The linear law that stands best for a bearing as it moved: stiffness, damping and offset by least squares.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/system/steady_state.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::study {

/// A law and how well it holds. Shares are of its forces under the last motion at the orders that were
/// fitted.
struct FittedBearing {
  gearset::dynamics::AffineBearing bearing;
  double residual = 0.0;          // [-]  what the law leaves of the whole force
  // From another law to that of the last motion alone:
  double stiffness_change = 0.0;  // [-]  of the springs' force
  double damping_change = 0.0;    // [-]  of the dampers' force
};

/// Gathers the motions of a bore that is driven at multiples of one frequency. Only what follows that
/// frequency counts: motion that the rollers give the bore is answered by the bore's mass, and would draw a
/// fit of forces over motion towards that mass.
class AffineFit {
 public:
  /// @param angular_frequency [rad/s]
  AffineFit(double angular_frequency, int orders);

  void add(const system::BoreSample& sample);

  /// What follows is another motion of the same bearing: one law is fitted to all of them, each by as much as
  /// it lasted and half as much as the one after it.
  void begin_motion();

  /// Force = offset - stiffness x position - damping x velocity over all orders and in the mean. `expected`
  /// is what is known beforehand, its stiffness to kExpectedStiffness of the largest, its damping to as much
  /// as it is: it stands where the motion shows no more than its own scatter, as across an orbit that is a
  /// line. Dampers give no energy: where the best ones would, their symmetric part is the nearest that does
  /// not. Offset and shares are those of the last motion.
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

  // Harmonics of the present motion: twice as many rows as orders, columns of Row.
  Eigen::MatrixXd harmonics() const;

  double angular_frequency_;
  Eigen::MatrixXd before_ = Eigen::MatrixXd(0, 6);  // harmonics of earlier motions, times root of weight
  double before_weight_ = 0.0;                      // of all those rows
  std::vector<Order> orders_;
  Row sum_ = Row::Zero();
  double weight_ = 0.0;
};

}  // namespace orbearing::study
